#include "vision_files.hpp"

#include "colmap_intrinsics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

ColmapCamera colmap_camera(const CameraIntrinsics& camera, std::uint32_t id) {
  const double cx = camera.principal_point_px.x() + kColmapShift_px;
  const double cy = camera.principal_point_px.y() + kColmapShift_px;
  ColmapCamera result{
      .id = id,
      .model = "OPENCV",
      .width_px = camera.width_px,
      .height_px = camera.height_px,
      .params = {
          camera.focal_px, camera.focal_px, cx, cy, camera.k1, camera.k2, camera.p1, camera.p2}};
  if (camera.k3 != 0.0) {
    result.model = "FULL_OPENCV";
    result.params.insert(result.params.end(), {camera.k3, 0.0, 0.0, 0.0});
  }
  return result;
}

ColmapImage colmap_image(const View& view, std::uint32_t id) {
  const Rigid3 camera_from_enu = view.enu_from_camera->inverse();
  ColmapImage image{.id = id,
                    .camera = view.camera + 1,
                    .name = view.name,
                    .camera_from_world = camera_from_enu.rotation,
                    .camera_from_world_translation = camera_from_enu.translation};
  for (const Observation& observation : view.observations) {
    image.points.push_back({.pixel = observation.pixel.cast<double>().array() + kColmapShift_px,
                            .point3d = observation.point + 1U});
  }
  return image;
}

}  // namespace

ColmapModel colmap_model_of(const Reconstruction& reconstruction) {
  ColmapModel model;
  for (std::uint32_t i = 0; i < reconstruction.cameras.size(); ++i) {
    model.cameras.push_back(colmap_camera(reconstruction.cameras[i], i + 1));
  }
  for (std::uint32_t i = 0; i < reconstruction.views.size(); ++i) {
    if (!reconstruction.views[i].enu_from_camera) continue;
    model.images.push_back(colmap_image(reconstruction.views[i], i + 1));
  }
  for (std::uint64_t i = 0; i < reconstruction.points.size(); ++i) {
    const ScenePoint& point = reconstruction.points[i];
    ColmapPoint3D stored{.id = i + 1,
                         .point_in_world = point.point_in_enu,
                         .color = point.color,
                         .error_px = point.mean_error_px};
    for (const ViewObservation& seen : point.track) {
      stored.track.push_back({.image = seen.view + 1, .point2d = seen.observation});
    }
    model.points.push_back(std::move(stored));
  }
  return model;
}

std::vector<PositionRow> position_rows(const Reconstruction& reconstruction,
                                       const std::vector<QuarantinedPhoto>& quarantined) {
  std::vector<PositionRow> rows;
  for (const View& view : reconstruction.views) {
    PositionRow row{.name = view.name, .gnss = view.gnss_in_enu, .reason = view.reason};
    if (view.enu_from_camera) row.position = view.enu_from_camera->translation;
    rows.push_back(std::move(row));
  }
  for (const QuarantinedPhoto& photo : quarantined) {
    rows.push_back({.name = photo.name, .reason = photo.reason});
  }
  std::ranges::sort(rows, {}, &PositionRow::name);
  return rows;
}

std::string covariance_csv(const Reconstruction& reconstruction) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  std::string text = "name,sigma_e_m,sigma_n_m,sigma_u_m,sigma_rx_deg,sigma_ry_deg,sigma_rz_deg";
  for (int r = 0; r < 6; ++r) {
    for (int c = r; c < 6; ++c) text += fmt::format(",c{}{}", r + 1, c + 1);
  }
  text += '\n';
  for (const View& view : reconstruction.views) {
    if (!view.pose_covariance) continue;
    const Eigen::Matrix<double, 6, 6>& covariance = *view.pose_covariance;
    text += csv_text(view.name);
    for (int k = 0; k < 6; ++k) {
      text += fmt::format(",{:.6g}", std::sqrt(covariance(k, k)) / (k < 3 ? 1.0 : kDegree));
    }
    for (int r = 0; r < 6; ++r) {
      for (int c = r; c < 6; ++c) text += fmt::format(",{:.9g}", covariance(r, c));
    }
    text += '\n';
  }
  return text;
}

}  // namespace hybridfusion
