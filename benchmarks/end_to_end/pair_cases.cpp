#include "pair_cases.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
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

void keep_lidar(SceneClouds& clouds, const std::vector<std::size_t>& kept) {
  clouds.lidar = select(clouds.lidar, kept);
  std::vector<float> path;
  path.reserve(kept.size());
  for (const std::size_t i : kept) path.push_back(clouds.lidar_path_m[i]);
  clouds.lidar_path_m = std::move(path);
}

void crop(SceneClouds& clouds, double radius_m, Random& random) {
  const auto place = random.index(static_cast<std::uint32_t>(clouds.sensor_positions.size()));
  const Eigen::Vector2f centre = clouds.sensor_positions[place].head<2>().cast<float>();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < clouds.lidar.size(); ++i) {
    const float distance = (clouds.lidar.points[i].head<2>() - centre).norm();
    if (static_cast<double>(distance) < radius_m) kept.push_back(i);
  }
  keep_lidar(clouds, kept);
  std::erase_if(clouds.sensor_positions, [&](const Eigen::Vector3d& p) {
    return (p.head<2>() - centre.cast<double>()).norm() > radius_m;
  });
}

/// Cuts the vision cloud back to what the LiDAR cannot have seen.
void separate(PointCloud& vision, const PointCloud& lidar) {
  Eigen::Vector2f low = lidar.points.front().head<2>();
  Eigen::Vector2f high = low;
  for (const Eigen::Vector3f& p : lidar.points) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < vision.size(); ++i) {
    const Eigen::Vector2f p = vision.points[i].head<2>();
    if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) kept.push_back(i);
  }
  vision = select(vision, kept);
}

/// Adds the cloud turned by 180 degrees about the vertical through the origin: two headings fit
/// equally well.
void make_symmetric(PointCloud& cloud) {
  PointCloud turned = cloud;
  for (Eigen::Vector3f& p : turned.points) p.head<2>() *= -1.0F;
  cloud = concatenate(std::move(cloud), turned);
}

void thin(PointCloud& cloud, int keep_every) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud.size(); i += static_cast<std::size_t>(keep_every)) {
    kept.push_back(i);
  }
  cloud = select(cloud, kept);
}

