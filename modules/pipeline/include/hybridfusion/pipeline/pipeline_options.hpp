#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/lidar/calibration.hpp>
#include <hybridfusion/lidar/gnss_alignment.hpp>
#include <hybridfusion/lidar/odometry_options.hpp>
#include <hybridfusion/pipeline/evaluation_options.hpp>
#include <hybridfusion/registration/fuse_clouds.hpp>
#include <hybridfusion/registration/registration_options.hpp>
#include <hybridfusion/vision/densify_options.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>
#include <hybridfusion/vision/streaming_options.hpp>

namespace hybridfusion {

/// Module A: photos -> dense cloud.
struct VisionStageOptions {
  ReconstructionOptions reconstruction = {};
  DensifyOptions densify = {};
  double max_conflict_sigma = 5.0;
  std::string model_format = "text";
};
template <>
struct OptionFields<VisionStageOptions> {
  using T = VisionStageOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::reconstruction, {.key = "reconstruction", .doc = "Camera poses."}},
      Field{&T::densify, {.key = "densify", .doc = "Dense cloud."}},
      Field{&T::max_conflict_sigma,
            {.key = "max_conflict_sigma",
             .unit = "sigma",
             .min = 1,
             .max = 1e6,
             .doc = "Positions of two sources (photos, geo.txt, ground control, given poses and "
                    "their origin, vehicle) that differ by more than so many of their combined "
                    "deviations contradict each other: the run is refused.",
             .source = "ours"}},
      Field{&T::model_format,
            {.key = "model_format",
             .choices = "text|both",
             .doc = "COLMAP model in vision/: as text, or as text and binary (cameras.bin, "
                    "images.bin, points3D.bin).",
             .source = "COLMAP"}},
  };
};

/// Module B: recording -> map.
struct LidarStageOptions {
  std::string imu = "auto";
  RecordingOptions recording = {};
  OdometryOptions odometry = {};
  GnssAlignmentOptions gnss = {};
  CalibrationOptions calibration = {};
};
template <>
struct OptionFields<LidarStageOptions> {
  using T = LidarStageOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::imu,
            {.key = "imu",
             .choices = "auto|required|none",
             .doc = "auto: motion comes from the LiDAR alone where the recording has no IMU; "
                    "required: such a recording is refused; none: an IMU is not listened to.",
             .source = "ours"}},
      Field{&T::recording, {.key = "recording", .doc = "Topics of the recording."}},
      Field{&T::odometry, {.key = "odometry", .doc = "LiDAR-inertial odometry and map."}},
      Field{&T::gnss, {.key = "gnss", .doc = "Placing the map by GNSS."}},
      Field{&T::calibration, {.key = "calibration", .doc = "map --calibrate."}},
  };
};

/// Merging the registered clouds.
struct FusionStageOptions {
  bool rescale_vision = true;
  bool level_vision = true;
  FuseOptions clouds = {};
};
template <>
struct OptionFields<FusionStageOptions> {
  using T = FusionStageOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::rescale_vision,
            {.key = "rescale_vision",
             .doc = "Correct the scale of the vision cloud to that of the LiDAR cloud in the fused "
                    "cloud when the registration supports it; vision/dense.ply stays as it is.",
             .source = "ours"}},
      Field{&T::level_vision,
            {.key = "level_vision",
             .doc = "Take the vertical of the fused cloud from gravity in the LiDAR map, not from "
                    "the GNSS heights of the photos, when it is the better known; vision/ stays as "
                    "it is.",
             .source = "ours"}},
      Field{&T::clouds, {.key = "clouds", .doc = "How doubles are dropped and gaps filled."}},
  };
};

/// Every option of every stage; one group a stage, one for the fusion, one for the
/// watch.
struct PipelineOptions {
  VisionStageOptions vision = {};
  LidarStageOptions lidar = {};
  RegistrationOptions registration = {};
  FusionStageOptions fusion = {};
  EvaluationOptions evaluation = {};
  StreamingOptions watch = {};
};

template <>
struct OptionFields<PipelineOptions> {
  using T = PipelineOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::vision, {.key = "vision", .doc = "Photos -> dense cloud."}},
      Field{&T::lidar, {.key = "lidar", .doc = "Recording -> map."}},
      Field{&T::registration, {.key = "registration", .doc = "Vision cloud and map -> pose."}},
      Field{&T::fusion, {.key = "fusion", .doc = "Registered clouds -> fused cloud."}},
      Field{&T::evaluation, {.key = "evaluation", .doc = "Metrics."}},
      Field{&T::watch, {.key = "watch", .doc = "reconstruct --watch: photos while they arrive."}},
  };
};

}  // namespace hybridfusion
