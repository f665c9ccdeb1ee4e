#pragma once

#include "fine_samples.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/registration/registration_options.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Point-to-plane residual [m] and its Jacobian over [v; w; s]: the moved point goes to
/// centre + exp(s) exp(w) (p - centre) + v.
[[nodiscard]] double plane_residual(const Eigen::Vector3d& moved,
                                    const Eigen::Vector3d& on_plane,
                                    const Eigen::Vector3d& normal,
                                    const Eigen::Vector3d& centre,
                                    Vector7d& jacobian);

/// `update` (as in plane_residual, about `centre`) applied after `target_from_source`.
[[nodiscard]] Sim3 apply_update(const Vector7d& update,
                                const Eigen::Vector3d& centre,
                                const Sim3& target_from_source);

struct FineResult {
  Rigid3 vision_from_lidar = {};
  Matrix6d covariance = Matrix6d::Zero();  ///< Tangent order of Rigid3, right perturbation.
  Sim3 similarity = {};                    ///< vision_from_lidar with the scale free.
  double scale_sigma = 0.0;                ///< One sigma of similarity.scale; 0 when not estimated.
  bool scale_supported = false;
  bool horizontal_updated = false;  ///< False: too few facades, x, y and heading are the start's.
  std::size_t num_vertical = 0;     ///< Pairs at the end.
  std::size_t num_horizontal = 0;
  double held_out_median_m = 0.0;  ///< |residual| of points that were not used.
  double held_out_share = 0.0;     ///< Of the held-out points near vision, those with a pair.
  double gate_m = 0.0;             ///< Of the last pairs; above the option's under drift.
  double vertical_rms_m = 0.0;
  double horizontal_rms_m = 0.0;
};

/// Planes of the vision cloud met by samples of the LiDAR cloud around `start`; facades and ground
/// get equal total weight. @param lidar_centroid  Where the rigid pose agrees with the similarity
/// [m].
/// @returns kInsufficient when fewer than 100 pairs remain, kCancelled when stopped.
[[nodiscard]] Expected<FineResult> align_fine(FineInputs& inputs,
                                              const Rigid3& start,
                                              const Eigen::Vector3d& lidar_centroid,
                                              const FineOptions& options,
                                              const RunContext& ctx);

}  // namespace hybridfusion
