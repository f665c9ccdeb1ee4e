#include "refinement.hpp"

#include "segments.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cstring>

namespace hybridfusion {
namespace {

constexpr double kConverged_m = 5e-4;

constexpr double kLinkSigma_m = 0.03;
constexpr double kLinkSigma_rad = 3e-3;
constexpr double kBlindLinkSigma_m = 0.3;
constexpr std::size_t kSegmentsAtOnce = 32;
constexpr std::size_t kNumBuckets = 64;
// Where laps overlap every segment meets every other: memory grows with the square of their number,
// time with its cube (1200: 1.1 GB and minutes, 500: 0.5 GB). Longer drives get longer segments.
constexpr std::size_t kMaxSegments = 250;
constexpr std::size_t kBlockClusters = 1024;

/// Clusters by the hash of their cell, so that one bucket at a time holds all members of its cells.
struct ClusterBuckets {
  struct Bucket {
    std::vector<PlaneCluster> open = {};
    std::vector<SpillFile::Block> blocks = {};
  };
  SpillFile spill;
  std::vector<Eigen::Matrix3d> held = {};  // per segment, see held_directions
  RangeNoise noise = {};
  std::vector<Bucket> buckets = std::vector<Bucket>(kNumBuckets);

  Expected<void> add(const std::vector<PlaneCluster>& clusters) {
    for (const PlaneCluster& cluster : clusters) {
      Bucket& bucket = buckets[(cluster.cell * 0x9E3779B97F4A7C15ULL) >> 58U];
      bucket.open.push_back(cluster);
      if (bucket.open.size() < kBlockClusters) continue;
      HF_TRY(const SpillFile::Block block, spill.append(std::as_bytes(std::span(bucket.open))));
      bucket.blocks.push_back(block);
      bucket.open.clear();
    }
    return {};
  }

