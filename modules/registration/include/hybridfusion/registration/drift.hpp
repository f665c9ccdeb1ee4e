#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Slow bending of the LiDAR cloud along the drive, as the photo cloud shows it.
struct DriftOptions {
  bool enabled = true;
  double knot_distance_m = 40.0;
  int max_knots = 16;
  double max_size_m = 2.0;
  double min_size_m = 0.08;
  double min_gain = 0.15;
};

template <>
struct OptionFields<DriftOptions> {
  using T = DriftOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Estimate the drift of the LiDAR cloud and, where the photo cloud supports it, "
                    "take it out before fusion.",
             .source = "ours"}},
      Field{&T::knot_distance_m,
            {.key = "knot_distance_m",
             .unit = "m",
             .min = 5.0,
             .max = 1e4,
             .doc = "Way between two corrections; between them it is interpolated.",
             .source = "ours"}},
      Field{&T::max_knots,
            {.key = "max_knots",
             .unit = "1",
             .min = 3.0,
             .max = 100.0,
             .doc = "Corrections along the whole drive at most; long drives space them wider.",
             .source = "ours"}},
      Field{&T::max_size_m,
            {.key = "max_size_m",
             .unit = "m",
             .min = 0.0,
             .max = 10.0,
             .doc = "A larger correction is not believed.",
             .source = "ours"}},
      Field{&T::min_size_m,
            {.key = "min_size_m",
             .unit = "m",
             .min = 0.0,
             .max = 10.0,
             .doc = "A smaller correction is left out: the photo cloud itself bends that much.",
             .source = "ours"}},
      Field{&T::min_gain,
            {.key = "min_gain",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Share by which the distances of held-out stretches of the drive must fall.",
             .source = "ours"}},
  };
};

/// What a drift is a function of.
enum class DriftAxis : std::uint8_t {
  kTime,  ///< Seconds, from the times of the LiDAR points.
  kPath,  ///< Metres along the sensor positions, at the position nearest in plan.
};

/// One end of a stretch. A point p measured there moves by shift_m + turn_rad x (p - pivot).
struct DriftKnot {
  double at = 0.0;                                  ///< [s] or [m], see DriftAxis.
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();
};

/// Correction of the LiDAR cloud in its own frame: linear between knots, constant beyond them. Its
/// rigid part is in the pose, not here.
struct DriftCorrection {
  bool supported = false;  ///< Held-out stretches confirm it and it is large enough to matter.
  DriftAxis axis = DriftAxis::kTime;
  std::vector<DriftKnot> knots = {};  ///< Ascending; empty when nothing could be estimated.
  double size_m = 0.0;                ///< Largest move of a knot's pivot.
  double held_out_before_m = 0.0;     ///< Mean distance (cut at 0.5 m) of held-out stretches.
  double held_out_after_m = 0.0;
};

/// Where `point`, measured at `at`, belongs. @pre correction.knots is not empty
[[nodiscard]] Eigen::Vector3d corrected(const DriftCorrection& correction,
                                        const Eigen::Vector3d& point,
                                        double at);

/// For each point where it lies on `axis`. @param sensor_positions  For kPath, in the frame of the
/// points. @returns kInsufficient when the points have no times (kTime) or there are fewer than two
/// positions (kPath).
[[nodiscard]] Expected<std::vector<double>> drift_parameters(
    const PointCloud& lidar,
    DriftAxis axis,
    std::span<const Eigen::Vector3d> sensor_positions,
    const RunContext& ctx);

/// The LiDAR cloud with the drift taken out; as it is when the correction is not supported.
[[nodiscard]] Expected<PointCloud> without_drift(PointCloud lidar,
                                                 const DriftCorrection& correction,
                                                 std::span<const Eigen::Vector3d> sensor_positions,
                                                 const RunContext& ctx = {});

}  // namespace hybridfusion
