#include "fragments.hpp"
#include "gnss_adjustment.hpp"
#include "model_export.hpp"
#include "pair_verification.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <atomic>
#include <exception>

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

Expected<Reconstruction> run(std::span<const Photo> photos,
                             const ReconstructionOptions& options,
                             const RunContext& ctx) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : photos) metadata.push_back(photo.metadata);
  HF_TRY(GnssIngest gnss, ingest_gnss(metadata, options.gnss));
  CameraSetup cameras = group_cameras(metadata, options.intrinsics, options.features.max_size_px);
  HF_TRY(const FeatureStage stage, extract_all(photos, options.features, ctx));
  const std::vector<PhotoPair> pairs = select_pairs(metadata, gnss, options.pairs);
  HF_TRY(const auto matched, match_pairs(stage.features, pairs, options.matching, ctx));
  if (options.intrinsics.probe_lens) {
    probe_lenses(cameras, stage.features, matched, ctx);
  }
  HF_TRY(const auto verified,
         verify_pairs(stage.features, cameras, matched, options.matching, ctx));
  const SfmModel empty = make_model(cameras, build_tracks(stage.features, verified));
  ctx.info(fmt::format(
      "{} of {} pairs verified, {} tracks", verified.size(), pairs.size(), empty.tracks.size()));
  HF_TRY(Fragments mapped, map_fragments(empty, verified, gnss, metadata, options, ctx));
  GnssTerms terms = gnss_terms(mapped.model, gnss, options.gnss, mapped.placement);
  if (auto adjusted = adjust_with_gnss(mapped.model, terms, options, ctx); !adjusted) {
    return std::unexpected(adjusted.error());
  }
  gnss.warnings.insert(gnss.warnings.end(), cameras.warnings.begin(), cameras.warnings.end());
  return export_model(mapped, terms, gnss, stage, metadata);
}

}  // namespace

Expected<Reconstruction> reconstruct(std::span<const Photo> photos,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx) {
  if (auto valid = validate(options, "vision"); !valid) return std::unexpected(valid.error());
  if (photos.size() < 3) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} photos given, 3 are needed", photos.size()));
  }
  try {
    return run(photos, options, ctx);
  } catch (const std::exception& error) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("structure from motion failed: {}", error.what()));
  }
}

}  // namespace hybridfusion
