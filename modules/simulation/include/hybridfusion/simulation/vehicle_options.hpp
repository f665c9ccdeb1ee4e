#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// The vehicle's way and what it records.
struct DriveOptions {
  bool enabled = true;
  int drives = 1;
  double duration_s = 50.0;
  double standstill_s = 3.0;
  double max_speed_mps = 12.0;
  double loop_overlap_m = 12.0;
  std::string route = "loop";
  double swing_deg = 0.0;
  double start_speed_mps = 0.0;
  std::string start_place = "random";
  double weave_m = 0.0;
  double boat_sway_deg = 0.0;
  double bump_sd_m = 0.008;
  double roll_per_lateral_g_deg = 3.0;
  double camera_hz = 0.0;
  std::string compression = "lz4";
};
template <>
struct OptionFields<DriveOptions> {
  using T = DriveOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled, {.key = "enabled", .doc = "Make the street recording.", .source = "ours"}},
      Field{&T::drives,
            {.key = "drives",
             .unit = "1",
             .min = 1,
             .max = 50,
             .doc = "Recordings: street.bag, street_2.bag, ..., each around its own group of "
                    "blocks.",
             .source = "ours"}},
      Field{&T::duration_s,
            {.key = "duration_s",
             .unit = "s",
             .min = 8,
             .max = 3600,
             .doc = "Length of a recording; the cruising speed follows from it and the path.",
             .source = "ours"}},
      Field{&T::standstill_s,
            {.key = "standstill_s",
             .unit = "s",
             .min = 0,
             .max = 60,
             .doc = "Standstill at the start.",
             .source = "ours"}},
      Field{&T::max_speed_mps,
            {.key = "max_speed_mps",
             .unit = "m/s",
             .min = 0.5,
             .max = 30,
             .doc = "Speed never exceeded; a short recording then ends before its loop closes.",
             .source = "ours"}},
      Field{&T::loop_overlap_m,
            {.key = "loop_overlap_m",
             .unit = "m",
             .min = 0,
             .max = 1000,
             .doc = "How far the vehicle drives on after closing the loop.",
             .source = "ours"}},
      Field{&T::route,
            {.key = "route",
             .choices = "loop|figure-eight",
             .doc = "loop: around its blocks; figure-eight: left around the first block, right "
                    "around the second (at least two blocks along x).",
             .source = "ours"}},
      Field{&T::swing_deg,
            {.key = "swing_deg",
             .unit = "deg",
             .min = 0,
             .max = 40,
             .doc = "Roll and pitch swing by up to this angle while driving, as a sensor carried "
                    "by hand or over rough ground does.",
             .source = "ours"}},
      Field{&T::start_speed_mps,
            {.key = "start_speed_mps",
             .unit = "m/s",
             .min = 0,
             .max = 30,
             .doc = "Speed at the first sample, as far as the next curve allows; then there is no "
                    "standstill at either end and the drive goes on at up to max_speed_mps.",
             .source = "ours"}},
      Field{&T::start_place,
            {.key = "start_place",
             .choices = "random|straight|corner",
             .doc = "Where on its loop a drive begins: anywhere, behind a corner, in one.",
             .source = "ours"}},
      Field{&T::weave_m,
            {.key = "weave_m",
             .unit = "m",
             .min = 0,
             .max = 1.5,
             .doc = "Weaving within the lane by up to this far to either side.",
             .source = "ours"}},
      Field{&T::boat_sway_deg,
            {.key = "boat_sway_deg",
             .unit = "deg",
             .min = 0,
             .max = 20,
             .doc = "Roll by up to this angle, half of it in pitch, with heave, at rest too: a "
                    "boat in a swell of 3 to 6 s.",
             .source = "ours"}},
      Field{&T::bump_sd_m,
            {.key = "bump_sd_m",
             .unit = "m",
             .min = 0,
             .max = 0.2,
             .doc = "Road roughness felt by the body, 1 sigma.",
             .source = "ours"}},
      Field{&T::roll_per_lateral_g_deg,
            {.key = "roll_per_lateral_g_deg",
             .unit = "deg",
             .min = 0,
             .max = 15,
             .doc = "Body roll in a curve of 1 g.",
             .source = "ours"}},
      Field{&T::camera_hz,
            {.key = "camera_hz",
             .unit = "Hz",
             .min = 0,
             .max = 30,
             .doc = "Rate of forward street-camera images in the bag; 0: none.",
             .source = "HybridFusion IV-A"}},
      Field{&T::compression,
            {.key = "compression",
             .choices = "none|bz2|lz4",
             .doc = "Compression of the bag's chunks.",
             .source = "ROS bag format 2.0"}},
  };
};

/// The vehicle's LiDAR.
struct LidarModelOptions {
  std::string model = "spinning";
  std::string message = "auto";
  double rate_hz = 10.0;
  int beams = 32;
  int columns = 360;
  double lowest_deg = -25.0;
  double highest_deg = 15.0;
  int avia_rays = 6000;
  double range_sd_m = 0.02;
  double min_range_m = 0.8;
  double max_range_m = 80.0;
};
template <>
struct OptionFields<LidarModelOptions> {
  using T = LidarModelOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::model,
            {.key = "model",
             .choices = "spinning|avia",
             .doc = "spinning: rings over 360 degrees; avia: 70 x 77 degrees forward, never the "
                    "same pattern twice.",
             .source = "HybridFusion IV-A"}},
      Field{&T::message,
            {.key = "message",
             .choices = "auto|pointcloud2|livox|both",
             .doc = "Message types in the bag; auto: PointCloud2 for spinning, both for avia.",
             .source = "ours"}},
      Field{&T::rate_hz,
            {.key = "rate_hz",
             .unit = "Hz",
             .min = 1,
             .max = 40,
             .doc = "Scans a second.",
             .source = "ours"}},
      Field{&T::beams,
            {.key = "beams",
             .unit = "1",
             .min = 4,
             .max = 128,
             .doc = "Rings of the spinning "
                    "model.",
             .source = "ours"}},
      Field{&T::columns,
            {.key = "columns",
             .unit = "1",
             .min = 60,
             .max = 4096,
             .doc = "Firings a turn.",
             .source = "ours"}},
      Field{&T::lowest_deg,
            {.key = "lowest_deg",
             .unit = "deg",
             .min = -80,
             .max = 0,
             .doc = "Lowest ring.",
             .source = "ours"}},
      Field{&T::highest_deg,
            {.key = "highest_deg",
             .unit = "deg",
             .min = 0,
             .max = 80,
             .doc = "Highest ring.",
             .source = "ours"}},
      Field{&T::avia_rays,
            {.key = "avia_rays",
             .unit = "1",
             .min = 200,
             .max = 48000,
             .doc = "Rays a scan of the "
                    "avia model.",
             .source = "ours"}},
      Field{&T::range_sd_m,
            {.key = "range_sd_m",
             .unit = "m",
             .min = 0,
             .max = 0.5,
             .doc = "Range noise, 1 sigma.",
             .source = "ours"}},
      Field{&T::min_range_m,
            {.key = "min_range_m",
             .unit = "m",
             .min = 0.1,
             .max = 5,
             .doc = "Nearest return.",
             .source = "ours"}},
      Field{&T::max_range_m,
            {.key = "max_range_m",
             .unit = "m",
             .min = 5,
             .max = 500,
             .doc = "Farthest return; dark and slanted surfaces are lost much nearer.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
