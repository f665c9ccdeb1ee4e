#include "body_sway.hpp"
#include "speed_profile.hpp"
#include "vehicle_motion.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kBodyHeight_m = 0.95;

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
  while (travel_time(speed_profile(route, max_speed_mps, kCreep_mps)) > moving_s &&
         route.path.size() > 40) {
    route.path.resize(route.path.size() * 9 / 10);
  }
  double low = 0.3;
  double high = max_speed_mps;
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (low + high);
    (travel_time(speed_profile(route, middle, kCreep_mps)) > moving_s ? low : high) = middle;
  }
  timed.speed = speed_profile(route, high, kCreep_mps);
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

constexpr double kSoftening_s = 0.35;  // Sigma of the pedals' softness.

/// Distance at every control value of a drive that starts and ends at rest.
Expected<std::vector<double>> distance_from_rest(TimedRoute& timed,
                                                 const DriveOptions& options,
                                                 std::size_t steps) {
  constexpr double kStandAtEnd_s = 2.0;
  constexpr double kLeastMoving_s = 2.0;
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
  timed = fit_route(timed.route, moving_s, options.max_speed_mps);
  return smoothed(distance_at_times(timed.speed, start_s, -kTimeStep_s, steps),
                  kSoftening_s / kTimeStep_s,
                  false);
}

/// The same for a drive that rolls at its first moment and does not stop.
std::vector<double> distance_rolling(TimedRoute& timed,
                                     const DriveOptions& options,
                                     std::size_t steps) {
  // It sets off before the recording, by what the softening needs at either end.
  const auto lead = static_cast<std::size_t>(std::ceil(3.0 * kSoftening_s / kTimeStep_s)) + 1;
  const double lead_s = static_cast<double>(lead) * kTimeStep_s;
  timed.speed = speed_profile(timed.route, options.max_speed_mps, options.start_speed_mps);
  // Until the first sample, and for the softening's width after it, at the speed asked for.
  const auto held = static_cast<std::size_t>(2.0 * lead_s * options.start_speed_mps / kPathStep_m);
  for (std::size_t i = 0; i < std::min(held, timed.speed.size()); ++i) {
    timed.speed[i] = std::min(timed.speed[i], options.start_speed_mps);
  }
  const double first_s = -kTimeStep_s - lead_s;
  const std::vector<double> distance =
      smoothed(distance_at_times(timed.speed, first_s, first_s, steps + 2 * lead),
               kSoftening_s / kTimeStep_s,
               false);
  const auto begin = distance.begin() + static_cast<std::ptrdiff_t>(lead);
  return {begin, begin + static_cast<std::ptrdiff_t>(steps)};
}

}  // namespace

Expected<VehicleMotion> drive(const DrivePlan& plan,
                              const Terrain& terrain,
                              const DriveOptions& options,
                              std::uint64_t seed,
                              std::uint64_t index) {
  const auto steps = static_cast<std::size_t>(std::lround(options.duration_s / kTimeStep_s)) + 3;
  TimedRoute timed{.route = plan};
  std::vector<double> distance;
  if (options.start_speed_mps > 0.0) {
    distance = distance_rolling(timed, options, steps);
  } else {
    HF_TRY(distance, distance_from_rest(timed, options, steps));
  }
  Random random(seed, "vehicle/roughness", index);
  const BodyPose pose(timed.route, terrain, options.bump_sd_m, random);
  VehicleMotion::Channels channels;
  for (const double s : distance) pose.append(s, channels);
  add_body_roll(distance, options.roll_per_lateral_g_deg * std::numbers::pi / 180.0, channels);
  add_swing(distance, options.swing_deg * std::numbers::pi / 180.0, seed, index, channels);
  add_boat_sway(options.boat_sway_deg * std::numbers::pi / 180.0, seed, index, channels);
  return VehicleMotion(std::move(channels), kTimeStep_s);
}

}  // namespace hybridfusion
