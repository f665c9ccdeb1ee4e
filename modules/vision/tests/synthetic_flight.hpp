#pragma once

#include "sfm_model.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Geometry>

namespace hybridfusion::testing {

/// Truth and model of a nadir grid flight over ground with boxes: 1600 x 1200 px, 65 m high.
struct SyntheticFlight {
  SfmModel truth;              ///< All views registered, all points set, all elements active.
  std::vector<double> time_s;  ///< Per view.
};

struct FlightOptions {
  int columns = 4;
  int rows = 3;
  int num_points = 500;
  double spacing_m = 14.0;
  double tilt_rad = 0.15;  ///< Views lean alternately: nadir alone leaves the focal length free.
  double jitter_m = 1.0;   ///< Deviation of the views from the grid, per axis.
  double noise_px = 0.3;
  std::uint64_t seed = 1;
};

inline CameraIntrinsics flight_camera() {
  return {.width_px = 1600,
          .height_px = 1200,
          .focal_px = 1290.0,
          .principal_point_px = {803.0, 595.0},
          .k1 = -0.045,
          .k2 = 0.018};
}

/// Camera looking down, image x towards `heading_rad` clockwise from east, leaning about x.
inline Eigen::Quaterniond looking_down(double heading_rad, double tilt_rad) {
  Eigen::Matrix3d down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return Eigen::Quaterniond(Eigen::AngleAxisd(-heading_rad, Eigen::Vector3d::UnitZ()) * down *
                            Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitX()));
}

inline SyntheticFlight make_flight(const FlightOptions& options = {}) {
  SyntheticFlight flight;
  SfmModel& model = flight.truth;
  Random random(options.seed, "test/flight");
  model.cameras = {flight_camera()};
  CameraPrior prior{.intrinsics = flight_camera(), .focal_sigma = 0.02};
  prior.intrinsics.focal_px = 1294.0;
  prior.intrinsics.principal_point_px = {799.5, 599.5};
  prior.intrinsics.k1 = 0.0;
  prior.intrinsics.k2 = 0.0;
  model.priors = {prior};
  for (int row = 0; row < options.rows; ++row) {
    for (int k = 0; k < options.columns; ++k) {
      const int column = row % 2 == 0 ? k : options.columns - 1 - k;
      const double heading = row % 2 == 0 ? 0.0 : std::numbers::pi;
      const double tilt = (row + k) % 2 == 0 ? options.tilt_rad : -options.tilt_rad;
      const Eigen::Vector3d jitter =
          options.jitter_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      model.world_from_view.push_back(Rigid3{
          .rotation = looking_down(heading + 0.02 * random.normal(), tilt),
          .translation =
              Eigen::Vector3d(options.spacing_m * column, options.spacing_m * row, 65.0) + jitter});
      flight.time_s.push_back(2.5 * static_cast<double>(flight.time_s.size()));
    }
  }
  model.camera_of_view.assign(model.world_from_view.size(), 0);
  for (int i = 0; i < options.num_points; ++i) {
    Eigen::Vector3d point(random.uniform(-30.0, options.spacing_m * options.columns + 15.0),
                          random.uniform(-25.0, options.spacing_m * options.rows + 10.0),
                          0.0);
    if (random.uniform() < 0.4) point.z() = random.uniform(3.0, 12.0);
    Track track;
    for (std::uint32_t view = 0; view < model.world_from_view.size(); ++view) {
      const Rigid3 camera_from_world = model.world_from_view[view]->inverse();
      const Eigen::Vector3d in_camera = camera_from_world * point;
      if (in_camera.z() <= 0.0) continue;
      Eigen::Vector2d pixel = project(model.cameras[0], in_camera);
      pixel += options.noise_px * Eigen::Vector2d(random.normal(), random.normal());
      if (pixel.x() < 0 || pixel.y() < 0 || pixel.x() > 1599 || pixel.y() > 1199) continue;
      track.push_back(
          {.view = view, .feature = static_cast<std::uint32_t>(i), .pixel = pixel, .active = true});
    }
    if (track.size() < 2) continue;
    model.tracks.push_back(track);
    model.points.emplace_back(point);
  }
  index_tracks(model);
  return flight;
}

}  // namespace hybridfusion::testing
