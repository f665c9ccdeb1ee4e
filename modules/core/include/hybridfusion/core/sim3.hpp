#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <span>

namespace hybridfusion {

/// Similarity `target_from_source`: point_in_target = scale * rotation * point_in_source +
/// translation.
struct Sim3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< Unit norm.
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         ///< [m] in the target frame.
  double scale = 1.0;                                            ///< > 0.

  [[nodiscard]] Sim3 inverse() const;
  [[nodiscard]] Eigen::Matrix4d matrix() const;
  /// A camera or sensor pose seen through the similarity: rotation composed, position mapped.
  [[nodiscard]] Rigid3 map_pose(const Rigid3& source_from_body) const;
};

[[nodiscard]] Sim3 operator*(const Sim3& c_from_b, const Sim3& b_from_a);
[[nodiscard]] inline Eigen::Vector3d operator*(const Sim3& target_from_source,
                                               const Eigen::Vector3d& point_in_source) {
  return target_from_source.scale * (target_from_source.rotation * point_in_source) +
         target_from_source.translation;
}

/// Least-squares alignment of paired points (Umeyama, PAMI 1991), optionally weighted.
/// @param weights  Empty, or one non-negative weight a pair.
/// @returns kInsufficient below 3 pairs, kDegenerate when the source points lie on one line.
[[nodiscard]] Expected<Sim3> fit_sim3(std::span<const Eigen::Vector3d> target,
                                      std::span<const Eigen::Vector3d> source,
                                      std::span<const double> weights = {});
/// As fit_sim3 with the scale held at 1.
[[nodiscard]] Expected<Rigid3> fit_rigid3(std::span<const Eigen::Vector3d> target,
                                          std::span<const Eigen::Vector3d> source,
                                          std::span<const double> weights = {});

}  // namespace hybridfusion
