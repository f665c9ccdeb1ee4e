#include "lights.hpp"

#include "../reconstruct_summary.hpp"
#include "chart.hpp"
#include "html.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::string_view color_of(double value, double green_from, double amber_from) {
  return value >= green_from ? "green" : value >= amber_from ? "amber" : "red";
}

/// A member of what a stage reported.
std::string result_of(std::string_view stage, std::string_view key) {
  return fmt::format("{}#/stages/{}/result/result/{}", workspace_file::kRun, stage, key);
}

std::string member(const Json& json,
                   std::string_view key,
                   std::string_view format,
                   std::string_view stage,
                   double factor = 1.0) {
  const std::string source = result_of(stage, key);
  return traced(factor * json.value(key, 0.0),
                format,
                factor == 1.0 ? source : fmt::format("{} * {}", factor, source));
}

void add_photo_lights(const ReportData& data, std::vector<Light>& lights) {
  const Json& result = data.reconstruct;
  const double photos = result.value("num_photos", 0.0);
  if (photos <= 0.0) return;
  const double share = result.value("num_registered", 0.0) / photos;
  lights.push_back({"photos located",
                    color_of(share, 0.95, 0.65),
                    fmt::format("{} of {} ({} %)",
                                member(result, "num_registered", "{:.0f}", "reconstruct"),
                                member(result, "num_photos", "{:.0f}", "reconstruct"),
                                traced(100.0 * share,
                                       "{:.0f}",
                                       "100 * " + result_of("reconstruct", "num_registered") +
                                           " / " + result_of("reconstruct", "num_photos"))),
                    "> 95 %, > 65 %"});
  if (result.contains("focal_change")) {
    const double change = result.value("focal_change", 0.0);
    lights.push_back({"focal length against metadata",
                      color_of(-std::abs(change), -0.01, -0.05),
                      member(result, "focal_change", "{:+.2f}", "reconstruct", 100.0) + " %",
                      "< 1 %, < 5 %"});
  }
  if (data.model) {
    std::vector<double> matches;
    for (const ColmapImage& image : data.model->images) {
      matches.push_back(static_cast<double>(image.points.size()));
    }
    const double median = quantile(matches, 0.5);
    lights.push_back(
        {"matches per photo (median)",
         color_of(median, 1000.0, 100.0),
         traced(
             median, "{:.0f}", fmt::format("median observations of {}", workspace_file::kImages)),
         "> 1000, > 100"});
  }
  if (result.contains("gnss_horizontal_rms_m")) {
    // Consumer GNSS is good to a few metres; beyond ten something is wrong with it.
    const double horizontal = result.value("gnss_horizontal_rms_m", 0.0);
    const double vertical = result.value("gnss_vertical_rms_m", 0.0);
    lights.push_back({"GNSS residuals of the photos (rms)",
                      color_of(-std::max(horizontal, vertical), -3.0, -10.0),
                      fmt::format("{} m horizontal, {} m vertical",
                                  member(result, "gnss_horizontal_rms_m", "{:.2f}", "reconstruct"),
                                  member(result, "gnss_vertical_rms_m", "{:.2f}", "reconstruct")),
                      "< 3 m, < 10 m"});
  }
}

/// Reprojection errors never show a wrong scale or tilt: the stage judged them by the positions. No
/// reason to stop where a LiDAR cloud was registered: the scale of the fused cloud is its scale.
void add_georeference_light(const ReportData& data, std::vector<Light>& lights) {
  const Json georeference = data.reconstruct.value("georeference", Json::object());
  const std::string verdict = georeference.value("verdict", "");
  if (verdict.empty()) return;
  if (verdict == kGivenPoses) {
    lights.push_back({"scale and tilt",
                      "amber",
                      "given poses, not adjusted: scale and tilt are theirs",
                      "0.5 % and 0.5°, 1 % and 1°"});
    return;
  }
  const bool rescaled = data.registered() && data.pose->fused_from_vision.scale != 1.0;
  lights.push_back(
      {"scale and tilt by GNSS alone",
       verdict == "good"                           ? "green"
       : verdict == "limited" || data.registered() ? "amber"
                                                   : "red",
       fmt::format("{}: scale ± {} %, tilt ± {}°{}",
                   escaped(verdict),
                   member(data.reconstruct, "scale_sigma", "{:.2f}", "reconstruct", 100.0),
                   member(data.reconstruct, "tilt_sigma_deg", "{:.2f}", "reconstruct"),
                   rescaled ? "; scale taken from the LiDAR" : ""),
       "0.5 % and 0.5°, 1 % and 1°"});
}

