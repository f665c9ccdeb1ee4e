#pragma once

#include "intrinsics_prior.hpp"
#include "model_export.hpp"
#include "tracks.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// What the pixels of the photos say, before any position has its say.
struct MatchedPhotos {
  FeatureStage stage = {};
  CameraSetup cameras = {};
  std::vector<VerifiedPair> pairs = {};
  const PhotoCache* cache = nullptr;  ///< For pairs that are matched later.
};

/// Features of all photos and matches of the pairs that positions and time suggest.
[[nodiscard]] Expected<MatchedPhotos> match_photos(std::span<const Photo> photos,
                                                   const GnssIngest& gnss,
                                                   const ReconstructionOptions& options,
                                                   const RunContext& ctx,
                                                   const PhotoCache* cache = nullptr);

/// Poses, calibration and points from the matches: mapping, placement, adjustment, judgement.
/// @param metadata  One per photo.
/// @param control   Surveyed points, which take the place of GNSS.
[[nodiscard]] Expected<Reconstruction> pose_photos(const MatchedPhotos& matched,
                                                   std::span<const PhotoMetadata> metadata,
                                                   GnssIngest gnss,
                                                   std::span<const ControlPoint> control,
                                                   const ReconstructionOptions& options,
                                                   const RunContext& ctx);

}  // namespace hybridfusion
