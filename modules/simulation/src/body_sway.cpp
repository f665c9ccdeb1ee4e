#include "body_sway.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::size_t kUp = 2;
constexpr std::size_t kYaw = 3;
constexpr std::size_t kPitch = 4;
constexpr std::size_t kRoll = 5;

}  // namespace

void add_body_roll(const std::vector<double>& distance,
                   double roll_per_g_rad,
                   VehicleMotion::Channels& channels) {
  std::vector<double> lateral(distance.size(), 0.0);
  for (std::size_t i = 1; i < distance.size(); ++i) {
    const double speed = (distance[i] - distance[i - 1]) / kTimeStep_s;
    lateral[i] = speed * (channels[kYaw][i] - channels[kYaw][i - 1]) / kTimeStep_s;
  }
  if (lateral.size() > 1) lateral[0] = lateral[1];  // a rolling start may begin in a curve
  lateral = smoothed(lateral, 0.25 / kTimeStep_s, false);
  for (std::size_t i = 0; i < lateral.size(); ++i) {
    channels[kRoll][i] += roll_per_g_rad / 9.81 * lateral[i];
  }
}

void add_swing(const std::vector<double>& distance,
               double amplitude_rad,
               std::uint64_t seed,
               std::uint64_t index,
               VehicleMotion::Channels& channels) {
  if (amplitude_rad == 0.0) return;
  constexpr double kFullSwing_mps = 2.0;
  constexpr double kFade_s = 0.5;
  std::vector<double> share(distance.size(), 0.0);
  for (std::size_t i = 1; i < distance.size(); ++i) {
    const double speed = (distance[i] - distance[i - 1]) / kTimeStep_s;
    share[i] = std::min(1.0, speed / kFullSwing_mps);
  }
  share = smoothed(share, kFade_s / kTimeStep_s, false);
  Random random(seed, "vehicle/swing", index);
  for (const std::size_t channel : {kPitch, kRoll}) {
    const double period_s = random.uniform(2.0, 4.0);
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    for (std::size_t i = 0; i < share.size(); ++i) {
      const double time_s = static_cast<double>(i) * kTimeStep_s;
      channels[channel][i] +=
          amplitude_rad * share[i] * std::sin(2.0 * std::numbers::pi * time_s / period_s + phase);
    }
  }
}

void add_boat_sway(double amplitude_rad,
                   std::uint64_t seed,
                   std::uint64_t index,
                   VehicleMotion::Channels& channels) {
  if (amplitude_rad == 0.0) return;
  constexpr double kHeave_m = 1.7;  // for each radian of roll: 0.3 m at 10 degrees
  Random random(seed, "vehicle/boat-sway", index);
  const std::array<std::pair<std::size_t, double>, 3> parts = {
      {{kRoll, amplitude_rad}, {kPitch, 0.5 * amplitude_rad}, {kUp, kHeave_m * amplitude_rad}}};
  for (const auto& [channel, amplitude] : parts) {
    const double period_s = random.uniform(3.0, 6.0);
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    for (std::size_t i = 0; i < channels[channel].size(); ++i) {
      const double time_s = static_cast<double>(i) * kTimeStep_s;
      channels[channel][i] +=
          amplitude * std::sin(2.0 * std::numbers::pi * time_s / period_s + phase);
    }
  }
}

}  // namespace hybridfusion