  Expected<std::vector<PlaneCluster>> sorted(std::size_t index) {
    Bucket& bucket = buckets[index];
    std::vector<PlaneCluster> clusters;
    std::vector<std::byte> bytes;
    for (const SpillFile::Block& block : bucket.blocks) {
      if (auto read = spill.read(block, bytes); !read) return std::unexpected(read.error());
      const std::size_t old_size = clusters.size();
      clusters.resize(old_size + bytes.size() / sizeof(PlaneCluster));
      std::memcpy(static_cast<void*>(clusters.data() + old_size), bytes.data(), bytes.size());
      spill.drop(block);
    }
    clusters.insert(clusters.end(), bucket.open.begin(), bucket.open.end());
    std::vector<PlaneCluster>().swap(bucket.open);
    std::ranges::sort(clusters, [](const PlaneCluster& a, const PlaneCluster& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.segment < b.segment;
    });
    return clusters;
  }
};

Expected<ClusterBuckets> cluster_all(const ScanStore& store,
                                     const std::vector<Segment>& segments,
                                     double voxel_m,
                                     const RunContext& ctx) {
  HF_TRY(SpillFile spill, store.new_spill());
  ClusterBuckets out{.spill = std::move(spill)};
  std::vector<Expected<std::vector<PlaneCluster>>> parts(kSegmentsAtOnce);
  for (std::size_t first = 0; first < segments.size(); first += kSegmentsAtOnce) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    const std::size_t count = std::min(kSegmentsAtOnce, segments.size() - first);
    parallel_for(ctx, count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        parts[i] = cluster_segment(
            store, segments[first + i], static_cast<std::uint32_t>(first + i), voxel_m);
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      if (!parts[i]) return std::unexpected(parts[i].error());
      const StoredScan& anchor = store.scans()[segments[first + i].anchor];
      out.held.push_back(held_directions(*parts[i], anchor.map_from_imu));
      out.noise.add(*parts[i], anchor.lidar_in_imu.cast<double>());
      if (auto added = out.add(*parts[i]); !added) return std::unexpected(added.error());
    }
  }
  return out;
}

std::vector<RelativePose> odometry_links(const std::vector<Rigid3>& poses) {
  std::vector<RelativePose> links;
  for (std::uint32_t i = 0; i + 1 < poses.size(); ++i) {
    links.push_back(
        {.first = i, .second = i + 1, .first_from_second = poses[i].inverse() * poses[i + 1]});
  }
  return links;
}

/// Along directions that no plane holds the odometry guesses: there the IMU decides.
void weigh_links(const std::vector<Eigen::Matrix3d>& held,
                 const std::vector<Rigid3>& poses,
                 std::vector<RelativePose>& links) {
  for (RelativePose& link : links) {
    const Eigen::Matrix3d axes = poses[link.first].rotation.toRotationMatrix().transpose();
    const Eigen::Matrix3d seen = axes * held[link.first] * held[link.second] * axes.transpose();
    const Eigen::Matrix3d both = 0.5 * (seen + seen.transpose());
    link.information = information_of(kLinkSigma_m, kLinkSigma_rad);
    link.information.topLeftCorner<3, 3>() =
        both / (kLinkSigma_m * kLinkSigma_m) +
        (Eigen::Matrix3d::Identity() - both) / (kBlindLinkSigma_m * kBlindLinkSigma_m);
  }
}

/// One pass of the adjustment. @param lenient  Without the limit of the noise, by which cells that
/// visits some centimetres apart share look rough. @returns kDegenerate, kCancelled, kIo.
Expected<PlaneAdjustmentReport> adjust_once(const LidarRefineOptions& options,
                                            bool lenient,
                                            const RunContext& ctx,
                                            const std::vector<Segment>& segments,
                                            std::vector<RelativePose>& links,
                                            ScanStore& store) {
  HF_TRY(ClusterBuckets clusters, cluster_all(store, segments, options.voxel_m, ctx));
  const std::vector<Rigid3> poses = anchor_poses(segments, store.scans());
  double max_sigma_m = options.max_plane_sigma_m;
  if (const auto noise_m = clusters.noise.sigma_m(); noise_m && !lenient) {
    max_sigma_m = std::min(max_sigma_m, options.max_plane_noise_ratio * *noise_m);
  }
  PlaneAdjustment adjustment(max_sigma_m, poses, clusters.held);
  for (std::size_t bucket = 0; bucket < kNumBuckets; ++bucket) {
    HF_TRY(const std::vector<PlaneCluster> members, clusters.sorted(bucket));
    adjustment.add(members);
  }
  weigh_links(clusters.held, poses, links);
  const auto changes = velocity_changes(segments, store.scans(), clusters.held);
  HF_TRY(const PlaneAdjustmentReport report, adjustment.solve(links, changes));
  move_scans(segments, adjustment.map_from_segment(), store.scans());
  return report;
}

}  // namespace

Expected<RefinementReport> refine_poses(const LidarRefineOptions& options,
                                        const RunContext& ctx,
                                        ScanStore& store) {
  RefinementReport report;
  std::vector<StoredScan>& scans = store.scans();
  if (scans.empty()) return report;
  const double duration_s = to_seconds(scans.back().time - scans.front().time);
  const std::vector<Segment> segments = cut_into_segments(
      scans, std::max(options.segment_s, duration_s / static_cast<double>(kMaxSegments)));
  report.num_segments = segments.size();
  if (segments.size() < 2) return report;
  std::vector<RelativePose> links = odometry_links(anchor_poses(segments, scans));
  bool lenient = options.iterations > 1;
  for (int pass = 0; pass < options.iterations; ++pass) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    ctx.report({.stage = "lidar/refine", .done = pass, .total = options.iterations});
    auto adjusted = adjust_once(options, lenient, ctx, segments, links, store);
    if (!adjusted) return std::unexpected(std::move(adjusted).error().with_context("refining"));
    if (pass == 0) report.rms_before_m = adjusted->rms_before_m;
    report.rms_after_m = adjusted->rms_before_m;
    report.num_planes = adjusted->num_planes;
    report.iterations = pass + 1;
    const bool converged = adjusted->max_shift_m < kConverged_m;
    if (converged && !lenient) break;
    lenient = lenient && !converged && pass + 1 < options.iterations / 2;
  }
  return report;
}

}  // namespace hybridfusion
