#include "pair_scene.hpp"

#include "drive_path.hpp"
#include "flight.hpp"
#include "lidar_model.hpp"
#include "street_drive.hpp"
#include "world.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/core/random.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion::benchmark {
namespace {

constexpr int kRaysPerPhoto = 40000;
constexpr double kVisionVoxel_m = 0.1;
constexpr double kLidarVoxel_m = 0.1;
/// 26 mm from 65 m, as a good reconstruction at a ground sampling distance of 5 cm has.
constexpr double kDepthNoise = 4e-4;
constexpr double kPhotoOffset_m = 0.02;
/// Matching windows smear roofs over about this many pixels.
constexpr double kFatteningSd_px = 2.0;
constexpr double kScanEvery_s = 0.4;

bool is_built(const Scene& scene, std::uint32_t face) {
  return scene.surfaces[scene.face_surface[face]].label == FaceLabel::kBuilding;
}

/// One photo's share of the vision cloud.
PointCloud photo_points(const Scene& scene,
                        const RayTracer& tracer,
                        const PinholeCamera& camera,
                        const Rigid3& world_from_camera,
                        std::uint64_t index,
                        const SceneOptions& options) {
  Random random(options.seed, "benchmark/photo", index);
  const double offset = options.noise * kPhotoOffset_m * random.normal();
  const Eigen::Matrix3d rotation = world_from_camera.rotation.toRotationMatrix();
  const Eigen::Vector3f origin = world_from_camera.translation.cast<float>();
  const auto cast = [&](double x, double y) {
    const Eigen::Vector3f ray = (rotation * camera.direction(x, y)).cast<float>().normalized();
    return tracer.cast(origin, ray, 1.0F, 400.0F);
  };
  PointCloud cloud;
  for (int k = 0; k < kRaysPerPhoto; ++k) {
    const double x = random.uniform(0.0, camera.width_px - 1.0);
    const double y = random.uniform(0.0, camera.height_px - 1.0);
    const double beside_x = x + kFatteningSd_px * random.normal();
    const double beside_y = y + kFatteningSd_px * random.normal();
    const double noise = random.normal();
    const double chance = random.uniform();
    const RayHit hit = cast(x, y);
    if (hit.face == kNoFace) continue;
    const Material material = scene.surfaces[scene.face_surface[hit.face]].material;
    if (material == Material::kGlass && chance < 0.8) continue;
    if (!options.buildings && is_built(scene, hit.face)) continue;
    auto range = static_cast<double>(hit.distance_m);
    const RayHit beside = cast(beside_x, beside_y);
    if (beside.face != kNoFace && static_cast<double>(beside.distance_m) < range - 0.4 &&
        (options.buildings || !is_built(scene, beside.face))) {
      range = static_cast<double>(beside.distance_m);
    }
    range += offset + options.noise * kDepthNoise * range * noise;
    const Eigen::Vector3d ray = (rotation * camera.direction(x, y)).normalized();
    cloud.points.push_back((world_from_camera.translation + range * ray).cast<float>());
  }
  return cloud;
}

void add_photos(const World& world,
                const RayTracer& tracer,
                const SimulationOptions& simulation,
                const SceneOptions& options,
                const RunContext& ctx,
                SceneClouds& clouds) {
  const std::vector<Shot> shots = plan_flight(world.terrain, simulation, options.seed);
  const PinholeCamera camera = make_true_camera(simulation.camera, options.seed);
  std::vector<PointCloud> parts(shots.size());
  parallel_for(ctx, shots.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      parts[i] = photo_points(world.scene, tracer, camera, shots[i].world_from_camera, i, options);
    }
  });
  constexpr double kSteepest = 0.9;  // cosine to straight down
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Eigen::Vector3d axis = shots[i].world_from_camera.rotation * Eigen::Vector3d::UnitZ();
    auto& points = (axis.z() < -kSteepest ? clouds.nadir : clouds.oblique).points;
    points.insert(points.end(), parts[i].points.begin(), parts[i].points.end());
  }
  clouds.nadir = voxel_mean(clouds.nadir, kVisionVoxel_m);
  clouds.oblique = voxel_mean(clouds.oblique, kVisionVoxel_m);
}

