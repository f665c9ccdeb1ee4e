#pragma once

#include "sfm_model.hpp"

#include <hybridfusion/core/photo.hpp>

#include <optional>
#include <span>
#include <string_view>

#include <Eigen/Core>

namespace hybridfusion {

/// Which way is up in the frame of the model, from something else than GNSS altitudes.
struct GravityCue {
  Eigen::Vector3d up_in_world = Eigen::Vector3d::UnitZ();
  double sigma_rad = 0.0;
  bool measured = false;  ///< By a sensor; else guessed from how photos are usually taken.
  std::string_view source = {};
};

/// Mean of what the camera mounts of the registered photos report.
[[nodiscard]] std::optional<GravityCue> gravity_from_gimbals(const SfmModel& model,
                                                             std::span<const PhotoMetadata> photos);

/// Photos are held level, so that up is perpendicular to all image rows. Empty when the rows are
/// nearly parallel.
[[nodiscard]] std::optional<GravityCue> gravity_from_level_rows(const SfmModel& model);

/// Photos that all look the same way look down. Empty when they do not.
[[nodiscard]] std::optional<GravityCue> gravity_from_common_axis(const SfmModel& model);

}  // namespace hybridfusion
