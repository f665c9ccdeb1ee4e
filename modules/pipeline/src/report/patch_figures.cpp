#include "chart.hpp"
#include "html.hpp"
#include "plan_map.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct OutcomeStyle {
  std::string_view name;
  std::string_view title;
  std::string_view color;
};
constexpr std::array<OutcomeStyle, 8> kOutcomes = {
    {{"no_candidate", "no patch in the ring", "#c9ced6"},
     {"no_correlation", "no descriptor correlates", "#9aa3ad"},
     {"no_similar_neighbours", "no similar neighbours", "#b39ddb"},
     {"no_boundary", "too little boundary or no 2D minimum", "#7e57c2"},
     {"rejected_3d", "3D alignment rejected", "#f0b429"},
     {"out_of_window", "leads far away", "#c0392b"},
     {"outside_cluster", "pose outside the cluster", "#d35400"},
     {"in_cluster", "pose in the cluster", "#239b56"}}};
constexpr OutcomeStyle kUnknown = {"", "unknown", "#000000"};

const OutcomeStyle& style_of(const std::string& outcome) {
  const auto found = std::ranges::find(kOutcomes, std::string_view(outcome), &OutcomeStyle::name);
  return found == kOutcomes.end() ? kUnknown : *found;
}

/// Colours of the outcomes that occur.
std::string legend_of(const Json& patches) {
  std::string legend = "<p class=keys>";
  for (const OutcomeStyle& style : kOutcomes) {
    const auto count = std::ranges::count_if(
        patches, [&](const Json& patch) { return patch.value("outcome", "") == style.name; });
    if (count == 0) continue;
    legend += fmt::format(
        "<span><i style='background:{}'></i>{} ({})</span> ", style.color, style.title, count);
  }
  return legend + "</p>\n";
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
  return map.svg() + legend_of(patches);
}

std::string cell_text(const Json& index) {
  if (index.size() != 2 || index[0].get<int>() < 0) return "–";
  return fmt::format("{}, {}", index[0].get<int>(), index[1].get<int>());
}

std::string source_of(std::size_t patch, std::string_view key) {
  return fmt::format("{}#/patches/{}/{}", workspace_file::kRegistration, patch, key);
}

/// How far each patch of the published chain came.
std::string chain_table(const Json& patches) {
  std::string html =
      "<details><summary>All patches</summary><table><tr><th>LiDAR cell</th><th>vision cell</th>"
      "<th>points</th><th>in the ring</th><th>correlated</th><th>similar</th><th>correlation</th>"
      "<th>neighbour score</th><th>2D score [m]</th><th>3D score [m]</th><th>outcome</th></tr>\n";
  std::size_t index = 0;
  for (const Json& patch : patches) {
    html += fmt::format("<tr><td>{}</td><td>{}</td>",
                        cell_text(patch.at("lidar_cell")),
                        cell_text(patch.at("vision_cell")));
    for (const std::string_view key :
         {"num_points", "num_candidates", "num_correlated", "num_similar"}) {
      html += fmt::format("<td class=v>{}</td>",
                          traced(patch.value(key, 0.0), "{:.0f}", source_of(index, key)));
    }
    for (const std::string_view key :
         {"correlation", "neighbour_score", "score_2d_m", "score_3d_m"}) {
      html += fmt::format("<td class=v>{}</td>",
                          traced(patch.value(key, 0.0), "{:.3f}", source_of(index, key)));
    }
    html += fmt::format("<td>{}</td></tr>\n", style_of(patch.value("outcome", "")).title);
    ++index;
  }
  return html + "</table></details>\n";
}

/// Where each patch would move the result, for those that found a pose.
std::string vote_table(const Json& patches, const StoredRegistration& result) {
  std::string html =
      "<details><summary>All patches</summary><table><tr><th>LiDAR cell</th><th>points</th>"
      "<th>east [m]</th><th>north [m]</th><th>up [m]</th><th>outcome</th></tr>\n";
  const std::string result_pose =
      fmt::format("{}#/vision_from_lidar", workspace_file::kRegistration);
  std::size_t index = 0;
  for (const Json& patch : patches) {
    const std::string outcome = patch.value("outcome", "");
    html += fmt::format(
        "<tr><td>{}</td><td class=v>{}</td>",
        cell_text(patch.at("lidar_cell")),
        traced(patch.value("num_points", 0.0), "{:.0f}", source_of(index, "num_points")));
    const bool has_pose = outcome == "in_cluster" || outcome == "outside_cluster";
    Eigen::Vector3d shift = Eigen::Vector3d::Constant(NAN);
    if (has_pose && result.ok) {
      const auto center = patch.at("centroid_in_vision").get<std::array<double, 3>>();
      const Eigen::Vector3d at(center[0], center[1], center[2]);
      const Rigid3 own = Rigid3::from_matrix(matrix_of(patch.at("vision_from_lidar")));
      shift = own * (result.vision_from_lidar.inverse() * at) - at;
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      html += fmt::format("<td class=v>{}</td>",
                          traced(shift[axis],
                                 "{:+.3f}",
                                 fmt::format("shift({}, {}, {}, {})",
                                             source_of(index, "vision_from_lidar"),
                                             result_pose,
                                             source_of(index, "centroid_in_vision"),
                                             axis)));
    }
    html += fmt::format("<td>{}</td></tr>\n", style_of(outcome).title);
    ++index;
  }
  return html + "</table></details>\n";
}

}  // namespace

std::vector<Figure> patch_figures(const ReportData& data) {
  if (!data.registration.is_object() || !data.registration.contains("patches")) return {};
  const Json& patches = data.registration["patches"];
  if (patches.empty()) return {};
  const bool published = data.pose && data.pose->method == "paper";
  Figure figure{
      .id = "patches",
      .title = published ? "Patches of the published chain" : "Vote of the patches on the pose",
      .body = patch_map(data, patches),
      .sources = {workspace_file::kRegistration, workspace_file::kDense}};
  if (published) {
    figure.body += chain_table(patches);
    figure.caption =
        "How far each LiDAR patch came: candidates in the ring, descriptor correlation, similar "
        "neighbours, 2D boundary and 3D alignment, membership in the largest cluster of poses "
        "(HybridFusion III-C, Algorithm 1).";
  } else {
    if (data.pose) figure.body += vote_table(patches, *data.pose);
    figure.caption =
        "Each patch of the LiDAR cloud is aligned for itself, from the pose that was found; the "
        "table says where it would move the result. Patches in one cluster about no move confirm "
        "the pose; patches that lead away contradict it (after HybridFusion III-C.5).";
  }
  return {std::move(figure)};
}

}  // namespace hybridfusion
