#include "image_warp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace hybridfusion {

CameraIntrinsics scaled(const CameraIntrinsics& intrinsics, int width_px, int height_px) {
  CameraIntrinsics result = intrinsics;
  const double scale = static_cast<double>(std::max(width_px, height_px)) /
                       std::max(intrinsics.width_px, intrinsics.height_px);
  result.width_px = width_px;
  result.height_px = height_px;
  result.focal_px *= scale;
  result.principal_point_px = scale * (intrinsics.principal_point_px + Eigen::Vector2d(0.5, 0.5)) -
                              Eigen::Vector2d(0.5, 0.5);
  return result;
}

WorkImage reduce(const Image8& photo, const CameraIntrinsics& intrinsics, int max_size_px) {
  const cv::Mat full(photo.height,
                     photo.width,
                     photo.channels == 3 ? CV_8UC3 : CV_8UC1,
                     const_cast<std::uint8_t*>(photo.pixels.data()));
  cv::Mat rgb;
  if (photo.channels == 3) {
    rgb = full;
  } else {
    cv::cvtColor(full, rgb, cv::COLOR_GRAY2RGB);
  }
  const double scale =
      std::min(1.0, static_cast<double>(max_size_px) / std::max(photo.width, photo.height));
  WorkImage result;
  if (scale < 1.0) {
    // By the scale, not to a size: the shorter side would be squeezed to a whole number of pixels.
    cv::resize(rgb, result.rgb, {}, scale, scale, cv::INTER_AREA);
  } else {
    result.rgb = rgb.clone();
  }
  cv::cvtColor(result.rgb, result.grey, cv::COLOR_RGB2GRAY);
  result.intrinsics = scaled(intrinsics, result.rgb.cols, result.rgb.rows);
  return result;
}

namespace {

/// Where the centre of a grid pixel lies in the photo; nothing behind the camera.
std::optional<Eigen::Vector2d> source_of(const CameraIntrinsics& camera,
                                         const PinholeGrid& grid,
                                         const Eigen::Matrix3d& camera_from_grid,
                                         int x,
                                         int y) {
  const Eigen::Vector3d ray = camera_from_grid * ray_of(grid, {x, y});
  if (!(ray.z() > 0.1)) return std::nullopt;
  return project(camera, ray);
}

constexpr int kLatticeStep = 4;

/// Source positions at every fourth pixel of a grid. Between them they are interpolated: at usual
/// focal lengths the curvature of distortion and perspective leaves less than 1/200 px.
struct Lattice {
  int columns = 0;
  std::vector<cv::Vec2f> nodes = {};

  Lattice(const CameraIntrinsics& camera,
          const PinholeGrid& grid,
          const Eigen::Matrix3d& camera_from_grid)
      : columns(grid.width_px / kLatticeStep + 2) {
    const int rows = grid.height_px / kLatticeStep + 2;
    nodes.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        const auto at =
            source_of(camera, grid, camera_from_grid, i * kLatticeStep, j * kLatticeStep);
        nodes.push_back(at ? cv::Vec2f(static_cast<float>(at->x()), static_cast<float>(at->y()))
                           : cv::Vec2f::all(std::numeric_limits<float>::quiet_NaN()));
      }
    }
  }
  [[nodiscard]] const cv::Vec2f* row(int j) const {
    return nodes.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(columns);
  }
};

}  // namespace

WarpMap warp_map(const CameraIntrinsics& camera,
                 const PinholeGrid& grid,
                 const Eigen::Quaterniond& camera_from_grid) {
  const Eigen::Matrix3d rotation = camera_from_grid.toRotationMatrix();
  const Lattice lattice(camera, grid, rotation);
  WarpMap result{.source = cv::Mat(grid.height_px, grid.width_px, CV_32FC2),
                 .mask = cv::Mat(grid.height_px, grid.width_px, CV_8UC1)};
  const auto last_x = static_cast<float>(camera.width_px - 1);
  const auto last_y = static_cast<float>(camera.height_px - 1);
  for (int y = 0; y < grid.height_px; ++y) {
    const cv::Vec2f* above = lattice.row(y / kLatticeStep);
    const cv::Vec2f* below = lattice.row(y / kLatticeStep + 1);
    const float t = static_cast<float>(y % kLatticeStep) / kLatticeStep;
    auto* source = result.source.ptr<cv::Vec2f>(y);
    auto* mask = result.mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < grid.width_px; ++x) {
      const int i = x / kLatticeStep;
      const float s = static_cast<float>(x % kLatticeStep) / kLatticeStep;
      const cv::Vec2f left = above[i] + t * (below[i] - above[i]);
      const cv::Vec2f right = above[i + 1] + t * (below[i + 1] - above[i + 1]);
      cv::Vec2f at = left + s * (right - left);
      if (std::isnan(at[0])) {
        const auto exact =
            source_of(camera, grid, rotation, x, y).value_or(Eigen::Vector2d(-9, -9));
        at = {static_cast<float>(exact.x()), static_cast<float>(exact.y())};
      }
      source[x] = at;
      const bool inside = at[0] >= 0.0F && at[1] >= 0.0F && at[0] <= last_x && at[1] <= last_y;
      mask[x] = inside ? 255 : 0;
    }
  }
  return result;
}

cv::Mat resample(const cv::Mat& photo, const WarpMap& map) {
  cv::Mat result;
  cv::remap(photo, result, map.source, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

PinholeGrid undistorted_grid(const CameraIntrinsics& intrinsics) {
  constexpr int kSteps = 32;
  constexpr double kMaxGrowth = 1.5;  // a distortion that moves the border farther is not real
  constexpr double kRounding_px = 1e-3;
  const Eigen::Vector2d last(intrinsics.width_px - 1, intrinsics.height_px - 1);
  const Eigen::Vector2d middle = 0.5 * last;
  Eigen::Vector2d low = middle;
  Eigen::Vector2d high = middle;
  const auto enclose = [&](double x_share, double y_share) {
    const Eigen::Vector2d pixel = last.cwiseProduct(Eigen::Vector2d(x_share, y_share));
    Eigen::Vector2d at =
        intrinsics.principal_point_px + intrinsics.focal_px * unproject(intrinsics, pixel);
    if (!at.allFinite()) at = pixel;  // the model folds before the border
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  };
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    enclose(share, 0.0);
    enclose(share, 1.0);
    enclose(0.0, share);
    enclose(1.0, share);
  }
  low = low.cwiseMax(middle - kMaxGrowth * middle);
  high = high.cwiseMin(middle + kMaxGrowth * middle);
  const Eigen::Vector2i first = (low.array() + kRounding_px).floor().cast<int>();
  const Eigen::Vector2i end = (high.array() - kRounding_px).ceil().cast<int>() + 1;
  return {.width_px = end.x() - first.x(),
          .height_px = end.y() - first.y(),
          .focal_px = intrinsics.focal_px,
          .principal_point_px = intrinsics.principal_point_px - first.cast<double>()};
}

}  // namespace hybridfusion
