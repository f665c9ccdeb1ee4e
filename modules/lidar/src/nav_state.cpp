#include "nav_state.hpp"

namespace hybridfusion {

Rigid3 NavState::pose() const {
  return {.rotation = Eigen::Quaterniond(map_from_imu).normalized(),
          .translation = position_in_map};
}

NavState plus(const NavState& state, const ErrorVector& error) {
  NavState out = state;
  out.position_in_map += error.segment<3>(err::kPosition);
  out.map_from_imu = state.map_from_imu * so3_exp(error.segment<3>(err::kRotation));
  out.velocity_in_map += error.segment<3>(err::kVelocity);
  out.gyro_bias += error.segment<3>(err::kGyroBias);
  out.accel_bias += error.segment<3>(err::kAccelBias);
  out.gravity_in_map = s2_plus(state.gravity_in_map, error.segment<2>(err::kGravity));
  out.lidar_in_imu += error.segment<3>(err::kExtrinsicPosition);
  out.imu_from_lidar = state.imu_from_lidar * so3_exp(error.segment<3>(err::kExtrinsicRotation));
  return out;
}

ErrorVector minus(const NavState& to, const NavState& from) {
  ErrorVector error;
  error.segment<3>(err::kPosition) = to.position_in_map - from.position_in_map;
  error.segment<3>(err::kRotation) = so3_log(from.map_from_imu.transpose() * to.map_from_imu);
  error.segment<3>(err::kVelocity) = to.velocity_in_map - from.velocity_in_map;
  error.segment<3>(err::kGyroBias) = to.gyro_bias - from.gyro_bias;
  error.segment<3>(err::kAccelBias) = to.accel_bias - from.accel_bias;
  error.segment<2>(err::kGravity) = s2_minus(to.gravity_in_map, from.gravity_in_map);
  error.segment<3>(err::kExtrinsicPosition) = to.lidar_in_imu - from.lidar_in_imu;
  error.segment<3>(err::kExtrinsicRotation) =
      so3_log(from.imu_from_lidar.transpose() * to.imu_from_lidar);
  return error;
}

ErrorMatrix transport(const NavState& prior, const ErrorVector& deviation) {
  ErrorMatrix j = ErrorMatrix::Identity();
  // Log(Exp(d) Exp(e)) = d + Jr(d)^-1 e, so an error about the prior becomes Jr(d) times itself.
  j.block<3, 3>(err::kRotation, err::kRotation) =
      so3_right_jacobian(deviation.segment<3>(err::kRotation));
  j.block<3, 3>(err::kExtrinsicRotation, err::kExtrinsicRotation) =
      so3_right_jacobian(deviation.segment<3>(err::kExtrinsicRotation));
  const Eigen::Vector2d u = deviation.segment<2>(err::kGravity);
  const Eigen::Vector3d gravity = s2_plus(prior.gravity_in_map, u);
  j.block<2, 2>(err::kGravity, err::kGravity) =
      s2_minus_jacobian(gravity) * s2_plus_jacobian(prior.gravity_in_map, u);
  return j;
}

}  // namespace hybridfusion
