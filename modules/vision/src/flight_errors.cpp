#include "flight_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hybridfusion {
namespace {

constexpr double kMaxGap_s = 30.0;
constexpr double kSameDirection = 0.7;  // cosine
constexpr std::size_t kReach = 2;

/// Step from position k to k + 1, zero when they say nothing of a velocity.
Eigen::Vector3d step_velocity(std::span<const TimedPosition> track, std::size_t k) {
  const double duration_s = track[k + 1].time_s - track[k].time_s;
  const bool joined = track[k + 1].flight == track[k].flight;
  if (!joined || !(duration_s > 0.0) || duration_s > kMaxGap_s) return Eigen::Vector3d::Zero();
  return (track[k + 1].position - track[k].position) / duration_s;
}

Eigen::Vector3d slope(std::span<const TimedPosition> track) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double mean_time_s = 0.0;
  for (const TimedPosition& p : track) {
    mean += p.position / static_cast<double>(track.size());
    mean_time_s += p.time_s / static_cast<double>(track.size());
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double square = 0.0;
  for (const TimedPosition& p : track) {
    sum += (p.time_s - mean_time_s) * (p.position - mean);
    square += (p.time_s - mean_time_s) * (p.time_s - mean_time_s);
  }
  return square > 0.0 ? Eigen::Vector3d(sum / square) : Eigen::Vector3d::Zero();
}

}  // namespace

std::vector<Eigen::Vector3d> track_velocities(std::span<const TimedPosition> track) {
  std::vector<Eigen::Vector3d> steps(track.size() + 1, Eigen::Vector3d::Zero());
  // steps[k] leads to position k, steps[k + 1] away from it.
  for (std::size_t k = 0; k + 1 < track.size(); ++k) steps[k + 1] = step_velocity(track, k);
  std::vector<Eigen::Vector3d> velocities;
  for (std::size_t k = 0; k < track.size(); ++k) {
    // At a turn, the step that is nearer in time belongs to the leg of the photo.
    const bool has_before = steps[k].norm() > 0.0;
    const bool has_after = steps[k + 1].norm() > 0.0;
    const bool after = has_after && (!has_before || track[k + 1].time_s - track[k].time_s <
                                                        track[k].time_s - track[k - 1].time_s);
    const Eigen::Vector3d leg = after ? steps[k + 1] : steps[k];
    const auto continues = [&](const Eigen::Vector3d& step) {
      return step.dot(leg) > kSameDirection * step.norm() * leg.norm();
    };
    std::size_t first = k;
    std::size_t last = k;
    while (first > 0 && k - first < kReach && continues(steps[first])) --first;
    while (last + 1 < track.size() && last - k < kReach && continues(steps[last + 1])) ++last;
    velocities.push_back(slope(track.subspan(first, last - first + 1)));
  }
  return velocities;
}

std::vector<Eigen::Vector3d> view_velocities(const SfmModel& model, const GnssIngest& gnss) {
  std::vector<TimedPosition> track;
  std::vector<std::size_t> views;
  for (const std::size_t view : gnss.by_time) {
    if (!model.world_from_view[view]) continue;
    views.push_back(view);
    track.push_back({.position = model.world_from_view[view]->translation,
                     .flight = gnss.fixes[view].flight,
                     .time_s = gnss.fixes[view].flight_time_s});
  }
  const std::vector<Eigen::Vector3d> velocities = track_velocities(track);
  std::vector<Eigen::Vector3d> by_view(model.world_from_view.size(), Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < views.size(); ++k) by_view[views[k]] = velocities[k];
  return by_view;
}

}  // namespace hybridfusion
