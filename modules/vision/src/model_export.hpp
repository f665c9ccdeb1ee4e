#pragma once

#include "features.hpp"
#include "fragments.hpp"
#include "gnss_adjustment.hpp"

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

struct FeatureStage {
  std::vector<FeatureSet> features = {};  ///< Per photo; empty for unreadable ones.
  std::vector<std::string> errors = {};   ///< Per photo; empty text: read.
};

/// Fills the points of `out` from the tracks that have one, and the observations of its views,
/// which must be there. @returns The errors of all observations [px of the reduced photos].
std::vector<double> export_points(const SfmModel& model,
                                  std::span<const std::uint32_t> tracks,
                                  std::span<const FeatureSet> features,
                                  Reconstruction& out);

/// The public result of an adjusted model, with its quality figures and warnings.
[[nodiscard]] Reconstruction export_model(const Fragments& mapped,
                                          const GnssTerms& terms,
                                          const GnssIngest& gnss,
                                          const FeatureStage& stage,
                                          std::span<const PhotoMetadata> metadata);

}  // namespace hybridfusion
