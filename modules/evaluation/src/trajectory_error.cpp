#include "statistics.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/evaluation/trajectory_error.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct PosePair {
  double time_s = 0.0;  // since the first common pose
  double path_m = 0.0;  // along the true path
  Rigid3 truth_from_body;
  Rigid3 map_from_body;
};

std::vector<PosePair> common_poses(const Trajectory& truth, const Trajectory& estimate) {
  std::vector<PosePair> pairs;
  for (const StampedPose& pose : estimate.poses) {
    const auto true_pose = interpolate(truth, pose.time, 0.0);
    if (!true_pose) continue;
    PosePair pair{.truth_from_body = *true_pose, .map_from_body = pose.map_from_body};
    pair.time_s = to_seconds(pose.time - estimate.poses.front().time);
    if (!pairs.empty()) {
      const Eigen::Vector3d step =
          true_pose->translation - pairs.back().truth_from_body.translation;
      pair.path_m = pairs.back().path_m + step.norm();
    }
    pairs.push_back(pair);
  }
  return pairs;
}

/// Pairs each pose with the first later one that is at least `step` further along `coordinate`.
RelativeErrors relative_errors(const std::vector<PosePair>& pairs,
                               double PosePair::* coordinate,
                               double step) {
  RelativeErrors result;
  double translation = 0.0;
  double rotation = 0.0;
  std::size_t j = 0;
  constexpr double kTolerance = 1e-3;  // stamps of a 10 Hz sensor jitter below a millisecond
  for (const PosePair& from : pairs) {
    while (j < pairs.size() && pairs[j].*coordinate < from.*coordinate + step - kTolerance) ++j;
    if (j == pairs.size()) break;
    const Rigid3 true_motion = from.truth_from_body.inverse() * pairs[j].truth_from_body;
    const Rigid3 motion = from.map_from_body.inverse() * pairs[j].map_from_body;
    const Rigid3 error = true_motion.inverse() * motion;
    translation += error.translation.squaredNorm();
    rotation += std::pow(rotation_distance_rad(error.rotation, Eigen::Quaterniond::Identity()), 2);
    ++result.num_pairs;
  }
  if (result.num_pairs == 0) return result;
  const auto count = static_cast<double>(result.num_pairs);
  result.translation_rmse_m = std::sqrt(translation / count);
  result.rotation_rmse_deg = to_deg(std::sqrt(rotation / count));
  return result;
}

/// Positions determine the alignment unless the path is one straight line; then points one metre
/// along the body's axes stand in for the missing directions.
Expected<Sim3> align(const std::vector<PosePair>& pairs) {
  std::vector<Eigen::Vector3d> truth;
  std::vector<Eigen::Vector3d> map;
  const auto append = [&](const Eigen::Vector3d& point_in_body) {
    for (const PosePair& pair : pairs) {
      truth.push_back(pair.truth_from_body * point_in_body);
      map.push_back(pair.map_from_body * point_in_body);
    }
  };
  append(Eigen::Vector3d::Zero());
  if (auto similarity = fit_sim3(truth, map)) return similarity;
  append(Eigen::Vector3d::UnitX());
  append(Eigen::Vector3d::UnitY());
  append(Eigen::Vector3d::UnitZ());
  return fit_sim3(truth, map);
}

/// As align(), with the scale held at 1: the similarity's rotation is already the best one.
Rigid3 without_scale(const Sim3& truth_from_map, const std::vector<PosePair>& pairs) {
  Eigen::Vector3d true_mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const PosePair& pair : pairs) {
    true_mean += pair.truth_from_body.translation;
    mean += pair.map_from_body.translation;
  }
  const auto count = static_cast<double>(pairs.size());
  return {.rotation = truth_from_map.rotation,
          .translation = true_mean / count - truth_from_map.rotation * (mean / count)};
}

void measure_absolute(const std::vector<PosePair>& pairs, TrajectoryErrors& result) {
  double translation = 0.0;
  double rotation = 0.0;
  for (const PosePair& pair : pairs) {
    const Rigid3 aligned = result.truth_from_map * pair.map_from_body;
    const double distance = (aligned.translation - pair.truth_from_body.translation).norm();
    translation += distance * distance;
    result.ate_max_m = std::max(result.ate_max_m, distance);
    rotation += std::pow(rotation_distance_rad(aligned.rotation, pair.truth_from_body.rotation), 2);
  }
  const auto count = static_cast<double>(pairs.size());
  result.ate_rmse_m = std::sqrt(translation / count);
  result.rotation_rmse_deg = to_deg(std::sqrt(rotation / count));
}

}  // namespace

Expected<TrajectoryErrors> trajectory_errors(const Trajectory& truth, const Trajectory& estimate) {
  const std::vector<PosePair> pairs = common_poses(truth, estimate);
  if (pairs.size() < 3) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("only {} of {} estimated poses lie in the time span of the truth; "
                            "at least 3 are needed, check that both use the same clock",
                            pairs.size(),
                            estimate.poses.size()));
  }
  TrajectoryErrors result{.num_poses = pairs.size(), .path_m = pairs.back().path_m};
  HF_TRY(const Sim3 similarity, align(pairs));
  result.truth_from_map = without_scale(similarity, pairs);
  result.scale_error = 1.0 / similarity.scale - 1.0;
  result.tilt_deg = tilt_deg(result.truth_from_map.rotation);
  measure_absolute(pairs, result);
  result.over_1_s = relative_errors(pairs, &PosePair::time_s, 1.0);
  result.over_50_m = relative_errors(pairs, &PosePair::path_m, 50.0);
  return result;
}

}  // namespace hybridfusion
