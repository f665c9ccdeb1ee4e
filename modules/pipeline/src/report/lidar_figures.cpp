#include "chart.hpp"
#include "html.hpp"
#include "plan_map.hpp"
#include "report_data.hpp"

#include <hybridfusion/core/time.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// The frame the drive is drawn in: that of the photos, else east-north-up by GNSS, else its own.
struct DriveFrame {
  Rigid3 shown_from_lidar = {};
  Orientation orientation = Orientation::kNorthUp;
};

DriveFrame drive_frame(const ReportData& data) {
  if (data.registered()) return {.shown_from_lidar = data.shown_from_lidar()};
  if (data.gnss.is_object() && data.gnss.contains("enu_from_map")) {
    return {.shown_from_lidar = Rigid3::from_matrix(matrix_of(data.gnss["enu_from_map"]))};
  }
  return {.orientation = Orientation::kOwnFrame};
}

std::vector<Eigen::Vector2d> plan_of(const Trajectory& trajectory, const Rigid3& shown_from_lidar) {
  std::vector<Eigen::Vector2d> plan;
  for (const StampedPose& pose : trajectory.poses) {
    plan.emplace_back((shown_from_lidar * pose.map_from_body.translation).head<2>());
  }
  return plan;
}

std::string map_from_above(const PointCloud& lidar, const Eigen::AlignedBox2d& box) {
  constexpr int kWidth_px = 900;
  std::vector<double> heights;
  for (std::size_t i = 0; i < lidar.size(); i += 16) heights.push_back(lidar.points[i].z());
  const double low = quantile(heights, 0.02);
  const double range = std::max(0.5, quantile(heights, 0.98) - low);
  Splatter splatter(view_from_above(box, kWidth_px));
  for (const Eigen::Vector3f& point : lidar.points) {
    // Light to dark with height: the street is pale, facades draw its outline.
    const double share = std::clamp((point.z() - low) / range, 0.0, 1.0);
    const auto grey = static_cast<std::uint8_t>(225.0 - 150.0 * share);
    splatter.add(point, {grey, grey, static_cast<std::uint8_t>(grey + 8)}, 1);
  }
  return data_uri(splatter.image({250, 250, 251})).value_or("");
}

Figure trajectory_figure(const ReportData& data) {
  const DriveFrame frame = drive_frame(data);
  const std::vector<Eigen::Vector2d> plan = plan_of(data.trajectory, frame.shown_from_lidar);
  const PointCloud lidar =
      transformed(frame.shown_from_lidar, PointCloud{.points = data.lidar.points});
  Eigen::AlignedBox2d box = trimmed_box(lidar.points, 0.01, 2.0);
  for (const Eigen::Vector2d& at : plan) box.extend(at);
  const Eigen::Vector2d margin(3.0, 3.0);
  PlanMap map({box.min() - margin, box.max() + margin}, 720.0, frame.orientation);
  if (!lidar.empty()) map.background(map_from_above(lidar, map.box()), 1.0);
  std::vector<double> residuals;
  for (const QualityRow& row : data.quality) residuals.push_back(row.mean_residual_m);
  const double most_m = std::max(0.01, 2.0 * quantile(residuals, 0.5));  // usual is green
  const std::size_t count = std::min(plan.size(), data.quality.size());
  constexpr std::size_t kMaxPieces = 1500;
  const std::size_t step = 1 + plan.size() / kMaxPieces;
  for (std::size_t i = step; i < plan.size(); i += step) {
    const double share = i < count ? data.quality[i].mean_residual_m / most_m : 0.0;
    map.line(
        std::vector{plan[i - step], plan[i]}, count > 0 ? ramp_color(share) : ink::kLidar, 3.5);
  }
  map.dot(plan.front(), "#111111", 5.0, "start");
  map.ring(plan.back(), "#111111", 6.0);
  return {.id = "trajectory",
          .title = "LiDAR trajectory, coloured by residual",
          .body = map.svg() + ramp_legend("0 m", fmt::format("{:.3f} m", most_m)),
          .caption =
              "The drive over its own map, from the dot to the ring. "
              "Colour: mean distance of the points of a scan from the planes of the map. Doubled "
              "facades or a red stretch tell of a trajectory that bends.",
          .sources = {workspace_file::kTrajectory,
                      workspace_file::kQuality,
                      workspace_file::kMap,
                      workspace_file::kRegistration}};
}

