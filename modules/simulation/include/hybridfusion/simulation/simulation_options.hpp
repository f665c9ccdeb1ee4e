#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/options.hpp>
#include <hybridfusion/simulation/fault_options.hpp>
#include <hybridfusion/simulation/flight_options.hpp>
#include <hybridfusion/simulation/inertial_options.hpp>
#include <hybridfusion/simulation/vehicle_options.hpp>
#include <hybridfusion/simulation/world_options.hpp>

#include <string_view>

namespace hybridfusion {

/// Everything simulate() can be told.
struct SimulationOptions {
  WorldOptions world = {};
  CameraOptions camera = {};
  FlightOptions flight = {};
  DriveOptions drive = {};
  LidarModelOptions lidar = {};
  ImuModelOptions imu = {};
  GnssModelOptions gnss = {};
  FaultOptions faults = {};
  double samples_per_m2 = 6.0;
};
template <>
struct OptionFields<SimulationOptions> {
  using T = SimulationOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::world, {.key = "world"}},
      Field{&T::camera, {.key = "camera"}},
      Field{&T::flight, {.key = "flight"}},
      Field{&T::drive, {.key = "drive"}},
      Field{&T::lidar, {.key = "lidar"}},
      Field{&T::imu, {.key = "imu"}},
      Field{&T::gnss, {.key = "gnss"}},
      Field{&T::faults, {.key = "faults"}},
      Field{&T::samples_per_m2,
            {.key = "samples_per_m2",
             .unit = "1/m^2",
             .min = 0.1,
             .max = 100,
             .doc = "Density of truth/samples.ply.",
             .source = "ours"}},
  };
};

/// The options of a named preset: "small" (24 photos 1200x900, 60 m block, 40 s drive), "paper"
/// (29 photos 1600x1200, 80 m block with one main building, 50 s; `main_building` 1 unless set) or
/// "city" (5 x 4 blocks, several hundred photos, four drives).
/// @returns kInvalidOptions naming the presets for another name.
[[nodiscard]] Expected<SimulationOptions> simulation_preset(std::string_view name);

}  // namespace hybridfusion
