#include "position_sources.hpp"

#include "finding_list.hpp"

#include <hybridfusion/io/photo_names.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::optional<std::filesystem::path> given_or_beside(
    const std::optional<std::filesystem::path>& given,
    const std::filesystem::path& images,
    std::string_view name) {
  if (given) return given;
  std::error_code code;
  const std::filesystem::path beside = images / name;
  if (std::filesystem::is_regular_file(beside, code)) return beside;
  return std::nullopt;
}

std::vector<PhotoMetadata> metadata_of(const PhotoFolder& folder) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : folder.photos) metadata.push_back(photo.metadata);
  return metadata;
}

std::string_view remedy_of(std::string_view id) {
  const auto kinds = finding_kinds();
  return std::ranges::find(kinds, id, &FindingKind::id)->remedy;
}

}  // namespace

PositionLimits limits_of(const VisionStageOptions& options) {
  return {.gnss = options.reconstruction.gnss, .max_sigma = options.max_conflict_sigma};
}

PhotoInputs with_files_beside(PhotoInputs inputs) {
  inputs.geo_tags = given_or_beside(inputs.geo_tags, inputs.images, "geo.txt");
  inputs.control = given_or_beside(inputs.control, inputs.images, "gcp_list.txt");
  return inputs;
}

Expected<PositionSources> take_positions(const PhotoInputs& inputs, PhotoFolder& folder) {
  PositionSources sources{.own = metadata_of(folder), .used = metadata_of(folder)};
  if (inputs.geo_tags) {
    HF_TRY(sources.tags, read_geo_tags(*inputs.geo_tags));
    sources.tags_path = inputs.geo_tags;
    TaggedPhotos tagged = apply_geo_tags(sources.tags.tags, folder.photos);
    if (tagged.num_tagged == 0) {
      return fail(ErrorCode::kInsufficient,
                  fmt::format("{}: none of its {} names is a photo of {}, the first is {}; {}",
                              inputs.geo_tags->string(),
                              sources.tags.tags.size(),
                              folder.folder.string(),
                              listed({&tagged.unknown.front(), 1}),
                              remedy_of("positions.no_photos")));
    }
    sources.num_tagged = tagged.num_tagged;
    sources.unknown_tags = std::move(tagged.unknown);
    sources.used = metadata_of(folder);
  }
  if (inputs.control) {
    HF_TRY(sources.control, read_surveyed_points(*inputs.control));
    sources.control_path = inputs.control;
  }
  return sources;
}

Expected<std::vector<std::string>> judged_positions(const PositionSources& sources,
                                                    const PositionLimits& limits) {
  std::vector<std::string> lines = sources.tags.notes;
  lines.insert(lines.end(), sources.control.notes.begin(), sources.control.notes.end());
  for (const PositionConflict& conflict : compare_positions(sources, limits)) {
    if (is_error(conflict)) {
      return fail(ErrorCode::kInsufficient,
                  fmt::format("{}. {}", conflict.text, remedy_of(conflict.id)));
    }
    lines.push_back(conflict.text);
  }
  return lines;
}

std::vector<ControlPoint> control_points(const SurveyFile& survey, const PhotoFolder& folder) {
  std::vector<std::string> names;
  for (const Photo& photo : folder.photos) names.push_back(photo.metadata.name);
  const PhotoNames index(names);
  std::vector<ControlPoint> points;
  for (const SurveyedPoint& from : survey.points) {
    std::string start = from.name.substr(0, 3);
    std::ranges::transform(start, start.begin(), [](unsigned char c) { return std::tolower(c); });
    ControlPoint point{.name = from.name, .position = from.position, .check = start == "chk"};
    for (const SurveyedPoint::Mark& mark : from.marks) {
      if (const auto photo = index.find(mark.photo)) {
        point.marks.push_back({.photo = *photo, .pixel = mark.pixel});
      }
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace hybridfusion
