#include "depth_consistency.hpp"

#include <algorithm>
#include <limits>

namespace hybridfusion {
namespace {

/// Another depth map as the reference sees it.
struct OtherView {
  const DepthMap* map;
  Rigid3 other_from_reference;
  bool is_partner;
};

std::vector<OtherView> others_of(std::span<const DepthMap> maps, const DepthMap& reference) {
  std::vector<OtherView> others;
  for (const std::uint32_t view : reference.overlapping) {
    if (maps[view].depth_m.values.empty()) continue;
    others.push_back(
        {.map = &maps[view],
         .other_from_reference = maps[view].enu_from_camera.inverse() * reference.enu_from_camera,
         .is_partner = std::ranges::find(reference.partners, view) != reference.partners.end()});
  }
  return others;
}

struct Verdict {
  std::vector<DepthGuess> supporting;
  std::vector<const OtherView*> supporters;
  int violations = 0;
};

/// Compares a depth of the reference with what the other depth maps hold in its direction.
void compare(const Eigen::Vector3d& ray,
             const DepthGuess& own,
             std::span<const OtherView> others,
             const DepthCheckOptions& options,
             Verdict& verdict) {
  verdict.supporting.assign(1, own);
  verdict.supporters.clear();
  verdict.violations = 0;
  const Eigen::Vector3d point = own.depth_m * ray;
  for (const OtherView& other : others) {
    const Eigen::Vector3d p = other.other_from_reference * point;
    if (!(p.z() > 0.0)) continue;
    const Eigen::Vector2d pixel = pixel_of(other.map->grid, p);
    const std::optional<double> seen = depth_at(*other.map, pixel);
    if (!seen) continue;
    const auto column = static_cast<int>(std::lround(pixel.x()));
    const auto row = static_cast<int>(std::lround(pixel.y()));
    const double sigma = other.map->has_depth(column, row)
                             ? static_cast<double>(other.map->sigma_m.at(column, row))
                             : own.sigma_m;
    const double step = std::max(own.sigma_m, sigma) / kDisparitySigmaPx;  // one pixel of disparity
    const double tolerance =
        std::min(options.max_relative_depth * p.z(), options.max_disparity_px * step);
    const double gap = *seen - p.z();
    if (std::abs(gap) <= tolerance) {
      // The gap along the other ray, carried over to the own one.
      const double own_gap = gap * (p.norm() / p.z()) / ray.norm();
      verdict.supporting.push_back({own.depth_m + own_gap, sigma});
      verdict.supporters.push_back(&other);
    } else if (gap > 2.0 * tolerance) {
      ++verdict.violations;  // the other photo looks through the point
    }
  }
}

constexpr int kPatch = 2;  // 5 x 5 pixels

double grey_of(const Rgb8& c) {
  return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
}

/// Grey value between pixels; nothing outside the photo.
std::optional<double> grey_at(const DepthMap& map, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(std::floor(pixel.x()));
  const int y = static_cast<int>(std::floor(pixel.y()));
  if (!map.rgb.contains(x, y) || !map.rgb.contains(x + 1, y + 1)) return std::nullopt;
  if (map.mask.at(x, y) == 0 || map.mask.at(x + 1, y + 1) == 0) return std::nullopt;
  const double u = pixel.x() - x;
  const double v = pixel.y() - y;
  return (1 - v) * ((1 - u) * grey_of(map.rgb.at(x, y)) + u * grey_of(map.rgb.at(x + 1, y))) +
         v * ((1 - u) * grey_of(map.rgb.at(x, y + 1)) + u * grey_of(map.rgb.at(x + 1, y + 1)));
}

/// Zero-mean normalised cross-correlation of the 5 x 5 pixels around (x, y) with where the other
/// photo sees their points; the depth of each pixel is its own where it has one (slanted windows).
std::optional<double> correlation(
    const DepthMap& reference, int x, int y, double depth, const OtherView& other) {
  constexpr double kSameSurface = 0.01;
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int dy = -kPatch; dy <= kPatch; ++dy) {
    for (int dx = -kPatch; dx <= kPatch; ++dx) {
      const int u = x + dx;
      const int v = y + dy;
      if (!reference.rgb.contains(u, v)) return std::nullopt;
      double z = depth;
      if (reference.has_depth(u, v) &&
          std::abs(reference.depth_m.at(u, v) - depth) < kSameSurface * depth) {
        z = reference.depth_m.at(u, v);
      }
      const Eigen::Vector3d p =
          other.other_from_reference * Eigen::Vector3d(z * ray_of(reference.grid, {u, v}));
      if (!(p.z() > 0.0)) return std::nullopt;
      const std::optional<double> theirs = grey_at(*other.map, pixel_of(other.map->grid, p));
      if (!theirs) return std::nullopt;
      const double ours = grey_of(reference.rgb.at(u, v));
      n += 1;
      a += ours;
      b += *theirs;
      aa += ours * ours;
      bb += *theirs * *theirs;
      ab += ours * *theirs;
    }
  }
  const double variance = (aa - a * a / n) * (bb - b * b / n);
  return variance > 1e-9 ? (ab - a * b / n) / std::sqrt(variance) : 0.0;
}

/// Photos that were not matched with the reference judge first; its partners only where no other
/// photo sees the point.
bool looks_alike(const DepthMap& reference,
                 int x,
                 int y,
                 double depth,
                 const std::vector<const OtherView*>& supporters,
                 double min_correlation) {
  constexpr int kMaxJudges = 3;
  for (const bool partners : {false, true}) {
    int judges = 0;
    for (const OtherView* other : supporters) {
      if (other->is_partner != partners || judges == kMaxJudges) continue;
      const std::optional<double> value = correlation(reference, x, y, depth, *other);
      if (!value) continue;
      if (*value >= min_correlation) return true;
      ++judges;
    }
    if (judges > 0) return false;
  }
  return false;
}

}  // namespace

CheckedDepth check_depths(std::span<const DepthMap> maps,
                          std::uint32_t reference_view,
                          const DepthCheckOptions& options) {
  const DepthMap& reference = maps[reference_view];
  const std::vector<OtherView> others = others_of(maps, reference);
  CheckedDepth result{.depth_m = reference.depth_m, .sigma_m = reference.sigma_m};
  Verdict verdict;
  for (int y = 0; y < reference.grid.height_px; ++y) {
    for (int x = 0; x < reference.grid.width_px; ++x) {
      if (!reference.has_depth(x, y)) continue;
      const DepthGuess own{reference.depth_m.at(x, y), reference.sigma_m.at(x, y)};
      compare(ray_of(reference.grid, {x, y}), own, others, options, verdict);
      const int support = static_cast<int>(verdict.supporters.size());
      const bool keep =
          support >= options.min_supporting_views && support > verdict.violations &&
          looks_alike(reference, x, y, own.depth_m, verdict.supporters, options.min_correlation);
      const DepthGuess merged = keep ? merge_guesses(verdict.supporting) : own;
      result.depth_m.at(x, y) =
          keep ? static_cast<float>(merged.depth_m) : std::numeric_limits<float>::quiet_NaN();
      result.sigma_m.at(x, y) = static_cast<float>(merged.sigma_m);
    }
  }
  return result;
}

}  // namespace hybridfusion