/// Scans along the way with everything moved to its true place. The distance driven rides along as
/// a channel through the thinning.
Expected<void> add_drive(const World& world,
                         const RayTracer& tracer,
                         const SimulationOptions& simulation,
                         const SceneOptions& options,
                         const RunContext& ctx,
                         SceneClouds& clouds) {
  const StreetPlan& streets = world.terrain.plan();
  Random random(options.seed, "benchmark/start");
  const DrivePlan plan = plan_drive(
      streets, {0, 1, 0, 1}, simulation.drive.loop_overlap_m, {.share = random.uniform(0.05, 0.9)});
  HF_TRY(const VehicleMotion motion, drive(plan, world.terrain, simulation.drive, options.seed, 0));
  LidarSetup setup{.options = simulation.lidar, .seed = options.seed};
  setup.body_from_lidar.translation = {0.3, 0.0, 1.0};
  const auto scans = static_cast<std::size_t>(motion.duration_s() / kScanEvery_s);
  std::vector<PointCloud> parts(scans);
  parallel_for(ctx, scans, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double start_s = kScanEvery_s * static_cast<double>(i);
      for (const LidarReturn& r : scan_scene(world.scene, tracer, motion, setup, i, start_s)) {
        if (r.point.norm() > options.lidar_reach_m) continue;
        const Rigid3 pose =
            motion.at(start_s + 1e-9 * r.offset_ns).world_from_body * setup.body_from_lidar;
        parts[i].points.push_back((pose * r.point.cast<double>()).cast<float>());
      }
    }
  });
  double path_m = 0.0;
  PointCloud all;
  for (std::size_t i = 0; i < scans; ++i) {
    const double start_s = kScanEvery_s * static_cast<double>(i);
    const Eigen::Vector3d at = motion.at(start_s).world_from_body.translation;
    if (!clouds.sensor_positions.empty()) path_m += (at - clouds.sensor_positions.back()).norm();
    clouds.sensor_positions.push_back(at);
    all.points.insert(all.points.end(), parts[i].points.begin(), parts[i].points.end());
    all.intensities.resize(all.points.size(), static_cast<float>(path_m));
  }
  if (!options.buildings) {
    // Beams pass where the buildings were taken out: only what stands free of them is left.
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const RayHit up = tracer.cast(
          all.points[i] + Eigen::Vector3f(0, 0, 60), -Eigen::Vector3f::UnitZ(), 0.0F, 200.0F);
      const RayHit down = tracer.cast(
          all.points[i] + Eigen::Vector3f(0, 0, 0.3F), -Eigen::Vector3f::UnitZ(), 0.0F, 1.0F);
      const auto built = [&](const RayHit& hit) {
        return hit.face != kNoFace && is_built(world.scene, hit.face);
      };
      if (!built(up) && !built(down)) kept.push_back(i);
    }
    all = select(all, kept);
  }
  clouds.lidar = voxel_mean(all, kLidarVoxel_m);
  clouds.lidar_path_m = std::move(clouds.lidar.intensities);
  clouds.lidar.intensities.clear();
  return {};
}

}  // namespace

Expected<SceneClouds> make_scene(const SceneOptions& options, const RunContext& ctx) {
  HF_TRY(SimulationOptions simulation, simulation_preset("paper"));
  Random random(options.seed, "benchmark/scene");
  simulation.world.variant = options.variant;
  simulation.world.size_m = random.uniform(80.0, 110.0);
  simulation.world.main_building = 0;
  simulation.world.blocks_x = options.blocks_x;
  simulation.world.relief_m = options.relief_m;
  simulation.drive.duration_s = 80.0;
  simulation.lidar.range_sd_m *= options.noise;
  const World world = generate_town(simulation.world, options.seed);
  const RayTracer tracer(world.scene);
  SceneClouds clouds;
  add_photos(world, tracer, simulation, options, ctx, clouds);
  const Expected<void> driven = add_drive(world, tracer, simulation, options, ctx, clouds);
  if (!driven) return std::unexpected(driven.error());
  return clouds;
}

Expected<SceneClouds> SceneCache::get(const SceneOptions& options, const RunContext& ctx) {
  for (const auto& [known, clouds] : scenes_) {
    if (known == options) return clouds;
  }
  HF_TRY(SceneClouds clouds, make_scene(options, ctx));
  return scenes_.emplace_back(options, std::move(clouds)).second;
}

}  // namespace hybridfusion::benchmark
