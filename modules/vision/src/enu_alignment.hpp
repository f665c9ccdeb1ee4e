#pragma once

#include "sfm_model.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>

#include <span>
#include <string>

namespace hybridfusion {

struct EnuAlignment {
  Sim3 enu_from_world = {};
  bool altitude_trusted = true;  ///< Else up came from elsewhere and altitudes may drift.
  std::string warning = {};      ///< Says why the altitudes were not trusted.
};

/// Places the registered views on the map by their GNSS positions, robustly and aware of gravity:
/// bundle adjustment hardly turns a model, so that orientation and scale must be right before.
/// Altitudes are set aside, and up is taken from the camera mounts (or from how photos are usually
/// taken), when they contradict it or do not fit their stated accuracy.
/// @returns kInsufficient below 3 registered views with GNSS, kDegenerate when nothing determines
///          the orientation.
[[nodiscard]] Expected<EnuAlignment> align_to_enu(const SfmModel& model,
                                                  const GnssIngest& gnss,
                                                  std::span<const PhotoMetadata> photos,
                                                  Random random);

/// Moves poses and points.
void transform_model(SfmModel& model, const Sim3& target_from_world);

}  // namespace hybridfusion
