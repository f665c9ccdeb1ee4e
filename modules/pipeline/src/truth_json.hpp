#pragma once

#include "json_text.hpp"

#include <hybridfusion/evaluation/pose_error.hpp>
#include <hybridfusion/evaluation/trajectory_error.hpp>

namespace hybridfusion {

[[nodiscard]] Json json_of(const CameraErrors& errors);
[[nodiscard]] Json json_of(const TrajectoryErrors& errors);

}  // namespace hybridfusion
