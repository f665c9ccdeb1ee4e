#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// What is wrong with a recording; the defaults leave it sound. sensors.yaml knows of none of it.
struct FaultOptions {
  std::string imu_turn = "none";
  bool second_imu = false;
  bool gravity_removed = false;
  double gyro_scale = 1.0;
  double accel_scale = 1.0;
  double imu_delay_s = 0.0;
  double gnss_stretch = 1.0;
};
template <>
struct OptionFields<FaultOptions> {
  using T = FaultOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::imu_turn,
            {.key = "imu_turn",
             .choices = "none|x90|y90|z90|upside-down|swap-xy",
             .doc = "The IMU is mounted turned about that axis, upside down, or its driver mixes "
                    "up x and y (a mirror).",
             .source = "ours"}},
      Field{&T::second_imu,
            {.key = "second_imu",
             .doc = "A second IMU, turned by 90 degrees, writes to the same topic under the frame "
                    "imu_rear.",
             .source = "ours"}},
      Field{&T::gravity_removed,
            {.key = "gravity_removed",
             .doc = "The accelerometer delivers acceleration without gravity.",
             .source = "ours"}},
      Field{&T::gyro_scale,
            {.key = "gyro_scale",
             .unit = "1",
             .min = 1e-3,
             .max = 1e3,
             .doc = "Factor on the rates: 57.2958 is degrees for radians.",
             .source = "ours"}},
      Field{&T::accel_scale,
            {.key = "accel_scale",
             .unit = "1",
             .min = 1e-3,
             .max = 1e3,
             .doc = "Factor on the accelerations: 0.101972 is g for m/s^2.",
             .source = "ours"}},
      Field{&T::imu_delay_s,
            {.key = "imu_delay_s",
             .unit = "s",
             .min = -10,
             .max = 10,
             .doc = "Added to the header stamps of the IMU.",
             .source = "ours"}},
      Field{&T::gnss_stretch,
            {.key = "gnss_stretch",
             .unit = "1",
             .min = 0,
             .max = 10,
             .doc = "The GNSS track of the vehicle is this much longer than its way, with the "
                    "stated sigmas of a sound one.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
