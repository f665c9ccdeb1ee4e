#include "chart.hpp"
#include "html.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

double heading_deg(const Rigid3& pose) {
  const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
  return kDegPerRad * std::atan2(rotation(1, 0), rotation(0, 0));
}

double tilt_deg(const Rigid3& pose) {
  const Eigen::Vector3d up = pose.rotation * Eigen::Vector3d::UnitZ();
  return kDegPerRad * std::atan2(up.head<2>().norm(), up.z());
}

/// A member of registration.json, e.g. "candidates/0/score".
std::string source_of(std::string_view member) {
  return fmt::format("{}#/{}", workspace_file::kRegistration, member);
}

std::string heading_formula(const std::string& pose) {
  return fmt::format("degrees(atan2({}, {}))", source_of(pose + "/4"), source_of(pose + "/0"));
}

std::string tilt_formula(const std::string& pose) {
  return fmt::format("degrees(atan2(hypot({}, {}), {}))",
                     source_of(pose + "/2"),
                     source_of(pose + "/6"),
                     source_of(pose + "/10"));
}

std::string sigma_formula(int axis) {
  return fmt::format("sqrt({})", source_of(fmt::format("covariance/{}", 7 * axis)));
}

/// Status, confidence and what else was found out.
std::string verdict_table(const StoredRegistration& pose, const Json& json) {
  std::string body = "<table><tr><th>verdict</th><th>value</th></tr>\n";
  const auto fact = [&](std::string_view name, const std::string& html) {
    body += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", name, html);
  };
  fact("status", pose.ok ? "registered" : "refused");
  fact("confidence", traced(pose.confidence, "{:.3f}", source_of("confidence")));
  if (!pose.reason.empty()) fact("reason", escaped(pose.reason));
  fact("method", escaped(pose.method));
  fact("coarse pose from", escaped(json.value("coarse_pose", "–")));
  if (json.value("vision_scale_supported", false)) {
    fact("scale of the photo model",
         fmt::format("{} % against the LiDAR cloud, ± {} %",
                     traced(100.0 * (1.0 / json.value("vision_scale", 1.0) - 1.0),
                            "{:+.3f}",
                            "100 * (1 / " + source_of("vision_scale") + " - 1)"),
                     traced(100.0 * json.value("vision_scale_sigma", 0.0),
                            "{:.3f}",
                            "100 * " + source_of("vision_scale_sigma"))));
  } else {
    fact("scale of the photo model", "could not be told from the LiDAR cloud");
  }
  if (json.contains("level")) {
    const Json& level = json["level"];
    fact("tilt of the photo model",
         level.value("corrected", false)
             ? fmt::format(
                   "{}° against gravity in the LiDAR map, levelled in the fused cloud",
                   traced(level.value("tilt_deg", 0.0), "{:.3f}", source_of("level/tilt_deg")))
             : "kept: " + escaped(level.value("reason", std::string())));
  }
  return body + "</table>\n";
}

/// The pose before and after; empty where there is neither.
std::string pose_table(const StoredRegistration& pose, const Json& json) {
  if (!pose.ok && !pose.initial) return {};
  std::array<double, 6> sigma{};
  if (json.contains("covariance") && json["covariance"].size() == 36) {
    for (std::size_t i = 0; i < 6; ++i) {
      sigma[i] = std::sqrt(std::max(0.0, json["covariance"][7 * i].get<double>()));
    }
  }
  std::string body =
      "<table><tr><th>LiDAR map in the vision frame</th><th>coarse</th><th>registered</th>"
      "<th>standard deviation</th><th>unit</th></tr>\n";
  const auto row = [&](std::string_view name,
                       auto value_of,
                       auto formula_of,
                       std::string deviation,
                       std::string_view unit) {
    body += fmt::format(
        "<tr><td>{}</td><td class=v>{}</td><td class=v>{}</td><td "
        "class=v>{}</td><td>{}</td></tr>\n",
        name,
        pose.initial ? traced(value_of(*pose.initial), "{:.3f}", formula_of("initial")) : "–",
        pose.ok
            ? traced(value_of(pose.vision_from_lidar), "{:.3f}", formula_of("vision_from_lidar"))
            : "–",
        pose.ok ? deviation : "–",
        unit);
  };
  constexpr std::array<std::string_view, 3> kAxes = {"east", "north", "up"};
  for (int axis = 0; axis < 3; ++axis) {
    row(
        kAxes[static_cast<std::size_t>(axis)],
        [axis](const Rigid3& p) { return p.translation[axis]; },
        [axis](const std::string& name) {
          return source_of(fmt::format("{}/{}", name, 4 * axis + 3));
        },
        traced(sigma[static_cast<std::size_t>(axis)], "{:.4f}", sigma_formula(axis)),
        "m");
  }
  row("heading",
      heading_deg,
      heading_formula,
      traced(kDegPerRad * sigma[5], "{:.4f}", "degrees(" + sigma_formula(5) + ")"),
      "°");
  row("tilt",
      tilt_deg,
      tilt_formula,
      traced(kDegPerRad * std::hypot(sigma[3], sigma[4]),
             "{:.4f}",
             fmt::format("degrees(hypot({}, {}))", sigma_formula(3), sigma_formula(4))),
      "°");
  return body + "</table>\n";
}

