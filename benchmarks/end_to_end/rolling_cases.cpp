#include "rolling_cases.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

struct Fault {
  const char* name;
  FaultOptions options;
};

// What users' recordings have had, and the least of each that no estimator can overlook.
const std::array<Fault, 11>& faults() {
  static const std::array<Fault, 11> all = {{
      {"imu turned about x", {.imu_turn = "x90"}},
      {"imu turned about z", {.imu_turn = "z90"}},
      {"imu upside down", {.imu_turn = "upside-down"}},
      {"x and y swapped", {.imu_turn = "swap-xy"}},
      {"two imus", {.second_imu = true}},
      {"rates in deg/s", {.gyro_scale = 57.2958}},
      {"rates 1.3 times", {.gyro_scale = 1.3}},
      {"accelerations in g", {.accel_scale = 0.101972}},
      {"gravity removed", {.gravity_removed = true}},
      {"imu 1 s late", {.imu_delay_s = 1.0}},
      {"gnss track doubled", {.gnss_stretch = 2.0}},
  }};
  return all;
}

std::string add_lidar(Random& random, SimulationOptions& options) {
  const double choice = random.uniform();
  if (choice < 0.4) {
    options.lidar.model = "avia";
    options.lidar.avia_rays = 12000;
    options.lidar.message = "pointcloud2";
    return "rosette";
  }
  options.lidar.beams = choice < 0.7 ? 16 : 32;
  options.lidar.columns = choice < 0.7 ? 900 : 600;
  if (options.lidar.beams == 16) {
    options.lidar.lowest_deg = -15.0;
    options.lidar.highest_deg = 15.0;
  }
  return fmt::format("{} lines", options.lidar.beams);
}

/// Straight, turning, weaving, climbing or swaying. @returns its name.
std::string add_motion(Random& random, double& speed_mps, SimulationOptions& options) {
  constexpr std::array<const char*, 5> kKinds = {
      "straight", "corner", "weaving", "climbing", "swaying"};
  const std::string kind = kKinds[random.index(kKinds.size())];
  options.drive.start_place = kind == "corner" ? "corner" : "straight";
  if (kind == "corner") speed_mps = std::min(speed_mps, 4.0);  // of 5 m radius: 3.2 m/s^2
  if (kind == "weaving") options.drive.weave_m = 1.0;
  if (kind == "climbing") options.world.relief_m = 8.0;
  if (kind == "swaying") {
    speed_mps = std::min(speed_mps, 8.0);
    options.drive.boat_sway_deg = random.uniform(3.0, 10.0);
  }
  return kind;
}

}  // namespace

RollingCase rolling_case(int number, std::uint64_t seed) {
  const auto index = static_cast<std::uint64_t>(number);
  Random random(seed, "rolling-starts", index);
  RollingCase out{.number = number, .seed = seed + 1000 * (index + 1)};
  SimulationOptions& options = out.simulation;
  options.flight.enabled = false;
  options.samples_per_m2 = 0.1;
  options.world.ambient_rays = 4;
  out.speed_mps = random.uniform(0.5, 30.0);
  const std::string motion = add_motion(random, out.speed_mps, options);
  const std::string lidar = add_lidar(random, options);
  constexpr std::array<double, 6> kRates_hz = {10, 20, 50, 100, 200, 400};
  options.imu.rate_hz = kRates_hz[random.index(kRates_hz.size())];
  options.imu.vibration = random.uniform() < 0.5 ? "car" : "none";
  options.drive.duration_s = 12.0;
  options.drive.start_speed_mps = out.speed_mps;
  options.drive.max_speed_mps = std::min(30.0, 1.2 * out.speed_mps + 2.0);
  // Bumps are drawn each quarter metre: without this a fast car would feel many g.
  options.drive.bump_sd_m = 0.008 * std::min(1.0, std::pow(3.0 / out.speed_mps, 2));
  // A straight long enough to brake from the speed (1.3 m/s^2).
  options.world.size_m = 90.0;
  options.world.blocks_x =
      std::clamp(static_cast<int>(std::ceil(out.speed_mps * out.speed_mps / 2.6 / 60.0)), 1, 6);
  constexpr int kEachFifth = 5;
  if (number % kEachFifth == kEachFifth - 1) {
    const Fault& fault = faults()[(index / kEachFifth) % faults().size()];
    out.fault = fault.name;
    options.faults = fault.options;
  }
  out.text = fmt::format("{:.1f} m/s {}, {}, IMU {:.0f} Hz{}",
                         out.speed_mps,
                         motion,
                         lidar,
                         options.imu.rate_hz,
                         options.imu.vibration == "car" ? " vibrating" : "");
  return out;
}

}  // namespace hybridfusion::benchmark
