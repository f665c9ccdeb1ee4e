#include "incremental_mapper.hpp"
#include "triangulation.hpp"

#include <algorithm>
#include <numeric>

namespace hybridfusion {
namespace {

constexpr std::size_t kLocalViews = 6;
constexpr int kTracksPerView = 640;
constexpr int kLocalIterations = 10;
constexpr int kGlobalIterations = 15;
constexpr std::size_t kRadialViews = 3;  // two views hardly tell focal length from shape

}  // namespace

Expected<void> IncrementalMapper::adjust_around(std::uint32_t view) {
  std::vector<std::size_t> shared(model_.world_from_view.size(), 0);
  AdjustmentRequest request;
  for (const TrackReference& reference : model_.tracks_of_view[view]) {
    if (!model_.points[reference.track] ||
        !model_.tracks[reference.track][reference.element].active) {
      continue;
    }
    request.tracks.push_back(reference.track);
    for (const TrackElement& e : model_.tracks[reference.track]) {
      if (e.active && e.view != view) ++shared[e.view];
    }
  }
  std::vector<std::uint32_t> neighbors = model_.registered();
  std::erase_if(neighbors, [&](std::uint32_t v) { return shared[v] == 0; });
  std::ranges::stable_sort(neighbors, std::greater<>{}, [&](std::uint32_t v) { return shared[v]; });
  // The neighbours that share most are free; those behind them hold the frame.
  const std::size_t free = std::min(neighbors.size() / 2, kLocalViews);
  request.free_views.assign(neighbors.begin(),
                            neighbors.begin() + static_cast<std::ptrdiff_t>(free));
  request.fixed_views.assign(neighbors.begin() + static_cast<std::ptrdiff_t>(free),
                             neighbors.end());
  request.free_views.push_back(view);
  request.loss_width_px = options_.adjustment.loss_width_px;
  request.max_iterations = kLocalIterations;
  if (request.fixed_views.empty()) return {};
  HF_TRY([[maybe_unused]] const auto summary, adjust(model_, request, options_.intrinsics, ctx_));
  return {};
}

Expected<void> IncrementalMapper::adjust_all() {
  const std::size_t count = model_.num_registered();
  AdjustmentRequest request;
  request.free_views = model_.registered();
  request.tracks = select_tracks(model_, kTracksPerView);
  request.loss_width_px = options_.adjustment.loss_width_px;
  request.max_iterations = kGlobalIterations;
  if (count >= static_cast<std::size_t>(options_.intrinsics.principal_point_min_views)) {
    request.calibration = CalibrationLevel::kFull;
  } else if (count >= kRadialViews) {
    request.calibration = CalibrationLevel::kRadial;
  }
  HF_TRY([[maybe_unused]] const auto summary, adjust(model_, request, options_.intrinsics, ctx_));
  // Points outside the selection follow their moved cameras.
  std::vector<std::uint32_t> all(model_.tracks.size());
  std::iota(all.begin(), all.end(), 0);
  triangulate_tracks(model_, all, options_.mapping, ctx_);
  return {};
}

}  // namespace hybridfusion
