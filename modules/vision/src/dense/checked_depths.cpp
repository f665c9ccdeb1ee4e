#include "checked_depths.hpp"

#include "depth_consistency.hpp"
#include "depth_map_store.hpp"
#include "stereo_depth.hpp"
#include "work_images.hpp"

#include <hybridfusion/core/memory.hpp>
#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

namespace hybridfusion {
namespace {

/// The first error of many threads.
class FirstError {
 public:
  void add(const Error& error) {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = error;
  }
  [[nodiscard]] Expected<void> result(const RunContext& ctx) {
    const std::scoped_lock lock(mutex_);
    if (error_) return std::unexpected(*error_);
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    return {};
  }

 private:
  std::mutex mutex_;
  std::optional<Error> error_ = {};
};

std::vector<std::uint32_t> registered_views(const Reconstruction& reconstruction) {
  std::vector<std::uint32_t> views;
  for (std::uint32_t v = 0; v < reconstruction.views.size(); ++v) {
    if (reconstruction.views[v].enu_from_camera) views.push_back(v);
  }
  return views;
}

/// What stereo gave for all photos.
struct StereoStage {
  std::unique_ptr<DepthMapStore> maps;
  double median_depth_m = 0.0;
};

Expected<StereoStage> match_all(std::span<const Photo> photos,
                                const Reconstruction& reconstruction,
                                const DensifyOptions& options,
                                const RunContext& ctx,
                                const std::filesystem::path& scratch) {
  const std::vector<std::uint32_t> views = registered_views(reconstruction);
  const std::size_t max_bytes = static_cast<std::size_t>(options.max_memory_mib) << 20U;
  // A quarter for the photos, which can be decoded again, the rest for their depths.
  WorkImages images(photos, reconstruction, options.max_size_px, max_bytes / 4);
  StereoStage stage;
  HF_TRY(stage.maps, DepthMapStore::create(photos.size(), max_bytes - max_bytes / 4, scratch));
  std::vector<std::vector<std::string>> refusals(photos.size());
  std::vector<double> medians(photos.size(), std::numeric_limits<double>::quiet_NaN());
  const std::unique_ptr<DeviceMatcher> device = DeviceMatcher::open(options.stereo, ctx);
  FirstError error;
  std::mutex mutex;
  std::int64_t done = 0;
  int num_pairs = 0;
  parallel_for(ctx, views.size(), 1, [&](std::size_t i, std::size_t) {
    if (!error.result(ctx)) return;
    const std::uint32_t v = views[i];
    if (images.get(v)) {
      StereoDepthResult result = stereo_depth(reconstruction, v, images, options, device.get());
      medians[v] = median_depth_m(result.map);
      refusals[v] = std::move(result.refusals);
      auto stored = stage.maps->put(v, std::move(result.map));
      if (!stored) error.add(stored.error());
      const std::scoped_lock lock(mutex);
      num_pairs += result.num_pairs;
    }
    const std::scoped_lock lock(mutex);
    ctx.report({.stage = "vision/dense/stereo",
                .done = ++done,
                .total = static_cast<std::int64_t>(views.size())});
  });
  if (auto result = error.result(ctx); !result) return std::unexpected(result.error());
  for (const std::string& failure : images.failures()) {
    if (!failure.empty()) ctx.warn(failure);
  }
  for (const auto& view : refusals) {
    for (const std::string& refusal : view) ctx.warn("stereo pair left out: " + refusal);
  }
  if (num_pairs == 0) {
    return fail(ErrorCode::kInsufficient,
                "no pair of photos can be matched: they share too few points or their intersection "
                "angles are outside vision.densify.min_angle_deg .. max_angle_deg");
  }
  std::erase_if(medians, [](double m) { return std::isnan(m); });
  if (!medians.empty()) {
    std::ranges::sort(medians);
    stage.median_depth_m = medians[medians.size() / 2];
  }
  return stage;
}

/// The photo's map with checked depths; nothing for a photo without a map.
Expected<std::optional<DepthMap>> check_one(DepthMapStore& maps,
                                            std::uint32_t view,
                                            double max_depth_m,
                                            const DepthCheckOptions& options,
                                            const RunContext& ctx) {
  HF_TRY(const DepthMapStore::Handle reference, maps.get(view));
  if (!reference) return std::optional<DepthMap>();
  std::vector<DepthMapStore::Handle> handles;
  std::vector<const DepthMap*> others;
  for (const std::uint32_t other : reference->overlapping) {
    HF_TRY(DepthMapStore::Handle handle, maps.get(other));
    if (!handle) continue;
    others.push_back(handle.get());
    handles.push_back(std::move(handle));
  }
  DepthMap result = *reference;
  CheckedDepth checked = check_depths(*reference, others, options, ctx);
  result.depth_m = std::move(checked.depth_m);
  result.sigma_m = std::move(checked.sigma_m);
  drop_far_depths(result, max_depth_m);
  return std::optional<DepthMap>(std::move(result));
}

}  // namespace

Expected<void> checked_depths(std::span<const Photo> photos,
                              const Reconstruction& reconstruction,
                              const DensifyOptions& options,
                              const RunContext& ctx,
                              const std::filesystem::path& scratch,
                              const std::function<void(const DepthMap&)>& visit) {
  HF_TRY(const StereoStage stage, match_all(photos, reconstruction, options, ctx, scratch));
  const std::vector<std::uint32_t> views = registered_views(reconstruction);
  const double max_depth_m = options.max_gsd_ratio * stage.median_depth_m;
  // One photo at a time on all threads: only the maps that one is checked against are in memory.
  constexpr std::size_t kTrimEvery = 32;  // maps that come and go leave holes in the heap
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i % kTrimEvery == 0) return_freed_memory();
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    HF_TRY(const auto map, check_one(*stage.maps, views[i], max_depth_m, options.check, ctx));
    if (map) visit(*map);
    ctx.report({.stage = "vision/dense/check",
                .done = static_cast<std::int64_t>(i + 1),
                .total = static_cast<std::int64_t>(views.size())});
  }
  return {};
}

}  // namespace hybridfusion
