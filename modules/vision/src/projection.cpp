#include "projection.hpp"

namespace hybridfusion {

IntrinsicsVector to_vector(const CameraIntrinsics& camera) {
  IntrinsicsVector values;
  values << camera.focal_px, camera.principal_point_px, camera.k1, camera.k2, camera.k3, camera.p1,
      camera.p2;
  return values;
}

void from_vector(const IntrinsicsVector& values, CameraIntrinsics& camera) {
  camera.focal_px = values[0];
  camera.principal_point_px = values.segment<2>(1);
  camera.k1 = values[3];
  camera.k2 = values[4];
  camera.k3 = values[5];
  camera.p1 = values[6];
  camera.p2 = values[7];
}

Projection project_with_jacobian(const IntrinsicsVector& intrinsics,
                                 const Eigen::Vector3d& point_in_camera) {
  const double f = intrinsics[0];
  const double k1 = intrinsics[3];
  const double k2 = intrinsics[4];
  const double k3 = intrinsics[5];
  const double p1 = intrinsics[6];
  const double p2 = intrinsics[7];
  const double inverse_z = 1.0 / point_in_camera.z();
  const double x = point_in_camera.x() * inverse_z;
  const double y = point_in_camera.y() * inverse_z;
  const double r2 = x * x + y * y;
  const double r4 = r2 * r2;
  const double r6 = r4 * r2;
  const double radial = 1.0 + k1 * r2 + k2 * r4 + k3 * r6;
  const double radial_by_r2 = k1 + 2.0 * k2 * r2 + 3.0 * k3 * r4;
  const Eigen::Vector2d distorted(x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
                                  y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y);
  Projection result;
  result.pixel = f * distorted + intrinsics.segment<2>(1);

  // d distorted / d (x, y); the mixed term is shared.
  const double mixed = 2.0 * x * y * radial_by_r2 + 2.0 * p1 * x + 2.0 * p2 * y;
  Eigen::Matrix2d by_normalized;
  by_normalized << radial + 2.0 * x * x * radial_by_r2 + 2.0 * p1 * y + 6.0 * p2 * x, mixed, mixed,
      radial + 2.0 * y * y * radial_by_r2 + 6.0 * p1 * y + 2.0 * p2 * x;
  by_normalized *= f;
  Eigen::Matrix<double, 2, 3> normalized_by_point;
  normalized_by_point << inverse_z, 0.0, -x * inverse_z, 0.0, inverse_z, -y * inverse_z;
  result.by_point = by_normalized * normalized_by_point;

  result.by_intrinsics.row(0) << distorted.x(), 1.0, 0.0, f * x * r2, f * x * r4, f * x * r6,
      2.0 * f * x * y, f * (r2 + 2.0 * x * x);
  result.by_intrinsics.row(1) << distorted.y(), 0.0, 1.0, f * y * r2, f * y * r4, f * y * r6,
      f * (r2 + 2.0 * y * y), 2.0 * f * x * y;
  return result;
}

}  // namespace hybridfusion
