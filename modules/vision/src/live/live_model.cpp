#include "live/live_model.hpp"

#include "enu_alignment.hpp"
#include "incremental_mapper.hpp"

#include <hybridfusion/core/geodetic.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::size_t kSeedPhotos = 12;  // of which the first model is made: the last that came
constexpr std::size_t kProbePairs = 3;

/// Only a stop ends the stream; a solver that fails costs accuracy until the next adjustment.
Expected<void> unless_cancelled(const Expected<void>& done, const RunContext& ctx) {
  if (done) return {};
  if (done.error().code == ErrorCode::kCancelled) return std::unexpected(done.error());
  ctx.warn(done.error().message);
  return {};
}

}  // namespace

LiveModel::LiveModel(const ReconstructionOptions& options,
                     const StreamingOptions& live,
                     PhotoCache cache)
    : options_(options), live_(live), cache_(std::move(cache)) {
  cache_.keys.clear();
}

/// Positions of all photos so far, in the frame of the first that were usable: the median of the
/// positions wanders while a flight goes on.
void LiveModel::take_positions() {
  auto ingested = ingest_gnss(metadata_, options_.gnss);
  gnss_ = ingested ? *std::move(ingested) : without_gnss(metadata_, ingested.error().message);
  if (ingested && !origin_) origin_ = gnss_.origin;
  if (!origin_) return;
  for (PhotoFix& fix : gnss_.fixes) {
    if (!fix.position_in_enu) continue;
    fix.position_in_enu =
        enu_from_geodetic(*origin_, geodetic_from_enu(gnss_.origin, *fix.position_in_enu));
  }
  gnss_.origin = *origin_;
}

/// The camera of the last photo; what was estimated of the others stays.
void LiveModel::take_camera() {
  const CameraSetup all =
      group_cameras(metadata_, options_.intrinsics, options_.features.max_size_px);
  for (std::size_t c = cameras_.cameras.size(); c < all.cameras.size(); ++c) {
    cameras_.cameras.push_back(all.cameras[c]);
    model_.priors.push_back(all.cameras[c]);
    model_.cameras.push_back(all.cameras[c].intrinsics);
  }
  cameras_.camera_of_photo = all.camera_of_photo;
  model_.camera_of_view = all.camera_of_photo;
  for (std::size_t c = 0; c < model_.cameras.size(); ++c) {
    cameras_.cameras[c].intrinsics = model_.cameras[c];
  }
}

Expected<std::vector<VerifiedPair>> LiveModel::match_last(const RunContext& ctx) {
  const auto last = static_cast<std::uint32_t>(metadata_.size() - 1);
  std::vector<bool> usable;
  for (const FeatureSet& f : features_) usable.push_back(f.size() > 0);
  std::vector<PhotoPair> pairs;
  for (const std::uint32_t other :
       live_partners(metadata_, gnss_, usable, options_.pairs, live_.max_pairs)) {
    // In order of name, as reconstruct() has them: the cache serves both.
    const bool other_first = metadata_[other].name < metadata_[last].name;
    pairs.push_back(other_first ? PhotoPair{other, last} : PhotoPair{last, other});
  }
  HF_TRY(std::vector<RawPair> raw, match_pairs(features_, pairs, options_.matching, ctx, &cache_));
  HF_TRY(std::vector<VerifiedPair> verified,
         verify_pairs(features_, cameras_, raw, options_.matching, ctx));
  if (!probed_) std::ranges::move(raw, std::back_inserter(raw_));
  return verified;
}

/// Once, when there are pairs enough to tell: the lens distortion, and with it all pairs again.
Expected<void> LiveModel::probe_once(std::vector<VerifiedPair>& fresh, const RunContext& ctx) {
  if (probed_ || raw_.size() < kProbePairs) return {};
  probed_ = true;
  if (!options_.intrinsics.probe_lens) return {};
  probe_lenses(cameras_, features_, raw_, ctx);
  for (std::size_t c = 0; c < model_.cameras.size(); ++c) {
    model_.priors[c] = cameras_.cameras[c];
    model_.cameras[c] = cameras_.cameras[c].intrinsics;
  }
  HF_TRY(fresh, verify_pairs(features_, cameras_, raw_, options_.matching, ctx));
  pairs_.clear();
  model_.tracks.clear();
  model_.points.clear();
  tracks_ = {};
  for (const FeatureSet& f : features_) tracks_.add_view(f);
  raw_.clear();
  return {};
}

/// Model points on the tracks of a view.
std::size_t LiveModel::num_visible(std::uint32_t view) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      model_.tracks_of_view[view],
      [&](const TrackReference& reference) { return model_.points[reference.track].has_value(); }));
}

/// Views that may be registered now: while there is no model the last ones, then the new one and,
/// of those that wait, the ones that see most points, if more than at their last trial.
std::vector<bool> LiveModel::candidates() const {
  std::vector<bool> usable(metadata_.size(), false);
  std::vector<std::pair<std::size_t, std::uint32_t>> waiting;
  for (auto v = static_cast<std::uint32_t>(metadata_.size()); v-- > 0;) {
    if (model_.world_from_view[v] || features_[v].size() == 0) continue;
    if (adjusted_views_ == 0) {
      usable[v] = true;
      if (static_cast<std::size_t>(std::ranges::count(usable, true)) == kSeedPhotos) break;
      continue;
    }
    const std::size_t visible = num_visible(v);
    const bool enough = visible >= static_cast<std::size_t>(options_.mapping.min_resection_inliers);
    if (enough && 5 * visible >= 6 * tried_with_[v]) waiting.emplace_back(visible, v);
  }
  const auto count = std::min(waiting.size(), static_cast<std::size_t>(live_.max_waiting_photos));
  std::ranges::sort(waiting, std::greater<>{});
  for (std::size_t k = 0; k < count; ++k) usable[waiting[k].second] = true;
  if (features_.back().size() > 0) usable.back() = true;
  return usable;
}

