#include "adjustment_costs.hpp"

namespace hybridfusion {
namespace {

Eigen::Map<const Eigen::Quaterniond> rotation_of(const double* pose) {
  return Eigen::Map<const Eigen::Quaterniond>(pose);
}
Eigen::Map<const Eigen::Vector3d> centre_of(const double* pose) {
  return Eigen::Map<const Eigen::Vector3d>(pose + 4);
}

}  // namespace

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const Eigen::Map<const Eigen::Vector3d> turn(delta + 3);
  Eigen::Map<Eigen::Quaterniond> rotation(x_plus_delta);
  rotation = (rotation_of(x) * rotation_exp(turn)).normalized();
  Eigen::Map<Eigen::Vector3d>(x_plus_delta + 4) =
      centre_of(x) + Eigen::Map<const Eigen::Vector3d>(delta);
  return true;
}

bool PoseManifold::PlusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, kPoseSize, kPoseTangent, Eigen::RowMajor>>{jacobian}
      .setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Eigen::Vector3d>{y_minus_x} = centre_of(y) - centre_of(x);
  const Eigen::AngleAxisd turn(rotation_of(x).conjugate() * rotation_of(y));
  Eigen::Map<Eigen::Vector3d>{y_minus_x + 3} = turn.angle() * turn.axis();
  return true;
}

bool PoseManifold::MinusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, kPoseTangent, kPoseSize, Eigen::RowMajor>>{jacobian}
      .setIdentity();
  return true;
}

bool ReprojectionCost::Evaluate(double const* const* parameters,
                                double* residuals,
                                double** jacobians) const {
  const Eigen::Matrix3d camera_from_world =
      rotation_of(parameters[0]).conjugate().toRotationMatrix();
  const Eigen::Map<const Eigen::Vector3d> point(parameters[1]);
  const Eigen::Map<const IntrinsicsVector> intrinsics(parameters[2]);
  const Eigen::Vector3d in_camera = camera_from_world * (point - centre_of(parameters[0]));
  // A step that carries a point behind a camera is refused and retried shorter.
  if (in_camera.z() <= 1e-9) return false;
  const Projection projection = project_with_jacobian(intrinsics, in_camera);
  Eigen::Map<Eigen::Vector2d>{residuals} = inverse_sigma_ * (projection.pixel - pixel_);
  if (jacobians == nullptr) return true;

  const Eigen::Matrix<double, 2, 3> by_camera = inverse_sigma_ * projection.by_point;
  const Eigen::Matrix<double, 2, 3> by_world = by_camera * camera_from_world;
  if (jacobians[0] != nullptr) {
    Eigen::Map<PoseJacobian<2>> jacobian(jacobians[0]);
    jacobian.leftCols<3>() = -by_world;
    // R exp(t): in_camera -> exp(-t) in_camera, so d in_camera / dt = [in_camera]x.
    jacobian.middleCols<3>(3) = by_camera * skew(in_camera);
    jacobian.col(6).setZero();
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>>{jacobians[1]} = by_world;
  }
  if (jacobians[2] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 2, kNumIntrinsics, Eigen::RowMajor>>{jacobians[2]} =
        inverse_sigma_ * projection.by_intrinsics;
  }
  return true;
}

bool GnssPositionCost::Evaluate(double const* const* parameters,
                                double* residuals,
                                double** jacobians) const {
  const double vertical_error_m = parameters[1][0] + parameters[1][1] * time_s_;
  const Eigen::Vector3d expected =
      centre_of(parameters[0]) + Eigen::Vector3d(0, 0, vertical_error_m);
  Eigen::Map<Eigen::Vector3d>{residuals} = (expected - position_).cwiseProduct(inverse_sigma_);
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) {
    Eigen::Map<PoseJacobian<3>> jacobian(jacobians[0]);
    jacobian.setZero();
    jacobian.leftCols<3>() = inverse_sigma_.asDiagonal();
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 3, 2, Eigen::RowMajor>> jacobian(jacobians[1]);
    jacobian.setZero();
    jacobian.row(2) << inverse_sigma_.z(), inverse_sigma_.z() * time_s_;
  }
  return true;
}

bool GnssDisplacementCost::Evaluate(double const* const* parameters,
                                    double* residuals,
                                    double** jacobians) const {
  const Eigen::Vector3d by_vision = centre_of(parameters[1]) - centre_of(parameters[0]);
  Eigen::Map<Eigen::Vector3d>{residuals} = (by_vision - displacement_).cwiseProduct(inverse_sigma_);
  if (jacobians == nullptr) return true;
  for (int block = 0; block < 2; ++block) {
    if (jacobians[block] == nullptr) continue;
    Eigen::Map<PoseJacobian<3>> jacobian(jacobians[block]);
    jacobian.setZero();
    jacobian.leftCols<3>() = inverse_sigma_.asDiagonal();
    if (block == 0) jacobian *= -1.0;
  }
  return true;
}

}  // namespace hybridfusion
