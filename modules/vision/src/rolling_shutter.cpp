#include "rolling_shutter.hpp"

#include "robust_statistics.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace hybridfusion {
namespace {

struct Readout {
  std::string_view model;
  double milliseconds;
};

/// Electronic shutters by EXIF model, as their users measured them (RSCalibration of OpenDroneMap).
/// Cameras with a mechanical shutter, and those nobody measured, are missing on purpose.
constexpr std::array<Readout, 9> kReadouts = {{{"FC300S", 33.0},
                                               {"FC300X", 33.0},
                                               {"FC330", 33.0},
                                               {"FC220", 64.0},
                                               {"L1D-20c", 47.0},
                                               {"FC3411", 32.0},
                                               {"FC3582", 26.0},
                                               {"FC3170", 27.0},
                                               {"FC7203", 20.0}}};

std::vector<double> depths_of(const SfmModel& model, std::uint32_t view) {
  const Rigid3 camera_from_world = model.world_from_view[view]->inverse();
  std::vector<double> depths;
  for (const TrackReference& reference : model.tracks_of_view[view]) {
    const auto& point = model.points[reference.track];
    if (!point || !model.tracks[reference.track][reference.element].active) continue;
    const double depth = (camera_from_world * *point).z();
    if (depth > 0.0) depths.push_back(depth);
  }
  return depths;
}

}  // namespace

std::vector<double> readout_times(std::span<const PhotoMetadata> photos,
                                  const RollingShutterOptions& options) {
  std::vector<double> times(photos.size(), 0.0);
  if (options.correction == "off") return times;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const auto known = std::ranges::find(kReadouts, photos[i].model, &Readout::model);
    const double by_table = known == kReadouts.end() ? 0.0 : known->milliseconds;
    times[i] = 1e-3 * (options.readout_ms > 0.0 ? options.readout_ms : by_table);
  }
  return times;
}

RollingShutterReport correct_rolling_shutter(SfmModel& model,
                                             std::span<const double> readout_s,
                                             std::span<const Eigen::Vector3d> velocity) {
  constexpr double kMinMove_px = 0.5;
  RollingShutterReport report;
  for (const std::uint32_t view : model.registered()) {
    const CameraIntrinsics& camera = model.camera_of(view);
    const Rigid3 camera_from_world = model.world_from_view[view]->inverse();
    const std::vector<double> depths = depths_of(model, view);
    if (depths.empty()) continue;
    const double depth = median(depths);
    const Eigen::Vector3d moved = camera_from_world.rotation * velocity[view] * readout_s[view];
    if (!(moved.norm() * camera.focal_px / depth > kMinMove_px)) continue;
    ++report.num_views;
    for (const TrackReference& reference : model.tracks_of_view[view]) {
      TrackElement& element = model.tracks[reference.track][reference.element];
      const auto& point = model.points[reference.track];
      // What is not triangulated yet is taken to lie as far as most of what is.
      const Eigen::Vector3d in_camera =
          point ? camera_from_world * *point
                : depth * unproject(camera, element.pixel).homogeneous();
      const double share = element.pixel.y() / camera.height_px - 0.5;
      const Eigen::Vector3d seen_from_row = in_camera - share * moved;
      if (!(in_camera.z() > 0.0) || !(seen_from_row.z() > 0.0)) continue;
      const Eigen::Vector2d shift = project(camera, seen_from_row) - project(camera, in_camera);
      element.pixel -= shift;
      report.largest_px = std::max(report.largest_px, shift.norm());
    }
  }
  return report;
}

}  // namespace hybridfusion
