#pragma once

#include "sfm_model.hpp"

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/rolling_shutter_options.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Readout time [s] of each photo: as the options say, else by camera model; 0: all rows at once.
[[nodiscard]] std::vector<double> readout_times(std::span<const PhotoMetadata> photos,
                                                const RollingShutterOptions& options);

struct RollingShutterReport {
  std::size_t num_views = 0;  ///< That were corrected.
  double largest_px = 0.0;    ///< Largest move of a pixel, stored photo.
};

/// Moves the pixels of the tracks to where they would be if all rows were exposed when the middle
/// one was. The camera moves on while rows are read, so that row y sees from C + v t with
/// t = (y / height - 1/2) readout; rotation during the readout is neglected. Views that move by
/// less than half a pixel on the scene stay.
/// @param readout_s      Per view.
/// @param velocity       Per view, world units a second; zero: unknown.
RollingShutterReport correct_rolling_shutter(SfmModel& model,
                                             std::span<const double> readout_s,
                                             std::span<const Eigen::Vector3d> velocity);

}  // namespace hybridfusion
