#pragma once

#include "fine_alignment.hpp"

#include <span>
#include <vector>

namespace hybridfusion {

/// A LiDAR sample on its vision plane.
struct FinePair {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< In the LiDAR frame [m].
  double residual_m = 0.0;
  Vector7d jacobian = Vector7d::Zero();
  double weight = 0.0;  ///< Of the last step; 0 for held-out pairs.
  bool is_vertical = false;
  bool is_held_out = false;
};

/// The value that `share` of `values` lie below; 0 for none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// Counts, residuals and held-out figures of `result`. @param held_out_near  held-out samples that
/// have a vision point within reach.
void fill_statistics(std::span<const FinePair> pairs, double held_out_near, FineResult& result);

/// Covariance over [v; w; s] about the centre by leaving out one block of the scene at a time
/// (Quenouille's jackknife): errors of one facade, of drift and of doming are shared by neighbours,
/// so that single residuals say too little about the pose.
[[nodiscard]] Matrix7d jackknife_covariance(std::span<const FinePair> pairs, bool free_scale);

/// The pose part of a covariance about `centre` as a covariance of the tangent of `pose`.
[[nodiscard]] Matrix6d tangent_covariance(const Matrix7d& centred,
                                          const Rigid3& pose,
                                          const Eigen::Vector3d& centre);

/// Stereo moves all facades outward or inward by a centimetre or so, which looks like a scale: one
/// sigma of that, from the horizontal spread of the vertical pairs.
[[nodiscard]] double systematic_scale_sigma(std::span<const FinePair> pairs);

}  // namespace hybridfusion
