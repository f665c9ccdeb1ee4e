#pragma once

#include "enu_alignment.hpp"
#include "gnss_terms.hpp"
#include "sfm_model.hpp"
#include "similarity_fit.hpp"

#include <hybridfusion/vision/reconstruction.hpp>

#include <optional>
#include <vector>

namespace hybridfusion {

/// How a model was placed on the map, as the adjustment needs it.
struct Placement {
  bool altitude_trusted = true;             ///< Else up came from elsewhere, and altitudes are out.
  std::vector<FlightErrors> flights = {};   ///< Systematic errors of the tags, per flight.
  TagErrorModel errors = {};                ///< Which of them are estimated.
  std::vector<UpObservation> ups = {};      ///< Per view: up from elsewhere than GNSS.
  std::optional<double> up_sigma_rad = {};  ///< Of that up direction.
};

/// Adds how a fragment was placed.
/// @param model  The fragment, in its own frame still.
void add_placement(const EnuAlignment& alignment, const SfmModel& model, Placement& placement);

}  // namespace hybridfusion