/// A row of marks for each kind of flag.
std::string flag_rows(const std::vector<QualityRow>& quality, double length_s) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kFlags = {
      {{"imu_gap", "IMU gap"},
       {"saturated", "IMU saturated"},
       {"lidar_gap", "LiDAR gap"},
       {"few_points", "few points"},
       {"unmatched", "unmatched"},
       {"degenerate", "degenerate"},
       {"diverged", "diverged"},
       {"clock_step", "clock step"},
       {"no_point_times", "no point times"},
       {"bad_points", "bad points"}}};
  std::string body = "<svg class=chart viewBox='0 0 720 210' width='720' role=img>\n";
  double y = 16.0;
  for (const auto& [flag, title] : kFlags) {
    std::size_t count = 0;
    std::string marks;
    for (const QualityRow& row : quality) {
      if (("|" + row.flags + "|").find(fmt::format("|{}|", flag)) == std::string::npos) continue;
      ++count;
      marks += fmt::format("<rect x='{:.1f}' y='{:.1f}' width=2 height=12 fill='{}'/>",
                           170.0 + 470.0 * (row.time_s - quality.front().time_s) / length_s,
                           y - 10.0,
                           ink::kAlarm);
    }
    body += fmt::format(
        "<text x=160 y='{0:.1f}' text-anchor=end>{1}</text><line class=g x1=170 x2=642 "
        "y1='{2:.1f}' "
        "y2='{2:.1f}'/>{3}<text x=652 y='{0:.1f}'>{4}</text>\n",
        y,
        title,
        y - 4.0,
        marks,
        count == 0 ? "none" : fmt::format("{} scans", count));
    y += 20.0;
  }
  return body + "</svg>\n";
}

Figure health_figure(const ReportData& data) {
  const double start_s = data.quality.front().time_s;
  const double length_s = std::max(0.1, data.quality.back().time_s - start_s);
  std::vector<Eigen::Vector2d> residuals;
  std::vector<Eigen::Vector2d> matched;
  double most_m = 0.01;
  double most_points = 1.0;
  for (const QualityRow& row : data.quality) {
    residuals.emplace_back(row.time_s - start_s, row.mean_residual_m);
    matched.emplace_back(row.time_s - start_s, row.num_matched);
    if (std::isfinite(row.mean_residual_m)) most_m = std::max(most_m, row.mean_residual_m);
    most_points = std::max(most_points, row.num_matched);
  }
  Chart residual({"time from the start [s]", 0.0, length_s},
                 {"mean residual [m]", 0.0, 1.1 * most_m},
                 720.0,
                 170.0);
  residual.line(residuals, ink::kLidar);
  Chart points({"time from the start [s]", 0.0, length_s},
               {"matched points", 0.0, 1.1 * most_points},
               720.0,
               170.0);
  points.line(matched, ink::kVision);
  return {.id = "lidar-health",
          .title = "LiDAR and IMU health over time",
          .body = residual.svg() + points.svg() + flag_rows(data.quality, length_s),
          .caption =
              "Residual and number of matched points of each scan; below, when something was "
              "unusual: gaps and saturation of the IMU, missing scans, scans that found no hold. "
              "The first scan has no map to match with.",
          .sources = {workspace_file::kQuality}};
}

std::optional<Figure> gnss_figure(const Json& gnss) {
  if (!gnss.is_object() || !gnss.contains("residuals")) return std::nullopt;
  std::array<std::vector<Eigen::Vector2d>, 3> axes;
  double start_s = NAN;
  double end_s = 0.0;
  double most_m = 0.1;
  for (const Json& residual : gnss["residuals"]) {
    const double time_s = residual.at("time").get<double>();
    if (std::isnan(start_s)) start_s = time_s;
    end_s = std::max(end_s, time_s - start_s);
    if (!residual.value("used", true)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = residual.at("enu_m").at(axis).get<double>();
      axes[axis].emplace_back(time_s - start_s, value);
      most_m = std::max(most_m, 1.1 * std::abs(value));
    }
  }
  if (axes[0].empty()) return std::nullopt;
  Chart chart(
      {"time from the first fix [s]", 0.0, end_s}, {"residual [m]", -most_m, most_m}, 720.0, 220.0);
  chart.line(axes[0], ink::kVision);
  chart.line(axes[1], ink::kBoth);
  chart.line(axes[2], ink::kLidar);
  chart.legend(std::array<std::pair<std::string, std::string_view>, 3>{
      {{"east", ink::kVision}, {"north", ink::kBoth}, {"up", ink::kLidar}}});
  return Figure{.id = "drive-gnss",
                .title = "GNSS residuals of the drive",
                .body = chart.svg(),
                .caption = fmt::format(
                    "Measured less placed trajectory; rms {:.2f} m horizontal, {:.2f} m vertical; "
                    "{} fixes used, {} left out; heading to {:.2f}°.",
                    gnss.value("horizontal_rms_m", 0.0),
                    gnss.value("vertical_rms_m", 0.0),
                    gnss.value("num_used", 0),
                    gnss.value("num_outliers", 0),
                    gnss.value("heading_sigma_deg", 0.0)),
                .sources = {workspace_file::kGnss}};
}

}  // namespace

std::vector<Figure> lidar_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (!data.trajectory.poses.empty()) figures.push_back(trajectory_figure(data));
  if (!data.quality.empty()) figures.push_back(health_figure(data));
  if (auto figure = gnss_figure(data.gnss)) figures.push_back(*std::move(figure));
  return figures;
}

}  // namespace hybridfusion