Figure transform_figure(const ReportData& data) {
  return {.id = "transform",
          .title = "Transform, covariance and confidence",
          .body = pose_table(*data.pose, data.registration) +
                  verdict_table(*data.pose, data.registration),
          .caption =
              "Where the LiDAR map lies in the frame of the photos, before and after registration. "
              "Standard deviations are those of the fine alignment; they know nothing of a wrong "
              "place, which the confidence judges.",
          .sources = {workspace_file::kRegistration}};
}

std::optional<Figure> evidence_figure(const Json& registration) {
  if (!registration.contains("scores") || registration["scores"].empty()) return std::nullopt;
  return Figure{.id = "evidence",
                .title = "Evidence for the verdict",
                .body = "<details><summary>All scores</summary>" +
                        html_table(registration["scores"], source_of("scores")) + "</details>\n",
                .caption =
                    "What the verdict is built on: shares lie between 0 and 1; peak_ratio is the "
                    "second best place over the best, ridge_ratio the best place 3 m beside it.",
                .sources = {workspace_file::kRegistration}};
}

std::optional<Figure> yaw_figure(const ReportData& data) {
  const Json& json = data.registration;
  if (!json.contains("yaw_scores") || json["yaw_scores"].size() < 2) return std::nullopt;
  std::vector<Eigen::Vector2d> curve;
  double most = 1.0;
  for (const Json& entry : json["yaw_scores"]) {
    curve.emplace_back(kDegPerRad * entry.at("yaw_rad").get<double>(),
                       entry.at("score").get<double>());
    most = std::max(most, curve.back().y());
  }
  // A window across +-180 degrees is drawn in one piece.
  for (std::size_t i = 1; i < curve.size(); ++i) {
    curve[i].x() = curve[i - 1].x() + std::remainder(curve[i].x() - curve[i - 1].x(), 360.0);
  }
  Chart chart({"heading of the LiDAR map [°]", curve.front().x(), curve.back().x()},
              {"best score over all shifts", 0.0, 1.1 * most},
              720.0);
  chart.line(curve, ink::kVision, 2.0);
  if (data.pose && data.pose->ok) {
    const double middle = 0.5 * (curve.front().x() + curve.back().x());
    const double chosen =
        middle + std::remainder(heading_deg(data.pose->vision_from_lidar) - middle, 360.0);
    chart.upright(chosen, ink::kAlarm, fmt::format("registered at {:.1f}°", chosen));
  }
  return Figure{
      .id = "yaw-search",
      .title = "Search score over heading",
      .body = chart.svg(),
      .caption = fmt::format(
          "For each of {} headings, the best score of the exhaustive search over shifts: facade "
          "columns on roof rims less ground inside buildings. One sharp peak is a safe answer; "
          "two of equal height are an ambiguous scene.",
          curve.size()),
      .sources = {workspace_file::kRegistration}};
}

std::optional<Figure> candidate_figure(const ReportData& data) {
  const Json& json = data.registration;
  if (!json.contains("candidates") || json["candidates"].empty()) return std::nullopt;
  std::string body =
      "<table><tr><th>place</th><th>score</th><th>share of the best</th><th>east [m]</th>"
      "<th>north [m]</th><th>heading [°]</th></tr>\n";
  const double best = std::max(1e-9, json["candidates"].front().value("score", 0.0));
  std::size_t rank = 0;
  for (const Json& candidate : json["candidates"]) {
    const Rigid3 pose = Rigid3::from_matrix(matrix_of(candidate.at("vision_from_lidar")));
    const std::string place = fmt::format("candidates/{}/", rank);
    const std::string score = source_of(place + "score");
    const auto value = [&](double number, std::string_view formula) {
      return traced(number, "{:.2f}", formula);
    };
    body += fmt::format(
        "<tr><td>{}</td><td class=v>{}</td><td class=v>{}</td><td class=v>{}</td>"
        "<td class=v>{}</td><td class=v>{}</td></tr>\n",
        ++rank,
        traced(candidate.value("score", 0.0), "{:.1f}", score),
        value(candidate.value("score", 0.0) / best,
              score + " / " + source_of("candidates/0/score")),
        value(pose.translation.x(), source_of(place + "vision_from_lidar/3")),
        value(pose.translation.y(), source_of(place + "vision_from_lidar/7")),
        value(heading_deg(pose), heading_formula(place + "vision_from_lidar")));
  }
  return Figure{.id = "candidates",
                .title = "Places considered",
                .body = body + "</table>\n",
                .caption =
                    "Distinct peaks of the search after refinement. A second place with nearly the "
                    "score of the first makes the answer ambiguous.",
                .sources = {workspace_file::kRegistration}};
}

}  // namespace

std::vector<Figure> registration_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (!data.pose) return figures;
  figures.push_back(transform_figure(data));
  for (auto figure :
       {yaw_figure(data), candidate_figure(data), evidence_figure(data.registration)}) {
    if (figure) figures.push_back(*std::move(figure));
  }
  return figures;
}

}  // namespace hybridfusion
