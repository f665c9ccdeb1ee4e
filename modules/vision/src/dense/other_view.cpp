#include "other_view.hpp"

#include <hybridfusion/core/floor.hpp>

#include <algorithm>
#include <array>

namespace hybridfusion {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr float kSameSurface = 0.01F;  // neighbouring depths of one surface seldom differ by more

/// Grey value between pixels; nothing outside the photo.
float grey_at(const DepthMap& map, float u, float v) {
  if (std::isnan(u)) return kNothing;
  const int x = floor_to_int(u);
  const int y = floor_to_int(v);
  if (x < 0 || y < 0 || x + 1 >= map.grey.width || y + 1 >= map.grey.height) return kNothing;
  if (map.mask.at(x, y) == 0 || map.mask.at(x + 1, y + 1) == 0) return kNothing;
  const std::uint8_t* top = map.grey.row(y) + x;
  const std::uint8_t* bottom = map.grey.row(y + 1) + x;
  const float s = u - static_cast<float>(x);
  const float t = v - static_cast<float>(y);
  return (1 - t) * ((1 - s) * static_cast<float>(top[0]) + s * static_cast<float>(top[1])) +
         t * ((1 - s) * static_cast<float>(bottom[0]) + s * static_cast<float>(bottom[1]));
}

bool tile_is_seen(const DepthTile& tile, const OtherView& other) {
  if (!tile.corners) return false;
  std::array<Eigen::Vector3f, 8> corners = *tile.corners;
  for (Eigen::Vector3f& p : corners) p = other.rotation * p + other.translation;
  return may_see(other.map->grid, corners);
}

}  // namespace

void OtherViewBand::look(const OtherView& other,
                         std::span<const DepthTile> tiles,
                         int first_row,
                         int end_row) {
  other_ = &other;
  first_row_ = first_row;
  const int width = reference_.grid.width_px;
  const auto per_px = static_cast<float>(1.0 / reference_.grid.focal_px);
  if (seen_.width != width || seen_.height < end_row - first_row) {
    seen_ = {width, end_row - first_row};
  }
  for (const DepthTile& tile : tiles) {
    const bool sees = tile_is_seen(tile, other);
    for (int y = first_row; y < end_row; ++y) {
      Seen* row = seen_.row(y - first_row);
      if (!sees) {
        std::fill(row + tile.begin_x, row + tile.end_x, Seen{});
        continue;
      }
      const Eigen::Vector3f ray = ray_of(reference_.grid, {0.0, y}).cast<float>();
      const Eigen::Vector3f turned = other.rotation * ray;
      for (int x = tile.begin_x; x < tile.end_x; ++x) {
        const float along = static_cast<float>(x) * per_px;
        row[x] = look_at(x, y, turned + along * other.rotation.col(0));
      }
    }
  }
}

Seen OtherViewBand::look_at(int x, int y, const Eigen::Vector3f& ray_in_other) const {
  Seen seen;
  const float depth = reference_.depth_m.at(x, y);
  if (std::isnan(depth)) return seen;
  const Eigen::Vector3f p = depth * ray_in_other + other_->translation;
  if (!(p.z() > 0.0F)) return seen;
  const DepthMap& map = *other_->map;
  const auto focal = static_cast<float>(map.grid.focal_px);
  const float u = focal * p.x() / p.z() + static_cast<float>(map.grid.principal_point_px.x());
  const float v = focal * p.y() / p.z() + static_cast<float>(map.grid.principal_point_px.y());
  // Also where the division overflowed: no pixel is that far out.
  if (!(u > -1.0F && v > -1.0F && u < static_cast<float>(map.grid.width_px) &&
        v < static_cast<float>(map.grid.height_px))) {
    return seen;
  }
  seen.u = u;
  seen.v = v;
  const float theirs = depth_at(map, u, v);
  if (std::isnan(theirs)) return seen;
  seen.has_depth = true;
  const int column = floor_to_int(u + 0.5F);
  const int row = floor_to_int(v + 0.5F);
  const float own_sigma = reference_.sigma_m.at(x, y);
  const float sigma = map.has_depth(column, row) ? map.sigma_m.at(column, row) : own_sigma;
  const float step =  // one pixel of disparity
      std::max(own_sigma, sigma) / static_cast<float>(reference_.disparity_sigma_px);
  const float tolerance = std::min(static_cast<float>(options_.max_relative_depth) * p.z(),
                                   static_cast<float>(options_.max_disparity_px) * step);
  const float gap = theirs - p.z();
  if (std::abs(gap) <= tolerance) {
    // The gap along the other ray, carried over to the own one.
    seen.depth_m = depth + gap * (p.norm() / p.z()) / ray_in_other.norm();
    seen.sigma_m = sigma;
  } else {
    seen.looks_through = gap > 2.0F * tolerance;
  }
  return seen;
}

/// Zero-mean normalised cross-correlation of the 5 x 5 pixels around (x, y) with where the other
/// photo shows their points. Each pixel counts with its own depth (slanted windows); those without
/// one, or on another surface, do not count. Nothing when few are left.
std::optional<float> OtherViewBand::correlation(int x, int y) const {
  constexpr float kMinCount = 9.0F;
  const float depth = reference_.depth_m.at(x, y);
  const auto middle = static_cast<float>(reference_.grey.at(x, y));
  const int begin = std::max(0, x - kCorrelationReach_px);
  const int end = std::min(reference_.grid.width_px, x + kCorrelationReach_px + 1);
  float n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int v = std::max(0, y - kCorrelationReach_px);
       v < std::min(reference_.grid.height_px, y + kCorrelationReach_px + 1);
       ++v) {
    const Seen* seen = seen_.row(v - first_row_);
    const float* depths = reference_.depth_m.row(v);
    const std::uint8_t* grey = reference_.grey.row(v);
    for (int u = begin; u < end; ++u) {
      if (!(std::abs(depths[u] - depth) < kSameSurface * depth)) continue;  // also NaN
      const float their_grey = grey_at(*other_->map, seen[u].u, seen[u].v);
      if (std::isnan(their_grey)) continue;
      const float ours = static_cast<float>(grey[u]) - middle;
      const float theirs = their_grey - middle;
      n += 1.0F;
      a += ours;
      b += theirs;
      aa += ours * ours;
      bb += theirs * theirs;
      ab += ours * theirs;
    }
  }
  if (n < kMinCount) return std::nullopt;
  const float variance = (aa - a * a / n) * (bb - b * b / n);
  return variance > 1e-3F ? (ab - a * b / n) / std::sqrt(variance) : 0.0F;
}

}  // namespace hybridfusion
