#include "chart.hpp"
#include "html.hpp"
#include "plan_map.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::optional<Figure> supplement_figure(const Json& metrics) {
  if (!metrics.is_object() || !metrics.contains("supplement")) return std::nullopt;
  std::string body =
      "<table><tr><th>leaf [m]</th><th>photos [m³]</th><th>fused [m³]</th>"
      "<th>supplement degree [%]</th></tr>\n";
  std::size_t index = 0;
  for (const Json& row : metrics["supplement"]) {
    const std::string place = fmt::format("{}#/supplement/{}/", workspace_file::kMetrics, index++);
    const auto value = [&](std::string_view key, std::string_view format) {
      return traced(row.at(key).get<double>(), format, place + std::string(key));
    };
    body += fmt::format(
        "<tr><td class=v>{}</td><td class=v>{}</td><td class=v>{}</td><td class=v>{}</td></tr>\n",
        value("leaf_m", "{:g}"),
        value("vision_volume_m3", "{:.1f}"),
        value("result_volume_m3", "{:.1f}"),
        traced(100.0 * row.at("supplement_degree").get<double>(),
               "{:.2f}",
               "100 * " + place + "supplement_degree"));
  }
  return Figure{.id = "supplement-degree",
                .title = "Supplement degree: what the LiDAR adds",
                .body = body + "</table>\n",
                .caption =
                    "Volume of the occupied octree leaves of the photos' cloud and of the fused "
                    "cloud inside the rectangle of the LiDAR cloud, for three leaf sizes, and the "
                    "gain in per cent (HybridFusion IV-A).",
                .sources = {workspace_file::kMetrics}};
}

std::optional<Figure> boundary_figure(const Json& metrics) {
  if (!metrics.is_object() || !metrics.contains("boundary")) return std::nullopt;
  const Json& boundary = metrics["boundary"];
  if (!boundary.contains("histogram")) return std::nullopt;
  const double bin_m = boundary["histogram"].at("bin_m");
  const auto counts = boundary["histogram"].at("counts").get<std::vector<double>>();
  std::vector<double> edges;
  for (std::size_t i = 0; i <= counts.size(); ++i) edges.push_back(bin_m * static_cast<double>(i));
  Chart chart({"distance to the boundary of the photos' cloud [m]", 0.0, edges.back()},
              {"LiDAR boundary points", 0.0, 1.05 * *std::ranges::max_element(counts)});
  chart.bars(edges, counts, ink::kLidar);
  const double mean_m = boundary.value("accuracy_m", 0.0);
  chart.upright(mean_m, ink::kAlarm, fmt::format("mean {:.2f} m", mean_m));
  std::string caption = fmt::format(
      "Distances between what stands on the ground in both clouds, seen from above; the last bar "
      "holds all beyond. {:.0f} % of the LiDAR boundary have a partner.",
      100.0 * boundary.value("share_with_partner", 0.0));
  if (boundary.contains("oracle_m")) {
    caption +=
        fmt::format(" At the true pose the mean is {:.3f} m.", boundary["oracle_m"].get<double>());
  }
  return Figure{.id = "boundary-distances",
                .title = "Boundary distances",
                .body = chart.svg(),
                .caption = std::move(caption),
                .sources = {workspace_file::kMetrics}};
}

std::optional<Figure> baseline_figure(const Json& metrics) {
  if (!metrics.is_object() || !metrics.contains("baselines")) return std::nullopt;
  std::string rows;
  const auto number = [](const Json& json, std::string_view key, const std::string& place) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number()) return std::string("–");
    return traced(found->get<double>(),
                  "{:.3f}",
                  fmt::format("{}#/{}{}", workspace_file::kMetrics, place, key));
  };
  rows += fmt::format(
      "<tr><td>{} (this result)</td><td>registered</td><td class=v>{}</td><td "
      "class=v>{}</td></tr>\n",
      escaped(metrics.value("method", "")),
      number(metrics, "boundary_accuracy_m", {}),
      number(metrics, "seconds", {}));
  for (const auto& [name, json] : metrics["baselines"].items()) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=v>{}</td><td class=v>{}</td></tr>\n",
                        escaped(name),
                        json.contains("error")           ? "failed"
                        : json.value("converged", false) ? "converged"
                                                         : "refused",
                        number(json, "accuracy_m", "baselines/" + name + "/"),
                        number(json, "seconds", "baselines/" + name + "/"));
  }
  return Figure{.id = "baselines",
                .title = "Against other methods",
                .body =
                    "<table><tr><th>method</th><th>verdict</th><th>boundary accuracy [m]</th>"
                    "<th>time [s]</th></tr>\n" +
                    rows + "</table>\n",
                .caption =
                    "The same clouds from the same coarse pose (HybridFusion IV, Table I). The "
                    "boundary accuracy has a floor well above zero, because the sensors see "
                    "different things.",
                .sources = {workspace_file::kMetrics}};
}

