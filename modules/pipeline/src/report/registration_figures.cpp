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
  return kDegPerRad * std::acos(std::clamp(up.z(), -1.0, 1.0));
}

Figure transform_figure(const ReportData& data) {
  const StoredRegistration& pose = *data.pose;
  const Json& json = data.registration;
  std::array<double, 6> sigma{};
  if (json.contains("covariance") && json["covariance"].size() == 36) {
    for (std::size_t i = 0; i < 6; ++i) {
      sigma[i] = std::sqrt(std::max(0.0, json["covariance"][7 * i].get<double>()));
    }
  }
  const bool has_pose = pose.ok || pose.initial.has_value();
  std::string body = has_pose ? "<table><tr><th>LiDAR map in the vision frame</th><th>coarse</th>"
                                "<th>registered</th><th>standard deviation</th><th>unit</th></tr>\n"
                              : "";
  const auto row =
      [&](std::string_view name, auto value_of, const std::string& deviation, auto unit) {
        if (!has_pose) return;
        body += fmt::format(
            "<tr><td>{}</td><td class=v>{}</td><td class=v>{}</td><td "
            "class=v>{}</td><td>{}</td></tr>\n",
            name,
            pose.initial ? fmt::format("{:.3f}", value_of(*pose.initial)) : "–",
            pose.ok ? fmt::format("{:.3f}", value_of(pose.vision_from_lidar)) : "–",
            pose.ok ? deviation : "–",
            unit);
      };
  constexpr std::array<std::string_view, 3> kAxes = {"east", "north", "up"};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    row(
        kAxes[static_cast<std::size_t>(axis)],
        [axis](const Rigid3& p) { return p.translation[axis]; },
        fmt::format("{:.4f}", sigma[static_cast<std::size_t>(axis)]),
        "m");
  }
  row("heading", heading_deg, fmt::format("{:.4f}", kDegPerRad * sigma[5]), "°");
  row("tilt", tilt_deg, fmt::format("{:.4f}", kDegPerRad * std::hypot(sigma[3], sigma[4])), "°");
  if (has_pose) body += "</table>\n";
  body += "<table><tr><th>verdict</th><th>value</th></tr>\n";
  const auto fact = [&](std::string_view name, const std::string& value) {
    body += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", name, escaped(value));
  };
  fact("status", pose.ok ? "registered" : "refused");
  fact("confidence", fmt::format("{:.3f}", pose.confidence));
  if (!pose.reason.empty()) fact("reason", pose.reason);
  fact("method", pose.method);
  fact("coarse pose from", json.value("coarse_pose", "–"));
  fact("scale of the photo model",
       json.value("vision_scale_supported", false)
           ? fmt::format("{:+.3f} % against the LiDAR cloud, ± {:.3f} %",
                         100.0 * (1.0 / json.value("vision_scale", 1.0) - 1.0),
                         100.0 * json.value("vision_scale_sigma", 0.0))
           : std::string("could not be told from the LiDAR cloud"));
  if (json.contains("level")) {
    const Json& level = json["level"];
    fact("tilt of the photo model",
         level.value("corrected", false)
             ? fmt::format("{:.3f}° against gravity in the LiDAR map, levelled in the fused cloud",
                           level.value("tilt_deg", 0.0))
             : "kept: " + level.value("reason", std::string()));
  }
  body += "</table>\n";
  return {.id = "transform",
          .title = "Transform, covariance and confidence",
          .body = std::move(body),
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
                        html_table(registration["scores"]) + "</details>\n",
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
    body += fmt::format(
        "<tr><td class=v>{}</td><td class=v>{:.1f}</td><td class=v>{:.2f}</td><td "
        "class=v>{:.2f}</td>"
        "<td class=v>{:.2f}</td><td class=v>{:.2f}</td></tr>\n",
        ++rank,
        candidate.value("score", 0.0),
        candidate.value("score", 0.0) / best,
        pose.translation.x(),
        pose.translation.y(),
        heading_deg(pose));
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
