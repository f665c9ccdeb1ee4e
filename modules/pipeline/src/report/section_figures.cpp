#include "chart.hpp"
#include "html.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kHalfWidth_m = 22.0;  // of a section, to each side of the drive
constexpr double kSlab_m = 0.4;        // half thickness
constexpr std::size_t kMaxDots = 6000;

/// A vertical plane across the drive: `right` lies in it, `ahead` is its normal.
struct Cut {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d ahead = Eigen::Vector3d::UnitY();
  double along_m = 0.0;  ///< Way driven.
};

/// What of a cloud lies in the cut: x to the right, y up [m].
std::vector<Eigen::Vector2d> slice(const PointCloud& cloud,
                                   const Rigid3& shown_from_cloud,
                                   const Cut& cut) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3f& point : cloud.points) {
    const Eigen::Vector3d offset =
        shown_from_cloud * Eigen::Vector3d(point.cast<double>()) - cut.center;
    if (std::abs(offset.dot(cut.ahead)) > kSlab_m) continue;
    const double x = offset.dot(cut.right);
    if (std::abs(x) < kHalfWidth_m) points.emplace_back(x, offset.z());
  }
  if (points.size() <= kMaxDots) return points;
  std::vector<Eigen::Vector2d> fewer;
  for (std::size_t i = 0; i < kMaxDots; ++i) fewer.push_back(points[i * points.size() / kMaxDots]);
  return fewer;
}

/// Cuts every few metres of the drive, across its direction.
std::vector<Cut> cuts_of(const Trajectory& trajectory, const Rigid3& shown_from_lidar) {
  std::vector<Cut> cuts;
  double along_m = 0.0;
  double next_m = 4.0;
  constexpr std::size_t kMaxCuts = 40;
  double length_m = 0.0;
  const auto& poses = trajectory.poses;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length_m +=
        (poses[i].map_from_body.translation - poses[i - 1].map_from_body.translation).norm();
  }
  const double step_m = std::max(4.0, length_m / kMaxCuts);
  Eigen::Vector3d last =
      poses.empty() ? Eigen::Vector3d::Zero() : poses[0].map_from_body.translation;
  for (const StampedPose& pose : poses) {
    const Eigen::Vector3d way = pose.map_from_body.translation - last;
    if (way.norm() < 0.5) continue;
    along_m += way.norm();
    last = pose.map_from_body.translation;
    if (along_m < next_m) continue;
    next_m = along_m + step_m;
    Eigen::Vector3d ahead = shown_from_lidar.rotation * way;
    ahead.z() = 0.0;
    if (ahead.norm() < 1e-6) continue;
    ahead.normalize();
    cuts.push_back({.center = shown_from_lidar * last,
                    .right = {ahead.y(), -ahead.x(), 0.0},
                    .ahead = ahead,
                    .along_m = along_m});
  }
  return cuts;
}

/// Half-metre cells above head height in which both clouds have a point and not on either side of
/// which they have, too: facades seen twice that are cut across. A facade cut along fills whole
/// rows.
std::size_t common_cells(const std::vector<Eigen::Vector2d>& a,
                         const std::vector<Eigen::Vector2d>& b) {
  constexpr double kCell_m = 0.5;
  std::map<std::pair<int, int>, unsigned> cells;
  unsigned bit = 1;
  for (const auto* points : {&a, &b}) {
    for (const Eigen::Vector2d& point : *points) {
      if (point.y() < 1.0) continue;
      cells[{static_cast<int>(std::floor(point.x() / kCell_m)),
             static_cast<int>(std::floor(point.y() / kCell_m))}] |= bit;
    }
    bit <<= 1U;
  }
  const auto is_common = [&cells](int column, int row) {
    const auto found = cells.find({column, row});
    return found != cells.end() && found->second == 3U;
  };
  return static_cast<std::size_t>(std::ranges::count_if(cells, [&](const auto& cell) {
    const auto [column, row] = cell.first;
    return cell.second == 3U && !(is_common(column - 1, row) && is_common(column + 1, row));
  }));
}

std::string section_chart(const ReportData& data,
                          const Cut& cut,
                          const Rigid3& pose,
                          double top_m) {
  constexpr double kWidth_px = 620.0;
  constexpr double kFrame_px = 78.0;  // what the axes take; the same scale on both
  const double bottom_m = -6.0;
  const double px_per_m = (kWidth_px - kFrame_px) / (2.0 * kHalfWidth_m);
  Chart chart({"across the street [m]", -kHalfWidth_m, kHalfWidth_m},
              {"height above the LiDAR [m]", bottom_m, top_m},
              kWidth_px,
              56.0 + px_per_m * (top_m - bottom_m));
  chart.dots(slice(data.vision, Rigid3{}, cut), ink::kVision, 1.1);
  chart.dots(slice(data.lidar, pose, cut), ink::kLidar, 1.1);
  chart.legend(std::array<std::pair<std::string, std::string_view>, 2>{
      {{"photos", ink::kVision}, {"LiDAR", ink::kLidar}}});
  return chart.svg();
}

