#include "matched_photos.hpp"

#include "appearance.hpp"
#include "cached_features.hpp"
#include "control_placement.hpp"
#include "fragments.hpp"
#include "georeference.hpp"
#include "gnss_adjustment.hpp"
#include "pair_verification.hpp"
#include "second_round.hpp"
#include "shutter_adjustment.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <atomic>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Expected<FeatureStage> extract_all(std::span<const Photo> photos,
                                   const FeatureOptions& options,
                                   const PhotoCache* cache,
                                   const RunContext& ctx) {
  FeatureStage stage;
  stage.features.resize(photos.size());
  stage.errors.resize(photos.size());
  std::atomic<std::int64_t> done = 0;
  parallel_for(ctx, photos.size(), 1, [&](std::size_t i, std::size_t) {
    if (ctx.stopped()) return;
    if (auto features = photo_features(photos[i], i, options, cache)) {
      stage.features[i] = std::move(*features);
    } else {
      stage.errors[i] = features.error().message;
    }
    ctx.report({.stage = "vision/features",
                .done = ++done,
                .total = static_cast<std::int64_t>(photos.size())});
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
  const auto readable = std::ranges::count(stage.errors, std::string());
  if (readable < 2) {
    const auto broken =
        std::ranges::find_if(stage.errors, [](const auto& e) { return !e.empty(); });
    return fail(ErrorCode::kInsufficient,
                fmt::format("only {} of {} photos can be read; the first failure: {}",
                            readable,
                            photos.size(),
                            *broken));
  }
  return stage;
}

/// Result without any position: its frame is arbitrary. With control: as good as the held-out
/// residuals say.
void judge_placement(std::span<const ControlTarget> targets,
                     const GnssTerms& terms,
                     Reconstruction& result) {
  if (!targets.empty()) return judge_control(targets, result);
  if (!terms.observations.empty()) return;
  result.georeferenced = false;
  result.quality.georeference = GeoreferenceVerdict::kUnusable;
  result.quality.georeference_reasons = {
      "no usable position of a photo and no ground control: the frame is arbitrary, its unit is no "
      "metre; give geo.txt or gcp_list.txt"};
  result.warnings.push_back("georeference: " + result.quality.georeference_reasons.front());
}

SfmModel make_model(const CameraSetup& cameras, std::vector<Track> tracks) {
  SfmModel model;
  model.priors = cameras.cameras;
  for (const CameraPrior& prior : cameras.cameras) model.cameras.push_back(prior.intrinsics);
  model.camera_of_view = cameras.camera_of_photo;
  model.world_from_view.resize(cameras.camera_of_photo.size());
  model.tracks = std::move(tracks);
  model.points.resize(model.tracks.size());
  index_tracks(model);
  return model;
}

/// Where more photos have no position than can all be matched with each other, by their looks.
void add_similar(std::span<const FeatureSet> features,
                 const GnssIngest& gnss,
                 const PairOptions& options,
                 const RunContext& ctx,
                 std::vector<PhotoPair>& pairs) {
  const auto unplaced = [&](std::uint32_t photo) { return !gnss.fixes[photo].position_in_enu; };
  const auto count = std::ranges::count_if(
      gnss.fixes, [](const PhotoFix& fix) { return !fix.position_in_enu.has_value(); });
  if (count == 0 || features.size() <= kAllPairsPhotos) return;
  for (const PhotoPair& pair : similar_photos(features, options.similar_neighbors, ctx)) {
    if (unplaced(pair.first) || unplaced(pair.second)) pairs.push_back(pair);
  }
  std::ranges::sort(pairs);
  const auto twice = std::ranges::unique(pairs);
  pairs.erase(twice.begin(), twice.end());
}

/// Control takes the place of GNSS: receivers are metres off, surveyed points centimetres.
Expected<std::vector<ControlTarget>> take_control(std::span<const ControlPoint> control,
                                                  GnssIngest& gnss,
                                                  Fragments& mapped) {
  if (control.empty()) return std::vector<ControlTarget>{};
  const bool has_gnss = std::ranges::any_of(
      gnss.fixes, [](const PhotoFix& fix) { return fix.position_in_enu.has_value(); });
  if (!has_gnss) gnss.origin = origin_of_control(control);
  HF_TRY(const Sim3 enu_from_world, place_by_control(mapped.model, control, gnss.origin));
  transform_model(mapped.model, enu_from_world);
  mapped.placement = {};
  return control_targets(mapped.model, control, gnss.origin);
}

Expected<Fragments> map_pairs(const MatchedPhotos& matched,
                              std::span<const VerifiedPair> pairs,
                              std::span<const PhotoMetadata> metadata,
                              const GnssIngest& gnss,
                              const ReconstructionOptions& options,
                              const RunContext& ctx) {
  const SfmModel empty = make_model(matched.cameras, build_tracks(matched.stage.features, pairs));
  return map_fragments(empty, pairs, gnss, metadata, options, ctx);
}

/// Maps, and once more with the pairs that the first model suggests where it left photos out or
/// unconnected.
Expected<Fragments> map_photos(const MatchedPhotos& matched,
                               std::span<const PhotoMetadata> metadata,
                               const GnssIngest& gnss,
                               const ReconstructionOptions& options,
                               const RunContext& ctx) {
  HF_TRY(Fragments mapped, map_pairs(matched, matched.pairs, metadata, gnss, options, ctx));
  const std::vector<PhotoPair> pairs =
      second_round_pairs(mapped.model, matched.pairs, gnss, options.pairs);
  if (pairs.empty()) return mapped;
  const std::vector<FeatureSet>& features = matched.stage.features;
  HF_TRY(const auto raw, match_pairs(features, pairs, options.matching, ctx, matched.cache));
  HF_TRY(const auto fresh, verify_pairs(features, matched.cameras, raw, options.matching, ctx));
  ctx.info(fmt::format("second round: {} of {} pairs verified", fresh.size(), pairs.size()));
  if (fresh.empty()) return mapped;
  std::vector<VerifiedPair> all = matched.pairs;
  all.insert(all.end(), fresh.begin(), fresh.end());
  std::ranges::sort(all, {}, &VerifiedPair::views);
  HF_TRY(Fragments again, map_pairs(matched, all, metadata, gnss, options, ctx));
  const bool better = again.model.num_registered() >= mapped.model.num_registered();
  return better ? std::move(again) : std::move(mapped);
}

std::vector<Eigen::Vector3d> centres_of(const SfmModel& model) {
  std::vector<Eigen::Vector3d> centres;
  for (const std::uint32_t view : model.registered()) {
    centres.push_back(model.world_from_view[view]->translation);
  }
  return centres;
}

}  // namespace

Expected<MatchedPhotos> match_photos(std::span<const Photo> photos,
                                     const GnssIngest& gnss,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx,
                                     const PhotoCache* cache) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : photos) metadata.push_back(photo.metadata);
  MatchedPhotos result{
      .cameras = group_cameras(metadata, options.intrinsics, options.features.max_size_px),
      .cache = cache};
  HF_TRY(result.stage, extract_all(photos, options.features, cache, ctx));
  const std::vector<FeatureSet>& features = result.stage.features;
  std::vector<PhotoPair> pairs = select_pairs(metadata, gnss, options.pairs);
  add_similar(features, gnss, options.pairs, ctx, pairs);
  HF_TRY(const auto raw, match_pairs(features, pairs, options.matching, ctx, cache));
  if (options.intrinsics.probe_lens) probe_lenses(result.cameras, features, raw, ctx);
  HF_TRY(result.pairs, verify_pairs(features, result.cameras, raw, options.matching, ctx));
  ctx.info(fmt::format("{} of {} pairs verified", result.pairs.size(), pairs.size()));
  return result;
}

