#include "body_sway.hpp"
#include "vehicle_motion.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kBodyHeight_m = 0.95;
constexpr double kLateralLimit_mps2 = 1.8;
constexpr double kForwardLimit_mps2 = 1.3;

Eigen::Vector2d point_on(const DrivePlan& plan, double s) {
  const double slot = std::clamp(s / kPathStep_m, 0.0, static_cast<double>(plan.path.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(slot), plan.path.size() - 2);
  return plan.path[i] + (slot - static_cast<double>(i)) * (plan.path[i + 1] - plan.path[i]);
}

double curvature_at(const DrivePlan& plan, double s) {
  constexpr double kHalf = 1.0;
  const Eigen::Vector2d a = point_on(plan, s - kHalf);
  const Eigen::Vector2d b = point_on(plan, s);
  const Eigen::Vector2d c = point_on(plan, s + kHalf);
  const Eigen::Vector2d first = b - a;
  const Eigen::Vector2d second = c - b;
  const double turn =
      std::atan2(first.x() * second.y() - first.y() * second.x(), first.dot(second));
  return std::abs(turn) / std::max(0.1, 0.5 * (first.norm() + second.norm()));
}

/// Highest speed along the path when nothing exceeds `cruise`, the curve limits and the pedals.
std::vector<double> speed_profile(const DrivePlan& plan, double cruise) {
  std::vector<double> speed(plan.path.size());
  if (speed.empty()) return speed;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const double k = curvature_at(plan, static_cast<double>(i) * kPathStep_m);
    speed[i] = std::min(cruise, std::sqrt(kLateralLimit_mps2 / std::max(k, 1e-4)));
  }
  speed.front() = speed.back() = 0.35;
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

/// Distance along the path at every time step, standing still before and after.
std::vector<double> distance_over_time(const std::vector<double>& speed,
                                       double still_s,
                                       std::size_t steps) {
  std::vector<double> distance(steps, 0.0);
  std::size_t i = 1;
  double time = still_s;
  double next = time;
  for (std::size_t step = 0; step < steps; ++step) {
    const double now = (static_cast<double>(step) - 1.0) * kTimeStep_s;
    while (i < speed.size()) {
      next = time + kPathStep_m / (0.5 * (speed[i] + speed[i - 1]));
      if (next >= now) break;
      time = next;
      ++i;
    }
    const double length = static_cast<double>(speed.size() - 1) * kPathStep_m;
    if (now <= still_s) {
      distance[step] = 0.0;
    } else if (i >= speed.size()) {
      distance[step] = length;
    } else {
      distance[step] = (static_cast<double>(i - 1) + (now - time) / (next - time)) * kPathStep_m;
    }
  }
  return distance;
}

/// Smooth random height of the road surface as the springs pass it on, by place, not by time.
class Roughness {
 public:
  Roughness(double sd, Random& random, std::size_t count) {
    std::vector<double> white(count);
    for (double& value : white) value = random.normal();
    values_ = smoothed(white, 0.45 / kPathStep_m, false);
    double square = 0.0;
    for (const double value : values_) square += value * value;
    const double scale = sd / std::sqrt(square / static_cast<double>(count));
    for (double& value : values_) value *= scale;
  }
  [[nodiscard]] double at(double s) const {
    const double slot =
        std::clamp(s / kPathStep_m, 0.0, static_cast<double>(values_.size() - 1) - 1e-9);
    const auto i = static_cast<std::size_t>(slot);
    const double t = slot - static_cast<double>(i);
    return (1.0 - t) * values_[i] + t * values_[std::min(i + 1, values_.size() - 1)];
  }

 private:
  std::vector<double> values_ = {};
};

/// The route with the slowest cruise that still ends in time; one that cannot is cut short.
struct TimedRoute {
  DrivePlan route = {};
  std::vector<double> speed = {};  ///< Per path point [m/s].
};

TimedRoute fit_route(const DrivePlan& plan, double moving_s, double max_speed_mps) {
  TimedRoute timed{.route = plan};
  DrivePlan& route = timed.route;
  while (travel_time(speed_profile(route, max_speed_mps)) > moving_s && route.path.size() > 40) {
    route.path.resize(route.path.size() * 9 / 10);
  }
  double low = 0.3;
  double high = max_speed_mps;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (low + high);
    (travel_time(speed_profile(route, middle)) > moving_s ? low : high) = middle;
  }
  timed.speed = speed_profile(route, high);
  return timed;
}

