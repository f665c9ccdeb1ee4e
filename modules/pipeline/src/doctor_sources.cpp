#include "doctor_checks.hpp"
#include "position_sources.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {

std::size_t check_sources(const PhotoInputs& inputs,
                          const VisionStageOptions& options,
                          PhotoFolder& folder,
                          Diagnosis& diagnosis) {
  if (!inputs.geo_tags && !inputs.control) return 0;
  // One file that cannot be read hides nothing of the other.
  PhotoInputs readable = inputs;
  for (auto* path : {&readable.geo_tags, &readable.control}) {
    if (!*path) continue;
    PhotoInputs alone{.images = inputs.images};
    (path == &readable.geo_tags ? alone.geo_tags : alone.control) = *path;
    PhotoFolder copy = folder;
    if (const auto taken = take_positions(alone, copy); !taken) {
      const bool unknown = taken.error().code == ErrorCode::kInsufficient;
      diagnosis.findings.add(unknown ? "positions.no_photos" : "positions.unreadable",
                             taken.error().message);
      path->reset();
    }
  }
  const auto sources = take_positions(readable, folder);
  if (!sources) return 0;  // said already
  if (sources->tags_path) {
    diagnosis.facts.push_back(fmt::format("{}: positions of {} of {} photos, {}",
                                          sources->tags_path->string(),
                                          sources->num_tagged,
                                          folder.photos.size(),
                                          sources->tags.system));
  }
  if (sources->control_path) {
    diagnosis.facts.push_back(fmt::format("{}: {} ground control points, {}",
                                          sources->control_path->string(),
                                          sources->control.points.size(),
                                          sources->control.system));
  }
  for (const auto* notes : {&sources->tags.notes, &sources->control.notes}) {
    diagnosis.facts.insert(diagnosis.facts.end(), notes->begin(), notes->end());
  }
  for (const PositionConflict& conflict : compare_positions(*sources, limits_of(options))) {
    diagnosis.findings.add(conflict.id, conflict.text, conflict.subjects);
  }
  const std::vector<ControlPoint> control = control_points(sources->control, folder);
  return static_cast<std::size_t>(std::ranges::count_if(
      control, [](const ControlPoint& point) { return !point.check && point.marks.size() >= 2; }));
}

}  // namespace hybridfusion
