#pragma once

#include "control_target.hpp"
#include "sfm_model.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/ground_control.hpp>

#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

/// The point that the marks of the registered views show; nothing with fewer than two of them or
/// when they do not meet.
[[nodiscard]] std::optional<Eigen::Vector3d> triangulate_marks(const SfmModel& model,
                                                               const ControlPoint& point);

/// Middle of the surveyed points, for photos without GNSS.
[[nodiscard]] GeodeticOrigin origin_of_control(std::span<const ControlPoint> points);

/// From the frame of the model to the surveyed positions, by the points that are not for checking.
/// @returns kInsufficient for fewer than three that two registered photos show, kDegenerate when
///          they lie on one line or when one contradicts the others by far (it is named).
[[nodiscard]] Expected<Sim3> place_by_control(const SfmModel& model,
                                              std::span<const ControlPoint> points,
                                              const GeodeticOrigin& origin);

/// The points that are not for checking, for the adjustment.
[[nodiscard]] std::vector<ControlTarget> control_targets(const SfmModel& model,
                                                         std::span<const ControlPoint> points,
                                                         const GeodeticOrigin& origin);

/// Of every point, against the adjusted model.
[[nodiscard]] std::vector<ControlResidual> control_residuals(const SfmModel& model,
                                                             std::span<const ControlPoint> points,
                                                             const GeodeticOrigin& origin);

}  // namespace hybridfusion
