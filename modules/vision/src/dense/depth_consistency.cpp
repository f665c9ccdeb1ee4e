#include "depth_consistency.hpp"

#include "footprint.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace hybridfusion {
namespace {

constexpr int kPatch = 2;      // 5 x 5 pixels
constexpr int kBandRows = 16;  // rows checked at a time: what the others show there fits the cache
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr float kSameSurface = 0.01F;  // neighbouring depths of one surface seldom differ by more

/// Another depth map as the reference sees it.
struct OtherView {
  const DepthMap* map;
  Eigen::Matrix3f rotation;  // other from reference
  Eigen::Vector3f translation;
  bool is_partner;
};

std::vector<OtherView> others_of(const DepthMap& reference, std::span<const DepthMap* const> maps) {
  std::vector<OtherView> others;
  for (const DepthMap* map : maps) {
    const Rigid3 other_from_reference = map->enu_from_camera.inverse() * reference.enu_from_camera;
    others.push_back({.map = map,
                      .rotation = other_from_reference.rotation.toRotationMatrix().cast<float>(),
                      .translation = other_from_reference.translation.cast<float>(),
                      .is_partner = std::ranges::find(reference.partners, map->view) !=
                                    reference.partners.end()});
  }
  return others;
}

/// What another photo shows at a depth of the reference.
struct Seen {
  float grey = kNothing;     // at the point's pixel; nothing outside the photo
  float depth_m = kNothing;  // carried over to the reference's own ray, when it supports
  float sigma_m = 0.0F;
  bool looks_through = false;
  bool has_depth = false;  // of its own, whether it supports or not
};

/// Grey value between pixels; nothing outside the photo.
float grey_at(const DepthMap& map, float u, float v) {
  const int x = static_cast<int>(std::floor(u));
  const int y = static_cast<int>(std::floor(v));
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

/// The rows of a band, and two above and below, as another photo shows them.
class Band {
 public:
  Band(const DepthMap& reference, const DepthCheckOptions& options)
      : reference_(reference), options_(options) {}

  /// @param tiles  Of these rows.
  void look(const OtherView& other, std::span<const DepthTile> tiles, int first_row, int end_row);
  [[nodiscard]] const Seen& at(int x, int y) const { return seen_.at(x, y - first_row_); }
  [[nodiscard]] const OtherView& other() const { return *other_; }
  [[nodiscard]] std::optional<float> correlation(int x, int y) const;

 private:
  [[nodiscard]] Seen look_at(int x, int y) const;

  const DepthMap& reference_;
  const DepthCheckOptions& options_;
  const OtherView* other_ = nullptr;
  int first_row_ = 0;
  ImagePlane<Seen> seen_;
};

void Band::look(const OtherView& other,
                std::span<const DepthTile> tiles,
                int first_row,
                int end_row) {
  other_ = &other;
  first_row_ = first_row;
  const int width = reference_.grid.width_px;
  if (seen_.width != width || seen_.height < end_row - first_row) {
    seen_ = {width, end_row - first_row};
  }
  for (const DepthTile& tile : tiles) {
    const bool sees = tile_is_seen(tile, other);
    for (int y = first_row; y < end_row; ++y) {
      Seen* row = seen_.row(y - first_row);
      for (int x = tile.begin_x; x < tile.end_x; ++x) row[x] = sees ? look_at(x, y) : Seen{};
    }
  }
}

Seen Band::look_at(int x, int y) const {
  Seen seen;
  const float depth = reference_.depth_m.at(x, y);
  if (std::isnan(depth)) return seen;
  const Eigen::Vector3f ray = ray_of(reference_.grid, {x, y}).cast<float>();
  const Eigen::Vector3f p = other_->rotation * (depth * ray) + other_->translation;
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
  seen.grey = grey_at(map, u, v);
  const std::optional<double> theirs = depth_at(map, {u, v});
  if (!theirs) return seen;
  seen.has_depth = true;
  const int column = static_cast<int>(std::floor(u + 0.5F));
  const int row = static_cast<int>(std::floor(v + 0.5F));
  const float own_sigma = reference_.sigma_m.at(x, y);
  const float sigma = map.has_depth(column, row) ? map.sigma_m.at(column, row) : own_sigma;
  const float step =  // one pixel of disparity
      std::max(own_sigma, sigma) / static_cast<float>(reference_.disparity_sigma_px);
  const float tolerance = std::min(static_cast<float>(options_.max_relative_depth) * p.z(),
                                   static_cast<float>(options_.max_disparity_px) * step);
  const float gap = static_cast<float>(*theirs) - p.z();
  if (std::abs(gap) <= tolerance) {
    // The gap along the other ray, carried over to the own one.
    seen.depth_m = depth + gap * (p.norm() / p.z()) / ray.norm();
    seen.sigma_m = sigma;
  } else {
    seen.looks_through = gap > 2.0F * tolerance;
  }
  return seen;
}

/// Zero-mean normalised cross-correlation of the 5 x 5 pixels around (x, y) with where the other
/// photo shows their points. Each pixel counts with its own depth (slanted windows); those without
/// one, or on another surface, do not count. Nothing when few are left.
std::optional<float> Band::correlation(int x, int y) const {
  constexpr float kMinCount = 9.0F;
  const float depth = reference_.depth_m.at(x, y);
  const auto middle = static_cast<float>(reference_.grey.at(x, y));
  const int begin = std::max(0, x - kPatch);
  const int end = std::min(reference_.grid.width_px, x + kPatch + 1);
  float n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int v = std::max(0, y - kPatch); v < std::min(reference_.grid.height_px, y + kPatch + 1);
       ++v) {
    const Seen* seen = seen_.row(v - first_row_);
    const float* depths = reference_.depth_m.row(v);
    const std::uint8_t* grey = reference_.grey.row(v);
    for (int u = begin; u < end; ++u) {
      // False for NaN.
      const bool counts =
          std::abs(depths[u] - depth) < kSameSurface * depth && seen[u].grey >= 0.0F;
      const float weight = counts ? 1.0F : 0.0F;
      const float ours = counts ? static_cast<float>(grey[u]) - middle : 0.0F;
      const float theirs = counts ? seen[u].grey - middle : 0.0F;
      n += weight;
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

/// Photos that have the depth and were not matched with the reference judge first, then its
/// partners that have it, then photos that know no depth there.
bool looks_alike(std::span<const Band> bands, int x, int y, double min_correlation) {
  constexpr int kMaxJudges = 3;
  enum class Judge { kOther, kPartner, kWithoutDepth };
  const auto kind_of = [&](const Band& band) -> std::optional<Judge> {
    const Seen& seen = band.at(x, y);
    if (!seen.has_depth) return Judge::kWithoutDepth;
    if (std::isnan(seen.depth_m)) return std::nullopt;
    return band.other().is_partner ? Judge::kPartner : Judge::kOther;
  };
  for (const Judge kind : {Judge::kOther, Judge::kPartner, Judge::kWithoutDepth}) {
    int judges = 0;
    for (const Band& band : bands) {
      if (judges == kMaxJudges || kind_of(band) != kind) continue;
      const std::optional<float> value = band.correlation(x, y);
      if (!value) continue;
      if (*value >= min_correlation) return true;
      ++judges;
    }
    if (judges > 0) return false;
  }
  return false;
}

/// The depth at a pixel after the check; nothing when it fails.
std::optional<DepthGuess> checked_depth(const DepthMap& reference,
                                        std::span<const Band> bands,
                                        int x,
                                        int y,
                                        const DepthCheckOptions& options,
                                        std::vector<DepthGuess>& supporting) {
  supporting.assign(1, {reference.depth_m.at(x, y), reference.sigma_m.at(x, y)});
  int violations = 0;
  for (const Band& band : bands) {
    const Seen& seen = band.at(x, y);
    if (seen.looks_through) ++violations;
    if (!std::isnan(seen.depth_m)) supporting.push_back({seen.depth_m, seen.sigma_m});
  }
  // A second pair of the reference is a second photo that agrees.
  const int other_pairs = reference.num_pairs.at(x, y) - 1;
  const int support = static_cast<int>(supporting.size()) - 1 + other_pairs;
  if (support < options.min_supporting_views || support <= violations) return std::nullopt;
  if (!looks_alike(bands, x, y, options.min_correlation)) return std::nullopt;
  return merge_guesses(supporting);
}

}  // namespace

CheckedDepth check_depths(const DepthMap& reference,
                          std::span<const DepthMap* const> maps,
                          const DepthCheckOptions& options) {
  const std::vector<OtherView> others = others_of(reference, maps);
  const int width = reference.grid.width_px;
  const int height = reference.grid.height_px;
  CheckedDepth result{.depth_m = {width, height, kNothing}, .sigma_m = {width, height, 0.0F}};
  std::vector<Band> bands(others.size(), Band(reference, options));
  std::vector<DepthGuess> supporting;
  for (int begin = 0; begin < height; begin += kBandRows) {
    const int end = std::min(height, begin + kBandRows);
    const int first_row = std::max(0, begin - kPatch);
    const int end_row = std::min(height, end + kPatch);
    const std::vector<DepthTile> tiles = tiles_of_rows(reference, first_row, end_row);
    for (std::size_t i = 0; i < others.size(); ++i) {
      bands[i].look(others[i], tiles, first_row, end_row);
    }
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        if (!reference.has_depth(x, y)) continue;
        const auto depth = checked_depth(reference, bands, x, y, options, supporting);
        if (!depth) continue;
        result.depth_m.at(x, y) = static_cast<float>(depth->depth_m);
        result.sigma_m.at(x, y) = static_cast<float>(depth->sigma_m);
      }
    }
  }
  return result;
}

}  // namespace hybridfusion
