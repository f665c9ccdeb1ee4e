#include "drive_errors.hpp"

#include <hybridfusion/evaluation/trajectory_error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hybridfusion::benchmark {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Pair {
  double path_m = 0.0;  // along the reference
  Rigid3 reference = {};
  Rigid3 estimate = {};
};

std::vector<Pair> common_pairs(const Trajectory& reference, const Trajectory& estimate) {
  std::vector<Pair> pairs;
  for (const StampedPose& pose : estimate.poses) {
    const auto true_pose = interpolate(reference, pose.time, 0.0);
    if (!true_pose) continue;
    Pair pair{.reference = *true_pose, .estimate = pose.map_from_body};
    if (!pairs.empty()) {
      pair.path_m = pairs.back().path_m +
                    (true_pose->translation - pairs.back().reference.translation).norm();
    }
    pairs.push_back(pair);
  }
  return pairs;
}

/// Motions over a segment, each in the frame of the body at its start.
struct Motion {
  Rigid3 reference = {};
  Rigid3 estimate = {};
  double length_m = 0.0;
};

std::vector<Motion> motions_over(const std::vector<Pair>& pairs, double length_m) {
  std::vector<Motion> motions;
  std::size_t j = 0;
  for (const Pair& from : pairs) {
    while (j < pairs.size() && pairs[j].path_m < from.path_m + length_m) ++j;
    if (j == pairs.size()) break;
    motions.push_back({.reference = from.reference.inverse() * pairs[j].reference,
                       .estimate = from.estimate.inverse() * pairs[j].estimate,
                       .length_m = pairs[j].path_m - from.path_m});
  }
  return motions;
}

/// The smallest turn that takes the mean estimated motion to the mean true one; none when it is too
/// large to be one of calibration.
Eigen::Quaterniond body_turn(const std::vector<Motion>& motions) {
  constexpr double kLargest_rad = 3.0 * kDegree;
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();
  Eigen::Vector3d estimate = Eigen::Vector3d::Zero();
  for (const Motion& motion : motions) {
    reference += motion.reference.translation;
    estimate += motion.estimate.translation;
  }
  if (reference.norm() == 0.0 || estimate.norm() == 0.0) return Eigen::Quaterniond::Identity();
  const auto turn = Eigen::Quaterniond::FromTwoVectors(estimate, reference);
  return turn.angularDistance(Eigen::Quaterniond::Identity()) < kLargest_rad
             ? turn
             : Eigen::Quaterniond::Identity();
}

SegmentError segment_error(const std::vector<Motion>& motions, const Eigen::Quaterniond& turn) {
  SegmentError error{.num_segments = motions.size()};
  if (motions.empty()) return error;
  error.translation_percent = error.turned_percent = error.rotation_deg = 0.0;
  const auto count = static_cast<double>(motions.size());
  for (const Motion& motion : motions) {
    const double share = 100.0 / (motion.length_m * count);
    const Eigen::Vector3d& true_way = motion.reference.translation;
    error.translation_percent += share * (motion.estimate.translation - true_way).norm();
    error.turned_percent += share * (turn * motion.estimate.translation - true_way).norm();
    error.rotation_deg +=
        motion.reference.rotation.angularDistance(motion.estimate.rotation) / kDegree / count;
  }
  return error;
}

/// Rms angle between the vertical of both after the turn about it that fits all orientations best.
double tilt_deg(const std::vector<Pair>& pairs) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Pair& pair : pairs) {
    sum += (pair.reference.rotation * pair.estimate.rotation.conjugate()).toRotationMatrix();
  }
  const double yaw = std::atan2(sum(1, 0) - sum(0, 1), sum(0, 0) + sum(1, 1));
  const Eigen::Quaterniond level(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  double square = 0.0;
  for (const Pair& pair : pairs) {
    const Eigen::Vector3d up = level * pair.estimate.rotation *
                               (pair.reference.rotation.conjugate() * Eigen::Vector3d::UnitZ());
    square += std::pow(std::acos(std::clamp(up.z(), -1.0, 1.0)) / kDegree, 2);
  }
  return std::sqrt(square / static_cast<double>(pairs.size()));
}

double length_m(const std::vector<Pair>& pairs) {
  double length = 0.0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    length += (pairs[i].estimate.translation - pairs[i - 1].estimate.translation).norm();
  }
  return length;
}

}  // namespace

Expected<DriveErrors> drive_errors(const Trajectory& reference, const Trajectory& estimate) {
  HF_TRY(const TrajectoryErrors aligned, trajectory_errors(reference, estimate));
  const std::vector<Pair> pairs = common_pairs(reference, estimate);
  DriveErrors errors{.num_poses = pairs.size(),
                     .path_m = pairs.back().path_m,
                     .path_ratio = length_m(pairs) / std::max(1e-9, pairs.back().path_m),
                     .ate_m = aligned.ate_rmse_m,
                     .ate_max_m = aligned.ate_max_m,
                     .tilt_deg = tilt_deg(pairs),
                     .reference_from_map = aligned.truth_from_map};
  const Eigen::Quaterniond turn = body_turn(motions_over(pairs, kSegments_m.front()));
  errors.misalignment_deg = turn.angularDistance(Eigen::Quaterniond::Identity()) / kDegree;
  for (std::size_t i = 0; i < kSegments_m.size(); ++i) {
    errors.segments[i] = segment_error(motions_over(pairs, kSegments_m[i]), turn);
  }
  return errors;
}

double plane_thickness_m(const PointCloud& cloud) {
  constexpr std::size_t kLeastPoints = 30;
  constexpr double kFlat = 0.3;    // deviation over that along the shorter side
  constexpr double kWide_m = 0.1;  // a plane, not a line
  std::map<std::tuple<int, int, int>, std::vector<Eigen::Vector3d>> cubes;
  for (const Eigen::Vector3f& point : cloud.points) {
    const Eigen::Vector3i cube = point.array().floor().cast<int>();
    cubes[{cube.x(), cube.y(), cube.z()}].push_back(point.cast<double>());
  }
  std::vector<double> deviations;
  for (const auto& [cube, points] : cubes) {
    if (points.size() < kLeastPoints) continue;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& point : points) mean += point / static_cast<double>(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& point : points) {
      covariance +=
          (point - mean) * (point - mean).transpose() / static_cast<double>(points.size());
    }
    const Eigen::Vector3d sides = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance)
                                      .eigenvalues()
                                      .cwiseMax(0.0)
                                      .cwiseSqrt();
    if (sides[1] > kWide_m && sides[0] < kFlat * sides[1]) deviations.push_back(sides[0]);
  }
  if (deviations.empty()) return -1.0;
  const auto middle = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
  std::ranges::nth_element(deviations, middle);
  return *middle;
}

}  // namespace hybridfusion::benchmark
