#include "segments.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>

#include <unordered_map>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxPointsPerScan = 4000;
constexpr float kMinClusterPoints = 3.0F;

struct Moments {
  std::uint64_t cell = 0;
  float count = 0.0F;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};

}  // namespace

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

Expected<std::vector<PlaneCluster>> cluster_segment(const ScanStore& store,
                                                    const Segment& segment,
                                                    std::uint32_t index,
                                                    double voxel_m) {
  const std::vector<StoredScan>& scans = store.scans();
  const Rigid3& anchor = scans[segment.anchor].map_from_imu;
  std::unordered_map<std::uint64_t, std::size_t> slots;
  std::vector<Moments> cells;
  std::vector<PackedPoint> points;
  for (std::size_t s = segment.first; s < segment.last; ++s) {
    const Eigen::Isometry3f map_from_imu(
        Eigen::Isometry3d(scans[s].map_from_imu.matrix()).cast<float>());
    const Eigen::Isometry3f segment_from_imu(
        Eigen::Isometry3d((anchor.inverse() * scans[s].map_from_imu).matrix()).cast<float>());
    if (auto read = store.read(scans[s], points); !read) return std::unexpected(read.error());
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

std::vector<Rigid3> anchor_poses(const std::vector<Segment>& segments,
                                 const std::vector<StoredScan>& scans) {
  std::vector<Rigid3> poses;
  poses.reserve(segments.size());
  for (const Segment& segment : segments) poses.push_back(scans[segment.anchor].map_from_imu);
  return poses;
}

}  // namespace hybridfusion
