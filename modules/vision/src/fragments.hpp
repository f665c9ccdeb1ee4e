#pragma once

#include "placement.hpp"
#include "sfm_model.hpp"
#include "tracks.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

struct Fragments {
  SfmModel model = {};  ///< In the east-north-up frame.
  Placement placement = {};
  std::vector<std::string> reasons = {};  ///< Per view; empty text where it is registered.
  std::vector<std::string> warnings = {};
};

/// Grows a model, places it on the map, and goes on with the photos that it left over: fragments
/// share the east-north-up frame even where no photo links them.
/// @param empty  Tracks and cameras, nothing registered.
/// @returns kInsufficient when no three photos connect, or the error of the first alignment.
[[nodiscard]] Expected<Fragments> map_fragments(const SfmModel& empty,
                                                std::span<const VerifiedPair> pairs,
                                                const GnssIngest& gnss,
                                                std::span<const PhotoMetadata> metadata,
                                                const ReconstructionOptions& options,
                                                const RunContext& ctx);

}  // namespace hybridfusion
