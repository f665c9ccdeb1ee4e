#include "speed_profile.hpp"

#include "body_sway.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kLateralLimit_mps2 = 1.8;
constexpr double kForwardLimit_mps2 = 1.3;

double curvature_at(const DrivePlan& plan, double s) {
  constexpr double kHalf = 1.0;
  // An end has no second direction: its curvature is that of its neighbourhood.
  const double length = static_cast<double>(plan.path.size() - 1) * kPathStep_m;
  if (length > 2.0 * kHalf) s = std::clamp(s, kHalf, length - kHalf);
  const Eigen::Vector2d a = point_on(plan, s - kHalf);
  const Eigen::Vector2d b = point_on(plan, s);
  const Eigen::Vector2d c = point_on(plan, s + kHalf);
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - b;
  const double turn =
      std::atan2(first.x() * second.y() - first.y() * second.x(), first.dot(second));
  return std::abs(turn) / std::max(0.1, 0.5 * (first.norm() + second.norm()));
}

}  // namespace

Eigen::Vector2d point_on(const DrivePlan& plan, double s) {
  const double slot = std::clamp(s / kPathStep_m, 0.0, static_cast<double>(plan.path.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(slot), plan.path.size() - 2);
  return plan.path[i] + (slot - static_cast<double>(i)) * (plan.path[i + 1] - plan.path[i]);
}

std::vector<double> speed_profile(const DrivePlan& plan, double cruise, double start_mps) {
  std::vector<double> speed(plan.path.size());
  if (speed.empty()) return speed;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const double k = curvature_at(plan, static_cast<double>(i) * kPathStep_m);
    speed[i] = std::min(cruise, std::sqrt(kLateralLimit_mps2 / std::max(k, 1e-4)));
  }
  speed.front() = std::min(speed.front(), start_mps);
  speed.back() = kCreep_mps;
  const double gain = 2.0 * kForwardLimit_mps2 * kPathStep_m;
  for (std::size_t i = 1; i < speed.size(); ++i) {
    speed[i] = std::min(speed[i], std::sqrt(speed[i - 1] * speed[i - 1] + gain));
  }
  for (std::size_t i = speed.size() - 1; i-- > 0;) {
    speed[i] = std::min(speed[i], std::sqrt(speed[i + 1] * speed[i + 1] + gain));
  }
  return speed;
}

double travel_time(const std::vector<double>& speed) {
  double time = 0.0;
  for (std::size_t i = 1; i < speed.size(); ++i) {
    time += kPathStep_m / (0.5 * (speed[i] + speed[i - 1]));
  }
  return time;
}

std::vector<double> distance_at_times(const std::vector<double>& speed,
                                      double depart_s,
                                      double first_s,
                                      std::size_t steps) {
  std::vector<double> distance(steps, 0.0);
  std::size_t i = 1;
  double time = depart_s;
  double next = time;
  for (std::size_t step = 0; step < steps; ++step) {
    const double now = first_s + static_cast<double>(step) * kTimeStep_s;
    while (i < speed.size()) {
      next = time + kPathStep_m / (0.5 * (speed[i] + speed[i - 1]));
      if (next >= now) break;
      time = next;
      ++i;
    }
    const double length = static_cast<double>(speed.size() - 1) * kPathStep_m;
    if (now <= depart_s) {
      distance[step] = 0.0;
    } else if (i >= speed.size()) {
      distance[step] = length;
    } else {
      distance[step] = (static_cast<double>(i - 1) + (now - time) / (next - time)) * kPathStep_m;
    }
  }
  return distance;
}

}  // namespace hybridfusion
