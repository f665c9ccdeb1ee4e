#include "matched_photos.hpp"

#include "fragments.hpp"
#include "gnss_adjustment.hpp"
#include "pair_verification.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <atomic>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Expected<FeatureStage> extract_all(std::span<const Photo> photos,
                                   const FeatureOptions& options,
                                   const RunContext& ctx) {
  FeatureStage stage;
  stage.features.resize(photos.size());
  stage.errors.resize(photos.size());
  std::atomic<std::int64_t> done = 0;
  parallel_for(ctx, photos.size(), 1, [&](std::size_t i, std::size_t) {
    if (ctx.stopped()) return;
    auto image = photos[i].load();
    if (!image) {
      stage.errors[i] = image.error().message;
    } else if (image->width != photos[i].metadata.width ||
               image->height != photos[i].metadata.height) {
      stage.errors[i] = fmt::format("decoded to {} x {} px, but its header says {} x {}",
                                    image->width,
                                    image->height,
                                    photos[i].metadata.width,
                                    photos[i].metadata.height);
    } else if (auto features = extract_features(*image, options)) {
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

}  // namespace

Expected<MatchedPhotos> match_photos(std::span<const Photo> photos,
                                     const GnssIngest& gnss,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : photos) metadata.push_back(photo.metadata);
  MatchedPhotos result{
      .cameras = group_cameras(metadata, options.intrinsics, options.features.max_size_px)};
  HF_TRY(result.stage, extract_all(photos, options.features, ctx));
  const std::vector<FeatureSet>& features = result.stage.features;
  const std::vector<PhotoPair> pairs = select_pairs(metadata, gnss, options.pairs);
  HF_TRY(const auto raw, match_pairs(features, pairs, options.matching, ctx));
  if (options.intrinsics.probe_lens) probe_lenses(result.cameras, features, raw, ctx);
  HF_TRY(result.pairs, verify_pairs(features, result.cameras, raw, options.matching, ctx));
  ctx.info(fmt::format("{} of {} pairs verified", result.pairs.size(), pairs.size()));
  return result;
}

Expected<Reconstruction> pose_photos(const MatchedPhotos& matched,
                                     std::span<const PhotoMetadata> metadata,
                                     GnssIngest gnss,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx) {
  const SfmModel empty =
      make_model(matched.cameras, build_tracks(matched.stage.features, matched.pairs));
  HF_TRY(Fragments mapped, map_fragments(empty, matched.pairs, gnss, metadata, options, ctx));
  GnssTerms terms = gnss_terms(mapped.model, gnss, options.gnss, mapped.placement);
  if (auto adjusted = adjust_with_gnss(mapped.model, terms, options, ctx); !adjusted) {
    return std::unexpected(adjusted.error());
  }
  gnss.warnings.insert(
      gnss.warnings.end(), matched.cameras.warnings.begin(), matched.cameras.warnings.end());
  return export_model(mapped, terms, gnss, matched.stage, metadata);
}

}  // namespace hybridfusion
