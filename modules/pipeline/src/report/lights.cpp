#include "lights.hpp"

#include "chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::string_view color_of(double value, double green_from, double amber_from) {
  return value >= green_from ? "green" : value >= amber_from ? "amber" : "red";
}

void add_photo_lights(const ReportData& data, std::vector<Light>& lights) {
  const Json& result = data.reconstruct;
  const double photos = result.value("num_photos", 0.0);
  if (photos <= 0.0) return;
  const double share = result.value("num_registered", 0.0) / photos;
  lights.push_back({"photos located",
                    color_of(share, 0.95, 0.65),
                    fmt::format("{} of {} ({:.0f} %)",
                                result.value("num_registered", 0),
                                result.value("num_photos", 0),
                                100.0 * share),
                    "> 95 %, > 65 %"});
  const double change = result.value("focal_change", 0.0);
  lights.push_back({"focal length against metadata",
                    color_of(-std::abs(change), -0.01, -0.05),
                    fmt::format("{:+.2f} %", 100.0 * change),
                    "< 1 %, < 5 %"});
  if (data.model) {
    std::vector<double> matches;
    for (const ColmapImage& image : data.model->images) {
      matches.push_back(static_cast<double>(image.points.size()));
    }
    const double median = quantile(matches, 0.5);
    lights.push_back({"matches per photo (median)",
                      color_of(median, 1000.0, 100.0),
                      fmt::format("{:.0f}", median),
                      "> 1000, > 100"});
  }
  if (result.contains("gnss_horizontal_rms_m")) {
    // Consumer GNSS is good to a few metres; beyond ten something is wrong with it.
    const double horizontal = result.value("gnss_horizontal_rms_m", 0.0);
    const double vertical = result.value("gnss_vertical_rms_m", 0.0);
    lights.push_back({"GNSS residuals of the photos (rms)",
                      color_of(-std::max(horizontal, vertical), -3.0, -10.0),
                      fmt::format("{:.2f} m horizontal, {:.2f} m vertical", horizontal, vertical),
                      "< 3 m, < 10 m"});
  }
}

/// Reprojection errors never show a wrong scale or tilt: the stage judged them by the positions. No
/// reason to stop where a LiDAR cloud was registered: the scale of the fused cloud is its scale.
void add_georeference_light(const ReportData& data, std::vector<Light>& lights) {
  const Json georeference = data.reconstruct.value("georeference", Json::object());
  const std::string verdict = georeference.value("verdict", "");
  if (verdict.empty()) return;
  lights.push_back({"scale and tilt by GNSS alone",
                    verdict == "good"                           ? "green"
                    : verdict == "limited" || data.registered() ? "amber"
                                                                : "red",
                    fmt::format("{}: scale ± {:.2f} %, tilt ± {:.2f}°",
                                verdict,
                                100.0 * data.reconstruct.value("scale_sigma", 0.0),
                                data.reconstruct.value("tilt_sigma_deg", 0.0)),
                    "0.5 % and 0.5°, 1 % and 1°"});
}

void add_lidar_lights(const ReportData& data, std::vector<Light>& lights) {
  const Json& result = data.map;
  const double scans = result.value("num_scans", 0.0);
  if (scans <= 0.0) return;
  const double bad = result.value("num_flagged_scans", 0.0) / scans;
  lights.push_back({"LiDAR scans without a flag",
                    color_of(1.0 - bad, 0.95, 0.80),
                    fmt::format("{:.1f} % of {:.0f}", 100.0 * (1.0 - bad), scans),
                    "> 95 %, > 80 %"});
  const double residual_m = result.value("mean_residual_m", 0.0);
  lights.push_back({"distance of scans from their map (mean)",
                    color_of(-residual_m, -0.05, -0.15),
                    fmt::format("{:.3f} m", residual_m),
                    "< 0.05 m, < 0.15 m"});
  const double gaps = result.value("num_imu_gaps", 0.0) + result.value("num_lidar_gaps", 0.0);
  lights.push_back({"gaps of IMU and LiDAR",
                    color_of(-gaps, 0.0, -3.0),
                    fmt::format("{:.0f}", gaps),
                    "none, up to 3"});
}

void add_registration_light(const ReportData& data, std::vector<Light>& lights) {
  if (!data.pose) return;
  if (!data.pose->ok) {
    lights.push_back(
        {"registration", "red", "REFUSED: " + data.pose->reason, "confidence > 0.9, > 0.5"});
    return;
  }
  std::string value = fmt::format("confidence {:.2f}", data.pose->confidence);
  if (!data.pose->reason.empty()) value += "; " + data.pose->reason;
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
  if (data.pose && !data.pose->ok) return {"REFUSED", "red", data.pose->reason};
  for (const auto& [color, word] : {std::pair{"red", "RED"}, {"amber", "AMBER"}}) {
    const auto found = std::ranges::find(lights, std::string_view(color), &Light::color);
    if (found != lights.end()) return {word, color, found->what + ": " + found->value};
  }
  if (lights.empty()) return {"NO RESULT", "amber", "no stage has run yet"};
  return {"GREEN", "green", "all checks of what ran are good"};
}

}  // namespace hybridfusion
