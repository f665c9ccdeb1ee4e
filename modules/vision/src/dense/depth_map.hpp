#pragma once

#include "image_plane.hpp"
#include "image_warp.hpp"

#include <hybridfusion/core/floor.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/vision/rectification.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Depths of one photo on its undistorted grid.
struct DepthMap {
  std::uint32_t view = 0;
  PinholeGrid grid = {};
  Rigid3 enu_from_camera = {};
  double disparity_sigma_px = 0.25;  ///< Of one pair's disparities: what `sigma_m` starts from.
  ImagePlane<float> depth_m = {};    ///< Along the optical axis; NaN where there is none.
  ImagePlane<float> sigma_m = {};
  ImagePlane<std::uint8_t> num_pairs = {};  ///< Partners that gave this depth.
  ImagePlane<Rgb8> rgb = {};
  ImagePlane<std::uint8_t> grey = {};           ///< grey_plane(rgb)
  ImagePlane<std::uint8_t> mask = {};           ///< 0 where the photo has no data.
  std::vector<std::uint32_t> partners = {};     ///< Views that it was matched with.
  std::vector<std::uint32_t> overlapping = {};  ///< Views that see the same points, best first.

  [[nodiscard]] bool has_depth(int x, int y) const {
    return depth_m.contains(x, y) && !std::isnan(depth_m.at(x, y));
  }
  [[nodiscard]] Eigen::Vector3d point_in_enu(int x, int y, double depth) const {
    return enu_from_camera * Eigen::Vector3d(depth * ray_of(grid, {x, y}));
  }
};

[[nodiscard]] ImagePlane<std::uint8_t> grey_plane(const ImagePlane<Rgb8>& rgb);

/// Depth at a position between pixels: bilinear over four valid depths of one surface, else the
/// nearest pixel's. NaN when that has none.
[[nodiscard]] inline float depth_at(const DepthMap& map, float u, float v) {
  constexpr float kSameSurface = 0.01F;  // neighbouring depths of one surface seldom differ by more
  const int x = floor_to_int(u);
  const int y = floor_to_int(v);
  if (x >= 0 && y >= 0 && x + 1 < map.depth_m.width && y + 1 < map.depth_m.height) {
    const float* top = map.depth_m.row(y) + x;
    const float* bottom = map.depth_m.row(y + 1) + x;
    const float low = std::min(std::min(top[0], top[1]), std::min(bottom[0], bottom[1]));
    const float high = std::max(std::max(top[0], top[1]), std::max(bottom[0], bottom[1]));
    const bool all_valid = !std::isnan(top[0] + top[1] + bottom[0] + bottom[1]);
    if (all_valid && high - low < kSameSurface * high) {
      const float s = u - static_cast<float>(x);
      const float t = v - static_cast<float>(y);
      return (1 - t) * ((1 - s) * top[0] + s * top[1]) + t * ((1 - s) * bottom[0] + s * bottom[1]);
    }
  }
  const int nearest_x = floor_to_int(u + 0.5F);
  const int nearest_y = floor_to_int(v + 0.5F);
  return map.depth_m.contains(nearest_x, nearest_y) ? map.depth_m.at(nearest_x, nearest_y)
                                                    : std::numeric_limits<float>::quiet_NaN();
}

/// A depth hypothesis and its standard deviation.
struct DepthGuess {
  double depth_m = 0.0;
  double sigma_m = 0.0;
  int count = 1;  ///< Guesses that were merged.
};

/// Inverse-variance mean of the guesses that agree with the best supported one (within three
/// standard deviations of their difference). Ties go to the first. @pre not empty
[[nodiscard]] DepthGuess merge_guesses(const std::vector<DepthGuess>& guesses);

/// Median of every seventh pixel's depth; NaN without depths.
[[nodiscard]] double median_depth_m(const DepthMap& map);

/// Drops depths beyond `max_depth_m`.
void drop_far_depths(DepthMap& map, double max_depth_m);

/// Drops depths within `margin_px` of a step by more than the share `edge_step` of the depth.
void erode_depth_edges(DepthMap& map, double edge_step, int margin_px);

}  // namespace hybridfusion
