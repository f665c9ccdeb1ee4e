#pragma once

#include "sfm_model.hpp"
#include "similarity_fit.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

struct EnuAlignment {
  Sim3 enu_from_world = {};
  bool altitude_trusted = true;            ///< Else up came from elsewhere.
  std::vector<FlightErrors> flights = {};  ///< Systematic errors of the tags, per flight.
  TagErrorModel errors = {};               ///< Which of them were found.
  /// The up direction known from elsewhere than the altitudes, as unit z of the result less its
  /// error: the adjustment must not turn away from it.
  std::optional<UpPrior> up = {};
  std::vector<std::string> warnings = {};  ///< What was found wrong with the tags.
};

/// Places the registered views on the map by their GNSS positions, robustly and aware of gravity:
/// bundle adjustment hardly turns a model, so that orientation and scale must be right before.
/// Drift of the altitudes and lag of the tags are estimated where they explain most of the
/// residuals. Altitudes are set aside, and up is taken from the camera mounts (or from how photos
/// are usually taken), when they still contradict it or do not fit their stated accuracy.
/// @returns kInsufficient below 3 registered views with GNSS, kDegenerate when nothing determines
///          the orientation.
[[nodiscard]] Expected<EnuAlignment> align_to_enu(const SfmModel& model,
                                                  const GnssIngest& gnss,
                                                  std::span<const PhotoMetadata> photos,
                                                  Random random);

/// Without positions: up as level photos hold it, the cameras around the origin, and scene points
/// 50 units away from the cameras (median).
[[nodiscard]] EnuAlignment align_to_nothing(const SfmModel& model,
                                            std::span<const PhotoMetadata> photos);

/// Moves poses and points.
void transform_model(SfmModel& model, const Sim3& target_from_world);

}  // namespace hybridfusion
