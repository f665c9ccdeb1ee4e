#include "matched_photos.hpp"

#include <hybridfusion/core/memory.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <exception>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Expected<Reconstruction> run(std::span<const Photo> photos,
                             std::span<const ControlPoint> control,
                             const ReconstructionOptions& options,
                             const RunContext& ctx,
                             const PhotoCache* cache) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : photos) metadata.push_back(photo.metadata);
  auto ingested = ingest_gnss(metadata, options.gnss);
  if (!ingested && ingested.error().code != ErrorCode::kInsufficient) {
    return std::unexpected(ingested.error());
  }
  const GnssIngest gnss =
      ingested ? *std::move(ingested) : without_gnss(metadata, ingested.error().message);
  HF_TRY(const MatchedPhotos matched, match_photos(photos, gnss, options, ctx, cache));
  return_freed_memory();  // decoded photos and the matcher's scores
  return pose_photos(matched, metadata, gnss, control, options, ctx);
}

}  // namespace

Expected<Reconstruction> reconstruct(std::span<const Photo> photos,
                                     const ReconstructionOptions& options,
                                     const RunContext& ctx,
                                     std::span<const ControlPoint> control,
                                     const PhotoCache* cache) {
  if (auto valid = validate(options, "vision"); !valid) return std::unexpected(valid.error());
  if (photos.size() < 3) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} photos given, 3 are needed", photos.size()));
  }
  try {
    return run(photos, control, options, ctx, cache);
  } catch (const std::exception& error) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("structure from motion failed: {}", error.what()));
  }
}

}  // namespace hybridfusion
