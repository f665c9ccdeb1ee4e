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

using Polygon = std::vector<Eigen::Vector2d>;

struct Survey {
  double ground_m = 0.0;  ///< Height of the scene under the photos.
  std::vector<Polygon> footprints = {};
  std::vector<std::string> names = {};
  std::vector<Eigen::Vector2d> cameras = {};
  Eigen::AlignedBox2d box = {};
};

/// Where the corners of a photo meet the level of the ground; rays at or above the horizon end at
/// a distance of `reach_m`.
Polygon footprint_of(const ColmapImage& image, const ColmapCamera& camera, double ground_m) {
  constexpr double kMaxReach = 4.0;  // times the height above ground
  const Eigen::Quaterniond enu_from_camera = image.camera_from_world.conjugate();
  const Eigen::Vector3d center = -(enu_from_camera * image.camera_from_world_translation);
  const double height_m = std::max(1.0, center.z() - ground_m);
  const double focal_px = camera.params.front();
  Polygon corners;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const Eigen::Vector3d ray =
        enu_from_camera *
        Eigen::Vector3d(x * camera.width_px / focal_px, y * camera.height_px / focal_px, 1.0);
    const double flat = std::max(1e-9, ray.head<2>().norm());
    const double range = ray.z() < 0.0 ? std::min(height_m / -ray.z(), kMaxReach * height_m / flat)
                                       : kMaxReach * height_m / flat;
    corners.emplace_back((center + range * ray).head<2>());
  }
  return corners;
}

Survey survey_of(const ReportData& data) {
  Survey survey;
  std::vector<double> heights;
  for (const ColmapPoint3D& point : data.model->points) heights.push_back(point.point_in_world.z());
  survey.ground_m = quantile(heights, 0.25);
  for (const ColmapImage& image : data.model->images) {
    const auto camera = std::ranges::find(data.model->cameras, image.camera, &ColmapCamera::id);
    if (camera == data.model->cameras.end() || camera->params.empty()) continue;
    if (!(camera->params.front() > 0.0)) continue;
    survey.footprints.push_back(footprint_of(image, *camera, survey.ground_m));
    survey.names.push_back(image.name);
    survey.cameras.emplace_back(
        (image.camera_from_world.conjugate() * -image.camera_from_world_translation).head<2>());
    survey.box.extend(survey.cameras.back());
  }
  // Footprints of oblique photos reach to the horizon: the maps end with the scene.
  std::vector<Eigen::Vector3f> scene;
  for (const ColmapPoint3D& point : data.model->points) {
    scene.push_back(point.point_in_world.cast<float>());
  }
  survey.box.extend(trimmed_box(scene, 0.01, 5.0));
  const Eigen::Vector2d margin = 0.15 * survey.box.sizes();
  survey.box.min() -= margin;
  survey.box.max() += margin;
  return survey;
}

bool is_inside(const Polygon& polygon, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

Figure survey_map(const ReportData& data, const Survey& survey) {
  PlanMap map(survey.box);
  const std::string picture = cloud_from_above(data.vision, map.box());
  if (!picture.empty()) map.background(picture, 1.0);
  for (const Polygon& polygon : survey.footprints) {
    map.polygon(polygon, "#000000", 0.0, "#ffffffaa");
  }
  for (std::size_t i = 0; i < survey.cameras.size(); ++i) {
    map.dot(survey.cameras[i], "#ffd33d", 4.0, survey.names[i]);
  }
  std::size_t lost = 0;
  for (const PositionRow& row : data.positions) {
    if (row.position) continue;
    ++lost;
    if (row.gnss) map.ring(row.gnss->head<2>(), ink::kAlarm, 5.0);
  }
  return {.id = "survey-map",
          .title = "Survey map",
          .body = map.svg(),
          .caption = fmt::format(
              "Dense cloud from above; yellow: the {} located photos; white: what each sees of the "
              "ground{}. Height above ground about {:.0f} m.",
              survey.cameras.size(),
              lost == 0 ? ""
                        : fmt::format("; red rings: the {} photos without a place, where GNSS saw "
                                      "them",
                                      lost),
              [&] {
                std::vector<double> heights;
                for (const PositionRow& row : data.positions) {
                  if (row.position) heights.push_back(row.position->z() - survey.ground_m);
                }
                return quantile(heights, 0.5);
              }()),
          .sources = {workspace_file::kImages, workspace_file::kPositions, workspace_file::kDense}};
}

Figure overlap_map(const Survey& survey) {
  constexpr int kCells = 110;
  constexpr int kMost = 10;
  PlanMap map(survey.box, 560.0);
  const double side_m = map.box().sizes().maxCoeff() / kCells;
  std::size_t covered = 0;
  std::size_t enough = 0;
  for (double y = map.box().min().y(); y < map.box().max().y(); y += side_m) {
    for (double x = map.box().min().x(); x < map.box().max().x(); x += side_m) {
      const Eigen::Vector2d middle(x + 0.5 * side_m, y + 0.5 * side_m);
      const auto count = static_cast<int>(std::ranges::count_if(
          survey.footprints, [&](const Polygon& polygon) { return is_inside(polygon, middle); }));
      if (count == 0) continue;
      ++covered;
      if (count >= 3) ++enough;
      // Few is red: the ramp runs the other way.
      map.square({x, y}, side_m, ramp_color(1.0 - (std::min(count, kMost) - 1.0) / (kMost - 1)));
    }
  }
  for (const Eigen::Vector2d& camera : survey.cameras) map.dot(camera, "#22222299", 2.0, "");
  std::string legend = "<div class=ramp><span>1 photo</span>";
  for (int i = 1; i <= kMost; ++i) {
    legend +=
        fmt::format("<i style='background:{}'></i>", ramp_color(1.0 - (i - 1.0) / (kMost - 1)));
  }
  legend += fmt::format("<span>{} or more</span></div>\n", kMost);
  const double cell_m2 = side_m * side_m;
  return {.id = "overlap",
          .title = "Photos that see each place",
          .body = map.svg() + legend,
          .caption = fmt::format(
              "How many photos see each place of the ground: {:.0f} m² are seen at all, {:.0f} m² "
              "by three or more. Places seen by one photo have no depth; fewer than three make it "
              "uncertain.",
              static_cast<double>(covered) * cell_m2,
              static_cast<double>(enough) * cell_m2),
          .sources = {workspace_file::kImages, workspace_file::kCameras}};
}

/// Estimated positions with their distance to GNSS, drawn larger than it is.
std::optional<Figure> position_figure(const ReportData& data) {
  Eigen::AlignedBox2d box;
  std::vector<double> gaps_m;
  for (const PositionRow& row : data.positions) {
    if (!row.position || !row.gnss) continue;
    box.extend(row.position->head<2>());
    gaps_m.push_back((*row.position - *row.gnss).head<2>().norm());
  }
  if (gaps_m.empty()) return std::nullopt;
  const double extent_m = std::max(1.0, box.sizes().maxCoeff());
  const double typical_m = std::max(1e-3, quantile(gaps_m, 0.5));
  double zoom = 1.0;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    if (step * typical_m < 0.05 * extent_m) zoom = step;
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.1 * extent_m + 2.0);
  PlanMap map({box.min() - margin, box.max() + margin}, 560.0);
  for (const PositionRow& row : data.positions) {
    if (!row.position || !row.gnss) continue;
    const Eigen::Vector2d at = row.position->head<2>();
    const Eigen::Vector2d to = at + zoom * (row.gnss->head<2>() - at);
    map.line(std::vector{at, to}, ink::kQuiet, 1.2);
    map.ring(to, ink::kQuiet, 3.0);
    map.dot(at, ink::kVision, 3.5, row.name);
  }
  return Figure{
      .id = "camera-positions",
      .title = "Camera positions: estimated against GNSS",
      .body = map.svg(),
      .caption = fmt::format(
          "Blue: estimated; grey: towards the GNSS position, differences "
          "drawn {:.0f} times as long. Median {:.2f} m, largest {:.2f} m. Lines that all point one "
          "way or turn about a centre tell of a systematic error.",
          zoom,
          typical_m,
          quantile(gaps_m, 1.0)),
      .sources = {workspace_file::kPositions}};
}

