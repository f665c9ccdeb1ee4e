#pragma once

#include "intrinsics_prior.hpp"

#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/vision/camera.hpp>

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A feature of a view that shows the point of a track.
struct TrackElement {
  std::uint32_t view = 0;
  std::uint32_t feature = 0;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< In the photo as stored.
  bool active = false;                              ///< Agrees with the point.
};
using Track = std::vector<TrackElement>;  ///< Ascending by view, one element a view.

struct TrackReference {
  std::uint32_t track = 0;
  std::uint32_t element = 0;
};

/// State of structure from motion. `world` is arbitrary until it was aligned to east-north-up.
struct SfmModel {
  std::vector<CameraPrior> priors = {};        ///< Per camera.
  std::vector<CameraIntrinsics> cameras = {};  ///< Per camera, as estimated.
  std::vector<std::uint32_t> camera_of_view = {};
  std::vector<std::optional<Rigid3>> world_from_view = {};  ///< Empty: not registered.
  /// Per view, of the last whole adjustment, as View::pose_covariance; may be empty.
  std::vector<std::optional<Eigen::Matrix<double, 6, 6>>> pose_covariance = {};
  std::vector<Track> tracks = {};
  std::vector<std::optional<Eigen::Vector3d>> points = {};       ///< Per track.
  std::vector<std::vector<TrackReference>> tracks_of_view = {};  ///< Per view.

  [[nodiscard]] const CameraIntrinsics& camera_of(std::uint32_t view) const {
    return cameras[camera_of_view[view]];
  }
  /// Stored pixels per pixel of the reduced photo, in which all error limits are stated.
  [[nodiscard]] double pixel_scale(std::uint32_t view) const {
    return priors[camera_of_view[view]].pixel_scale;
  }
  [[nodiscard]] std::size_t num_registered() const;
  [[nodiscard]] std::vector<std::uint32_t> registered() const;
  /// Error of an element against the point of its track, in pixels of the reduced photo; infinite
  /// behind the camera. @pre the view is registered
  [[nodiscard]] double error_px(const TrackElement& element, const Eigen::Vector3d& point) const;
};

/// Fills tracks_of_view from tracks.
void index_tracks(SfmModel& model);

}  // namespace hybridfusion
