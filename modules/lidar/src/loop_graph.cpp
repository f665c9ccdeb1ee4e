#include "loop_graph.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/lidar/gnss_alignment.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr double kVoxel_m = 1.0;
constexpr double kPointSigma_m = 0.03;
constexpr float kMaxClusterWeight = 20.0F;
// What the IMU holds without planes over a segment, and with parts of it not measured at all.
constexpr double kInertialSigma_m = 0.1;
constexpr double kInertialSigma_rad = 2e-3;
constexpr double kBridgedSigma_m = 0.5;
constexpr double kBridgedSigma_rad = 0.02;
// Odometry is never better than this over a segment, whatever the planes say.
constexpr double kFloor_m = 2e-3;
constexpr double kFloorShare = 1e-3;
constexpr double kFloor_rad = 4e-4;
constexpr double kLoopSigma_m = 0.02;
constexpr double kLoopSigma_rad = 2e-3;
// Errors of a receiver last about as long.
constexpr double kGnssCorrelation_s = 120.0;
constexpr double kDefaultGnssSigma_m = 2.0;

PoseMatrix link_information(const PoseMatrix& planes, double length_m, bool bridged) {
  const PoseMatrix inertial = bridged ? information_of(kBridgedSigma_m, kBridgedSigma_rad)
                                      : information_of(kInertialSigma_m, kInertialSigma_rad);
  const double floor_m = kFloor_m + kFloorShare * length_m;
  PoseMatrix covariance = (planes + inertial).inverse();
  covariance.diagonal().head<3>().array() += floor_m * floor_m;
  covariance.diagonal().tail<3>().array() += kFloor_rad * kFloor_rad;
  return covariance.inverse();
}

std::uint32_t segment_of(const std::vector<Segment>& segments, std::size_t scan) {
  const auto behind = std::ranges::upper_bound(segments, scan, {}, &Segment::first);
  return static_cast<std::uint32_t>(behind - segments.begin() - 1);
}

}  // namespace

PoseMatrix plane_information(std::span<const PlaneCluster> first,
                             std::span<const PlaneCluster> second,
                             const Rigid3& first_from_second) {
  const Eigen::Matrix3d held = held_directions(first, {});
  PoseMatrix sum = PoseMatrix::Zero();
  for (auto a = first.begin(), b = second.begin(); a != first.end() && b != second.end();) {
    if (a->cell != b->cell) {
      a->cell < b->cell ? ++a : ++b;
      continue;
    }
    if (const auto normal = normal_of(*a)) {
      // r = n.(R q + t - c): d r / d t = n, d r / d theta = q x R^T n.
      PoseVector row;
      row << held * *normal,
          b->mean.cast<double>().cross(first_from_second.rotation.conjugate() * *normal);
      const double weight =
          std::min({a->count, b->count, kMaxClusterWeight}) / (kPointSigma_m * kPointSigma_m);
      sum += weight * row * row.transpose();
    }
    ++a;
    ++b;
  }
  return sum;
}

Expected<PoseGraph> build_loop_graph(const ScanStore& store,
                                     const std::vector<Segment>& segments,
                                     const std::vector<Loop>& loops,
                                     const RunContext& ctx) {
  const std::vector<StoredScan>& scans = store.scans();
  const std::vector<Rigid3> poses = anchor_poses(segments, scans);
  PoseGraph graph;
  std::vector<PlaneCluster> last;
  std::vector<Eigen::Matrix3d> held;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    graph.up_in_body.push_back(poses[i].rotation.conjugate() * Eigen::Vector3d::UnitZ());
    HF_TRY(std::vector<PlaneCluster> clusters, cluster_segment(store, segments[i], i, kVoxel_m));
    std::ranges::sort(clusters, {}, &PlaneCluster::cell);
    if (i > 0) {
      RelativePose link{
          .first = i - 1, .second = i, .first_from_second = poses[i - 1].inverse() * poses[i]};
      link.information =
          link_information(plane_information(last, clusters, link.first_from_second),
                           link.first_from_second.translation.norm(),
                           is_bridged(scans, segments[i - 1].anchor, segments[i].anchor));
      graph.odometry.push_back(link);
    }
    held.push_back(held_directions(clusters, poses[i]));
    last = std::move(clusters);
  }
  graph.velocity_changes = velocity_changes(segments, scans, held);
  for (const Loop& loop : loops) {
    const std::uint32_t first = segment_of(segments, loop.scans.first);
    const std::uint32_t second = segment_of(segments, loop.scans.second);
    graph.loops.push_back(
        {.first = first,
         .second = second,
         .first_from_second = poses[first].inverse() * scans[loop.scans.first].map_from_imu *
                              loop.first_from_second *
                              scans[loop.scans.second].map_from_imu.inverse() * poses[second],
         .information = information_of(kLoopSigma_m, kLoopSigma_rad)});
  }
  return graph;
}

void add_gnss(const GnssTrack& gnss,
              const std::vector<Segment>& segments,
              std::span<const StoredScan> scans,
              PoseGraph& graph) {
  Trajectory trajectory;
  for (const StoredScan& scan : scans) {
    trajectory.poses.push_back({.time = scan.time, .map_from_body = scan.map_from_imu});
  }
  const auto usable = std::ranges::find_if(gnss.fixes, [](const GnssFix& fix) {
    const GeodeticPosition& at = fix.position;
    return std::isfinite(at.latitude_deg + at.longitude_deg + at.altitude_m);
  });
  if (usable == gnss.fixes.end()) return;
  const GeodeticOrigin origin = usable->position;
  const auto aligned = align_gnss(trajectory, gnss.fixes, origin, gnss.antenna_in_imu, {});
  if (!aligned) return;
  const Rigid3 map_from_enu = aligned->enu_from_map.inverse();
  const double period_s =
      to_seconds(scans.back().time - scans.front().time) / static_cast<double>(segments.size());
  auto fix = gnss.fixes.begin();
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const Timestamp time = scans[segments[i].anchor].time;
    while (fix != gnss.fixes.end() && fix->time < time) ++fix;
    if (fix == gnss.fixes.end()) return;
    if (to_seconds(fix->time - time) > 0.5 * period_s) continue;
    // The vehicle has moved on by the time of the fix.
    const auto pose = interpolate(trajectory, fix->time, 0.0);
    const Eigen::Vector3d at = map_from_enu * enu_from_geodetic(origin, fix->position);
    if (!pose || !at.allFinite()) continue;
    const double stated_m = fix->sigma_enu_m.maxCoeff();
    const double sigma_m =
        stated_m > 0.0 && std::isfinite(stated_m) ? stated_m : kDefaultGnssSigma_m;
    graph.positions.push_back(
        {.pose = i,
         .lever_in_body =
             scans[segments[i].anchor].map_from_imu.inverse() * (*pose * gnss.antenna_in_imu),
         .point_in_map = at,
         .sigma_m = sigma_m * std::sqrt(std::max(1.0, kGnssCorrelation_s / period_s))});
  }
}

double total_strain(std::span<const RelativePose> odometry,
                    std::span<const Rigid3> map_from_segment) {
  double sum2 = 0.0;
  for (const RelativePose& edge : odometry) {
    const PoseVector r =
        residual_of(edge, map_from_segment[edge.first], map_from_segment[edge.second]);
    sum2 += r.dot(edge.information * r);
  }
  return std::sqrt(sum2);
}

}  // namespace hybridfusion
