#include "../colmap_intrinsics.hpp"
#include "chart.hpp"
#include "html.hpp"
#include "report_data.hpp"

#include <hybridfusion/vision/camera.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Distance of every observation from its projected scene point [px].
std::vector<double> reprojection_errors_px(const ColmapModel& model) {
  std::unordered_map<std::uint32_t, CameraIntrinsics> cameras;
  for (const ColmapCamera& camera : model.cameras) {
    if (auto intrinsics = intrinsics_of(camera)) cameras[camera.id] = *intrinsics;
  }
  std::unordered_map<std::uint64_t, Eigen::Vector3d> points;
  for (const ColmapPoint3D& point : model.points) points[point.id] = point.point_in_world;
  std::vector<double> errors_px;
  for (const ColmapImage& image : model.images) {
    const auto camera = cameras.find(image.camera);
    if (camera == cameras.end()) continue;
    for (const ColmapPoint2D& seen : image.points) {
      const auto point = seen.point3d ? points.find(*seen.point3d) : points.end();
      if (point == points.end()) continue;
      const Eigen::Vector3d in_camera =
          image.camera_from_world * point->second + image.camera_from_world_translation;
      if (in_camera.z() <= 0.0) continue;
      // COLMAP counts pixels from the corner of the first one.
      const Eigen::Vector2d pixel = project(camera->second, in_camera).array() + 0.5;
      errors_px.push_back((pixel - seen.pixel).norm());
    }
  }
  return errors_px;
}

std::optional<Figure> reprojection_figure(const ColmapModel& model) {
  const std::vector<double> errors_px = reprojection_errors_px(model);
  if (errors_px.empty()) return std::nullopt;
  const double most_px = std::max(0.1, quantile(errors_px, 0.995));
  const Histogram bins = histogram(errors_px, 0.0, most_px, 50);
  Chart chart({"distance in the image [px]", 0.0, most_px},
              {"observations", 0.0, 1.05 * *std::ranges::max_element(bins.counts)});
  chart.bars(bins.edges, bins.counts, ink::kVision);
  const double median_px = quantile(errors_px, 0.5);
  chart.upright(median_px, ink::kAlarm, fmt::format("median {:.2f} px", median_px));
  return Figure{
      .id = "reprojection",
      .title = "Reprojection errors",
      .body = chart.svg(),
      .caption = fmt::format(
          "Distance of {} observations from their scene points, projected with the estimated "
          "cameras; the last bar holds all beyond {:.2f} px. A median above 1 px tells of blur, of "
          "a wrong camera model or of moving things.",
          errors_px.size(),
          most_px),
      .sources = {workspace_file::kImages, workspace_file::kPoints3d, workspace_file::kCameras}};
}

std::optional<Figure> track_figure(const ColmapModel& model) {
  constexpr int kMost = 20;
  std::vector<double> lengths;
  for (const ColmapPoint3D& point : model.points) {
    lengths.push_back(static_cast<double>(point.track.size()));
  }
  if (lengths.empty()) return std::nullopt;
  const Histogram bins = histogram(lengths, 1.5, kMost + 0.5, kMost - 1);
  Chart chart({"photos that see the point", 1.5, kMost + 0.5},
              {"scene points", 0.0, 1.05 * *std::ranges::max_element(bins.counts)});
  chart.bars(bins.edges, bins.counts, ink::kVision);
  return Figure{.id = "track-lengths",
                .title = "Track lengths",
                .body = chart.svg(),
                .caption = fmt::format(
                    "In how many photos each of the {} scene points was found (the last bar: {} or "
                    "more); median {:.0f}. Long tracks tie the photos together.",
                    lengths.size(),
                    kMost,
                    quantile(lengths, 0.5)),
                .sources = {workspace_file::kPoints3d}};
}

std::optional<Figure> match_figure(const ColmapModel& model) {
  std::vector<double> edges = {0.5};
  std::vector<double> counts;
  for (const ColmapImage& image : model.images) {
    edges.push_back(edges.back() + 1.0);
    counts.push_back(static_cast<double>(image.points.size()));
  }
  if (counts.empty()) return std::nullopt;
  Chart chart({"photo, by name", 0.5, edges.back()},
              {"observations", 0.0, 1.05 * *std::ranges::max_element(counts)});
  chart.bars(edges, counts, ink::kVision);
  const auto fewest = std::ranges::min_element(counts) - counts.begin();
  return Figure{
      .id = "photo-matches",
      .title = "Matches per photo",
      .body = chart.svg(),
      .caption = fmt::format(
          "Scene points seen by each photo; median {:.0f}, fewest {:.0f} ({}). Fewer than "
          "100 leave a photo's place uncertain.",
          quantile(counts, 0.5),
          counts[static_cast<std::size_t>(fewest)],
          model.images[static_cast<std::size_t>(fewest)].name),
      .sources = {workspace_file::kImages}};
}

