#include "depth_consistency.hpp"
#include "depth_fusion.hpp"
#include "stereo_depth.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/vision/densify.hpp>

#include <algorithm>
#include <atomic>
#include <mutex>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Runs `work(i)` for each registered view in parallel, with progress and stop.
template <class Work>
Expected<void> for_each_registered(const Reconstruction& reconstruction,
                                   std::string_view stage,
                                   const RunContext& ctx,
                                   Work&& work) {
  std::vector<std::uint32_t> views;
  for (std::uint32_t v = 0; v < reconstruction.views.size(); ++v) {
    if (reconstruction.views[v].enu_from_camera) views.push_back(v);
  }
  std::mutex mutex;
  std::int64_t done = 0;
  parallel_for(ctx, views.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !ctx.stopped(); ++i) {
      work(views[i]);
      const std::scoped_lock lock(mutex);
      ctx.report(
          {.stage = stage, .done = ++done, .total = static_cast<std::int64_t>(views.size())});
    }
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
  return {};
}

/// Photos reduced to working size; empty where a photo is not registered or cannot be decoded.
Expected<std::vector<WorkImage>> load_images(std::span<const Photo> photos,
                                             const Reconstruction& reconstruction,
                                             int max_size_px,
                                             const RunContext& ctx) {
  std::vector<WorkImage> images(photos.size());
  std::vector<std::string> failures(photos.size());
  const auto loaded =
      for_each_registered(reconstruction, "vision/dense/decode", ctx, [&](std::uint32_t v) {
        const Expected<Image8> photo = photos[v].load();
        if (!photo) {
          failures[v] = photo.error().message;
          return;
        }
        const View& view = reconstruction.views[v];
        images[v] = reduce(*photo, reconstruction.cameras[view.camera], max_size_px);
      });
  if (!loaded) return std::unexpected(loaded.error());
  for (const std::string& failure : failures) {
    if (!failure.empty()) ctx.warn(failure);
  }
  return images;
}

/// Twice the median ground sampling distance of the photos at full resolution: what the photos
/// resolve.
double default_voxel_m(const Reconstruction& reconstruction) {
  std::vector<double> gsd;
  for (const View& view : reconstruction.views) {
    if (!view.enu_from_camera) continue;
    const Rigid3 camera_from_enu = view.enu_from_camera->inverse();
    for (std::size_t i = 0; i < view.observations.size(); i += 5) {
      const ScenePoint& point = reconstruction.points[view.observations[i].point];
      const double z = (camera_from_enu * point.point_in_enu).z();
      if (z > 0.0) gsd.push_back(z / reconstruction.cameras[view.camera].focal_px);
    }
  }
  if (gsd.empty()) return 0.0;
  const auto middle = gsd.begin() + static_cast<std::ptrdiff_t>(gsd.size() / 2);
  std::ranges::nth_element(gsd, middle);
  return 2.0 * *middle;
}

Expected<std::vector<DepthMap>> compute_depth_maps(std::span<const Photo> photos,
                                                   const Reconstruction& reconstruction,
                                                   const DensifyOptions& options,
                                                   const RunContext& ctx) {
  HF_TRY(const std::vector<WorkImage> images,
         load_images(photos, reconstruction, options.max_size_px, ctx));
  std::vector<DepthMap> maps(photos.size());
  std::vector<std::vector<std::string>> refusals(photos.size());
  std::atomic<int> num_pairs = 0;
  const auto matched =
      for_each_registered(reconstruction, "vision/dense/stereo", ctx, [&](std::uint32_t v) {
        if (images[v].rgb.empty()) return;
        StereoDepthResult result = stereo_depth(reconstruction, v, images, options);
        erode_depth_edges(result.map, options.check.edge_step, options.check.edge_margin_px);
        num_pairs += result.num_pairs;
        refusals[v] = std::move(result.refusals);
        maps[v] = std::move(result.map);
      });
  if (!matched) return std::unexpected(matched.error());
  for (const auto& view : refusals) {
    for (const std::string& refusal : view) ctx.warn("stereo pair left out: " + refusal);
  }
  if (num_pairs == 0) {
    return fail(ErrorCode::kInsufficient,
                "no pair of photos can be matched: they share too few points or their intersection "
                "angles are outside vision.densify.min_angle_deg .. max_angle_deg");
  }
  return maps;
}

Expected<PointCloud> densify_registered(std::span<const Photo> photos,
                                        const Reconstruction& reconstruction,
                                        const DensifyOptions& options,
                                        const RunContext& ctx) {
  HF_TRY(std::vector<DepthMap> maps, compute_depth_maps(photos, reconstruction, options, ctx));
  std::vector<CheckedDepth> checked(maps.size());
  const auto done =
      for_each_registered(reconstruction, "vision/dense/check", ctx, [&](std::uint32_t v) {
        if (!maps[v].depth_m.values.empty()) checked[v] = check_depths(maps, v, options.check);
      });
  if (!done) return std::unexpected(done.error());
  for (std::size_t v = 0; v < maps.size(); ++v) {
    maps[v].depth_m = std::move(checked[v].depth_m);
    maps[v].sigma_m = std::move(checked[v].sigma_m);
  }
  const double voxel_m = options.voxel_m > 0.0 ? options.voxel_m : default_voxel_m(reconstruction);
  PointCloud cloud = fuse_depth_maps(maps, voxel_m, options, ctx);
  if (cloud.empty()) {
    return fail(ErrorCode::kInsufficient, "no depth is confirmed by a second photo");
  }
  return cloud;
}

}  // namespace

Expected<PointCloud> densify(std::span<const Photo> photos,
                             const Reconstruction& reconstruction,
                             const DensifyOptions& options,
                             const RunContext& ctx) {
  HF_CHECK(photos.size() == reconstruction.views.size());
  const auto registered = std::ranges::count_if(
      reconstruction.views, [](const View& v) { return v.enu_from_camera.has_value(); });
  if (registered < 2) {
    return fail(
        ErrorCode::kInsufficient,
        fmt::format("a dense cloud needs at least 2 registered photos, got {}", registered));
  }
  try {
    return densify_registered(photos, reconstruction, options, ctx);
  } catch (const cv::Exception& e) {
    return fail(ErrorCode::kInsufficient, std::string("OpenCV failed on a photo: ") + e.what());
  }
}

}  // namespace hybridfusion
