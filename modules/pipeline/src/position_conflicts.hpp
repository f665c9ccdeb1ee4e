#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/io/geo_tags.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Positions of two sources that contradict each other, or one that cannot be.
struct PositionConflict {
  std::string id = {};    ///< Of finding_kinds(): an error there refuses the run.
  std::string text = {};  ///< Both values, the limit and the likely cause.
  std::vector<std::string> subjects = {};
};

/// How far positions may differ.
struct PositionLimits {
  GnssOptions gnss = {};
  double max_sigma = 5.0;  ///< Combined deviations of the two sources.
};

/// What is known of the places of photos before they are looked at.
struct PositionSources {
  std::vector<PhotoMetadata> own = {};   ///< As the photos say.
  std::vector<PhotoMetadata> used = {};  ///< The same photos after the tags.
  std::optional<std::filesystem::path> tags_path = {};
  GeoTagFile tags = {};
  std::size_t num_tagged = 0;                  ///< Photos that have a tag.
  std::vector<std::string> unknown_tags = {};  ///< Names of tags that are no photo's.
  std::optional<std::filesystem::path> control_path = {};
  SurveyFile control = {};
};

/// geo.txt against the photos' own positions, ground control against the photos that show it, and
/// the extent of the block. Limits are multiples of the combined deviations.
[[nodiscard]] std::vector<PositionConflict> compare_positions(const PositionSources& sources,
                                                              const PositionLimits& limits);

/// What placed a model, where GNSS did not.
struct PlacedBy {
  std::string what = {};  ///< For a person: "ground control", "origin.json of the given poses".
  /// Height in it that may be wrong [m]; absent: the heights of the photos themselves.
  std::optional<double> height_m = {};
  bool unit_assumed =
      false;  ///< The heights were taken in the unit of a system that has no metres.
};

/// Positions of the photos against where a model that GNSS did not place has them.
[[nodiscard]] std::vector<PositionConflict> compare_placement(const Reconstruction& reconstruction,
                                                              const PlacedBy& placed_by,
                                                              const PositionLimits& limits);

/// Whether it refuses the run.
[[nodiscard]] bool is_error(const PositionConflict& conflict);

}  // namespace hybridfusion
