#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// The vehicle's IMU.
struct ImuModelOptions {
  double rate_hz = 200.0;
  double gyro_noise_density = 2.4e-4;
  double accel_noise_density = 1.7e-3;
  double gyro_bias_sd_radps = 0.004;
  double accel_bias_sd_mps2 = 0.03;
  double gyro_bias_walk = 2e-5;
  double accel_bias_walk = 2e-4;
  std::string vibration = "none";
};
template <>
struct OptionFields<ImuModelOptions> {
  using T = ImuModelOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::rate_hz,
            {.key = "rate_hz",
             .unit = "Hz",
             .min = 1,
             .max = 2000,
             .doc = "Samples a second.",
             .source = "ours"}},
      Field{&T::gyro_noise_density,
            {.key = "gyro_noise_density",
             .unit = "rad/s/sqrt(Hz)",
             .min = 0,
             .max = 0.1,
             .doc = "White noise of the gyroscope.",
             .source = "ours"}},
      Field{&T::accel_noise_density,
            {.key = "accel_noise_density",
             .unit = "m/s^2/sqrt(Hz)",
             .min = 0,
             .max = 1,
             .doc = "White noise of the accelerometer.",
             .source = "ours"}},
      Field{&T::gyro_bias_sd_radps,
            {.key = "gyro_bias_sd_radps",
             .unit = "rad/s",
             .min = 0,
             .max = 0.5,
             .doc = "Gyroscope bias at the start per axis, 1 sigma.",
             .source = "ours"}},
      Field{&T::accel_bias_sd_mps2,
            {.key = "accel_bias_sd_mps2",
             .unit = "m/s^2",
             .min = 0,
             .max = 2,
             .doc = "Accelerometer bias at the start per axis, 1 sigma.",
             .source = "ours"}},
      Field{&T::gyro_bias_walk,
            {.key = "gyro_bias_walk",
             .unit = "rad/s^2/sqrt(Hz)",
             .min = 0,
             .max = 0.1,
             .doc = "Random walk of the gyroscope bias.",
             .source = "ours"}},
      Field{&T::accel_bias_walk,
            {.key = "accel_bias_walk",
             .unit = "m/s^3/sqrt(Hz)",
             .min = 0,
             .max = 1,
             .doc = "Random walk of the accelerometer bias.",
             .source = "ours"}},
      Field{&T::vibration,
            {.key = "vibration",
             .choices = "none|car",
             .doc = "car: engine and road as an OXTS RT3003 on a car feels them at walking pace, "
                    "the road's share growing with the root of the speed.",
             .source = "KITTI raw 2011_09_29, 100 Hz, 110 s: band rms by Welch's method"}},
  };
};

/// Both GNSS receivers.
struct GnssModelOptions {
  double sigma_horizontal_m = 1.5;
  double sigma_vertical_m = 3.0;
  bool rtk = false;
  double correlation_s = 300.0;
  double rate_hz = 5.0;
};
template <>
struct OptionFields<GnssModelOptions> {
  using T = GnssModelOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::sigma_horizontal_m,
            {.key = "sigma_horizontal_m",
             .unit = "m",
             .min = 0,
             .max = 50,
             .doc = "Total error east and north, each 1 sigma.",
             .source = "ours"}},
      Field{&T::sigma_vertical_m,
            {.key = "sigma_vertical_m",
             .unit = "m",
             .min = 0,
             .max = 100,
             .doc = "Total error up, 1 sigma.",
             .source = "ours"}},
      Field{&T::rtk,
            {.key = "rtk", .doc = "RTK fixed: 3 cm in all axes instead.", .source = "ours"}},
      Field{&T::correlation_s,
            {.key = "correlation_s",
             .unit = "s",
             .min = 1,
             .max = 1e5,
             .doc = "Time constant of the slow part.",
             .source = "ours"}},
      Field{&T::rate_hz,
            {.key = "rate_hz",
             .unit = "Hz",
             .min = 0.1,
             .max = 50,
             .doc = "Fixes a second of the "
                    "vehicle's receiver.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
