#include "incremental_mapper.hpp"

#include "resection.hpp"
#include "triangulation.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxSeeds = 10;
constexpr std::size_t kMinSeedPoints = 50;

/// Model points that an unregistered view should see.
struct Visible {
  std::vector<Eigen::Vector2d> pixels;
  std::vector<Eigen::Vector3d> points;
};

Visible visible_points(const SfmModel& model, std::uint32_t view) {
  Visible visible;
  for (const TrackReference& reference : model.tracks_of_view[view]) {
    if (!model.points[reference.track]) continue;
    visible.pixels.push_back(model.tracks[reference.track][reference.element].pixel);
    visible.points.push_back(*model.points[reference.track]);
  }
  return visible;
}

/// Occupied cells of grids of 2, 4 and 8 cells a side, finer ones counting more: many points in one
/// corner hold a camera worse than fewer spread out.
double coverage(const Visible& visible, const CameraIntrinsics& camera) {
  double score = 0.0;
  for (const int cells : {2, 4, 8}) {
    std::vector<bool> occupied(static_cast<std::size_t>(cells * cells), false);
    for (const Eigen::Vector2d& pixel : visible.pixels) {
      const int x = std::clamp(static_cast<int>(pixel.x() * cells / camera.width_px), 0, cells - 1);
      const int y =
          std::clamp(static_cast<int>(pixel.y() * cells / camera.height_px), 0, cells - 1);
      occupied[static_cast<std::size_t>(y * cells + x)] = true;
    }
    score += cells * static_cast<double>(std::ranges::count(occupied, true));
  }
  return score;
}

}  // namespace

IncrementalMapper::IncrementalMapper(SfmModel& model,
                                     std::span<const VerifiedPair> pairs,
                                     const GnssIngest& gnss,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx)
    : model_(model),
      pairs_(pairs),
      gnss_(gnss),
      options_(options),
      ctx_(ctx),
      reasons_(model.world_from_view.size()),
      tried_with_(model.world_from_view.size(), 0) {}

/// Many matches, a wide angle, and more than a plane.
std::vector<std::size_t> IncrementalMapper::ranked_seeds(const std::vector<bool>& usable) const {
  constexpr double kGoodAngle_rad = 12.0 * std::numbers::pi / 180.0;
  constexpr double kMinAngle_rad = 2.0 * std::numbers::pi / 180.0;
  constexpr double kPlanarShare = 0.9;
  constexpr double kPlanarPenalty = 0.3;
  std::vector<std::pair<double, std::size_t>> scored;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const VerifiedPair& pair = pairs_[k];
    if (!usable[pair.views.first] || !usable[pair.views.second]) continue;
    if (pair.median_angle_rad < kMinAngle_rad) continue;
    const double angle = std::min(1.0, pair.median_angle_rad / kGoodAngle_rad);
    const double depth = pair.homography_share > kPlanarShare ? kPlanarPenalty : 1.0;
    scored.emplace_back(-static_cast<double>(pair.matches.size()) * angle * depth, k);
  }
  std::ranges::sort(scored);
  std::vector<std::size_t> seeds;
  for (const auto& [score, k] : scored) seeds.push_back(k);
  if (seeds.size() > kMaxSeeds) seeds.resize(kMaxSeeds);
  return seeds;
}

void IncrementalMapper::clear() {
  for (auto& pose : model_.world_from_view) pose.reset();
  for (auto& point : model_.points) point.reset();
  for (Track& track : model_.tracks) {
    for (TrackElement& element : track) element.active = false;
  }
  std::ranges::fill(tried_with_, 0);
}

Expected<bool> IncrementalMapper::start(const VerifiedPair& seed) {
  clear();
  model_.world_from_view[seed.views.first] = Rigid3{};
  model_.world_from_view[seed.views.second] = seed.second_from_first.inverse();
  extend(seed.views.first);
  const auto points = static_cast<std::size_t>(
      std::ranges::count_if(model_.points, [](const auto& p) { return p.has_value(); }));
  if (points < kMinSeedPoints) return false;
  if (auto adjusted = adjust_all(); !adjusted) return std::unexpected(adjusted.error());
  return true;
}

