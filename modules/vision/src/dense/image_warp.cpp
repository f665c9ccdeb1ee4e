#include "image_warp.hpp"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace hybridfusion {

CameraIntrinsics scaled(const CameraIntrinsics& intrinsics, int width_px, int height_px) {
  CameraIntrinsics result = intrinsics;
  const double x_scale = static_cast<double>(width_px) / intrinsics.width_px;
  const double y_scale = static_cast<double>(height_px) / intrinsics.height_px;
  result.width_px = width_px;
  result.height_px = height_px;
  result.focal_px *= 0.5 * (x_scale + y_scale);
  result.principal_point_px.x() = (intrinsics.principal_point_px.x() + 0.5) * x_scale - 0.5;
  result.principal_point_px.y() = (intrinsics.principal_point_px.y() + 0.5) * y_scale - 0.5;
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
  const cv::Size size(static_cast<int>(std::lround(photo.width * scale)),
                      static_cast<int>(std::lround(photo.height * scale)));
  if (scale < 1.0) {
    cv::resize(rgb, result.rgb, size, 0.0, 0.0, cv::INTER_AREA);
  } else {
    result.rgb = rgb.clone();
  }
  result.intrinsics = scaled(intrinsics, size.width, size.height);
  return result;
}

WarpedImage warp(const WorkImage& image,
                 const PinholeGrid& grid,
                 const Eigen::Quaterniond& camera_from_grid) {
  const CameraIntrinsics& c = image.intrinsics;
  const Eigen::Matrix3d rotation = camera_from_grid.toRotationMatrix();
  cv::Mat map(grid.height_px, grid.width_px, CV_32FC2);
  WarpedImage result;
  result.mask = cv::Mat(grid.height_px, grid.width_px, CV_8UC1, cv::Scalar(0));
  for (int y = 0; y < grid.height_px; ++y) {
    auto* source = map.ptr<cv::Vec2f>(y);
    auto* mask = result.mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < grid.width_px; ++x) {
      const Eigen::Vector3d ray = rotation * ray_of(grid, {x, y});
      Eigen::Vector2d pixel(-10.0, -10.0);
      if (ray.z() > 0.1) pixel = project(c, ray);
      source[x] = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
      const bool inside = pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= c.width_px - 1 &&
                          pixel.y() <= c.height_px - 1;
      mask[x] = inside ? 255 : 0;
    }
  }
  cv::remap(image.rgb, result.rgb, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

PinholeGrid undistorted_grid(const CameraIntrinsics& intrinsics) {
  return {.width_px = intrinsics.width_px,
          .height_px = intrinsics.height_px,
          .focal_px = intrinsics.focal_px,
          .principal_point_px = intrinsics.principal_point_px};
}

}  // namespace hybridfusion
