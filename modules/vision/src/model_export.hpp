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

/// The public result of an adjusted model, with its quality figures and warnings.
[[nodiscard]] Reconstruction export_model(const Fragments& mapped,
                                          const GnssTerms& terms,
                                          const GnssIngest& gnss,
                                          const FeatureStage& stage,
                                          std::span<const PhotoMetadata> metadata);

}  // namespace hybridfusion