/// Moves every LiDAR point by what an odometry with this drift would have gathered by then: a
/// slow turn of heading and a shift along one direction.
void add_drift(SceneClouds& clouds, double drift, Random& random) {
  const double bearing = random.uniform(0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3f along(
      static_cast<float>(std::cos(bearing)), static_cast<float>(std::sin(bearing)), 0.2F);
  for (std::size_t i = 0; i < clouds.lidar.size(); ++i) {
    clouds.lidar.points[i] += static_cast<float>(drift) * clouds.lidar_path_m[i] * along;
  }
}

/// A bend that an odometry leaves: smooth over some 200 m of way.
void add_wander(SceneClouds& clouds, double size_m, Random& random) {
  const double length_m = random.uniform(150.0, 300.0);
  const std::array<double, 3> phases = {
      random.uniform(0.0, 6.28), random.uniform(0.0, 6.28), random.uniform(0.0, 6.28)};
  for (std::size_t i = 0; i < clouds.lidar.size(); ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(clouds.lidar_path_m[i]) / length_m;
    const Eigen::Vector3d move(std::sin(angle + phases[0]),
                               std::sin(angle + phases[1]),
                               0.3 * std::sin(angle + phases[2]));
    clouds.lidar.points[i] += (size_m * move).cast<float>();
  }
}

/// Doming and block deformation: a few centimetres over a hundred metres.
void bend(PointCloud& cloud, Random& random) {
  constexpr double kSize_m = 0.04;
  const double wave = 2.0 * std::numbers::pi / random.uniform(100.0, 200.0);
  const double phase = random.uniform(0.0, 6.28);
  for (Eigen::Vector3f& p : cloud.points) {
    const double x = wave * static_cast<double>(p.x());
    const double y = wave * static_cast<double>(p.y());
    p += (kSize_m * Eigen::Vector3d(std::sin(y + phase), std::cos(x + phase), std::sin(x + y)))
             .cast<float>();
  }
}

/// Dark asphalt and deep shadow: discs in which stereo finds no ground.
void drop_dark_ground(PointCloud& cloud, Random& random) {
  constexpr float kCell_m = 4.0F;
  constexpr float kLow_m = 0.5F;
  std::map<std::pair<int, int>, float> lowest;
  const auto cell = [&](const Eigen::Vector3f& p) {
    return std::pair{static_cast<int>(std::floor(p.x() / kCell_m)),
                     static_cast<int>(std::floor(p.y() / kCell_m))};
  };
  for (const Eigen::Vector3f& p : cloud.points) {
    const auto [entry, is_new] = lowest.try_emplace(cell(p), p.z());
    if (!is_new) entry->second = std::min(entry->second, p.z());
  }
  std::vector<Eigen::Vector3f> discs;
  for (int k = 0; k < 25; ++k) {
    const auto at = random.index(static_cast<std::uint32_t>(cloud.size()));
    const Eigen::Vector3f& p = cloud.points[at];
    discs.emplace_back(p.x(), p.y(), static_cast<float>(random.uniform(4.0, 12.0)));
  }
  std::erase_if(cloud.points, [&](const Eigen::Vector3f& p) {
    if (p.z() > lowest[cell(p)] + kLow_m) return false;
    return std::ranges::any_of(discs, [&](const Eigen::Vector3f& d) {
      return (d.head<2>() - p.head<2>()).norm() < d.z();
    });
  });
}

/// What cars that drove along leave in a LiDAR map: smeared boxes beside the way.
void add_moving_cars(SceneClouds& clouds, Random& random) {
  for (int car = 0; car < 6; ++car) {
    const auto count = static_cast<std::uint32_t>(clouds.sensor_positions.size());
    const std::uint32_t first = random.index(count);
    const double side_m = random.uniform(2.5, 4.0);
    for (std::uint32_t k = first; k + 1 < std::min(count, first + 12); ++k) {
      const Eigen::Vector3d& at = clouds.sensor_positions[k];
      const Eigen::Vector3d along = clouds.sensor_positions[k + 1] - at;
      if (along.norm() < 0.1) continue;
      const Eigen::Vector3d across = Eigen::Vector3d::UnitZ().cross(along).normalized();
      for (int i = 0; i < 150; ++i) {
        const Eigen::Vector3d p = at + random.uniform() * along +
                                  (side_m + random.uniform(-0.9, 0.9)) * across -
                                  random.uniform(0.2, 1.8) * Eigen::Vector3d::UnitZ();
        clouds.lidar.points.push_back(p.cast<float>());
        clouds.lidar_path_m.push_back(clouds.lidar_path_m.empty() ? 0.0F
                                                                  : clouds.lidar_path_m.back());
      }
    }
  }
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

/// The start: wrong by the group's amounts at the middle of the LiDAR cloud, level.
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

const std::vector<CaseGroup>& case_groups() {
  static const std::vector<CaseGroup> groups = {
      {.name = "start_2m", .text = "start 2 m, 3 deg off", .offset_m = 2, .yaw_deg = 3},
      {.name = "start_5m", .text = "start 5 m, 10 deg off", .offset_m = 5, .yaw_deg = 10},
      {.name = "start_10m", .text = "start 10 m, 20 deg off", .offset_m = 10, .yaw_deg = 20},
      {.name = "start_15m", .text = "start 15 m, 30 deg off", .offset_m = 15, .yaw_deg = 30},
      {.name = "start_30m", .text = "start 30 m off, any heading"},
      {.name = "nadir_only", .text = "photos straight down only", .nadir_only = true},
      {.name = "crop_30m", .text = "LiDAR within 30 m", .crop_m = 30},
      {.name = "crop_20m", .text = "LiDAR within 20 m", .crop_m = 20},
      {.name = "crop_12m", .text = "LiDAR within 12 m", .crop_m = 12},
      {.name = "scale_drift",
       .text = "photos 0.2 % too large, LiDAR drifts 0.1 %",
       .scale = 1.002,
       .drift = 0.001},
      {.name = "sparse", .text = "a tenth of the vision points", .keep_every = 10},
      {.name = "bent_drive",
       .text = "LiDAR bent by up to 0.25 m along the drive",
       .wander_m = 0.25},
      {.name = "everyday",
       .text = "twice the noise, photos bent by 4 cm, no dark ground, moving cars",
       .noise = 2.0,
       .everyday = true},
      {.name = "noisy", .text = "three times the noise", .noise = 3.0},
      {.name = "other_site", .text = "clouds of two places", .must_refuse = true},
      {.name = "flat_field", .text = "open field", .must_refuse = true},
      {.name = "no_overlap", .text = "neighbouring blocks", .must_refuse = true},
      {.name = "mirrored", .text = "LiDAR mirrored", .must_refuse = true},
      {.name = "trees_only", .text = "no buildings", .must_refuse = true},
      {.name = "symmetric", .text = "fits equally when turned by 180 deg", .must_refuse = true},
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
