#include "manifold.hpp"

#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

// Below this angle the second-order series is exact to double precision.
constexpr double kSmallAngle_rad = 1e-5;

Eigen::Matrix3d left_jacobian(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const Eigen::Matrix3d k = skew(phi);
  if (angle < kSmallAngle_rad) return Eigen::Matrix3d::Identity() + 0.5 * k + k * k / 6.0;
  const double angle2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1.0 - std::cos(angle)) / angle2 * k +
         (1.0 - std::sin(angle) / angle) / angle2 * k * k;
}

}  // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Eigen::Matrix3d so3_exp(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  const Eigen::Matrix3d k = skew(phi);
  if (angle < kSmallAngle_rad) return Eigen::Matrix3d::Identity() + k + 0.5 * k * k;
  return Eigen::Matrix3d::Identity() + std::sin(angle) / angle * k +
         (1.0 - std::cos(angle)) / (angle * angle) * k * k;
}

Eigen::Vector3d so3_log(const Eigen::Matrix3d& rotation) {
  // Through the quaternion: well conditioned at 0 and at pi.
  Eigen::Quaterniond q(rotation);
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return 2.0 * std::atan2(sine, q.w()) / sine * q.vec();
}

Eigen::Matrix3d so3_right_jacobian(const Eigen::Vector3d& phi) {
  return left_jacobian(-phi);
}

S2Basis s2_basis(const Eigen::Vector3d& direction) {
  // The coordinate axis that is farthest from the direction keeps the basis well conditioned.
  Eigen::Index axis = 0;
  direction.cwiseAbs().minCoeff(&axis);
  S2Basis basis;
  basis.col(0) = direction.cross(Eigen::Vector3d::Unit(axis)).normalized();
  basis.col(1) = direction.normalized().cross(basis.col(0));
  return basis;
}

Eigen::Vector3d s2_plus(const Eigen::Vector3d& direction, const Eigen::Vector2d& u) {
  const Eigen::Vector3d phi = s2_basis(direction) * u;
  return so3_exp(phi) * direction;
}

Eigen::Vector2d s2_minus(const Eigen::Vector3d& to, const Eigen::Vector3d& from) {
  const Eigen::Vector3d axis = from.cross(to);
  const double sine = axis.norm();
  const double cosine = from.dot(to);
  const double scale = from.norm() * to.norm();
  if (sine < 1e-14 * scale) {
    return cosine >= 0.0 ? Eigen::Vector2d::Zero().eval() : Eigen::Vector2d(std::numbers::pi, 0.0);
  }
  return std::atan2(sine, cosine) / sine * s2_basis(from).transpose() * axis;
}

S2Basis s2_plus_jacobian(const Eigen::Vector3d& direction, const Eigen::Vector2d& u) {
  const S2Basis basis = s2_basis(direction);
  const Eigen::Vector3d phi = basis * u;
  // d(Exp(phi) g) = -Exp(phi) [g]x Jr(phi) d(phi)
  return -so3_exp(phi) * skew(direction) * so3_right_jacobian(phi) * basis;
}

Eigen::Matrix<double, 2, 3> s2_minus_jacobian(const Eigen::Vector3d& direction) {
  return s2_basis(direction).transpose() * skew(direction) / direction.squaredNorm();
}

}  // namespace hybridfusion
