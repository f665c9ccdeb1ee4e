#include "real_drives_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::benchmark {
namespace {

std::string percent(const SegmentError& segment) {
  return segment.num_segments == 0
             ? "-"
             : fmt::format("{:.2f} ({:.2f})", segment.turned_percent, segment.translation_percent);
}

std::string line(const RealDriveRow& row) {
  std::string text = fmt::format("| {} | {} | {} |",
                                 row.drive,
                                 row.program,
                                 row.run ? std::to_string(row.run->exit_code) : "-");
  if (row.errors) {
    const DriveErrors& errors = *row.errors;
    text += fmt::format(" {}/{} | {:.3f} |", errors.num_poses, row.num_scans, errors.path_ratio);
    for (const SegmentError& segment : errors.segments)
      text += fmt::format(" {} |", percent(segment));
    for (const SegmentError& segment : errors.segments) {
      text += segment.num_segments == 0 ? " - |" : fmt::format(" {:.2f} |", segment.rotation_deg);
    }
    text += fmt::format(" {:.2f} | {:.2f} |", errors.tilt_deg, errors.ate_m);
  } else {
    text += fmt::format(" 0/{} | - | - | - | - | - | - | - | - | - | - | - |", row.num_scans);
  }
  text += row.thickness_m < 0.0 ? " - |" : fmt::format(" {:.3f} |", row.thickness_m);
  if (!row.run) return text + " - | - |";
  return text + fmt::format(" {:.0f} | {:.0f} |",
                            1e3 * row.run->cpu_s /
                                static_cast<double>(std::max<std::size_t>(1, row.num_scans)),
                            row.run->peak_mib);
}

}  // namespace

std::string table(const std::vector<RealDriveRow>& rows) {
  std::string text =
      "| drive | program | exit | scans | path ratio | t5 % | t10 % | t25 % | t50 % | r5 deg | r10 "
      "| r25 | r50 | tilt deg | ATE m | planes m | CPU ms a scan | MiB |\n|";
  for (int i = 0; i < 18; ++i) text += "---|";
  for (const RealDriveRow& row : rows) text += fmt::format("\n{}", line(row));
  return text + "\n";
}

nlohmann::json to_json(const RealDriveRow& row) {
  nlohmann::json json = {{"drive", row.drive}, {"program", row.program}, {"scans", row.num_scans}};
  if (row.run) {
    json["exit"] = row.run->exit_code;
    json["cpu_s"] = row.run->cpu_s;
    json["peak_mib"] = row.run->peak_mib;
  }
  if (row.thickness_m >= 0.0) json["plane_thickness_m"] = row.thickness_m;
  if (!row.errors) return json;
  json["path_ratio"] = row.errors->path_ratio;
  json["tilt_deg"] = row.errors->tilt_deg;
  json["ate_m"] = row.errors->ate_m;
  json["misalignment_deg"] = row.errors->misalignment_deg;
  for (std::size_t i = 0; i < kSegments_m.size(); ++i) {
    const SegmentError& segment = row.errors->segments[i];
    json["segments"].push_back({{"length_m", kSegments_m[i]},
                                {"count", segment.num_segments},
                                {"translation_percent", segment.translation_percent},
                                {"turned_percent", segment.turned_percent},
                                {"rotation_deg", segment.rotation_deg}});
  }
  return json;
}

}  // namespace hybridfusion::benchmark
