#include "html.hpp"
#include "plan_view.hpp"
#include "run_record.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// One line of the verdict table at the top.
struct Light {
  std::string what;
  std::string_view color;  // green, amber, red
  std::string value;
};

std::string_view color_of(double value, double green_from, double amber_from) {
  return value >= green_from ? "green" : value >= amber_from ? "amber" : "red";
}

/// Result of a stage as its function reported it; null when the stage did not run.
Json result_of(const RunRecord& record, const std::string& stage) {
  const auto found = record.stages.find(stage);
  if (found == record.stages.end()) return nullptr;
  return Json::parse(found->second.result_json).value("result", Json());
}

void add_photo_lights(const Json& result, std::vector<Light>& lights) {
  const double photos = result.value("num_photos", 0.0);
  if (photos <= 0.0) return;
  const double share = result.value("num_registered", 0.0) / photos;
  lights.push_back({"photos calibrated",
                    color_of(share, 0.95, 0.65),
                    fmt::format("{} of {} ({:.0f} %)",
                                result.value("num_registered", 0),
                                result.value("num_photos", 0),
                                100.0 * share)});
  const double change = result.value("focal_change", 0.0);
  lights.push_back({"focal length against metadata",
                    color_of(-std::abs(change), -0.01, -0.05),
                    fmt::format("{:+.2f} %", 100.0 * change)});
}

void add_lidar_lights(const Json& result, std::vector<Light>& lights) {
  const double scans = result.value("num_scans", 0.0);
  if (scans <= 0.0) return;
  const double bad = result.value("num_flagged_scans", 0.0) / scans;
  lights.push_back({"LiDAR scans without a flag",
                    color_of(1.0 - bad, 0.95, 0.80),
                    fmt::format("{:.1f} %", 100.0 * (1.0 - bad))});
}

void add_registration_light(const Json& result, std::vector<Light>& lights) {
  const std::string status = result.value("status", "");
  if (status.empty()) return;
  const double confidence = result.value("confidence", 0.0);
  if (status != "ok") {
    lights.push_back({"registration", "red", "REFUSED: " + result.value("reason", "")});
    return;
  }
  lights.push_back({"registration",
                    color_of(confidence, 0.9, 0.5),
                    fmt::format("ok, confidence {:.2f}", confidence)});
}

std::string lights_table(const RunRecord& record) {
  std::vector<Light> lights;
  if (const Json result = result_of(record, "reconstruct"); result.is_object()) {
    add_photo_lights(result, lights);
  }
  if (const Json result = result_of(record, "map"); result.is_object()) {
    add_lidar_lights(result, lights);
  }
  if (const Json result = result_of(record, "register"); result.is_object()) {
    add_registration_light(result, lights);
  }
  std::string html = "<table><tr><th>check</th><th>verdict</th><th>value</th></tr>\n";
  for (const Light& light : lights) {
    html += fmt::format("<tr><td>{}</td><td class={}>{}</td><td>{}</td></tr>\n",
                        escaped(light.what),
                        light.color,
                        light.color,
                        escaped(light.value));
  }
  return html + "</table>\n";
}

std::string cost_table(const RunRecord& record) {
  std::string html =
      "<table><tr><th>stage</th><th>time [s]</th><th>CPU [s]</th><th>peak memory [MiB]</th></tr>\n";
  for (const std::string_view stage : kStages) {
    const auto found = record.stages.find(std::string(stage));
    if (found == record.stages.end()) continue;
    const StageCost& cost = found->second.cost;
    html += fmt::format(
        "<tr><td>{}</td><td class=v>{:.1f}</td><td class=v>{:.1f}</td><td class=v>{:.0f}</td>"
        "</tr>\n",
        stage,
        cost.wall_s,
        cost.cpu_s,
        cost.peak_memory_mib);
  }
  return html + "</table>\n";
}

}  // namespace

Expected<void> write_report(const Project& project) {
  const Workspace& workspace = project.workspace;
  if (auto folder = workspace.make_folder("report"); !folder) return folder;
  const RunRecord record = RunRecord::load(workspace.path(workspace_file::kRun));
  std::string html = html_head("HybridFusion report");
  html += fmt::format("<p>hybridfusion {}, workspace {}</p>\n",
                      program_version(),
                      escaped(workspace.root().filename().string()));
  html += lights_table(record);
  html += "<h2>Plan</h2>\n" + plan_view_svg(workspace);
  html += "<h2>Cost</h2>\n" + cost_table(record);
  for (const std::string_view stage : kStages) {
    const Json result = result_of(record, std::string(stage));
    if (!result.is_object()) continue;
    html += fmt::format("<h2>Stage {}</h2>\n{}", stage, html_table(result));
  }
  html += "</body></html>\n";
  return write_file_atomically(workspace.path(workspace_file::kReport), html);
}

}  // namespace hybridfusion
