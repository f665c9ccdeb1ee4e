#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

inline constexpr double kUnknownSigma_m = 1.0e3;  ///< Of an altitude that must not turn the model.

/// A camera centre of the model and where GNSS puts it.
struct PositionPair {
  Eigen::Vector3d in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d in_enu = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();
  Eigen::Vector3d velocity_in_world = Eigen::Vector3d::Zero();  ///< Per second; zero: unknown.
  int flight = 0;
  double flight_time_s = 0.0;
};

/// Which systematic errors of the tags are estimated, where a flight shows them.
struct TagErrorModel {
  bool drift = false;  ///< Height offset and linear drift.
  bool lag = false;    ///< Time between photo and tag.
};

struct UpPrior {
  Eigen::Vector3d up_in_world = Eigen::Vector3d::UnitZ();
  double sigma_rad = 0.0;
};

struct SimilarityFit {
  Sim3 enu_from_world = {};
  std::vector<FlightErrors> flights = {};  ///< Per flight; zero where not estimated.
  std::vector<FlightErrors> sigmas = {};   ///< Their standard deviations.
  double tilt_sigma_rad = 0.0;             ///< Of the up direction, with the up direction given.
  double scale_sigma = 0.0;                ///< Relative.
  double horizontal_ratio = 0.0;  ///< Robust deviation of the residuals over the stated sigmas.
  double vertical_ratio = 0.0;
  /// The same by the 80 % quantile: a third of the tags, the strips of one direction say, counts.
  double horizontal_spread = 0.0;
  double vertical_spread = 0.0;
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

/// Whether a flight of these pairs tells its lag: it has eight photos with a velocity, and they do
/// not all go one way (a lag along one direction is a place).
[[nodiscard]] bool tells_lag(std::span<const PositionPair> pairs, int flight);

/// Gauss-Newton from `start` on the weighted residuals with Cauchy weights, plus the up direction
/// where given, plus systematic errors of the tags. Where residuals exceed the stated sigmas, these
/// are scaled, horizontal and vertical apart.
[[nodiscard]] SimilarityFit refine_similarity(std::span<const PositionPair> pairs,
                                              const Sim3& start,
                                              const std::optional<UpPrior>& up,
                                              const TagErrorModel& model = {});

}  // namespace hybridfusion
