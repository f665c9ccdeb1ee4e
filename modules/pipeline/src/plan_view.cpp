#include "plan_view.hpp"

#include "positions_csv.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/tum.hpp>

#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kWidth_px = 760.0;
constexpr double kMargin_px = 24.0;

struct PlanData {
  std::vector<Eigen::Vector2d> gnss;
  std::vector<Eigen::Vector2d> cameras;
  std::vector<Eigen::Vector2d> drive;
};

std::vector<Eigen::Vector2d> registered_drive(const Workspace& workspace) {
  const auto registration = read_registration(workspace.path(workspace_file::kRegistration));
  const auto trajectory = read_tum(workspace.path(workspace_file::kTrajectory));
  std::vector<Eigen::Vector2d> drive;
  if (!registration || !registration->ok || !trajectory) return drive;
  for (const StampedPose& pose : trajectory->poses) {
    drive.emplace_back(
        (registration->vision_from_lidar * pose.map_from_body.translation).head<2>());
  }
  return drive;
}

std::string circles(const std::vector<Eigen::Vector2d>& points,
                    const Eigen::Affine2d& page_from_plan,
                    std::string_view style) {
  std::string svg;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d at = page_from_plan * point;
    svg += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' {}/>\n", at.x(), at.y(), style);
  }
  return svg;
}

std::string polyline(const std::vector<Eigen::Vector2d>& points,
                     const Eigen::Affine2d& page_from_plan) {
  if (points.empty()) return {};
  std::string svg = "<polyline fill='none' stroke='#c0392b' stroke-width='2' points='";
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d at = page_from_plan * point;
    svg += fmt::format("{:.1f},{:.1f} ", at.x(), at.y());
  }
  return svg + "'/>\n";
}

/// A bar of 1, 2 or 5 times a power of ten metres, about a fifth of the page.
std::string scale_bar(double px_per_m, double height_px) {
  double length_m = 1.0;
  while (length_m * 10.0 * px_per_m < kWidth_px / 4.0) length_m *= 10.0;
  if (length_m * 5.0 * px_per_m < kWidth_px / 4.0) {
    length_m *= 5.0;
  } else if (length_m * 2.0 * px_per_m < kWidth_px / 4.0) {
    length_m *= 2.0;
  }
  const double y = height_px - 10.0;
  return fmt::format(
      "<line x1='10' y1='{0:.1f}' x2='{1:.1f}' y2='{0:.1f}' stroke='#222' stroke-width='2'/>"
      "<text x='{2:.1f}' y='{3:.1f}' font-size='12'>{4:g} m</text>\n",
      y,
      10.0 + length_m * px_per_m,
      16.0 + length_m * px_per_m,
      y + 4.0,
      length_m);
}

}  // namespace

std::string plan_view_svg(const Workspace& workspace) {
  PlanData plan;
  if (const auto rows = read_positions_csv(workspace.path(workspace_file::kPositions))) {
    for (const PositionRow& row : *rows) {
      if (row.gnss) plan.gnss.emplace_back(row.gnss->head<2>());
      if (row.position) plan.cameras.emplace_back(row.position->head<2>());
    }
  }
  plan.drive = registered_drive(workspace);
  Eigen::AlignedBox2d box;
  for (const auto* points : {&plan.gnss, &plan.cameras, &plan.drive}) {
    for (const Eigen::Vector2d& point : *points) box.extend(point);
  }
  if (box.isEmpty()) return "<p>No positions to draw yet.</p>\n";
  const Eigen::Vector2d size = box.sizes().cwiseMax(1.0);
  const double px_per_m = (kWidth_px - 2.0 * kMargin_px) / size.maxCoeff();
  const double height_px = size.y() * px_per_m + 2.0 * kMargin_px + 20.0;
  Eigen::Affine2d page_from_plan = Eigen::Affine2d::Identity();
  page_from_plan.translate(Eigen::Vector2d(kMargin_px, kMargin_px + size.y() * px_per_m));
  page_from_plan.scale(Eigen::Vector2d(px_per_m, -px_per_m));  // north is up on the page
  page_from_plan.translate(-box.min());
  return fmt::format("<svg width='{0:.0f}' height='{1:.0f}' viewBox='0 0 {0:.0f} {1:.0f}'>\n",
                     kWidth_px,
                     height_px) +
         polyline(plan.drive, page_from_plan) +
         circles(plan.gnss, page_from_plan, "fill='none' stroke='#888'") +
         circles(plan.cameras, page_from_plan, "fill='#2471a3'") + scale_bar(px_per_m, height_px) +
         "</svg>\n<p>Filled: camera positions as estimated; rings: as measured by GNSS; red: "
         "registered LiDAR trajectory. North is up.</p>\n";
}

}  // namespace hybridfusion