void add_lidar_lights(const ReportData& data, std::vector<Light>& lights) {
  const Json& result = data.map;
  const double scans = result.value("num_scans", 0.0);
  if (scans <= 0.0) return;
  const double bad = result.value("num_flagged_scans", 0.0) / scans;
  lights.push_back({"LiDAR scans without a flag",
                    color_of(1.0 - bad, 0.95, 0.80),
                    fmt::format("{} % of {}",
                                traced(100.0 * (1.0 - bad),
                                       "{:.1f}",
                                       "100 * (1 - " + result_of("map", "num_flagged_scans") +
                                           " / " + result_of("map", "num_scans") + ")"),
                                member(result, "num_scans", "{:.0f}", "map")),
                    "> 95 %, > 80 %"});
  const double residual_m = result.value("mean_residual_m", 0.0);
  lights.push_back({"distance of scans from their map (mean)",
                    color_of(-residual_m, -0.05, -0.15),
                    member(result, "mean_residual_m", "{:.3f}", "map") + " m",
                    "< 0.05 m, < 0.15 m"});
  const double gaps = result.value("num_imu_gaps", 0.0) + result.value("num_lidar_gaps", 0.0);
  lights.push_back(
      {"gaps of IMU and LiDAR",
       color_of(-gaps, 0.0, -3.0),
       traced(gaps,
              "{:.0f}",
              result_of("map", "num_imu_gaps") + " + " + result_of("map", "num_lidar_gaps")),
       "none, up to 3"});
}

void add_registration_light(const ReportData& data, std::vector<Light>& lights) {
  if (!data.pose) return;
  if (!data.pose->ok) {
    lights.push_back({"registration",
                      "red",
                      "REFUSED: " + escaped(data.pose->reason),
                      "confidence > 0.9, > 0.5"});
    return;
  }
  std::string value =
      "confidence " + traced(data.pose->confidence,
                             "{:.2f}",
                             fmt::format("{}#/confidence", workspace_file::kRegistration));
  if (!data.pose->reason.empty()) value += "; " + escaped(data.pose->reason);
  lights.push_back({"registration",
                    color_of(data.pose->confidence, 0.9, 0.5),
                    std::move(value),
                    "confidence > 0.9, > 0.5"});
}

}  // namespace

std::vector<Light> traffic_lights(const ReportData& data) {
  std::vector<Light> lights;
  if (data.reconstruct.is_object()) {
    add_photo_lights(data, lights);
    add_georeference_light(data, lights);
  }
  if (data.map.is_object()) add_lidar_lights(data, lights);
  add_registration_light(data, lights);
  return lights;
}

Verdict overall_verdict(const ReportData& data, const std::vector<Light>& lights) {
  if (data.pose && !data.pose->ok) return {"REFUSED", "red", escaped(data.pose->reason)};
  for (const auto& [color, word] : {std::pair{"red", "RED"}, {"amber", "AMBER"}}) {
    const auto found = std::ranges::find(lights, std::string_view(color), &Light::color);
    if (found != lights.end()) return {word, color, found->what + ": " + found->value};
  }
  if (lights.empty()) return {"NO RESULT", "amber", "no stage has run yet"};
  return {"GREEN", "green", "all checks of what ran are good"};
}

}  // namespace hybridfusion
