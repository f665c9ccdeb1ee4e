#include "refinement.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <unordered_map>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxPointsPerScan = 4000;
constexpr float kMinClusterPoints = 3.0F;
constexpr double kConverged_m = 5e-4;

/// Consecutive scans that move as one body; the frame is the IMU at the middle scan.
struct Segment {
  std::size_t first = 0;
  std::size_t last = 0;  // one behind
  std::size_t anchor = 0;
};

std::vector<Segment> cut_into_segments(const std::vector<StoredScan>& scans, double duration_s) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (segments.empty() ||
        to_seconds(scans[i].time - scans[segments.back().first].time) >= duration_s - 1e-3) {
      segments.push_back({.first = i});
    }
    segments.back().last = i + 1;
    segments.back().anchor = (segments.back().first + segments.back().last) / 2;
  }
  return segments;
}

struct Moments {
  std::uint64_t cell = 0;
  float count = 0.0F;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};

std::vector<PlaneCluster> cluster_segment(const ScanStore& store,
                                          const Segment& segment,
                                          std::uint32_t index,
                                          double voxel_m) {
  const std::vector<StoredScan>& scans = store.scans();
  const Rigid3& anchor = scans[segment.anchor].map_from_imu;
  std::unordered_map<std::uint64_t, std::size_t> slots;
  std::vector<Moments> cells;
  for (std::size_t s = segment.first; s < segment.last; ++s) {
    const Eigen::Isometry3f map_from_imu(
        Eigen::Isometry3d(scans[s].map_from_imu.matrix()).cast<float>());
    const Eigen::Isometry3f segment_from_imu(
        Eigen::Isometry3d((anchor.inverse() * scans[s].map_from_imu).matrix()).cast<float>());
    const auto points = store.points_of(scans[s]);
    const std::size_t stride = points.size() / kMaxPointsPerScan + 1;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      const Eigen::Vector3f point = unpack(points[i]).point_in_imu;
      const std::uint64_t cell = voxel_key(voxel_of(map_from_imu * point, voxel_m));
      const auto [at, added] = slots.try_emplace(cell, cells.size());
      if (added) cells.push_back({.cell = cell});
      Moments& moments = cells[at->second];
      const Eigen::Vector3d q = (segment_from_imu * point).cast<double>();
      moments.count += 1.0F;
      moments.sum += q;
      moments.squares += q * q.transpose();
    }
  }
  std::vector<PlaneCluster> clusters;
  for (const Moments& moments : cells) {
    if (moments.count < kMinClusterPoints) continue;
    const Eigen::Vector3d mean = moments.sum / moments.count;
    clusters.push_back(
        {.cell = moments.cell,
         .segment = index,
         .count = moments.count,
         .mean = mean.cast<float>(),
         .covariance = (moments.squares / moments.count - mean * mean.transpose()).cast<float>()});
  }
  return clusters;
}

std::vector<PlaneCluster> cluster_all(const ScanStore& store,
                                      const std::vector<Segment>& segments,
                                      double voxel_m,
                                      const RunContext& ctx) {
  std::vector<std::vector<PlaneCluster>> parts(segments.size());
  parallel_for(ctx, segments.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      parts[i] = cluster_segment(store, segments[i], static_cast<std::uint32_t>(i), voxel_m);
    }
  });
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<PlaneCluster> clusters;
  clusters.reserve(total);
  for (auto& part : parts) {
    clusters.insert(clusters.end(), part.begin(), part.end());
    part = {};
  }
  std::ranges::sort(clusters, [](const PlaneCluster& a, const PlaneCluster& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.segment < b.segment;
  });
  return clusters;
}

/// Carries the moves of the segments over to all scans: between two anchors the correction is
/// interpolated in time, so that the trajectory stays smooth.
void move_scans(const std::vector<Segment>& segments,
                const std::vector<Rigid3>& map_from_segment,
                std::vector<StoredScan>& scans) {
  Trajectory corrections;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const StoredScan& anchor = scans[segments[i].anchor];
    corrections.poses.push_back(
        {.time = anchor.time,
         .map_from_body = anchor.map_from_imu.inverse() * map_from_segment[i]});
  }
  for (StoredScan& scan : scans) {
    const auto correction = interpolate(corrections, scan.time, kUnbounded);
    if (!correction) continue;
    scan.map_from_imu = scan.map_from_imu * *correction;
    scan.map_from_imu.rotation.normalize();
  }
}

}  // namespace

Expected<RefinementReport> refine_poses(const LidarRefineOptions& options,
                                        const RunContext& ctx,
                                        ScanStore& store) {
  RefinementReport report;
  std::vector<StoredScan>& scans = store.scans();
  const std::vector<Segment> segments = cut_into_segments(scans, options.segment_s);
  report.num_segments = segments.size();
  if (segments.size() < 2) return report;
  std::vector<SegmentLink> links;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    links.push_back({.first_from_second = scans[segments[i].anchor].map_from_imu.inverse() *
                                          scans[segments[i + 1].anchor].map_from_imu});
  }
  for (int pass = 0; pass < options.iterations; ++pass) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    ctx.report({.stage = "lidar/refine", .done = pass, .total = options.iterations});
    const auto clusters = cluster_all(store, segments, options.voxel_m, ctx);
    std::vector<Rigid3> poses;
    for (const Segment& segment : segments) poses.push_back(scans[segment.anchor].map_from_imu);
    auto adjusted = adjust_planes(clusters, links, options.max_plane_sigma_m, poses);
    if (!adjusted) return std::unexpected(std::move(adjusted).error().with_context("refining"));
    move_scans(segments, poses, scans);
    if (pass == 0) report.rms_before_m = adjusted->rms_before_m;
    report.rms_after_m = adjusted->rms_before_m;
    report.num_planes = adjusted->num_planes;
    report.iterations = pass + 1;
    if (adjusted->max_shift_m < kConverged_m) break;
  }
  return report;
}

}  // namespace hybridfusion
