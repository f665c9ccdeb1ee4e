#include "chart.hpp"
#include "html.hpp"
#include "plan_map.hpp"
#include "report_data.hpp"

#include <array>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct OutcomeStyle {
  std::string_view name;
  std::string_view title;
  std::string_view color;
};
constexpr std::array<OutcomeStyle, 7> kOutcomes = {
    {{"no_candidate", "no patch in the ring", "#c9ced6"},
     {"no_correlation", "no descriptor correlates", "#9aa3ad"},
     {"no_similar_neighbours", "no similar neighbours", "#b39ddb"},
     {"no_boundary", "no boundary or no 2D minimum", "#7e57c2"},
     {"rejected_3d", "3D alignment rejected", "#f0b429"},
     {"outside_cluster", "pose outside the cluster", "#d35400"},
     {"in_cluster", "pose in the cluster", "#239b56"}}};

const OutcomeStyle& style_of(const std::string& outcome) {
  for (const OutcomeStyle& style : kOutcomes) {
    if (style.name == outcome) return style;
  }
  return kOutcomes.front();
}

std::string patch_map(const ReportData& data, const Json& patches) {
  Eigen::AlignedBox2d box;
  std::vector<Eigen::Vector2d> centers;
  for (const Json& patch : patches) {
    if (!patch.contains("centroid_in_vision")) return {};
    const auto center = patch["centroid_in_vision"].get<std::array<double, 3>>();
    centers.emplace_back(center[0], center[1]);
    box.extend(centers.back());
  }
  if (box.isEmpty()) return {};
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(15.0);
  PlanMap map({box.min() - margin, box.max() + margin}, 620.0);
  const std::string picture = cloud_from_above(data.vision, map.box());
  if (!picture.empty()) map.background(picture, 0.55);
  for (std::size_t i = 0; i < centers.size(); ++i) {
    map.dot(centers[i], "#ffffff", 8.5, "");
    const std::string outcome = patches[i].value("outcome", "");
    const OutcomeStyle& style = style_of(outcome);
    map.dot(centers[i], style.color, 6.5, style.title);
  }
  std::string legend = "<p class=keys>";
  for (const OutcomeStyle& style : kOutcomes) {
    legend +=
        fmt::format("<span><i style='background:{}'></i>{}</span> ", style.color, style.title);
  }
  return map.svg() + legend + "</p>\n";
}

std::string patch_table(const Json& patches) {
  std::string html =
      "<details><summary>All patches</summary><table><tr><th>LiDAR cell</th><th>vision cell</th>"
      "<th>points</th><th>in the ring</th><th>correlated</th><th>similar</th><th>correlation</th>"
      "<th>neighbour score</th><th>2D score [m]</th><th>3D score [m]</th><th>outcome</th></tr>\n";
  const auto cell = [](const Json& index) {
    return index.size() == 2 ? fmt::format("{}, {}", index[0].get<int>(), index[1].get<int>())
                             : "–";
  };
  for (const Json& patch : patches) {
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=v>{}</td><td class=v>{}</td><td class=v>{}</td>"
        "<td class=v>{}</td><td class=v>{:.3f}</td><td class=v>{:.3f}</td><td class=v>{:.3f}</td>"
        "<td class=v>{:.3f}</td><td>{}</td></tr>\n",
        cell(patch.at("lidar_cell")),
        cell(patch.at("vision_cell")),
        patch.value("num_points", 0),
        patch.value("num_candidates", 0),
        patch.value("num_correlated", 0),
        patch.value("num_similar", 0),
        patch.value("correlation", 0.0),
        patch.value("neighbour_score", 0.0),
        patch.value("score_2d_m", 0.0),
        patch.value("score_3d_m", 0.0),
        escaped(style_of(patch.value("outcome", "")).title));
  }
  return html + "</table></details>\n";
}

}  // namespace

std::vector<Figure> patch_figures(const ReportData& data) {
  if (!data.registration.is_object() || !data.registration.contains("patches")) return {};
  const Json& patches = data.registration["patches"];
  if (patches.empty()) return {};
  return {
      {.id = "patches",
       .title = "Patches of the published chain",
       .body = patch_map(data, patches) + patch_table(patches),
       .caption =
           "How far each LiDAR patch came: candidates in the ring, descriptor correlation, "
           "similar neighbours, 2D boundary and 3D alignment, membership in the largest cluster "
           "of poses (HybridFusion III-C, Algorithm 1).",
       .sources = {workspace_file::kRegistration, workspace_file::kDense}}};
}

}  // namespace hybridfusion
