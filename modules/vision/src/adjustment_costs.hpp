#pragma once

/// @file
/// Residuals of the bundle adjustment. A pose block holds [qx qy qz qw | centre]: the rotation
/// world_from_camera and the camera centre. Its tangent is [centre (world); rotation (right
/// perturbation)]. As the costs give their Jacobians in the tangent directly, they fill the first
/// six of the block's seven columns, and PoseManifold's plus Jacobian is [I; 0].

#include "projection.hpp"
#include "rotation.hpp"

#include <Eigen/Core>
#include <ceres/ceres.h>

namespace hybridfusion {

inline constexpr int kPoseSize = 7;
inline constexpr int kPoseTangent = 6;
template <int Rows>
using PoseJacobian = Eigen::Matrix<double, Rows, kPoseSize, Eigen::RowMajor>;

class PoseManifold final : public ceres::Manifold {
 public:
  [[nodiscard]] int AmbientSize() const override { return kPoseSize; }
  [[nodiscard]] int TangentSize() const override { return kPoseTangent; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

/// HybridFusion Eq. (2), divided by the standard deviation. Blocks: pose, point, intrinsics.
class ReprojectionCost final : public ceres::SizedCostFunction<2, kPoseSize, 3, kNumIntrinsics> {
 public:
  ReprojectionCost(const Eigen::Vector2d& pixel, double sigma_px)
      : pixel_(pixel), inverse_sigma_(1.0 / sigma_px) {}
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector2d pixel_;
  double inverse_sigma_;
};

/// Offset [m], rate [m/s] and lag [s] of the tags of one flight, as in FlightErrors.
inline constexpr int kNumTagErrors = 3;

/// A GNSS tag as a residual sees it.
struct GnssTag {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();
  double time_s = 0.0;                                          ///< Since the start of the flight.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();       ///< Of the camera; zero: no lag.
  Eigen::Vector3d antenna_in_camera = Eigen::Vector3d::Zero();  ///< Lever arm [m].
};

/// Where the antenna was against where the tag says, divided by the deviations:
/// C + R l + up (offset + rate * time) - lag * velocity - tag. Blocks: pose, [offset, rate, lag].
class GnssPositionCost final : public ceres::SizedCostFunction<3, kPoseSize, kNumTagErrors> {
 public:
  explicit GnssPositionCost(const GnssTag& tag) : tag_(tag) {}
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  GnssTag tag_;
};

/// HybridFusion Eq. (3): displacement of the antenna by vision less displacement by GNSS between
/// two frames, divided by the deviations. Blocks: pose before, pose after.
class GnssDisplacementCost final : public ceres::SizedCostFunction<3, kPoseSize, kPoseSize> {
 public:
  GnssDisplacementCost(const Eigen::Vector3d& displacement,
                       const Eigen::Vector3d& sigma_m,
                       const Eigen::Vector3d& antenna_in_camera)
      : displacement_(displacement),
        inverse_sigma_(sigma_m.cwiseInverse()),
        antenna_in_camera_(antenna_in_camera) {}
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector3d displacement_;
  Eigen::Vector3d inverse_sigma_;
  Eigen::Vector3d antenna_in_camera_;
};

/// The horizontal part of what a camera knows as up, divided by the deviation. Block: pose.
class UpDirectionCost final : public ceres::SizedCostFunction<2, kPoseSize> {
 public:
  UpDirectionCost(const Eigen::Vector3d& up_in_camera, double sigma_rad)
      : up_in_camera_(up_in_camera), sigma_rad_(sigma_rad) {}
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Vector3d up_in_camera_;
  double sigma_rad_;
};

/// Independent normal priors on a block of `Size` numbers.
template <int Size>
class NormalPriorCost final : public ceres::SizedCostFunction<Size, Size> {
 public:
  using Vector = Eigen::Matrix<double, Size, 1>;
  NormalPriorCost(const Vector& mean, const Vector& sigma)
      : mean_(mean), inverse_sigma_(sigma.cwiseInverse()) {}
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Vector> value(parameters[0]);
    Eigen::Map<Vector>{residuals} = (value - mean_).cwiseProduct(inverse_sigma_);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, Size, Size, Eigen::RowMajor>>{jacobians[0]} =
          inverse_sigma_.asDiagonal();
    }
    return true;
  }

 private:
  Vector mean_;
  Vector inverse_sigma_;
};

}  // namespace hybridfusion
