#include "doctor_checks.hpp"
#include "json_text.hpp"
#include "photo_places.hpp"
#include "recording_choice.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/pipeline/doctor.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxSiteGap_m = 500.0;
constexpr double kMaxBelow_m = 30.0;  // two receivers with their biases agree better than that

/// Of the positions whose altitude is known; none of none.
std::optional<double> median_altitude_m(std::span<const GeodeticPosition> positions) {
  std::vector<double> altitudes;
  for (const GeodeticPosition& position : positions) {
    if (std::isfinite(position.altitude_m)) altitudes.push_back(position.altitude_m);
  }
  if (altitudes.empty()) return std::nullopt;
  const auto middle = altitudes.begin() + static_cast<std::ptrdiff_t>(altitudes.size() / 2);
  std::ranges::nth_element(altitudes, middle);
  return *middle;
}

GeodeticPosition swapped(const GeodeticPosition& position) {
  return {.latitude_deg = position.longitude_deg,
          .longitude_deg = position.latitude_deg,
          .altitude_m = position.altitude_m};
}

/// Horizontal distance between the nearest of the photos and the drive [m].
double gap_m(std::span<const GeodeticPosition> photos,
             std::span<const GeodeticPosition> fixes,
             bool swap_photos) {
  constexpr std::size_t kMaxFixes = 500;
  const std::size_t step = std::max<std::size_t>(1, fixes.size() / kMaxFixes);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const GeodeticPosition& photo : photos) {
    GeodeticPosition place = swap_photos ? swapped(photo) : photo;
    place.altitude_m = 0.0;
    if (std::abs(place.latitude_deg) > 90.0) return nearest_m;
    for (std::size_t i = 0; i < fixes.size(); i += step) {
      // Not only east and north: beyond the horizon the plane leaves the Earth.
      nearest_m = std::min(nearest_m,
                           enu_from_geodetic(place,
                                             {.latitude_deg = fixes[i].latitude_deg,
                                              .longitude_deg = fixes[i].longitude_deg,
                                              .altitude_m = 0.0})
                               .norm());
    }
  }
  return nearest_m;
}

bool is_resource(const Finding& finding) {
  return finding.id.starts_with("machine.") || finding.id.starts_with("output.");
}

}  // namespace

bool DoctorReport::has_errors() const {
  return std::ranges::any_of(
      findings, [](const Finding& finding) { return finding.severity == Severity::kError; });
}

bool DoctorReport::only_resource_errors() const {
  return has_errors() && std::ranges::all_of(findings, [](const Finding& finding) {
           return finding.severity != Severity::kError || is_resource(finding);
         });
}

void check_site(const PhotoEvidence& photos,
                const RecordingEvidence& recording,
                Diagnosis& diagnosis) {
  if (photos.positions.empty() || recording.fixes.empty()) return;
  const double gap = gap_m(photos.positions, recording.fixes, false);
  if (gap > kMaxSiteGap_m) {
    const bool swap_helps = gap_m(photos.positions, recording.fixes, true) <= kMaxSiteGap_m;
    diagnosis.findings.add(
        "site.apart",
        fmt::format("the nearest photo is {:.1f} km from the drive{}",
                    gap / 1000.0,
                    swap_helps ? "; latitude and longitude of the photos are swapped" : ""));
    return;
  }
  const auto photos_m = median_altitude_m(photos.positions);
  const auto drive_m = median_altitude_m(recording.fixes);
  if (!photos_m || !drive_m) return;
  const double above_m = *photos_m - *drive_m;
  diagnosis.facts.push_back(fmt::format("the photos lie {:.0f} m {} the drive (median)",
                                        std::abs(above_m),
                                        above_m < 0.0 ? "below" : "above"));
  if (!photos.take_off_altitudes_m.empty()) {
    const double take_off_m = median_of(photos.take_off_altitudes_m) - *drive_m;
    diagnosis.facts.push_back(
        fmt::format("by both receivers the take-off lies {:.1f} m {} the antenna of the drive: "
                    "where the ground is level, their heights differ by about that",
                    std::abs(take_off_m),
                    take_off_m < 0.0 ? "below" : "above"));
  }
  if (above_m < -kMaxBelow_m) {
    diagnosis.findings.add("site.photos_below_street",
                           fmt::format("the photos lie {:.0f} m below the drive", -above_m));
  }
}

Expected<DoctorReport> examine(const DoctorInputs& inputs,
                               const PipelineOptions& options,
                               const RunContext& ctx) {
  Diagnosis diagnosis;
  diagnosis.facts.push_back(
      fmt::format("hybridfusion {}, {} threads", program_version(), effective_threads(ctx)));
  RecordingEvidence recording;
  if (inputs.bag || inputs.sensors) {
    const SensorConfig sensors = check_sensors(
        inputs.bag ? sensors_file(*inputs.bag, inputs.sensors) : inputs.sensors, diagnosis);
    if (inputs.bag) {
      HF_TRY(recording,
             check_recording(
                 *inputs.bag, recording_options(options.lidar.recording, sensors), diagnosis, ctx));
    }
  }
  const std::optional<double> ground_altitude_m = median_altitude_m(recording.fixes);
  PhotoEvidence photos;
  if (inputs.images) {
    HF_TRY(photos,
           check_photos(
               {.images = *inputs.images, .geo_tags = inputs.geo_tags, .control = inputs.control},
               ground_altitude_m,
               options.vision,
               diagnosis,
               ctx));
  }
  if (!photos.weak_georeference.empty() && !inputs.bag) {
    diagnosis.findings.add("photos.weak_georeference", photos.weak_georeference);
  }
  check_site(photos, recording, diagnosis);
  check_machine(machine_state(inputs.workspace), photos, recording, diagnosis);
  if (inputs.workspace) check_workspace(*inputs.workspace, diagnosis);
  return DoctorReport{.findings = diagnosis.findings.take(), .facts = std::move(diagnosis.facts)};
}

std::string to_json(const DoctorReport& report) {
  Json findings = Json::array();
  for (const Finding& finding : report.findings) {
    findings.push_back({{"id", finding.id},
                        {"severity", to_string(finding.severity)},
                        {"cause", finding.cause},
                        {"remedy", finding.remedy},
                        {"subjects", finding.subjects}});
  }
  return to_text(Json{{"facts", report.facts}, {"findings", findings}});
}

}  // namespace hybridfusion
