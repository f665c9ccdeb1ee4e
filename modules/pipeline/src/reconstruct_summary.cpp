#include "reconstruct_summary.hpp"

#include "json_text.hpp"
#include "vision_files.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::string_view word_of(GeoreferenceVerdict verdict) {
  switch (verdict) {
    case GeoreferenceVerdict::kGood:
      return "good";
    case GeoreferenceVerdict::kLimited:
      return "limited";
    case GeoreferenceVerdict::kUnusable:
      return "unusable";
  }
  return "unusable";
}

/// Whether place, scale and tilt can be relied on, and what was found wrong with the tags.
Json georeference_json(const ReconstructionQuality& quality, PoseSource source) {
  if (source == PoseSource::kGiven) {
    return {{"verdict", kGivenPoses},
            {"reasons", {"the poses were given and not adjusted: scale and tilt are theirs"}},
            {"flights", Json::array()}};
  }
  Json flights = Json::array();
  for (const FlightErrors& flight : quality.flights) {
    flights.push_back({{"altitude_offset_m", flight.offset_m},
                       {"altitude_drift_mps", flight.rate_mps},
                       {"lag_s", flight.lag_s}});
  }
  return {{"verdict", word_of(quality.georeference)},
          {"reasons", quality.georeference_reasons},
          {"flights", std::move(flights)}};
}

Json vector_json(const Eigen::Vector3d& v) {
  return v.allFinite() ? Json{v.x(), v.y(), v.z()} : Json();
}

Json control_json(const std::vector<ControlResidual>& control) {
  Json points = Json::array();
  for (const ControlResidual& point : control) {
    points.push_back({{"name", point.name},
                      {"used", point.used},
                      {"num_marks", point.num_marks},
                      {"residual_m", vector_json(point.residual_m)},
                      {"held_out_m", vector_json(point.held_out_m)}});
  }
  return points;
}

/// Root mean square of what the points leave, held out.
std::optional<double> held_out_rms_m(const std::vector<ControlResidual>& control) {
  double sum = 0.0;
  double count = 0.0;
  for (const ControlResidual& point : control) {
    if (!point.held_out_m.allFinite()) continue;
    sum += point.held_out_m.squaredNorm();
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  return std::sqrt(sum / count);
}

double focal_px_of(const Reconstruction& reconstruction) {
  return reconstruction.cameras.empty() ? 0.0 : reconstruction.cameras.front().focal_px;
}

double focal_change_of(const Reconstruction& reconstruction) {
  const double initial_px = reconstruction.quality.initial_focal_px;
  return initial_px > 0.0 ? focal_px_of(reconstruction) / initial_px - 1.0 : 0.0;
}

bool has_gnss(const Reconstruction& reconstruction) {
  return std::ranges::any_of(reconstruction.views, [](const View& view) {
    return view.enu_from_camera && view.gnss_in_enu;
  });
}

/// Only bundle adjustment knows these.
void add_adjustment(const Reconstruction& reconstruction, Json& json) {
  const ReconstructionQuality& quality = reconstruction.quality;
  json.update({{"initial_focal_px", quality.initial_focal_px},
               {"focal_change", focal_change_of(reconstruction)},
               {"gnss_sigma_horizontal_m", quality.estimated_sigma_horizontal_m},
               {"gnss_sigma_vertical_m", quality.estimated_sigma_vertical_m},
               {"scale_sigma", quality.scale_sigma},
               {"tilt_sigma_deg", quality.tilt_sigma_rad * 180.0 / std::numbers::pi},
               {"dome_m", quality.dome_m}});
}

Json json_of(const Reconstruction& reconstruction,
             PoseSource source,
             const PhotoFolder& folder,
             const PointCloud& dense) {
  const ReconstructionQuality& quality = reconstruction.quality;
  Json rejected = Json::array();
  std::size_t registered = 0;
  for (const PositionRow& row : position_rows(reconstruction, folder.quarantined)) {
    if (row.position) {
      ++registered;
    } else {
      rejected.push_back(row.name + ": " + row.reason);
    }
  }
  Json json = {{"num_photos", reconstruction.views.size() + folder.quarantined.size()},
               {"num_registered", registered},
               {"num_quarantined", folder.quarantined.size()},
               {"not_registered", rejected},
               {"num_scene_points", reconstruction.points.size()},
               {"num_dense_points", dense.size()},
               {"mean_reprojection_px", quality.mean_reprojection_px},
               {"median_reprojection_px", quality.median_reprojection_px},
               {"focal_px", focal_px_of(reconstruction)},
               {"georeference", georeference_json(quality, source)},
               {"georeferenced", reconstruction.georeferenced},
               {"control", control_json(reconstruction.control)},
               {"warnings", reconstruction.warnings}};
  if (has_gnss(reconstruction)) {
    json["gnss_horizontal_rms_m"] = quality.gnss_horizontal_rms_m;
    json["gnss_vertical_rms_m"] = quality.gnss_vertical_rms_m;
  }
  if (source == PoseSource::kAdjusted) add_adjustment(reconstruction, json);
  return json;
}

/// What is known of place, scale and tilt, a line each.
std::vector<std::string> placement_lines(const Reconstruction& reconstruction, PoseSource source) {
  const ReconstructionQuality& quality = reconstruction.quality;
  if (!reconstruction.georeferenced) return {quality.georeference_reasons.front()};
  std::vector<std::string> lines;
  if (has_gnss(reconstruction)) {
    lines.push_back(fmt::format("GNSS residuals {:.2f} m horizontal, {:.2f} m vertical (rms)",
                                quality.gnss_horizontal_rms_m,
                                quality.gnss_vertical_rms_m));
  }
  if (source == PoseSource::kGiven) {
    lines.emplace_back("poses as given, not adjusted: scale and tilt are theirs");
  } else {
    lines.push_back(fmt::format("scale and tilt by GNSS alone {}: +-{:.2f} %, +-{:.2f} deg",
                                word_of(quality.georeference),
                                100.0 * quality.scale_sigma,
                                quality.tilt_sigma_rad * 180.0 / std::numbers::pi));
  }
  if (const auto rms_m = held_out_rms_m(reconstruction.control)) {
    lines.push_back(fmt::format("{} ground control points, {:.3f} m (rms) when held out",
                                reconstruction.control.size(),
                                *rms_m));
  }
  return lines;
}

}  // namespace

StageResult reconstruct_summary(const Reconstruction& reconstruction,
                                PoseSource source,
                                const PhotoFolder& folder,
                                const PointCloud& dense) {
  const Json json = json_of(reconstruction, source, folder, dense);
  // A result without place and scale is not what the other stages wait for.
  StageResult result{.refused = !reconstruction.georeferenced, .json = to_text(json)};
  std::string adjusted =
      fmt::format("reprojection {:.2f} px", reconstruction.quality.mean_reprojection_px);
  if (source == PoseSource::kAdjusted) {
    adjusted += fmt::format(", focal length {:+.2f} % against its first value",
                            100.0 * focal_change_of(reconstruction));
  }
  result.summary = {
      fmt::format("{} of {} photos registered, {} damaged",
                  json["num_registered"].get<std::size_t>(),
                  json["num_photos"].get<std::size_t>(),
                  folder.quarantined.size()),
      std::move(adjusted),
      fmt::format("{} scene points, {} dense points", reconstruction.points.size(), dense.size())};
  for (std::string& line : placement_lines(reconstruction, source)) {
    result.summary.push_back(std::move(line));
  }
  return result;
}

}  // namespace hybridfusion
