#pragma once

#include "adjustment_costs.hpp"
#include "gnss_terms.hpp"

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <ceres/ceres.h>

namespace hybridfusion {

/// The GNSS part of a bundle adjustment: its residuals and the error blocks of the flights. Lives
/// as long as the problem.
class GnssBlocks {
 public:
  explicit GnssBlocks(GnssTerms& terms);

  /// @param poses       Per view; not moved afterwards.
  /// @param in_problem  Per view: whether its pose takes part.
  void add_to(ceres::Problem& problem,
              std::vector<std::array<double, kPoseSize>>& poses,
              const std::vector<bool>& in_problem);
  [[nodiscard]] std::vector<Eigen::Vector3d>& flights() { return flights_; }
  /// Estimated errors back into the terms.
  void store();

 private:
  void add_positions(ceres::Problem& problem,
                     std::vector<std::array<double, kPoseSize>>& poses,
                     const std::vector<bool>& in_problem);
  void add_displacements(ceres::Problem& problem,
                         std::vector<std::array<double, kPoseSize>>& poses,
                         const std::vector<bool>& in_problem);
  void hold_flight(ceres::Problem& problem, Eigen::Vector3d& errors);

  GnssTerms& terms_;
  std::vector<Eigen::Vector3d> flights_;  // [offset, rate, lag]
  std::unique_ptr<ceres::LossFunction> loss_;
  ceres::SubsetManifold drift_only_{kNumTagErrors, {2}};
  ceres::SubsetManifold lag_only_{kNumTagErrors, {0, 1}};
};

}  // namespace hybridfusion
