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
Json georeference_json(const ReconstructionQuality& quality) {
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

}  // namespace

StageResult reconstruct_summary(const Reconstruction& reconstruction,
                                const PhotoFolder& folder,
                                const PointCloud& dense) {
  const auto registered = std::ranges::count_if(
      reconstruction.views, [](const View& view) { return view.enu_from_camera.has_value(); });
  const ReconstructionQuality& quality = reconstruction.quality;
  const double focal_px =
      reconstruction.cameras.empty() ? 0.0 : reconstruction.cameras.front().focal_px;
  const double focal_change =
      quality.initial_focal_px > 0.0 ? focal_px / quality.initial_focal_px - 1.0 : 0.0;
  Json rejected = Json::array();
  for (const PositionRow& row : position_rows(reconstruction, folder.quarantined)) {
    if (!row.position) rejected.push_back(row.name + ": " + row.reason);
  }
  const Json json = {{"num_photos", reconstruction.views.size() + folder.quarantined.size()},
                     {"num_registered", registered},
                     {"num_quarantined", folder.quarantined.size()},
                     {"not_registered", rejected},
                     {"num_scene_points", reconstruction.points.size()},
                     {"num_dense_points", dense.size()},
                     {"mean_reprojection_px", quality.mean_reprojection_px},
                     {"median_reprojection_px", quality.median_reprojection_px},
                     {"initial_focal_px", quality.initial_focal_px},
                     {"focal_px", focal_px},
                     {"focal_change", focal_change},
                     {"gnss_horizontal_rms_m", quality.gnss_horizontal_rms_m},
                     {"gnss_vertical_rms_m", quality.gnss_vertical_rms_m},
                     {"gnss_sigma_horizontal_m", quality.estimated_sigma_horizontal_m},
                     {"gnss_sigma_vertical_m", quality.estimated_sigma_vertical_m},
                     {"scale_sigma", quality.scale_sigma},
                     {"tilt_sigma_deg", quality.tilt_sigma_rad * 180.0 / std::numbers::pi},
                     {"georeference", georeference_json(quality)},
                     {"dome_m", quality.dome_m},
                     {"georeferenced", reconstruction.georeferenced},
                     {"control", control_json(reconstruction.control)},
                     {"warnings", reconstruction.warnings}};
  // A result without place and scale is not what the other stages wait for.
  StageResult result{.refused = !reconstruction.georeferenced, .json = to_text(json)};
  result.summary = {
      fmt::format("{} of {} photos registered, {} damaged",
                  registered,
                  reconstruction.views.size() + folder.quarantined.size(),
                  folder.quarantined.size()),
      fmt::format("reprojection {:.2f} px, focal length {:+.2f} % against its first value",
                  quality.mean_reprojection_px,
                  100.0 * focal_change),
      fmt::format("{} scene points, {} dense points", reconstruction.points.size(), dense.size())};
  if (reconstruction.georeferenced) {
    result.summary.push_back(
        fmt::format("GNSS residuals {:.2f} m horizontal, {:.2f} m vertical (rms)",
                    quality.gnss_horizontal_rms_m,
                    quality.gnss_vertical_rms_m));
    result.summary.push_back(
        fmt::format("scale and tilt by GNSS alone {}: +-{:.2f} %, +-{:.2f} deg",
                    word_of(quality.georeference),
                    100.0 * quality.scale_sigma,
                    quality.tilt_sigma_rad * 180.0 / std::numbers::pi));
  }
  if (!reconstruction.georeferenced) {
    result.summary.push_back(reconstruction.quality.georeference_reasons.front());
  } else if (const auto rms_m = held_out_rms_m(reconstruction.control)) {
    result.summary.push_back(fmt::format("{} ground control points, {:.3f} m (rms) when held out",
                                         reconstruction.control.size(),
                                         *rms_m));
  }
  return result;
}

}  // namespace hybridfusion
