#include "flight.hpp"

#include "gnss_model.hpp"
#include "jpeg_photo.hpp"
#include "output_file.hpp"
#include "render.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kSensorDiagonal_mm = 8.0;
constexpr double kFullFrameDiagonal_mm = 43.2666;

/// Where the camera should be and look.
struct Waypoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< In the block frame.
  Eigen::Vector3d forward = -Eigen::Vector3d::UnitZ();
  Eigen::Vector3d image_up = Eigen::Vector3d::UnitX();
};

/// Evenly spaced stations over [-half, half], at most `spacing` (and a fifth) apart.
std::vector<double> stations(double half, double spacing) {
  const int gaps = std::max(1, static_cast<int>(std::ceil(2.0 * half / spacing - 0.2)));
  std::vector<double> out;
  for (int i = 0; i <= gaps; ++i) out.push_back(half * (2.0 * i / gaps - 1.0));
  return out;
}

void add_nadir_grid(const Terrain& terrain,
                    const SimulationOptions& options,
                    std::vector<Waypoint>& plan) {
  const FlightOptions& flight = options.flight;
  const double focal = exif_focal_px(options.camera);
  const double along_m = flight.altitude_m * options.camera.height_px / focal;
  const double across_m = flight.altitude_m * options.camera.width_px / focal;
  const Eigen::Vector2d core = terrain.plan().core_half_m;
  const auto xs =
      stations(std::max(5.0, core.x() - 0.15 * along_m), (1.0 - flight.forward_overlap) * along_m);
  const auto ys =
      stations(std::max(5.0, core.y() - 0.15 * across_m), (1.0 - flight.side_overlap) * across_m);
  for (std::size_t row = 0; row < ys.size(); ++row) {
    const bool back = row % 2 == 1;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const double x = back ? xs[xs.size() - 1 - i] : xs[i];
      plan.push_back({.position = {x, ys[row], terrain.height(0, 0) + flight.altitude_m},
                      .image_up = {back ? -1.0 : 1.0, 0.0, 0.0}});
    }
  }
}

void add_oblique_ring(const Terrain& terrain,
                      const FlightOptions& flight,
                      const Eigen::Vector2d& center,
                      Random& random,
                      std::vector<Waypoint>& plan) {
  const double tilt = flight.oblique_tilt_deg * std::numbers::pi / 180.0;
  const double ground = terrain.height(center.x(), center.y());
  const double radius = flight.oblique_altitude_m * std::tan(tilt);
  for (int i = 0; i < flight.oblique_photos; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / flight.oblique_photos;
    Waypoint waypoint;
    waypoint.position = {center.x() + radius * std::cos(angle),
                         center.y() + radius * std::sin(angle),
                         ground + flight.oblique_altitude_m};
    const Eigen::Vector3d target(
        center.x() + 2.0 * random.normal(), center.y() + 2.0 * random.normal(), ground + 3.0);
    waypoint.forward = (target - waypoint.position).normalized();
    waypoint.image_up = Eigen::Vector3d::UnitZ();
    plan.push_back(waypoint);
  }
}

Rigid3 camera_pose(const Waypoint& waypoint) {
  const Eigen::Vector3d right = waypoint.forward.cross(waypoint.image_up).normalized();
  Eigen::Matrix3d rotation;
  rotation.col(0) = right;
  rotation.col(1) = waypoint.forward.cross(right);
  rotation.col(2) = waypoint.forward;
  return {.rotation = Eigen::Quaterniond(rotation), .translation = waypoint.position};
}

Eigen::Vector3d normal3(Random& random) {
  const double x = random.normal();
  const double y = random.normal();
  return {x, y, random.normal()};
}

}  // namespace

std::vector<Shot> plan_flight(const Terrain& terrain,
                              const SimulationOptions& options,
                              std::uint64_t seed) {
  Random random(seed, "flight/pose");
  std::vector<Waypoint> plan;
  add_nadir_grid(terrain, options, plan);
  const StreetPlan& streets = terrain.plan();
  for (std::size_t j = 0; j + 1 < streets.street_y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < streets.street_x.size(); ++i) {
      const Eigen::Vector2d center(0.5 * (streets.street_x[i] + streets.street_x[i + 1]),
                                   0.5 * (streets.street_y[j] + streets.street_y[j + 1]));
      add_oblique_ring(terrain, options.flight, center, random, plan);
    }
  }
  const Rigid3 world_from_block{.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(
                                    terrain.plan().yaw_rad, Eigen::Vector3d::UnitZ()))};
  GnssError gnss(options.gnss, seed, "gnss/drone", 0);
  const double attitude_sd = options.flight.attitude_sd_deg * std::numbers::pi / 180.0;
  std::vector<Shot> shots;
  double time_s = 0.0;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    Shot shot;
    shot.name = fmt::format("IMG_{:04}.JPG", i + 1);
    Rigid3 pose = world_from_block * camera_pose(plan[i]);
    pose.translation += options.flight.position_sd_m * normal3(random);
    const Eigen::Vector3d turn = attitude_sd * normal3(random);
    const Eigen::Quaterniond wobble(Eigen::AngleAxisd(turn.norm(), turn.normalized().eval()));
    pose.rotation = (pose.rotation * wobble).normalized();
    shot.world_from_camera = pose;
    if (i > 0) {
      time_s += (pose.translation - shots.back().world_from_camera.translation).norm() /
                options.flight.speed_mps;
    }
    shot.time_s = 1e-3 * std::round(1e3 * time_s);
    shot.gnss_in_enu = pose.translation + gnss.at(shot.time_s);
    shots.push_back(shot);
  }
  return shots;
}

Expected<void> fly(const Scene& scene,
                   const RayTracer& tracer,
                   const PinholeCamera& camera,
                   const std::vector<Shot>& shots,
                   const SimulationOptions& options,
                   const GeodeticOrigin& origin,
                   const std::filesystem::path& folder,
                   const RunContext& ctx) {
  RenderSettings settings{.samples_per_pixel = options.camera.samples_per_pixel,
                          .vignetting = options.camera.vignetting,
                          .noise_sd = options.camera.noise_sd,
                          .seed = ctx.seed};
  for (std::size_t i = 0; i < shots.size(); ++i) {
    ctx.report({.stage = "simulate/photos",
                .done = static_cast<std::int64_t>(i),
                .total = static_cast<std::int64_t>(shots.size())});
    settings.index = i;
    HF_TRY(const Image8 image,
           render_photo(scene, tracer, camera, shots[i].world_from_camera, settings, ctx));
    const ExifFields exif{
        .time = from_seconds(kTakeOffTime_s) + from_seconds(shots[i].time_s),
        .focal_mm = options.camera.focal_35mm * kSensorDiagonal_mm / kFullFrameDiagonal_mm,
        .focal_35mm = options.camera.focal_35mm,
        .width_px = image.width,
        .height_px = image.height,
        .position = geodetic_from_enu(origin, shots[i].gnss_in_enu),
        .horizontal_error_m = options.gnss.rtk ? 0.03 : options.gnss.sigma_horizontal_m};
    HF_TRY(const std::string jpeg,
           encode_jpeg(image, options.camera.jpeg_quality, exif_segment(exif)));
    if (Expected<void> written = write_whole_file(folder / shots[i].name, jpeg); !written) {
      return written;
    }
  }
  ctx.report({.stage = "simulate/photos",
              .done = static_cast<std::int64_t>(shots.size()),
              .total = static_cast<std::int64_t>(shots.size())});
  return {};
}

}  // namespace hybridfusion
