#pragma once

#include "sfm_model.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Ray through a pixel in world coordinates.
struct WorldRay {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< Unit length.
};

/// Point with the least sum of squared distances to the rays; nullopt for parallel rays.
[[nodiscard]] std::optional<Eigen::Vector3d> intersect_rays(std::span<const WorldRay> rays);

/// Largest angle between two of the rays from `point` to the centres [rad].
[[nodiscard]] double largest_angle_rad(std::span<const WorldRay> rays,
                                       const Eigen::Vector3d& point);

/// Gives a point to every listed track that at least two registered views show from different
/// enough directions: hypotheses from pairs of its rays, the one with most agreeing views refined
/// by Gauss-Newton on reprojection errors. Updates the active flags; a track without an acceptable
/// point loses it.
void triangulate_tracks(SfmModel& model,
                        std::span<const std::uint32_t> tracks,
                        const MappingOptions& options,
                        const RunContext& ctx);

}  // namespace hybridfusion