Expected<Reconstruction> pose_photos(const MatchedPhotos& matched,
                                     std::span<const PhotoMetadata> metadata,
                                     GnssIngest gnss,
                                     std::span<const ControlPoint> control,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx) {
  HF_TRY(Fragments mapped, map_photos(matched, metadata, gnss, options, ctx));
  HF_TRY(const std::vector<ControlTarget> targets, take_control(control, gnss, mapped));
  GnssTerms terms = gnss_terms(mapped.model, gnss, options.gnss, mapped.placement);
  if (!targets.empty()) terms.observations.clear();
  const std::vector<Eigen::Vector3d> before = centres_of(mapped.model);
  const AdjustmentInputs inputs{gnss, metadata, targets, options};
  if (auto adjusted = adjust_with_shutter(mapped.model, terms, inputs, ctx); !adjusted) {
    return std::unexpected(adjusted.error());
  }
  gnss.warnings.insert(
      gnss.warnings.end(), matched.cameras.warnings.begin(), matched.cameras.warnings.end());
  Reconstruction result = export_model(mapped, terms, gnss, matched.stage, metadata);
  result.quality.dome_m = dome_between(before, centres_of(mapped.model));
  result.control = control_residuals(mapped.model, control, gnss.origin);
  judge_placement(targets, terms, result);
  return result;
}

}  // namespace hybridfusion