/// The whole result from one side, coloured, or by source.
std::string picture(const ReportData& data, bool by_source) {
  constexpr int kWidth_px = 1100;
  constexpr Rgb8 kPaper = {247, 248, 250};
  constexpr double kAzimuth_rad = 205.0 * std::numbers::pi / 180.0;
  constexpr double kElevation_rad = 42.0 * std::numbers::pi / 180.0;
  const Rigid3 shown_from_lidar = data.shown_from_lidar();
  PointCloud lidar = transformed(shown_from_lidar, data.lidar);
  const bool both = data.registered() && !data.vision.empty() && !data.lidar.empty();
  const PointCloud& main = data.vision.empty() ? lidar : data.vision;
  // Of an unregistered pair only the photos' cloud is drawn: the other has no place in it. Of a
  // registered one the surroundings of the drive are shown, where there is something to compare.
  constexpr double kAround_m = 12.0;
  Eigen::AlignedBox2d plan = trimmed_box(main.points, 0.02, 1.0);
  if (both) plan = plan.intersection(trimmed_box(lidar.points, 0.01, kAround_m));
  std::vector<double> heights;
  for (std::size_t i = 0; i < main.size(); i += 8) {
    const Eigen::Vector3d point = main.points[i].cast<double>();
    if (plan.contains(point.head<2>())) heights.push_back(point.z());
  }
  const Eigen::AlignedBox3d box(
      Eigen::Vector3d(plan.min().x(), plan.min().y(), quantile(heights, 0.01)),
      Eigen::Vector3d(plan.max().x(), plan.max().y(), quantile(heights, 0.99) + 1.0));
  Splatter splatter(oblique_view(box, kAzimuth_rad, kElevation_rad, kWidth_px));
  const double low = quantile(heights, 0.02);
  const double range = std::max(0.5, quantile(heights, 0.98) - low);
  const auto draw = [&](const PointCloud& cloud, Rgb8 tint) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (!plan.contains(Eigen::Vector2d(cloud.points[i].head<2>().cast<double>()))) continue;
      Rgb8 color = tint;
      const double share = std::clamp((cloud.points[i].z() - low) / range, 0.0, 1.0);
      if (!by_source && !cloud.colors.empty()) {
        color = cloud.colors[i];
      } else {
        for (std::uint8_t& c : color) {
          c = static_cast<std::uint8_t>(c * (0.62 + 0.38 * share));
        }
      }
      splatter.add(cloud.points[i], color, 1);
    }
  };
  if (!data.vision.empty()) draw(data.vision, {88, 150, 210});
  if (data.vision.empty() || both)
    draw(lidar, by_source ? Rgb8{235, 130, 45} : Rgb8{205, 200, 192});
  return data_uri(without_blank_rows(splatter.image(kPaper), kPaper)).value_or("");
}

Figure picture_figure(const ReportData& data, bool by_source) {
  return {.id = by_source ? "sources" : "picture",
          .title = by_source ? "Which sensor saw what" : "The cloud",
          .body = fmt::format("<img class=wide alt='{}' src='{}'>\n",
                              by_source ? "clouds by source" : "cloud",
                              picture(data, by_source)),
          .caption = by_source
                         ? "Blue: photos; orange: LiDAR. The drone sees roofs and open ground, "
                           "the vehicle facades and what lies under trees."
                     : data.registered()
                         ? "Photos and LiDAR together, seen from the south-west, thinned to 0.1 m."
                         : "Seen from the south-west, thinned to 0.1 m.",
          .sources = {workspace_file::kDense, workspace_file::kMap, workspace_file::kRegistration}};
}

}  // namespace

std::vector<Figure> fusion_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (!data.vision.empty() || !data.lidar.empty()) figures.push_back(picture_figure(data, false));
  if (data.registered() && !data.vision.empty() && !data.lidar.empty()) {
    figures.push_back(picture_figure(data, true));
  }
  return figures;
}

std::vector<Figure> metric_figures(const ReportData& data) {
  std::vector<Figure> figures;
  for (auto figure : {supplement_figure(data.metrics),
                      boundary_figure(data.metrics),
                      baseline_figure(data.metrics)}) {
    if (figure) figures.push_back(*std::move(figure));
  }
  return figures;
}

}  // namespace hybridfusion
