#include "live/live_depth.hpp"

#include "dense/depth_consistency.hpp"
#include "dense/stereo_depth.hpp"
#include "robust_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::size_t kKeptMaps = 12;    // that may confirm the next ones
constexpr std::size_t kKeptPhotos = 64;  // reduced photos in memory: a strip or two

std::size_t num_depths(const ImagePlane<float>& depth) {
  return static_cast<std::size_t>(
      std::ranges::count_if(depth.values, [](float d) { return !std::isnan(d); }));
}

}  // namespace

LiveDepth::LiveDepth(const DensifyOptions& densify, const StreamingOptions& live)
    : options_(densify), max_points_(static_cast<std::size_t>(live.preview_points_per_photo)) {
  options_.max_size_px = live.preview_size_px;
  options_.num_neighbors = live.preview_neighbors;
}

void LiveDepth::add_photo(const PhotoMetadata& metadata, std::shared_ptr<const Image8> reduced) {
  photos_.push_back(
      {.metadata = metadata, .load = [image = std::move(reduced)]() -> Expected<Image8> {
         if (!image) return fail(ErrorCode::kNotFound, "the photo cannot be read");
         return *image;
       }});
  if (photos_.size() <= kKeptPhotos) return;
  photos_[photos_.size() - 1 - kKeptPhotos].load = []() -> Expected<Image8> {
    return fail(ErrorCode::kNotFound, "the photo came too long ago to be matched with");
  };
}

PhotoPoints LiveDepth::thinned(const DepthMap& map) const {
  const double share = static_cast<double>(num_depths(map.depth_m)) /
                       static_cast<double>(std::max<std::size_t>(1, max_points_));
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
  PhotoPoints points;
  for (int y = 0; y < map.grid.height_px; y += step) {
    for (int x = 0; x < map.grid.width_px; x += step) {
      if (!map.has_depth(x, y)) continue;
      points.in_camera.emplace_back(
          (map.depth_m.at(x, y) * ray_of(map.grid, {x, y})).cast<float>());
      points.colors.push_back(map.rgb.at(x, y));
    }
  }
  return points;
}

std::optional<PhotoPoints> LiveDepth::points_of(const Reconstruction& reconstruction,
                                                std::uint32_t view,
                                                const RunContext& ctx) {
  if (!device_sought_) device_ = DeviceMatcher::open(options_.stereo, ctx);
  device_sought_ = true;
  WorkImages images(photos_, reconstruction, options_.max_size_px, std::size_t{64} << 20U);
  if (!images.get(view)) return std::nullopt;
  DepthMap map = stereo_depth(reconstruction, view, images, options_, device_.get()).map;
  const double median_m = median_depth_m(map);
  if (std::isnan(median_m)) return std::nullopt;  // no depths, or next to none
  focal_px_ = map.grid.focal_px;
  medians_m_.push_back(median_m);
  std::vector<const DepthMap*> others;
  for (const std::uint32_t other : map.overlapping) {
    for (DepthMap& kept : maps_) {
      if (kept.view != other) continue;
      kept.enu_from_camera = *reconstruction.views[other].enu_from_camera;
      others.push_back(&kept);
    }
  }
  DepthMap checked = map;
  if (!others.empty()) {
    CheckedDepth depth = check_depths(map, others, options_.check, ctx);
    checked.depth_m = std::move(depth.depth_m);
    checked.sigma_m = std::move(depth.sigma_m);
    drop_far_depths(checked, options_.max_gsd_ratio * median(medians_m_));
  }
  maps_.push_back(std::move(map));
  if (maps_.size() > kKeptMaps) maps_.pop_front();
  if (others.empty()) return std::nullopt;
  return thinned(checked);
}

void LiveDepth::scale(double factor) {
  for (double& depth_m : medians_m_) depth_m *= factor;
  for (DepthMap& map : maps_) {
    for (float& depth_m : map.depth_m.values) depth_m *= static_cast<float>(factor);
    for (float& sigma_m : map.sigma_m.values) sigma_m *= static_cast<float>(factor);
  }
}

double LiveDepth::default_voxel_m() const {
  if (medians_m_.empty() || !(focal_px_ > 0.0)) return 0.0;
  return 2.0 * median(medians_m_) / focal_px_;
}

}  // namespace hybridfusion
