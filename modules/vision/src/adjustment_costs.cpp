#include "adjustment_costs.hpp"

namespace hybridfusion {
namespace {

Eigen::Map<const Eigen::Quaterniond> rotation_of(const double* pose) {
  return Eigen::Map<const Eigen::Quaterniond>(pose);
}
Eigen::Map<const Eigen::Vector3d> centre_of(const double* pose) {
  return Eigen::Map<const Eigen::Vector3d>(pose + 4);
}

/// Of the antenna's place C + R l over a pose block; d(R exp(t) l)/dt = -R [l]x.
void fill_antenna_jacobian(const Eigen::Matrix3d& world_from_camera,
                           const Eigen::Vector3d& antenna_in_camera,
                           const Eigen::Vector3d& weight,
                           double* jacobian) {
  Eigen::Map<PoseJacobian<3>> out(jacobian);
  out.setZero();
  out.leftCols<3>() = weight.asDiagonal();
  out.middleCols<3>(3) = -(weight.asDiagonal() * world_from_camera * skew(antenna_in_camera));
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
  const Eigen::Matrix3d world_from_camera = rotation_of(parameters[0]).toRotationMatrix();
  const double* errors = parameters[1];
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d expected =
      centre_of(parameters[0]) + world_from_camera * tag_.antenna_in_camera +
      (errors[0] + errors[1] * tag_.time_s) * up - errors[2] * tag_.velocity_mps;
  const Eigen::Vector3d inverse_sigma = tag_.sigma_m.cwiseInverse();
  Eigen::Map<Eigen::Vector3d>{residuals} = (expected - tag_.position).cwiseProduct(inverse_sigma);
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) {
    fill_antenna_jacobian(world_from_camera, tag_.antenna_in_camera, inverse_sigma, jacobians[0]);
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 3, kNumTagErrors, Eigen::RowMajor>> jacobian(jacobians[1]);
    jacobian << up, tag_.time_s * up, -tag_.velocity_mps;
    jacobian = inverse_sigma.asDiagonal() * jacobian.eval();
  }
  return true;
}

bool GnssDisplacementCost::Evaluate(double const* const* parameters,
                                    double* residuals,
                                    double** jacobians) const {
  const Eigen::Matrix3d before = rotation_of(parameters[0]).toRotationMatrix();
  const Eigen::Matrix3d after = rotation_of(parameters[1]).toRotationMatrix();
  const Eigen::Vector3d by_vision = centre_of(parameters[1]) + after * antenna_in_camera_ -
                                    centre_of(parameters[0]) - before * antenna_in_camera_;
  Eigen::Map<Eigen::Vector3d>{residuals} = (by_vision - displacement_).cwiseProduct(inverse_sigma_);
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) {
    fill_antenna_jacobian(before, antenna_in_camera_, -inverse_sigma_, jacobians[0]);
  }
  if (jacobians[1] != nullptr) {
    fill_antenna_jacobian(after, antenna_in_camera_, inverse_sigma_, jacobians[1]);
  }
  return true;
}

bool UpDirectionCost::Evaluate(double const* const* parameters,
                               double* residuals,
                               double** jacobians) const {
  const Eigen::Matrix3d world_from_camera = rotation_of(parameters[0]).toRotationMatrix();
  const Eigen::Vector3d up = world_from_camera * up_in_camera_;
  Eigen::Map<Eigen::Vector2d>{residuals} = up.head<2>() / sigma_rad_;
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Map<PoseJacobian<2>> jacobian(jacobians[0]);
  jacobian.setZero();
  // d(R exp(t) u)/dt = -R [u]x
  jacobian.middleCols<3>(3) = (-world_from_camera * skew(up_in_camera_) / sigma_rad_).topRows<2>();
  return true;
}

}  // namespace hybridfusion