Expected<void> IncrementalMapper::grow(const std::vector<bool>& usable) {
  const auto wanted = static_cast<std::size_t>(std::ranges::count(usable, true));
  SfmModel best;
  std::vector<std::string> best_reasons;
  for (const std::size_t k : ranked_seeds(usable)) {
    HF_TRY(const bool started, start(pairs_[k]));
    if (!started) continue;
    double adjusted_views = 2.0;
    while (true) {
      if (ctx_.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
      HF_TRY(const bool found, register_next(usable));
      if (!found) break;
      const auto count = static_cast<double>(model_.num_registered());
      ctx_.report({.stage = "vision/mapping",
                   .done = static_cast<std::int64_t>(count),
                   .total = static_cast<std::int64_t>(wanted)});
      if (count < options_.mapping.global_growth * adjusted_views) continue;
      if (auto adjusted = adjust_all(); !adjusted) return adjusted;
      adjusted_views = count;
    }
    if (auto adjusted = adjust_all(); !adjusted) return adjusted;
    if (model_.num_registered() > (best.world_from_view.empty() ? 2 : best.num_registered())) {
      best = model_;
      best_reasons = reasons_;
    }
    // Another seed is worth its cost only when this one reached less than half.
    if (2 * model_.num_registered() > wanted) break;
  }
  clear();
  if (!best.world_from_view.empty()) {
    model_ = std::move(best);
    reasons_ = std::move(best_reasons);
  }
  for (const std::uint32_t view : model_.registered()) reasons_[view].clear();
  return {};
}

Expected<bool> IncrementalMapper::register_next(const std::vector<bool>& usable) {
  std::vector<std::pair<double, std::uint32_t>> candidates;
  for (std::uint32_t view = 0; view < model_.world_from_view.size(); ++view) {
    if (model_.world_from_view[view] || !usable[view]) continue;
    const Visible visible = visible_points(model_, view);
    const auto count = visible.points.size();
    if (static_cast<int>(count) < options_.mapping.min_resection_inliers) {
      reasons_[view] = fmt::format("shares {} points with the model ({} needed)",
                                   count,
                                   options_.mapping.min_resection_inliers);
      continue;
    }
    // A view that failed is tried again when a fifth more points are visible.
    if (5 * count < 6 * tried_with_[view]) continue;
    candidates.emplace_back(-coverage(visible, model_.camera_of(view)), view);
  }
  std::ranges::sort(candidates);
  for (const auto& [score, view] : candidates) {
    if (!try_view(view)) continue;
    extend(view);
    if (auto adjusted = adjust_around(view); !adjusted) return std::unexpected(adjusted.error());
    return true;
  }
  return false;
}

bool IncrementalMapper::try_view(std::uint32_t view) {
  const Visible visible = visible_points(model_, view);
  const auto resection =
      resect_camera(model_.camera_of(view),
                    visible.pixels,
                    visible.points,
                    {.max_error_px = options_.mapping.max_error_px * model_.pixel_scale(view),
                     .min_inliers = options_.mapping.min_resection_inliers},
                    Random(ctx_.seed, "vision/resection", view));
  tried_with_[view] = visible.points.size();
  constexpr double kMinShare = 0.25;  // fewer agree by chance in repetitive scenes
  if (!resection || static_cast<double>(resection->inliers.size()) <
                        kMinShare * static_cast<double>(visible.points.size())) {
    reasons_[view] = fmt::format("{} of {} shared points agree on a pose",
                                 resection ? resection->inliers.size() : 0,
                                 visible.points.size());
    return false;
  }
  if (!plausible(view, resection->world_from_camera.translation)) {
    reasons_[view] = "its pose contradicts its GNSS position";
    return false;
  }
  model_.world_from_view[view] = resection->world_from_camera;
  return true;
}

/// Against a similarity from the other registered views to GNSS; true when there is none.
bool IncrementalMapper::plausible(std::uint32_t view, const Eigen::Vector3d& centre) const {
  constexpr std::size_t kMinViews = 6;
  constexpr double kMinTolerance_m = 30.0;
  constexpr double kSigmas = 5.0;
  const PhotoFix& fix = gnss_.fixes[view];
  if (!fix.position_in_enu) return true;
  std::vector<Eigen::Vector3d> target;
  std::vector<Eigen::Vector3d> source;
  for (const std::uint32_t other : model_.registered()) {
    if (!gnss_.fixes[other].position_in_enu) continue;
    target.push_back(*gnss_.fixes[other].position_in_enu);
    source.push_back(model_.world_from_view[other]->translation);
  }
  if (target.size() < kMinViews) return true;
  const auto enu_from_world = fit_sim3(target, source);
  if (!enu_from_world) return true;
  double worst_m = 0.0;  // how badly the others fit says how far a good one may be off
  for (std::size_t i = 0; i < target.size(); ++i) {
    worst_m = std::max(worst_m, (*enu_from_world * source[i] - target[i]).norm());
  }
  const double tolerance_m =
      std::max({kMinTolerance_m, kSigmas * fix.sigma_m.maxCoeff(), 3.0 * worst_m});
  return (*enu_from_world * centre - *fix.position_in_enu).norm() < tolerance_m;
}

/// Triangulates what the view newly sees twice and adds it to points that it confirms.
void IncrementalMapper::extend(std::uint32_t view) {
  std::vector<std::uint32_t> fresh;
  for (const TrackReference& reference : model_.tracks_of_view[view]) {
    auto& point = model_.points[reference.track];
    TrackElement& element = model_.tracks[reference.track][reference.element];
    if (point && model_.error_px(element, *point) <= options_.mapping.max_error_px) {
      element.active = true;
    } else if (!point) {
      fresh.push_back(reference.track);
    }
  }
  triangulate_tracks(model_, fresh, options_.mapping, ctx_);
}

}  // namespace hybridfusion
