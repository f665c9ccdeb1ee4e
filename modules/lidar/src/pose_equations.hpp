#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace hybridfusion {

using PoseVector = Eigen::Matrix<double, 6, 1>;
using PoseMatrix = Eigen::Matrix<double, 6, 6>;

/// Block-sparse symmetric normal equations of a Gauss-Newton step over poses map_from_body, six
/// rows a pose: translation in the map, rotation on the right. Upper triangle: row <= column.
class PoseEquations {
 public:
  explicit PoseEquations(std::size_t num_poses);

  PoseMatrix& block(std::uint32_t row, std::uint32_t column);
  PoseVector& right(std::uint32_t row) { return right_[row]; }

  /// The step with pose 0 held; six numbers for each pose behind it. @returns kDegenerate.
  [[nodiscard]] Expected<Eigen::VectorXd> solve() const;

 private:
  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const;

  std::vector<PoseMatrix> diagonal_;
  std::vector<PoseVector> right_;
  std::vector<PoseMatrix> blocks_ = {};
  std::vector<std::uint64_t> keys_ = {};
  std::unordered_map<std::uint64_t, std::size_t> index_ = {};
};

/// A measured motion between two poses.
struct RelativePose {
  std::uint32_t first = 0;
  std::uint32_t second = 0;  ///< @pre second > first
  Rigid3 first_from_second = {};
  /// Of [translation in the first frame; rotation in the second] [1/m^2, 1/rad^2].
  PoseMatrix information = PoseMatrix::Identity();
};

/// Information of independent errors with these deviations.
[[nodiscard]] PoseMatrix information_of(double sigma_m, double sigma_rad);

/// [d - d_measured; Log(R_measured^T Ra^T Rb)] with d the second position in the first frame.
[[nodiscard]] PoseVector residual_of(const RelativePose& edge, const Rigid3& a, const Rigid3& b);
/// d residual_of / d (pose a) and d (pose b); the Jacobian of Log is taken as identity.
struct RelativePoseJacobians {
  PoseMatrix by_first = PoseMatrix::Zero();
  PoseMatrix by_second = PoseMatrix::Zero();
};
[[nodiscard]] RelativePoseJacobians jacobians_of(const Rigid3& a, const Rigid3& b);

/// Adds `weight` times the squared residual of `edge`.
void add_edge(const RelativePose& edge,
              double weight,
              std::span<const Rigid3> map_from_body,
              PoseEquations& equations);

/// Mean velocities before and behind a pose differ by what the IMU felt: holds motion along
/// directions that the LiDAR does not see far better than the motion itself is known.
struct VelocityChange {
  std::uint32_t middle = 0;  ///< Between poses middle - 1 and middle + 1.
  double before_s = 1.0;     ///< Since pose middle - 1.
  double behind_s = 1.0;     ///< Until pose middle + 1.
  Eigen::Vector3d in_middle_mps = Eigen::Vector3d::Zero();  ///< In the middle body's frame.
  /// In the middle body's frame [s^2/m^2].
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
};

/// The change of velocity that the poses show, minus the measured one.
[[nodiscard]] Eigen::Vector3d residual_of(const VelocityChange& change,
                                          std::span<const Rigid3> map_from_body);
void add_velocity_change(const VelocityChange& change,
                         std::span<const Rigid3> map_from_body,
                         PoseEquations& equations);

/// Applies a step of PoseEquations::solve. @returns the largest shift [m].
double apply_step(const Eigen::VectorXd& step, std::vector<Rigid3>& map_from_body);

}  // namespace hybridfusion