Expected<void> LiveModel::register_waiting(const RunContext& ctx) {
  const std::vector<bool> usable = candidates();
  if (adjusted_views_ == 0) {  // what is too old for the first model is no use any more
    std::erase_if(pairs_, [&](const VerifiedPair& pair) {
      return !usable[pair.views.first] || !usable[pair.views.second];
    });
  }
  IncrementalMapper mapper(model_, pairs_, gnss_, options_, ctx);
  Expected<void> done;
  if (adjusted_views_ == 0) {
    done = mapper.grow(usable);
    if (static_cast<int>(model_.num_registered()) >= options_.mapping.min_model_photos) {
      adjusted_views_ = model_.num_registered();
    } else {
      for (auto& pose : model_.world_from_view) pose.reset();
    }
  } else {
    bool found = true;
    while (done && found) {
      auto next = mapper.register_next(usable);
      found = next.value_or(true);  // the view of a failed adjustment has its resected pose
      if (!next) done = std::unexpected(next.error());
      if (!next && next.error().code != ErrorCode::kCancelled) {
        done = unless_cancelled(done, ctx);
      }
    }
  }
  if (adjusted_views_ > 0) pairs_.clear();  // only a first model starts from pairs
  for (std::uint32_t v = 0; v < reasons_.size(); ++v) {
    if (usable[v] && adjusted_views_ > 0) tried_with_[v] = num_visible(v);
    if (model_.world_from_view[v]) {
      reasons_[v].clear();
    } else if (!mapper.reasons()[v].empty()) {
      reasons_[v] = mapper.reasons()[v];
    } else if (reasons_[v].empty()) {
      reasons_[v] = "waits for more photos that overlap it";
    }
  }
  return unless_cancelled(done, ctx);
}

Expected<bool> LiveModel::adjust_if_grown(const RunContext& ctx) {
  const std::size_t count = model_.num_registered();
  if (static_cast<double>(count) < live_.global_growth * static_cast<double>(adjusted_views_)) {
    return false;
  }
  adjusted_views_ = count;
  IncrementalMapper mapper(model_, pairs_, gnss_, options_, ctx);
  if (auto done = unless_cancelled(mapper.adjust_all(), ctx); !done) {
    return std::unexpected(done.error());
  }
  return true;
}

/// By GNSS where it tells the place; else once as level photos hold it.
/// @returns the scale of the similarity, when there was one.
std::optional<double> LiveModel::place(const RunContext& ctx) {
  const auto alignment =
      align_to_enu(model_, gnss_, metadata_, Random(ctx.seed, "vision/alignment"));
  if (!alignment && (georeferenced_ || in_any_frame_)) return std::nullopt;
  const Sim3 target_from_world =
      alignment ? alignment->enu_from_world : align_to_nothing(model_, metadata_).enu_from_world;
  transform_model(model_, target_from_world);
  (alignment ? georeferenced_ : in_any_frame_) = true;
  return target_from_world.scale;
}

Expected<LiveModel::Step> LiveModel::add(const PhotoMetadata& photo,
                                         FeatureSet features,
                                         const std::string& key,
                                         const std::string& error,
                                         const RunContext& ctx) {
  metadata_.push_back(photo);
  cache_.keys.push_back(cache_.load ? key : std::string());
  features_.push_back(std::move(features));
  reasons_.push_back(error);
  tried_with_.push_back(0);
  model_.world_from_view.emplace_back();
  tracks_.add_view(features_.back());
  take_positions();
  take_camera();
  Step step;
  if (features_.back().size() == 0) {
    index_tracks(model_);
    return step;
  }
  HF_TRY(std::vector<VerifiedPair> fresh, match_last(ctx));
  step.num_pairs = fresh.size();
  if (step.num_pairs == 0 && metadata_.size() > 1) {
    reasons_.back() = "no matches with the photos before it";
  }
  if (auto done = probe_once(fresh, ctx); !done) return std::unexpected(done.error());
  for (const VerifiedPair& pair : fresh) tracks_.add_pair(features_, pair, model_);
  index_tracks(model_);
  if (adjusted_views_ == 0) std::ranges::move(fresh, std::back_inserter(pairs_));
  const bool first = adjusted_views_ == 0;
  const std::vector<std::uint32_t> before = model_.registered();
  if (auto done = register_waiting(ctx); !done) return std::unexpected(done.error());
  std::ranges::set_difference(model_.registered(), before, std::back_inserter(step.registered));
  if (step.registered.empty()) return step;
  bool adjusted = first;
  if (!first) {
    HF_TRY(adjusted, adjust_if_grown(ctx));
  }
  // Until there is a place every photo may tell it.
  if (!adjusted && georeferenced_) return step;
  const std::optional<double> scale = place(ctx);
  step.moved = adjusted || scale.has_value();
  step.scale = scale.value_or(1.0);
  return step;
}

}  // namespace hybridfusion
