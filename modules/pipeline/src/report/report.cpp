#include "html.hpp"
#include "lights.hpp"
#include "report_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct Chapter {
  std::string_view id;
  std::string_view title;
  std::vector<std::vector<Figure> (*)(const ReportData&)> parts;
};

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> kChapters = {
      {"result", "Result", {fusion_figures, metric_figures, overlap_figures}},
      {"vision", "Photos", {photo_figures, camera_figures}},
      {"lidar", "LiDAR and IMU", {lidar_figures, profile_figures}},
      {"registration", "Registration", {registration_figures, section_figures, patch_figures}}};
  return kChapters;
}

/// Figures of one kind; what a foreign or damaged file breaks is left out.
std::vector<Figure> figures_of(const Chapter& chapter,
                               const ReportData& data,
                               const RunContext& ctx) {
  std::vector<Figure> figures;
  for (const auto part : chapter.parts) {
    if (ctx.stopped()) return figures;
    try {
      for (Figure& figure : part(data)) figures.push_back(std::move(figure));
    } catch (const Json::exception& error) {
      ctx.warn(fmt::format("report, {}: a figure is left out ({})", chapter.title, error.what()));
    }
  }
  return figures;
}

std::string html_of(const Figure& figure, const Workspace& workspace) {
  std::string sources;
  for (const std::string_view source : figure.sources) {
    if (!workspace.has(source)) continue;  // of a stage that did not run
    sources += fmt::format("{}<code>{}</code>", sources.empty() ? "" : ", ", escaped(source));
  }
  return fmt::format(
      "<figure id='{}'><h3>{}</h3>\n{}<figcaption>{} <span class=src>Drawn from {}.</span>"
      "</figcaption></figure>\n",
      figure.id,
      escaped(figure.title),
      figure.body,
      escaped(figure.caption),
      sources);
}

std::string verdict_html(const ReportData& data) {
  const std::vector<Light> lights = traffic_lights(data);
  const Verdict verdict = overall_verdict(data, lights);
  std::string html = fmt::format(
      "<div class='verdict {}'><b>{}</b><span>{}</span></div>\n"
      "<table class=lights><tr><th>check</th><th>verdict</th><th>value</th><th>green, "
      "amber</th></tr>\n",
      verdict.color,
      verdict.word,
      verdict.reason);
  for (const Light& light : lights) {
    html +=
        fmt::format("<tr><td>{}</td><td class={}>{}</td><td>{}</td><td class=quiet>{}</td></tr>\n",
                    escaped(light.what),
                    light.color,
                    light.color,
                    light.value,
                    escaped(light.limits));
  }
  return html + "</table>\n";
}

void append(std::string& list, std::string_view separator, const std::string& entry) {
  if (!list.empty()) list += separator;
  list += entry;
}

/// Which stages made this report, and which are still to come.
std::string stages_html(const RunRecord& record) {
  std::string ran;
  std::string missing;
  for (const std::string_view stage : kStages) {
    append(record.stages.contains(std::string(stage)) ? ran : missing, ", ", std::string(stage));
  }
  std::string html = fmt::format("<p class=sub>Ran: {}.", ran.empty() ? "nothing" : ran);
  if (!missing.empty()) html += fmt::format(" Not run: {}.", missing);
  return html + "</p>\n";
}

std::string cost_html(const RunRecord& record) {
  std::string rows;
  StageCost total;
  std::array<std::string, 3> sums;
  for (const std::string_view stage : kStages) {
    const auto found = record.stages.find(std::string(stage));
    if (found == record.stages.end()) continue;
    const StageCost& cost = found->second.cost;
    total.wall_s += cost.wall_s;
    total.cpu_s += cost.cpu_s;
    total.peak_memory_mib = std::max(total.peak_memory_mib, cost.peak_memory_mib);
    const auto source = [&](std::string_view key) {
      return fmt::format("{}#/stages/{}/{}", workspace_file::kRun, stage, key);
    };
    append(sums[0], " + ", source("seconds"));
    append(sums[1], " + ", source("cpu_seconds"));
    append(sums[2], ", ", source("peak_memory_mib"));
    rows += fmt::format(
        "<tr><td>{}</td><td class=v>{}</td><td class=v>{}</td><td class=v>{}</td>"
        "<td class=v>{}</td></tr>\n",
        stage,
        traced(cost.wall_s, "{:.1f}", source("seconds")),
        traced(cost.cpu_s, "{:.1f}", source("cpu_seconds")),
        traced(cost.peak_memory_mib, "{:.0f}", source("peak_memory_mib")),
        traced(found->second.threads, "{:.0f}", source("threads")));
  }
  if (rows.empty()) return {};
  return fmt::format(
      "<section id=cost><h2>Time and memory</h2><figure id=cost-table><table><tr><th>stage</th>"
      "<th>time [s]</th><th>CPU time [s]</th><th>peak memory [MiB]</th><th>threads</th></tr>\n{}"
      "<tr class=sum><td>together</td><td class=v>{}</td><td class=v>{}</td>"
      "<td class=v>{}</td><td></td></tr></table><figcaption><span class=src>Drawn from "
      "<code>{}</code>.</span></figcaption></figure></section>\n",
      rows,
      traced(total.wall_s, "{:.1f}", sums[0]),
      traced(total.cpu_s, "{:.1f}", sums[1]),
      traced(total.peak_memory_mib, "{:.0f}", "max(0, " + sums[2] + ")"),
      workspace_file::kRun);
}

std::string numbers_html(const RunRecord& record) {
  std::string html;
  for (const std::string_view stage : kStages) {
    const Json result = stage_result(record, stage);
    if (!result.is_object()) continue;
    html += fmt::format(
        "<details><summary>{}</summary>{}</details>\n",
        stage,
        html_table(result,
                   fmt::format("{}#/stages/{}/result/result", workspace_file::kRun, stage)));
  }
  if (html.empty()) return {};
  return fmt::format(
      "<section id=numbers><h2>All numbers</h2>{}<p class=src>From "
      "<code>{}</code>.</p></section>\n",
      html,
      workspace_file::kRun);
}

std::string page_of(const ReportData& data, const Workspace& workspace, const RunContext& ctx) {
  std::string contents;
  std::string body;
  for (const Chapter& chapter : chapters()) {
    const std::vector<Figure> figures = figures_of(chapter, data, ctx);
    if (figures.empty()) continue;
    contents += fmt::format("<a href='#{}'>{}</a> ", chapter.id, chapter.title);
    body += fmt::format("<section id={}><h2>{}</h2>\n", chapter.id, chapter.title);
    for (const Figure& figure : figures) body += html_of(figure, workspace);
    body += "</section>\n";
  }
  if (!body.empty())
    contents += "<a href='#cost'>Time and memory</a> <a href='#numbers'>All numbers</a>";
  return html_head("HybridFusion report: " + data.name) + verdict_html(data) +
         stages_html(data.record) + "<nav>" + contents + "</nav>\n" + body +
         cost_html(data.record) + numbers_html(data.record) +
         fmt::format("<footer>hybridfusion {}</footer>\n</body></html>\n", program_version());
}

}  // namespace

Expected<void> write_report(const Project& project, const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  if (auto folder = workspace.make_folder("report"); !folder) return folder;
  const ReportData data = read_report_data(workspace, ctx);
  std::string html;
  try {
    html = page_of(data, workspace, ctx);
  } catch (const Json::exception& error) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: {}; run the stages again",
                            workspace.path(workspace_file::kRun).string(),
                            error.what()));
  }
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while drawing the report");
  return write_file_atomically(workspace.path(workspace_file::kReport), html);
}

}  // namespace hybridfusion
