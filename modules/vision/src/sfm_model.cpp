#include "sfm_model.hpp"

#include <algorithm>
#include <limits>

namespace hybridfusion {

std::size_t SfmModel::num_registered() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(world_from_view, [](const auto& pose) { return pose.has_value(); }));
}

std::vector<std::uint32_t> SfmModel::registered() const {
  std::vector<std::uint32_t> views;
  for (std::uint32_t view = 0; view < world_from_view.size(); ++view) {
    if (world_from_view[view]) views.push_back(view);
  }
  return views;
}

double SfmModel::error_px(const TrackElement& element, const Eigen::Vector3d& point) const {
  const Rigid3& pose = *world_from_view[element.view];
  const Eigen::Vector3d in_camera = pose.rotation.conjugate() * (point - pose.translation);
  if (in_camera.z() <= 1e-9) return std::numeric_limits<double>::infinity();
  return (project(camera_of(element.view), in_camera) - element.pixel).norm() /
         pixel_scale(element.view);
}

void index_tracks(SfmModel& model) {
  model.tracks_of_view.assign(model.world_from_view.size(), {});
  for (std::uint32_t track = 0; track < model.tracks.size(); ++track) {
    for (std::uint32_t element = 0; element < model.tracks[track].size(); ++element) {
      model.tracks_of_view[model.tracks[track][element].view].push_back({track, element});
    }
  }
}

}  // namespace hybridfusion
