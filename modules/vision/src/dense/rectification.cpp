#include <hybridfusion/vision/rectification.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// cos(60 deg): beyond, the rectified images would be stretched more than twofold.
constexpr double kMinAxisSine = 0.5;
// Rays flatter than this against the rectified axis are left out of the image.
constexpr double kMinRayCosine = 0.45;

Eigen::Vector3d optical_axis(const PosedCamera& camera) {
  return camera.enu_from_camera.rotation * Eigen::Vector3d::UnitZ();
}

/// Columns are the rectified axes in ENU.
Eigen::Matrix3d rectified_axes(const PosedCamera& first, const PosedCamera& second) {
  const Eigen::Vector3d x =
      (second.enu_from_camera.translation - first.enu_from_camera.translation).normalized();
  const Eigen::Vector3d mean_axis = optical_axis(first) + optical_axis(second);
  const Eigen::Vector3d z = (mean_axis - x * x.dot(mean_axis)).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return axes;
}

struct Bounds {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
};

/// Extent of a photo in the rectified plane z = 1, from points along its border.
Bounds extent_of(const PosedCamera& camera, const Eigen::Quaterniond& enu_from_rectified) {
  constexpr int kSteps = 32;
  const CameraIntrinsics& c = camera.intrinsics;
  const Eigen::Quaterniond rectified_from_camera =
      enu_from_rectified.conjugate() * camera.enu_from_camera.rotation;
  Bounds bounds;
  const auto add = [&](double x_share, double y_share) {
    const Eigen::Vector2d pixel(x_share * (c.width_px - 1), y_share * (c.height_px - 1));
    const Eigen::Vector3d ray =
        (rectified_from_camera * unproject(c, pixel).homogeneous()).normalized();
    const double z = std::max(ray.z(), kMinRayCosine);
    bounds.low = bounds.low.cwiseMin(ray.head<2>() / z);
    bounds.high = bounds.high.cwiseMax(ray.head<2>() / z);
  };
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    add(share, 0.0);
    add(share, 1.0);
    add(0.0, share);
    add(1.0, share);
  }
  return bounds;
}

/// Rows and columns of the first photo that the second can see at the given depths.
Bounds common_extent(const Bounds& first, const Bounds& second, double near_gap, double far_gap) {
  Bounds common;
  common.low.y() = std::max(first.low.y(), second.low.y());
  common.high.y() = std::min(first.high.y(), second.high.y());
  common.low.x() = std::max(first.low.x(), second.low.x() + far_gap);
  common.high.x() = std::min(first.high.x(), second.high.x() + near_gap);
  return common;
}

int disparity_count(double near_gap_px, double far_gap_px) {
  const int steps = static_cast<int>(std::ceil((near_gap_px - far_gap_px) / 4.0));
  return 4 * std::max(1, steps) + 1;
}

}  // namespace

double rectified_depth_m(const PosedCamera& first,
                         const PosedCamera& second,
                         const Eigen::Vector3d& point_in_enu) {
  return rectified_axes(first, second).col(2).dot(point_in_enu - first.enu_from_camera.translation);
}

Expected<RectifiedGeometry> rectify(const PosedCamera& first,
                                    const PosedCamera& second,
                                    const RectificationRequest& request) {
  HF_CHECK(request.focal_px > 0.0 && request.near_m > 0.0 && request.far_m > request.near_m);
  const Eigen::Vector3d baseline =
      second.enu_from_camera.translation - first.enu_from_camera.translation;
  const double baseline_m = baseline.norm();
  if (!(baseline_m > 0.0)) return fail(ErrorCode::kDegenerate, "the two photos share one centre");
  for (const PosedCamera* camera : {&first, &second}) {
    const double sine = optical_axis(*camera).cross(baseline).norm() / baseline_m;
    if (!(sine > kMinAxisSine)) {
      return fail(ErrorCode::kDegenerate, "the baseline runs along the view (forward motion)");
    }
  }

  RectifiedGeometry result;
  result.baseline_m = baseline_m;
  result.enu_from_rectified = Eigen::Quaterniond(rectified_axes(first, second)).normalized();
  const double near_gap = baseline_m / request.near_m;  // on the plane z = 1
  const double far_gap = baseline_m / request.far_m;
  const Bounds extent = common_extent(extent_of(first, result.enu_from_rectified),
                                      extent_of(second, result.enu_from_rectified),
                                      near_gap,
                                      far_gap);
  const double f = request.focal_px;
  const Eigen::Vector2d size_px = f * (extent.high - extent.low);
  if (!(size_px.minCoeff() > 16.0)) {
    return fail(ErrorCode::kDegenerate, "the two photos do not overlap once rectified");
  }

  // Multiples of four, so that the images halve twice without a remainder.
  const Eigen::Vector2i size = 4 * (size_px / 4.0).array().ceil().cast<int>();
  result.left = {.width_px = size.x(),
                 .height_px = size.y(),
                 .focal_px = f,
                 .principal_point_px = -f * extent.low};
  result.num_disparities = disparity_count(f * near_gap, f * far_gap);
  result.first_column_gap = f * far_gap;
  result.right = result.left;
  result.right.width_px += result.num_disparities - 1;
  result.right.principal_point_px.x() += result.first_column_gap + result.num_disparities - 1;
  return result;
}

}  // namespace hybridfusion
