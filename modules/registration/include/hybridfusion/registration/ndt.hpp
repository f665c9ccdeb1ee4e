#pragma once

#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/registration_options.hpp>

#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// Rigid motion in the plane, `target_from_source`: p_target = R(yaw) p_source + translation.
struct Rigid2 {
  double yaw_rad = 0.0;
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();  ///< [m]
};

/// One pass of the normal distributions transform. Biber and Strasser (IROS 2003) in 2D, Magnusson
/// (PhD thesis 2009, chapter 6) in 3D, with Newton steps about the centre of the source points (the
/// rotation then does not move the cloud) and a step length that must lower the objective.
struct NdtPass {
  double cell_m = 2.0;
  int min_cell_points = 6;
  double outlier_ratio = 0.55;
  int max_iterations = 40;
};

struct NdtQuality {
  double score = 0.0;            ///< Mean over the source points of the normalised density, 0..1.
  double matched_share = 0.0;    ///< Source points that have a cell nearby.
  double mean_distance_m = 0.0;  ///< Matched points to the mean of their cell.
  int iterations = 0;
  bool converged = false;  ///< The last step was shorter than 1 mm; false at the iteration limit.
};

struct Ndt2Result {
  Rigid2 target_from_source = {};
  NdtQuality quality = {};
};
struct Ndt3Result {
  Rigid3 target_from_source = {};
  NdtQuality quality = {};
};

/// @returns kInsufficient when no target cell has enough points or no source point is near one,
/// kCancelled when stopped.
[[nodiscard]] Expected<Ndt2Result> align_ndt_2d(std::span<const Eigen::Vector2f> target,
                                                std::span<const Eigen::Vector2f> source,
                                                const Rigid2& start,
                                                const NdtPass& pass = {},
                                                const RunContext& ctx = {});
[[nodiscard]] Expected<Ndt3Result> align_ndt_3d(std::span<const Eigen::Vector3f> target,
                                                std::span<const Eigen::Vector3f> source,
                                                const Rigid3& start,
                                                const NdtPass& pass = {},
                                                const RunContext& ctx = {});

}  // namespace hybridfusion