/// How far the lens moves a pixel, from the centre of the image to its corner.
std::string distortion_chart(const CameraIntrinsics& camera) {
  const double corner_px = 0.5 * std::hypot(camera.width_px, camera.height_px);
  CameraIntrinsics radial = camera;
  radial.p1 = radial.p2 = 0.0;
  std::vector<Eigen::Vector2d> curve;
  double most_px = 0.5;
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    const double radius = corner_px / camera.focal_px * i / kSteps;
    const double moved = distort(radial, {radius, 0.0}).x() - radius;
    curve.emplace_back(radius * camera.focal_px, moved * camera.focal_px);
    if (std::isfinite(moved)) most_px = std::max(most_px, std::abs(curve.back().y()));
  }
  Chart chart({"distance from the centre of the image [px]", 0.0, corner_px},
              {"radial shift [px]", -1.1 * most_px, 1.1 * most_px},
              620.0,
              180.0);
  chart.line(curve, ink::kVision, 2.0);
  return chart.svg();
}

std::optional<Figure> camera_table(const ReportData& data) {
  std::string body;
  for (const ColmapCamera& stored : data.model->cameras) {
    const auto camera = intrinsics_of(stored);
    if (!camera) continue;
    const bool is_first = &stored == &data.model->cameras.front();
    const double before_px = is_first && data.reconstruct.is_object()
                                 ? data.reconstruct.value("initial_focal_px", 0.0)
                                 : 0.0;
    body += fmt::format(
        "<table><tr><th>camera {}, {} × {} "
        "px</th><th>before</th><th>after</th><th>unit</th></tr>\n",
        stored.id,
        camera->width_px,
        camera->height_px);
    const auto row = [&](std::string_view name,
                         std::string_view key,
                         double after,
                         std::string_view unit) {
      const std::string formula = fmt::format("{}#{}/{}", workspace_file::kCameras, stored.id, key);
      const std::string before = key != "focal_px" ? traced(0.0, "{:.0f}", "0")
                                 : before_px <= 0.0
                                     ? "–"
                                     : traced(before_px,
                                              "{:.6g}",
                                              fmt::format("{}#/stages/reconstruct/result/result/"
                                                          "initial_focal_px",
                                                          workspace_file::kRun));
      body += fmt::format("<tr><td>{}</td><td class=v>{}</td><td class=v>{}</td><td>{}</td></tr>\n",
                          name,
                          before,
                          traced(after, "{:.6g}", formula),
                          unit);
    };
    row("focal length", "focal_px", camera->focal_px, "px");
    row("principal point, x from the centre",
        "center_x_px",
        camera->principal_point_px.x() + 0.5 - 0.5 * camera->width_px,
        "px");
    row("principal point, y from the centre",
        "center_y_px",
        camera->principal_point_px.y() + 0.5 - 0.5 * camera->height_px,
        "px");
    row("k1", "k1", camera->k1, "1");
    row("k2", "k2", camera->k2, "1");
    row("k3", "k3", camera->k3, "1");
    row("p1", "p1", camera->p1, "1");
    row("p2", "p2", camera->p2, "1");
    body += "</table>\n" + distortion_chart(*camera);
  }
  if (body.empty()) return std::nullopt;
  return Figure{.id = "camera-model",
                .title = "Camera model before and after",
                .body = std::move(body),
                .caption =
                    "What the photos' metadata and an ideal lens say, and what bundle adjustment "
                    "found; below, how far the estimated lens moves a pixel. A focal length that "
                    "changes by more than 5 % is a bad sign.",
                .sources = {workspace_file::kCameras, workspace_file::kRun}};
}

}  // namespace

std::vector<Figure> camera_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (!data.model) return figures;
  for (auto figure : {reprojection_figure(*data.model),
                      track_figure(*data.model),
                      match_figure(*data.model),
                      camera_table(data)}) {
    if (figure) figures.push_back(*std::move(figure));
  }
  return figures;
}

}  // namespace hybridfusion
