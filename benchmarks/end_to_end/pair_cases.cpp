#include "pair_cases.hpp"

#include "pair_disturbances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace hybridfusion::benchmark {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
/// Far enough that no scene of the success groups is drawn.
constexpr std::uint64_t kOtherSite = 1000000;

SceneOptions scene_of(const CaseGroup& group, std::uint64_t seed) {
  SceneOptions options{.seed = seed, .noise = group.noise};
  if (group.name == "flat_field") options.variant = "flat";
  if (group.name == "trees_only") options.buildings = false;
  if (group.name == "symmetric") options.relief_m = 0.0;
  if (group.name == "no_overlap") {
    options.blocks_x = 2;
    options.lidar_reach_m = 30.0;
  }
  return options;
}

Eigen::Quaterniond tilt(double low_deg, double high_deg, Random& random) {
  const double bearing = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double angle = kDegree * random.uniform(low_deg, high_deg);
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(angle, Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0)));
}

Eigen::Quaterniond turn(double yaw_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

/// Where the points of L truly lie in G, and the rigid motion that comes nearest.
Expected<SceneTruth> truth_of(const PointCloud& lidar_in_lidar,
                              const PointCloud& undrifted_in_world,
                              double vision_scale) {
  ScenePlaces places;
  const std::size_t step = std::max<std::size_t>(1, lidar_in_lidar.size() / 5000);
  for (std::size_t i = 0; i < lidar_in_lidar.size(); i += step) {
    places.points_in_map.push_back(lidar_in_lidar.points[i].cast<double>());
    places.points_in_truth.push_back(undrifted_in_world.points[i].cast<double>());
  }
  return registration_truth(places, Sim3{.scale = 1.0 / vision_scale});
}

}  // namespace

Rigid3 wrong_start(const Rigid3& world_from_lidar,
                   const Eigen::Vector3d& centroid_in_lidar,
                   const CaseGroup& group,
                   Random& random) {
  const double yaw = group.yaw_deg >= 180.0
                         ? random.uniform(-std::numbers::pi, std::numbers::pi)
                         : kDegree * group.yaw_deg * (random.uniform() < 0.5 ? -1.0 : 1.0);
  const double bearing = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double up = random.uniform(1.0, 3.0) * (random.uniform() < 0.5 ? -1.0 : 1.0);
  const Eigen::Vector3d shift(
      group.offset_m * std::cos(bearing), group.offset_m * std::sin(bearing), up);
  const Eigen::Vector3d forward = world_from_lidar.rotation * Eigen::Vector3d::UnitX();
  Rigid3 start;
  start.rotation = turn(std::atan2(forward.y(), forward.x()) + yaw);
  start.translation =
      world_from_lidar * centroid_in_lidar + shift - start.rotation * centroid_in_lidar;
  return start;
}

const std::vector<CaseGroup>& case_groups() {
  static const std::vector<CaseGroup> groups = {
      {.name = "start_2m",
       .text = "start 2 m, 3 deg off",
       .kind = PairKind::kClean,
       .offset_m = 2,
       .yaw_deg = 3},
      {.name = "start_5m",
       .text = "start 5 m, 10 deg off",
       .kind = PairKind::kClean,
       .offset_m = 5,
       .yaw_deg = 10},
      {.name = "start_10m",
       .text = "start 10 m, 20 deg off",
       .kind = PairKind::kClean,
       .offset_m = 10,
       .yaw_deg = 20},
      {.name = "start_15m",
       .text = "start 15 m, 30 deg off",
       .kind = PairKind::kClean,
       .offset_m = 15,
       .yaw_deg = 30},
      {.name = "start_30m", .text = "start 30 m off, any heading", .kind = PairKind::kClean},
      {.name = "nadir_only",
       .text = "photos straight down only",
       .kind = PairKind::kClean,
       .nadir_only = true},
      {.name = "crop_30m", .text = "LiDAR within 30 m", .kind = PairKind::kCrop, .crop_m = 30},
      {.name = "crop_20m", .text = "LiDAR within 20 m", .kind = PairKind::kCrop, .crop_m = 20},
      {.name = "crop_12m", .text = "LiDAR within 12 m", .kind = PairKind::kShortCrop, .crop_m = 12},
      {.name = "scale_drift",
       .text = "photos 0.2 % too large, LiDAR drifts 0.1 %",
       .kind = PairKind::kScaleDrift,
       .scale = 1.002,
       .drift = 0.001},
      {.name = "sparse",
       .text = "a tenth of the vision points",
       .kind = PairKind::kClean,
       .keep_every = 10},
      {.name = "bent_drive",
       .text = "LiDAR bent by up to 0.25 m along the drive",
       .kind = PairKind::kBent,
       .wander_m = 0.25},
      {.name = "everyday",
       .text = "twice the noise, photos bent by 4 cm, no dark ground, moving cars",
       .kind = PairKind::kThick,
       .noise = 2.0,
       .everyday = true},
      {.name = "noisy", .text = "three times the noise", .kind = PairKind::kThick, .noise = 3.0},
      {.name = "other_site", .text = "clouds of two places", .kind = PairKind::kRefuse},
      {.name = "flat_field", .text = "open field", .kind = PairKind::kRefuse},
      {.name = "no_overlap", .text = "neighbouring blocks", .kind = PairKind::kRefuse},
      {.name = "mirrored", .text = "LiDAR mirrored", .kind = PairKind::kRefuse},
      {.name = "trees_only", .text = "no buildings", .kind = PairKind::kRefuse},
      {.name = "symmetric",
       .text = "fits equally when turned by 180 deg",
       .kind = PairKind::kRefuse},
  };
  return groups;
}

