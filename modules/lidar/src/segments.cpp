#include "segments.hpp"

#include "levelling.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxPointsPerScan = 4000;
constexpr float kMinClusterPoints = 3.0F;

constexpr float kMinPlanePoints = 6.0F;
constexpr float kMaxPlaneSigma_m = 0.06F;
constexpr float kMinFlatness = 9.0F;
constexpr float kMaxClusterWeight = 20.0F;
// Directions with a smaller mean squared cosine to the normals are held by errors of the normals
// alone.
constexpr double kMinCosine2 = 0.01;
// Tilt of the poses and changes of the accelerometer bias; noise of the accelerometer.
constexpr double kAccelSigma_mps2 = 0.01;
constexpr double kVelocitySigma_mps = 0.003;

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

bool is_bridged(const std::vector<StoredScan>& scans, std::size_t first, std::size_t last) {
  constexpr std::uint32_t kImuGap = static_cast<std::uint32_t>(ScanFlag::kImuGap);
  constexpr std::uint32_t kGap = static_cast<std::uint32_t>(ScanFlag::kLidarGap);
  return std::ranges::any_of(
      std::span(scans).subspan(first + 1, last - first), [](const StoredScan& scan) {
        return (scan.flags & (kImuGap | kGap)) != 0 || scan.since_last.bridged;
      });
}

namespace {

struct Face {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit
  double sigma_m = 0.0;                              // of the points about it
  /// Of the normal, by which noise of the points turns it.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

std::optional<Face> face_of(const PlaneCluster& cluster) {
  if (cluster.count < kMinPlanePoints) return std::nullopt;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(cluster.covariance);
  const Eigen::Vector3f& spread = solver.eigenvalues();
  if (!(spread[0] <= kMaxPlaneSigma_m * kMaxPlaneSigma_m) ||
      !(spread[1] >= kMinFlatness * spread[0])) {
    return std::nullopt;
  }
  Face face{.normal = solver.eigenvectors().col(0).cast<double>(),
            .sigma_m = std::sqrt(std::max(0.0, static_cast<double>(spread[0])))};
  for (int i = 1; i < 3; ++i) {
    const Eigen::Vector3d axis = solver.eigenvectors().col(i).cast<double>();
    const double lever2 = static_cast<double>(cluster.count) * static_cast<double>(spread[i]);
    face.covariance += face.sigma_m * face.sigma_m / lever2 * axis * axis.transpose();
  }
  return face;
}

}  // namespace

std::optional<Eigen::Vector3d> normal_of(const PlaneCluster& cluster) {
  const auto face = face_of(cluster);
  return face ? std::optional(face->normal) : std::nullopt;
}

void RangeNoise::add(std::span<const PlaneCluster> clusters,
                     const Eigen::Vector3d& lidar_in_segment) {
  // Few points fit their plane too well; a flat view shows the roughness along the ray instead.
  constexpr float kMinPoints = 15.0F;
  constexpr double kMinCosine = 0.5;
  for (const PlaneCluster& cluster : clusters) {
    if (cluster.count < kMinPoints) continue;
    const auto face = face_of(cluster);
    if (!face) continue;
    const Eigen::Vector3d ray = (cluster.mean.cast<double>() - lidar_in_segment).normalized();
    const double cosine = std::abs(face->normal.dot(ray));
    if (!(cosine >= kMinCosine)) continue;
    const double bin = face->sigma_m / cosine / kBin_m;
    ++counts_[std::min(static_cast<std::size_t>(bin), counts_.size() - 1)];
    ++total_;
  }
}

std::optional<double> RangeNoise::sigma_m() const {
  constexpr std::size_t kMinFaces = 200;
  if (total_ < kMinFaces) return std::nullopt;
  std::size_t below = 0;
  std::size_t bin = 0;
  while (2 * (below + counts_[bin]) < total_) below += counts_[bin++];
  return kBin_m * (static_cast<double>(bin) + 0.5);
}

Eigen::Matrix3d held_directions(std::span<const PlaneCluster> clusters,
                                const Rigid3& map_from_segment) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double sum_weights = 0.0;
  for (const PlaneCluster& cluster : clusters) {
    const auto face = face_of(cluster);
    if (!face) continue;
    const double weight = std::min(cluster.count, kMaxClusterWeight);
    const Eigen::Matrix3d map_axes = map_from_segment.rotation.toRotationMatrix();
    // Without what the noise of the normals adds on average, or a bare tunnel would seem to be
    // held.
    sum += weight * map_axes * (face->normal * face->normal.transpose() - face->covariance) *
           map_axes.transpose();
    sum_weights += weight;
  }
  Eigen::Matrix3d held = Eigen::Matrix3d::Identity();
  if (sum_weights == 0.0) return held;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] >= kMinCosine2 * sum_weights) continue;
    held -= solver.eigenvectors().col(i) * solver.eigenvectors().col(i).transpose();
  }
  return held;
}

std::vector<VelocityChange> velocity_changes(const std::vector<Segment>& segments,
                                             const std::vector<StoredScan>& scans,
                                             std::span<const Eigen::Matrix3d> held) {
  std::vector<VelocityChange> changes;
  const auto fit = fit_gravity(scans);
  if (!fit) return changes;
  for (std::uint32_t k = 1; k + 1 < segments.size(); ++k) {
    const Eigen::Matrix3d open = Eigen::Matrix3d::Identity() - held[k];
    if (open.isZero(1e-9)) continue;
    const std::size_t middle = segments[k].anchor;
    const auto measured = inertial_velocity_change(
        scans, segments[k - 1].anchor, middle, segments[k + 1].anchor, *fit);
    if (!measured) continue;
    const double period_s = 0.5 * (measured->before_s + measured->behind_s);
    const double sigma_mps = std::hypot(kAccelSigma_mps2 * period_s, kVelocitySigma_mps);
    const Eigen::Matrix3d rotation = scans[middle].map_from_imu.rotation.toRotationMatrix();
    changes.push_back(
        {.middle = k,
         .before_s = measured->before_s,
         .behind_s = measured->behind_s,
         .in_middle_mps = rotation.transpose() * measured->in_map_mps,
         .information = rotation.transpose() * open * rotation / (sigma_mps * sigma_mps)});
  }
  return changes;
}

std::vector<Rigid3> anchor_poses(const std::vector<Segment>& segments,
                                 const std::vector<StoredScan>& scans) {
  std::vector<Rigid3> poses;
  poses.reserve(segments.size());
  for (const Segment& segment : segments) poses.push_back(scans[segment.anchor].map_from_imu);
  return poses;
}

}  // namespace hybridfusion