/// Direction of travel, unit length.
Eigen::Vector2d heading_at(const DrivePlan& route, double s) {
  constexpr double kWheelbaseHalf_m = 0.6;
  const double length = static_cast<double>(route.path.size() - 1) * kPathStep_m;
  return (point_on(route, std::min(length, s + kWheelbaseHalf_m)) -
          point_on(route, std::max(0.0, s - kWheelbaseHalf_m)))
      .normalized();
}

/// Position and attitude at every time step from slope, roughness and, in curves, body roll.
class BodyPose {
 public:
  BodyPose(const DrivePlan& route, const Terrain& terrain, double bump_sd_m, Random& random)
      : route_(route),
        terrain_(terrain),
        bump_(bump_sd_m, random, route.path.size()),
        pitch_(0.22 * bump_sd_m, random, route.path.size()),
        roll_(0.28 * bump_sd_m, random, route.path.size()) {}

  void append(double s, VehicleMotion::Channels& channels) const {
    const Eigen::Vector2d at = point_on(route_, s);
    const Eigen::Vector2d ahead = heading_at(route_, s);
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    double yaw = std::atan2(ahead.y(), ahead.x()) + terrain_.frame().yaw_rad;
    if (!channels[3].empty()) {
      const double turns = (yaw - channels[3].back()) / (2.0 * std::numbers::pi);
      yaw -= 2.0 * std::numbers::pi * std::round(turns);
    }
    const double grade = (ground(at + 1.4 * ahead) - ground(at - 1.4 * ahead)) / 2.8;
    const double bank = (ground(at + 0.8 * left) - ground(at - 0.8 * left)) / 1.6;
    const Eigen::Vector3d body =
        terrain_.frame() *
        Eigen::Vector3d(at.x(), at.y(), ground(at) + kBodyHeight_m + bump_.at(s));
    const std::array values = {body.x(),
                               body.y(),
                               body.z(),
                               yaw,
                               -std::atan(grade) + pitch_.at(s),
                               std::atan(bank) + roll_.at(s)};
    for (std::size_t i = 0; i < values.size(); ++i) channels[i].push_back(values[i]);
  }

 private:
  [[nodiscard]] double ground(const Eigen::Vector2d& p) const {
    return terrain_.height(p.x(), p.y()) - (terrain_.plan().streets ? kKerbHeight_m : 0.0);
  }

  const DrivePlan& route_;
  const Terrain& terrain_;
  Roughness bump_;
  Roughness pitch_;
  Roughness roll_;
};

}  // namespace

Expected<VehicleMotion> drive(const DrivePlan& plan,
                              const Terrain& terrain,
                              const DriveOptions& options,
                              std::uint64_t seed,
                              std::uint64_t index) {
  constexpr double kStandAtEnd_s = 2.0;
  constexpr double kLeastMoving_s = 2.0;
  constexpr double kSoftening_s = 0.35;  // Sigma of the pedals' softness.
  // The softening spreads 3 sigma; it must not reach into the standstill.
  const double start_s = options.standstill_s + 3.0 * kSoftening_s;
  const double moving_s = options.duration_s - start_s - 3.0 * kSoftening_s - kStandAtEnd_s;
  if (moving_s < kLeastMoving_s) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("drive.duration_s = {} leaves {:.1f} s of driving after {} s of "
                            "standstill and {} s at the end; at least {} s are needed",
                            options.duration_s,
                            moving_s,
                            options.standstill_s,
                            kStandAtEnd_s,
                            kLeastMoving_s));
  }
  const TimedRoute timed = fit_route(plan, moving_s, options.max_speed_mps);
  const auto steps = static_cast<std::size_t>(std::lround(options.duration_s / kTimeStep_s)) + 3;
  const std::vector<double> distance =
      smoothed(distance_over_time(timed.speed, start_s, steps), kSoftening_s / kTimeStep_s, false);
  Random random(seed, "vehicle/roughness", index);
  const BodyPose pose(timed.route, terrain, options.bump_sd_m, random);
  VehicleMotion::Channels channels;
  for (const double s : distance) pose.append(s, channels);
  add_body_roll(distance, options.roll_per_lateral_g_deg * std::numbers::pi / 180.0, channels);
  add_swing(distance, options.swing_deg * std::numbers::pi / 180.0, seed, index, channels);
  return VehicleMotion(std::move(channels), kTimeStep_s);
}

}  // namespace hybridfusion
