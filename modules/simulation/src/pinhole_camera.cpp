#include "pinhole_camera.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr std::size_t kTableSize = 2048;
constexpr double kFullFrameDiagonal_mm = 43.2666;  // 36 x 24 mm

}  // namespace

PinholeCamera::PinholeCamera(
    int width, int height, double focal, Eigen::Vector2d principal, double k1_in, double k2_in)
    : width_px(width),
      height_px(height),
      focal_px(focal),
      principal_px(std::move(principal)),
      k1(k1_in),
      k2(k2_in) {
  const double reach_x = std::max(principal_px.x(), width - principal_px.x()) + 2.0;
  const double reach_y = std::max(principal_px.y(), height - principal_px.y()) + 2.0;
  table_end_ = (reach_x * reach_x + reach_y * reach_y) / (focal * focal);
  undistort_.resize(kTableSize + 1);
  for (std::size_t i = 0; i <= kTableSize; ++i) {
    const double r_d = std::sqrt(table_end_ * static_cast<double>(i) / kTableSize);
    double r = r_d;
    for (int step = 0; step < 12; ++step) {
      const double r2 = r * r;
      const double residual = r * (1.0 + k1 * r2 + k2 * r2 * r2) - r_d;
      r -= residual / (1.0 + 3.0 * k1 * r2 + 5.0 * k2 * r2 * r2);
    }
    undistort_[i] = r_d > 0.0 ? r / r_d : 1.0;
  }
}

Eigen::Vector3d PinholeCamera::direction(double x_px, double y_px) const {
  const double x = (x_px - principal_px.x()) / focal_px;
  const double y = (y_px - principal_px.y()) / focal_px;
  const double slot = std::min((x * x + y * y) / table_end_, 1.0) * kTableSize;
  const auto i = std::min(static_cast<std::size_t>(slot), kTableSize - 1);
  const double t = slot - static_cast<double>(i);
  const double scale = (1.0 - t) * undistort_[i] + t * undistort_[i + 1];
  return {x * scale, y * scale, 1.0};
}

bool PinholeCamera::project(const Eigen::Vector3d& point, Eigen::Vector2d& pixel) const {
  if (point.z() <= 0.05) return false;
  const Eigen::Vector2d flat = point.head<2>() / point.z();
  const double r2 = flat.squaredNorm();
  if (r2 > 1.2 * table_end_) return false;
  pixel = focal_px * (1.0 + k1 * r2 + k2 * r2 * r2) * flat + principal_px;
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= width_px - 1.0 &&
         pixel.y() <= height_px - 1.0;
}

double exif_focal_px(const CameraOptions& options) {
  return options.focal_35mm / kFullFrameDiagonal_mm *
         std::hypot(options.width_px, options.height_px);
}

PinholeCamera make_true_camera(const CameraOptions& options, std::uint64_t seed) {
  Random random(seed, "camera/intrinsics");
  const double focal = exif_focal_px(options) * (1.0 + options.focal_error_sd * random.normal());
  const Eigen::Vector2d principal(
      0.5 * (options.width_px - 1) + options.principal_point_sd_px * random.normal(),
      0.5 * (options.height_px - 1) + options.principal_point_sd_px * random.normal());
  return {options.width_px, options.height_px, focal, principal, options.k1, options.k2};
}

}  // namespace hybridfusion