Expected<RegistrationPair> make_pair(const CaseGroup& group,
                                     std::uint64_t seed,
                                     SceneCache& scenes,
                                     const RunContext& ctx) {
  Random random(seed, group.name);
  HF_TRY(SceneClouds clouds, scenes.get(scene_of(group, seed), ctx));
  if (group.name == "other_site") {
    HF_TRY(SceneClouds other, scenes.get({.seed = seed + kOtherSite}, ctx));
    clouds.nadir = std::move(other.nadir);
    clouds.oblique = std::move(other.oblique);
  }
  if (group.crop_m > 0.0) crop(clouds, group.crop_m, random);
  RegistrationPair pair;
  pair.vision = group.nadir_only ? std::move(clouds.nadir)
                                 : concatenate(std::move(clouds.nadir), clouds.oblique);
  if (group.name == "no_overlap") separate(pair.vision, clouds.lidar);
  if (group.name == "symmetric") {
    make_symmetric(pair.vision);
    make_symmetric(clouds.lidar);
    clouds.lidar_path_m.resize(clouds.lidar.size(), 0.0F);
  }
  if (group.keep_every > 1) thin(pair.vision, group.keep_every);
  if (group.everyday) add_moving_cars(clouds, random);
  const PointCloud undrifted = clouds.lidar;
  if (group.wander_m > 0.0) add_wander(clouds, group.wander_m, random);
  if (group.drift > 0.0) add_drift(clouds, group.drift, random);

  Rigid3 world_from_lidar;
  world_from_lidar.rotation =
      tilt(0.5, 2.0, random) * turn(random.uniform(-std::numbers::pi, std::numbers::pi));
  world_from_lidar.translation = {
      random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-5, 5)};
  const Rigid3 lidar_from_world = world_from_lidar.inverse();
  pair.lidar = transformed(lidar_from_world, std::move(clouds.lidar));
  for (const Eigen::Vector3d& p : clouds.sensor_positions) {
    pair.input.sensor_positions.push_back(lidar_from_world * p);
  }
  if (group.name == "mirrored") {
    for (Eigen::Vector3f& p : pair.lidar.points) p.x() = -p.x();
    for (Eigen::Vector3d& p : pair.input.sensor_positions) p.x() = -p.x();
  }
  for (Eigen::Vector3f& p : pair.vision.points) p *= static_cast<float>(group.scale);
  if (group.everyday) {
    bend(pair.vision, random);
    drop_dark_ground(pair.vision, random);
  }
  const std::size_t stride = std::max<std::size_t>(1, undrifted.size() / 5000);
  for (std::size_t i = 0; i < undrifted.size(); i += stride) {
    pair.checked.push_back(i);
    pair.places_in_vision.push_back(group.scale * undrifted.points[i].cast<double>());
  }
  HF_TRY(pair.truth, truth_of(pair.lidar, undrifted, group.scale));
  pair.input.vision_from_lidar_initial =
      wrong_start(pair.truth.vision_from_lidar, pair.truth.centroid_in_lidar, group, random);
  return pair;
}

}  // namespace hybridfusion::benchmark
