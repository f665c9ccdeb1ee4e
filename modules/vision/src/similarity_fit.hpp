#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>

#include <optional>
#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// A camera centre of the model and where GNSS puts it.
struct PositionPair {
  Eigen::Vector3d in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d in_enu = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();
};

struct UpPrior {
  Eigen::Vector3d up_in_world = Eigen::Vector3d::UnitZ();
  double sigma_rad = 0.0;
};

struct SimilarityFit {
  Sim3 enu_from_world = {};
  double tilt_sigma_rad = 0.0;    ///< Of the up direction, as GNSS alone leaves it.
  double horizontal_ratio = 0.0;  ///< Robust deviation of the residuals over the stated sigmas.
  double vertical_ratio = 0.0;
};

/// Similarity with the least median of squared weighted residuals over three-point samples.
/// @returns kInsufficient below 3 pairs, kDegenerate when the positions lie on one line.
[[nodiscard]] Expected<Sim3> least_median_similarity(std::span<const PositionPair> pairs,
                                                     Random random);

/// Similarity whose up direction is given: heading, scale and horizontal offset by the least median
/// over two-point samples of the horizontal coordinates, height by the median.
[[nodiscard]] Expected<Sim3> least_median_upright_similarity(std::span<const PositionPair> pairs,
                                                             const Eigen::Vector3d& up_in_world,
                                                             Random random);

/// Gauss-Newton from `start` on the weighted residuals with Cauchy weights, plus the up direction
/// where given.
[[nodiscard]] SimilarityFit refine_similarity(std::span<const PositionPair> pairs,
                                              const Sim3& start,
                                              const std::optional<UpPrior>& up);

}  // namespace hybridfusion
