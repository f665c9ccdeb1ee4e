#include "lidar_model.hpp"
#include "shading.hpp"
#include "truth_files.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kLidarStep_s = 0.4;
constexpr std::uint8_t kManyPhotos = 4;
// A surface counts as seen where beams hit it densely: not far off, not at a grazing angle.
constexpr double kLidarReach_m = 45.0;
constexpr float kLidarFacing = 0.12F;
constexpr float kPhotoFacing = 0.05F;

std::vector<TruthSample> draw_samples(const Scene& scene, double per_m2, std::uint64_t seed) {
  Random random(seed, "truth/samples");
  std::vector<TruthSample> samples;
  double owed = 0.5;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const auto& face = scene.faces[f];
    const Eigen::Vector3f& a = scene.vertices[face[0]];
    const Eigen::Vector3f ab = scene.vertices[face[1]] - a;
    const Eigen::Vector3f ac = scene.vertices[face[2]] - a;
    if (a.head<2>().cwiseAbs().maxCoeff() > scene.core_radius_m + 4.0) continue;
    // Undersides and inner faces that other solids cover are no surface of the scene.
    constexpr float kCovered = 0.02F;
    if (std::max({scene.ambient[face[0]], scene.ambient[face[1]], scene.ambient[face[2]]}) <
        kCovered) {
      continue;
    }
    const double area = 0.5 * static_cast<double>(ab.cross(ac).norm());
    if (area < 1e-8) continue;
    for (owed += area * per_m2; owed >= 1.0; owed -= 1.0) {
      auto u = static_cast<float>(random.uniform());
      auto v = static_cast<float>(random.uniform());
      if (u + v > 1.0F) {
        u = 1.0F - u;
        v = 1.0F - v;
      }
      samples.push_back(
          {.point = a + u * ab + v * ac,
           .normal = face_normal(scene, f),
           .label = static_cast<std::uint8_t>(scene.surfaces[scene.face_surface[f]].label)});
    }
  }
  return samples;
}

/// Free line of sight. Leaves are seen from both sides.
bool sees(const RayTracer& tracer,
          const TruthSample& sample,
          const Eigen::Vector3d& eye,
          float least_facing) {
  const Eigen::Vector3f to_eye = eye.cast<float>() - sample.point;
  const float distance = to_eye.norm();
  const Eigen::Vector3f direction = to_eye / distance;
  const float facing = sample.normal.dot(direction);
  const bool leaf = sample.label == static_cast<std::uint8_t>(FaceLabel::kVegetation);
  if (facing < least_facing && !(leaf && facing < -least_facing)) return false;
  const Eigen::Vector3f start = sample.point + (facing > 0 ? 0.004F : -0.004F) * sample.normal;
  return !tracer.blocked(start, direction, 0.0F, distance);
}

}  // namespace

Expected<std::vector<TruthSample>> sample_truth(const Scene& scene,
                                                const RayTracer& tracer,
                                                const SimulationOptions& options,
                                                const PinholeCamera& camera,
                                                const std::vector<Shot>& shots,
                                                const VehicleSetup& vehicle,
                                                const std::vector<DriveRecord>& drives,
                                                const RunContext& ctx) {
  std::vector<TruthSample> samples = draw_samples(scene, options.samples_per_m2, ctx.seed);
  std::vector<Rigid3> cameras_from_world;
  for (const Shot& shot : shots) cameras_from_world.push_back(shot.world_from_camera.inverse());
  std::vector<Rigid3> world_from_lidars;
  for (const DriveRecord& drive : drives) {
    for (double time = 0.0; time < drive.motion.duration_s(); time += kLidarStep_s) {
      const Rigid3 pose = drive.motion.at(time).world_from_body * vehicle.body_from_lidar();
      const bool moved = world_from_lidars.empty() ||
                         (pose.translation - world_from_lidars.back().translation).norm() > 0.3;
      if (moved) world_from_lidars.push_back(pose);
    }
  }
  const auto look = [&](TruthSample& sample) {
    const Eigen::Vector3d point = sample.point.cast<double>();
    Eigen::Vector2d pixel;
    for (std::size_t i = 0; i < shots.size() && sample.drone < kManyPhotos; ++i) {
      if (!camera.project(cameras_from_world[i] * point, pixel)) continue;
      if (sees(tracer, sample, shots[i].world_from_camera.translation, kPhotoFacing))
        ++sample.drone;
    }
    for (const Rigid3& world_from_lidar : world_from_lidars) {
      if ((world_from_lidar.translation - point).squaredNorm() > kLidarReach_m * kLidarReach_m) {
        continue;
      }
      if (!in_field_of_view(options.lidar, world_from_lidar.inverse() * point)) continue;
      if (!sees(tracer, sample, world_from_lidar.translation, kLidarFacing)) continue;
      sample.vehicle = 1;
      return;
    }
  };
  constexpr std::size_t kSlab = 1U << 16U;
  for (std::size_t slab = 0; slab < samples.size(); slab += kSlab) {
    const std::size_t count = std::min(kSlab, samples.size() - slab);
    parallel_for(ctx, count, 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = slab + begin; i < slab + end; ++i) look(samples[i]);
    });
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while sampling the truth");
    ctx.report({.stage = "simulate/truth",
                .done = static_cast<std::int64_t>(slab + count),
                .total = static_cast<std::int64_t>(samples.size())});
  }
  return samples;
}

}  // namespace hybridfusion
