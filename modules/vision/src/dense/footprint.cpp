#include "footprint.hpp"

#include <algorithm>
#include <limits>

namespace hybridfusion {

namespace {

constexpr int kTileColumns = 64;

std::optional<std::array<Eigen::Vector3f, 8>> block_of(
    const DepthMap& map, int begin_x, int end_x, int first_row, int end_row) {
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = 0.0F;
  for (int y = first_row; y < end_row; ++y) {
    const float* depths = map.depth_m.row(y);
    for (int x = begin_x; x < end_x; ++x) {
      // False for NaN.
      if (depths[x] < nearest) nearest = depths[x];
      if (depths[x] > farthest) farthest = depths[x];
    }
  }
  if (!(nearest <= farthest)) return std::nullopt;
  std::array<Eigen::Vector3f, 8> corners;
  std::size_t k = 0;
  for (const int y : {first_row, end_row - 1}) {
    for (const int x : {begin_x, end_x - 1}) {
      const Eigen::Vector3f ray = ray_of(map.grid, {x, y}).cast<float>();
      corners[k++] = nearest * ray;
      corners[k++] = farthest * ray;
    }
  }
  return corners;
}

}  // namespace

std::vector<DepthTile> tiles_of_rows(const DepthMap& map, int first_row, int end_row) {
  std::vector<DepthTile> tiles;
  for (int begin = 0; begin < map.grid.width_px; begin += kTileColumns) {
    const int end = std::min(map.grid.width_px, begin + kTileColumns);
    tiles.push_back({begin, end, block_of(map, begin, end, first_row, end_row)});
  }
  return tiles;
}

bool may_see(const PinholeGrid& grid, const std::array<Eigen::Vector3f, 8>& corners) {
  constexpr float kMargin_px = 2.0F;  // of rounding and of what lies between pixels
  Eigen::Array2f low = Eigen::Array2f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array2f high = -low;
  int behind = 0;
  for (const Eigen::Vector3f& p : corners) {
    if (!(p.z() > 0.0F)) {
      ++behind;
      continue;
    }
    const Eigen::Array2f pixel = static_cast<float>(grid.focal_px) * p.head<2>().array() / p.z() +
                                 grid.principal_point_px.cast<float>().array();
    low = low.min(pixel);
    high = high.max(pixel);
  }
  if (behind == 8) return false;
  if (behind > 0) return true;  // the block's image is not bounded by that of its corners
  const Eigen::Array2f size(static_cast<float>(grid.width_px), static_cast<float>(grid.height_px));
  return (high >= -kMargin_px).all() && (low <= size + kMargin_px).all();
}

}  // namespace hybridfusion