std::optional<Figure> residual_figure(const ReportData& data) {
  std::string body;
  std::vector<Eigen::Vector3d> gaps_m;
  for (const PositionRow& row : data.positions) {
    if (row.position && row.gnss) gaps_m.push_back(*row.position - *row.gnss);
  }
  if (gaps_m.empty()) return std::nullopt;
  const double sigma_h =
      data.reconstruct.is_object() ? data.reconstruct.value("gnss_sigma_horizontal_m", 0.0) : 0.0;
  const double sigma_v =
      data.reconstruct.is_object() ? data.reconstruct.value("gnss_sigma_vertical_m", 0.0) : 0.0;
  constexpr std::array<std::string_view, 3> kAxes = {"east", "north", "up"};
  std::string rms;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double sigma = axis == 2 ? sigma_v : sigma_h;
    double most = 1.5 * sigma;
    double sum = 0.0;
    std::vector<Eigen::Vector2d> dots;
    for (std::size_t i = 0; i < gaps_m.size(); ++i) {
      dots.emplace_back(static_cast<double>(i + 1), gaps_m[i][axis]);
      most = std::max(most, std::abs(gaps_m[i][axis]) * 1.1);
      sum += gaps_m[i][axis] * gaps_m[i][axis];
    }
    Chart chart({"photo", 0.0, static_cast<double>(gaps_m.size() + 1)},
                {fmt::format("{} [m]", kAxes[static_cast<std::size_t>(axis)]), -most, most},
                620.0,
                150.0);
    if (sigma > 0.0) chart.band(-sigma, sigma, ink::kVision);
    chart.dots(dots, ink::kVision, 2.6);
    body += chart.svg();
    rms += fmt::format("{}{} {:.3f} m",
                       axis == 0 ? "" : ", ",
                       kAxes[static_cast<std::size_t>(axis)],
                       std::sqrt(sum / static_cast<double>(gaps_m.size())));
  }
  return Figure{
      .id = "gnss-residuals",
      .title = "GNSS residuals of the photos, per axis",
      .body = std::move(body),
      .caption = fmt::format(
          "Estimated less measured position of each photo; rms {}.{}",
          rms,
          sigma_h > 0.0 ? fmt::format(" Bands: one standard deviation as estimated from the "
                                      "residuals, {:.3f} m horizontal and {:.3f} m vertical.",
                                      sigma_h,
                                      sigma_v)
                        : std::string()),
      .sources = {workspace_file::kPositions, workspace_file::kRun}};
}

}  // namespace

std::vector<Figure> photo_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (data.model && !data.model->images.empty()) {
    const Survey survey = survey_of(data);
    if (!survey.footprints.empty()) {
      figures.push_back(survey_map(data, survey));
      figures.push_back(overlap_map(survey));
    }
  }
  if (auto figure = position_figure(data)) figures.push_back(*std::move(figure));
  if (auto figure = residual_figure(data)) figures.push_back(*std::move(figure));
  return figures;
}

}  // namespace hybridfusion