Figure section_figure(const ReportData& data) {
  const std::vector<Cut> cuts = cuts_of(data.trajectory, data.shown_from_lidar());
  std::vector<std::pair<std::size_t, const Cut*>> ranked;
  for (const Cut& cut : cuts) {
    ranked.emplace_back(common_cells(slice(data.vision, Rigid3{}, cut),
                                     slice(data.lidar, data.shown_from_lidar(), cut)),
                        &cut);
  }
  std::ranges::stable_sort(
      ranked, std::ranges::greater{}, &std::pair<std::size_t, const Cut*>::first);
  std::string body;
  const Cut* first = nullptr;
  for (const auto& [common, cut] : ranked) {
    constexpr double kApart_m = 15.0;
    if (first != nullptr && (cut->center - first->center).norm() < kApart_m) continue;
    std::vector<double> heights = {6.0};
    for (const Eigen::Vector2d& point : slice(data.vision, Rigid3{}, *cut))
      heights.push_back(point.y());
    for (const Eigen::Vector2d& point : slice(data.lidar, data.shown_from_lidar(), *cut)) {
      heights.push_back(point.y());
    }
    const double top_m = std::clamp(quantile(heights, 0.998) + 1.0, 6.0, 30.0);
    body += fmt::format("<h4>At {:.0f} m of the drive</h4>\n", cut->along_m);
    if (data.pose->initial) {
      body += "<p class=sub>before: coarse pose</p>" +
              section_chart(data, *cut, *data.pose->initial, top_m);
    }
    body += "<p class=sub>after registration</p>" +
            section_chart(data, *cut, data.shown_from_lidar(), top_m);
    if (first != nullptr) break;
    first = cut;
  }
  return {.id = "cross-sections",
          .title = "Cross-sections through facades, before and after",
          .body = std::move(body),
          .caption = fmt::format(
              "Vertical cuts of {:.1f} m across the street, where both clouds see most facade. "
              "Blue: photos; orange: LiDAR. After registration walls and street must lie on each "
              "other; what only one colour shows is what the other sensor could not see.",
              2.0 * kSlab_m),
          .sources = {workspace_file::kDense,
                      workspace_file::kMap,
                      workspace_file::kTrajectory,
                      workspace_file::kRegistration}};
}

/// Lower edge of a cloud below each station of the drive.
std::vector<Eigen::Vector2d> ground_below(const PointCloud& cloud,
                                          const Rigid3& shown_from_cloud,
                                          const std::vector<Cut>& stations) {
  constexpr double kReach_m = 2.0;
  std::vector<std::vector<double>> heights(stations.size());
  for (const Eigen::Vector3f& stored : cloud.points) {
    const Eigen::Vector3d point = shown_from_cloud * Eigen::Vector3d(stored.cast<double>());
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Eigen::Vector3d offset = point - stations[i].center;
      if (offset.head<2>().squaredNorm() < kReach_m * kReach_m && offset.z() < 0.5) {
        heights[i].push_back(point.z());
      }
    }
  }
  constexpr std::size_t kMinPoints = 5;
  std::vector<Eigen::Vector2d> profile;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (heights[i].size() < kMinPoints) continue;
    profile.emplace_back(stations[i].along_m, quantile(heights[i], 0.2));
  }
  return profile;
}

std::optional<Figure> profile_figure(const ReportData& data) {
  const std::vector<Cut> stations = cuts_of(data.trajectory, data.shown_from_lidar());
  if (stations.size() < 2) return std::nullopt;
  std::vector<Eigen::Vector2d> drive;
  for (const Cut& station : stations) drive.emplace_back(station.along_m, station.center.z());
  const std::vector<Eigen::Vector2d> lidar =
      ground_below(data.lidar, data.shown_from_lidar(), stations);
  std::vector<Eigen::Vector2d> vision;
  if (data.registered()) vision = ground_below(data.vision, Rigid3{}, stations);
  double low = drive.front().y();
  double high = low;
  for (const auto* points : {&std::as_const(drive), &lidar, &std::as_const(vision)}) {
    for (const Eigen::Vector2d& point : *points) {
      low = std::min(low, point.y());
      high = std::max(high, point.y());
    }
  }
  Chart chart({"way driven [m]", 0.0, stations.back().along_m},
              {"height [m]", low - 0.5, high + 0.5},
              720.0);
  chart.line(drive, ink::kQuiet);
  chart.line(lidar, ink::kLidar, 2.0);
  chart.dots(vision, ink::kVision, 3.0);
  std::vector<std::pair<std::string, std::string_view>> names = {{"LiDAR sensor", ink::kQuiet},
                                                                 {"ground, LiDAR", ink::kLidar}};
  if (!vision.empty()) names.emplace_back("ground, photos", ink::kVision);
  chart.legend(names);
  return Figure{.id = "ground-profile",
                .title = "Ground profile along the drive",
                .body = chart.svg(),
                .caption =
                    "Height of the sensor and of the ground below it in the shown frame. The "
                    "sensor keeps its height above ground; the ground of the photos lies on that "
                    "of the LiDAR. A gap that grows along the way tells of tilt or drift.",
                .sources = {workspace_file::kTrajectory,
                            workspace_file::kMap,
                            workspace_file::kDense,
                            workspace_file::kRegistration}};
}

}  // namespace

std::vector<Figure> profile_figures(const ReportData& data) {
  auto profile = profile_figure(data);
  if (!profile) return {};
  return {*std::move(profile)};
}

std::vector<Figure> section_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (data.registered() && !data.vision.empty() && !data.lidar.empty() &&
      !data.trajectory.poses.empty()) {
    Figure sections = section_figure(data);
    if (!sections.body.empty()) figures.push_back(std::move(sections));
  }
  return figures;
}

}  // namespace hybridfusion
