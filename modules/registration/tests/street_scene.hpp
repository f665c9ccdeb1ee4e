#pragma once

/// @file
/// Seeded synthetic blocks for tests: rotated boxes with overhanging roofs, trees, a sloping
/// ground, seen by a drone from above (roofs, open ground, few facades) and by a vehicle on a loop
/// (facades, street, tree crowns). Both clouds are in one frame, so the true pose is the identity.

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace hybridfusion::test {

struct SceneOptions {
  double half_extent_m = 45.0;        ///< Of the vision cloud.
  double lidar_half_extent_m = 60.0;  ///< Buildings and LiDAR points reach this far.
  int buildings = 40;                 ///< Attempts; those that overlap are dropped.
  int trees = 15;
  double overhang_m = 0.4;
  double vision_noise_m = 0.03;
  double lidar_noise_m = 0.02;
  double facade_share = 0.3;  ///< Of facade points that the photos show.
  double slope = 0.02;
  bool is_straight_canyon = false;  ///< Two endless walls instead of buildings.
};

struct Scene {
  PointCloud vision = {};
  PointCloud lidar = {};
  std::vector<Eigen::Vector3d> sensor_positions = {};
};

namespace detail {

struct Box {
  Eigen::Vector2d centre;
  Eigen::Vector2d half;
  double angle;
  double height;

  [[nodiscard]] Eigen::Vector2d local(const Eigen::Vector2d& p) const {
    return Eigen::Rotation2D<double>(-angle) * (p - centre);
  }
  [[nodiscard]] bool contains(const Eigen::Vector2d& p, double margin) const {
    const Eigen::Vector2d q = local(p).cwiseAbs();
    return q.x() < half.x() + margin && q.y() < half.y() + margin;
  }
  /// Distance along a ray to the first wall; infinite when missed.
  [[nodiscard]] double hit(const Eigen::Vector2d& from, const Eigen::Vector2d& direction) const {
    const Eigen::Vector2d o = local(from);
    const Eigen::Vector2d d = Eigen::Rotation2D<double>(-angle) * direction;
    double enter = 0.0;
    double leave = 1e9;
    for (int axis = 0; axis < 2; ++axis) {
      const double speed = std::abs(d[axis]) < 1e-12 ? 1e-12 : d[axis];
      const double a = (-half[axis] - o[axis]) / speed;
      const double b = (half[axis] - o[axis]) / speed;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter < leave && enter > 0.0 ? enter : 1e9;
  }
};

struct Tree {
  Eigen::Vector2d centre;
  double radius;
  double height;
};

struct World {
  std::vector<Box> boxes;
  std::vector<Tree> trees;
  std::vector<Eigen::Vector2d> path;
  double slope;

  [[nodiscard]] double ground(const Eigen::Vector2d& p) const {
    return 2.0 + slope * p.x() - 0.5 * slope * p.y();
  }
};

inline World make_world(std::uint64_t seed, const SceneOptions& options) {
  Random random(seed, "street-scene");
  World world{.boxes = {}, .trees = {}, .path = {}, .slope = options.slope};
  const double extent = options.lidar_half_extent_m;
  const double turn = random.uniform(0.0, std::numbers::pi / 2.0);
  if (options.is_straight_canyon) {
    for (double y = -0.4 * extent; y <= 0.4 * extent; y += 1.0) world.path.emplace_back(0.0, y);
    for (const double side : {-1.0, 1.0}) {
      world.boxes.push_back({{side * 15.0, 0.0}, {8.0, 3.0 * extent}, 0.0, 12.0});
    }
    return world;
  }
  const double a = random.uniform(18.0, 28.0);
  const double b = random.uniform(14.0, 24.0);
  const Eigen::Rotation2D<double> rotate(turn);
  // A superellipse: a loop with rounded corners.
  for (int k = 0; k < 140; ++k) {
    const double t = 2.0 * std::numbers::pi * k / 140.0;
    const auto corner = [](double v) { return std::copysign(std::sqrt(std::abs(v)), v); };
    world.path.push_back(rotate *
                         Eigen::Vector2d(a * corner(std::cos(t)), b * corner(std::sin(t))));
  }
  const auto is_clear = [&](const Box& box) {
    const auto on_street = [&](const Eigen::Vector2d& p) { return box.contains(p, 4.0); };
    const auto overlaps = [&](const Box& other) {
      return (other.centre - box.centre).norm() < other.half.norm() + box.half.norm();
    };
    return std::ranges::none_of(world.path, on_street) &&
           std::ranges::none_of(world.boxes, overlaps);
  };
  for (int k = 0; k < options.buildings; ++k) {
    const Box box{{random.uniform(-extent, extent), random.uniform(-extent, extent)},
                  {random.uniform(3.0, 9.0), random.uniform(3.0, 9.0)},
                  turn + random.uniform(-0.3, 0.3),
                  random.uniform(4.0, 16.0)};
    if (is_clear(box)) world.boxes.push_back(box);
  }
  for (int k = 0; k < options.trees; ++k) {
    const Tree tree{{random.uniform(-extent, extent), random.uniform(-extent, extent)},
                    random.uniform(1.5, 3.0),
                    random.uniform(5.0, 9.0)};
    const auto covers = [&](const Box& box) { return box.contains(tree.centre, tree.radius); };
    const auto on_street = [&](const Eigen::Vector2d& p) { return (p - tree.centre).norm() < 3.5; };
    if (std::ranges::none_of(world.boxes, covers) && std::ranges::none_of(world.path, on_street)) {
      world.trees.push_back(tree);
    }
  }
  return world;
}

inline PointCloud drone_view(const World& world, const SceneOptions& options, Random& random) {
  PointCloud cloud;
  const auto add = [&](const Eigen::Vector2d& p, double z) {
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d point = Eigen::Vector3d(p.x(), p.y(), z) + options.vision_noise_m * noise;
    cloud.points.emplace_back(point.cast<float>());
  };
  const double extent = options.half_extent_m;
  for (double x = -extent; x < extent; x += 0.25) {
    for (double y = -extent; y < extent; y += 0.25) {
      const Eigen::Vector2d p(x + random.uniform(0.0, 0.2), y + random.uniform(0.0, 0.2));
      double z = world.ground(p);
      for (const Tree& tree : world.trees) {
        const double inside = 1.0 - (p - tree.centre).squaredNorm() / (tree.radius * tree.radius);
        if (inside > 0.0) {
          z = world.ground(tree.centre) + tree.height - tree.radius +
              tree.radius * std::sqrt(inside);
        }
      }
      for (const Box& box : world.boxes) {
        if (box.contains(p, options.overhang_m)) z = world.ground(box.centre) + box.height;
      }
      add(p, z);
    }
  }
  for (const Box& box : world.boxes) {
    for (double t = 0.0; t < 4.0; t += 0.25 / (box.half.x() + box.half.y())) {
      const double s = 2.0 * (t - std::floor(t)) - 1.0;
      const int side = static_cast<int>(t);
      const Eigen::Vector2d q = side % 2 == 0
                                    ? Eigen::Vector2d(s * box.half.x(), (side - 1) * box.half.y())
                                    : Eigen::Vector2d((side - 2) * box.half.x(), s * box.half.y());
      const Eigen::Vector2d p = box.centre + Eigen::Rotation2D<double>(box.angle) * q;
      if (p.cwiseAbs().maxCoeff() > extent) continue;
      for (double h = 0.0; h < box.height; h += 0.25) {
        if (random.uniform() < options.facade_share) add(p, world.ground(p) + h);
      }
    }
  }
  return cloud;
}

inline PointCloud vehicle_view(const World& world, const SceneOptions& options, Random& random) {
  constexpr double kSensorHeight_m = 1.8;
  constexpr double kRange_m = 50.0;
  PointCloud cloud;
  const auto add = [&](const Eigen::Vector2d& p, double z) {
    if (p.cwiseAbs().maxCoeff() > options.lidar_half_extent_m) return;
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d point = Eigen::Vector3d(p.x(), p.y(), z) + options.lidar_noise_m * noise;
    cloud.points.emplace_back(point.cast<float>());
  };
  for (std::size_t k = 0; k < world.path.size(); k += 2) {
    const Eigen::Vector2d& from = world.path[k];
    for (int ray = 0; ray < 360; ++ray) {
      const double bearing = (ray + random.uniform()) * std::numbers::pi / 180.0;
      const Eigen::Vector2d direction(std::cos(bearing), std::sin(bearing));
      double range = kRange_m;
      const Box* wall = nullptr;
      for (const Box& box : world.boxes) {
        const double distance = box.hit(from, direction);
        if (distance < range) {
          range = distance;
          wall = &box;
        }
      }
      for (double d = 2.0 + random.uniform(); d < range; d *= 1.06) {
        const Eigen::Vector2d p = from + d * direction;
        add(p, world.ground(p));
      }
      for (const Tree& tree : world.trees) {
        const Eigen::Vector2d arm = tree.centre - from;
        const double along = arm.dot(direction);
        const double off = std::abs(arm.x() * direction.y() - arm.y() * direction.x());
        if (along < 0.0 || along > range || off > tree.radius) continue;
        const Eigen::Vector2d p =
            from + direction * (along - std::sqrt(tree.radius * tree.radius - off * off));
        for (double h = tree.height - 2.0 * tree.radius; h < tree.height; h += 0.3) {
          add(p + random.uniform(0.0, tree.radius) * direction, world.ground(p) + h);
        }
      }
      if (wall == nullptr) continue;
      const Eigen::Vector2d p = from + range * direction;
      const double top = std::min(wall->height, kSensorHeight_m + 0.5 * range);
      for (double h = random.uniform(0.0, 0.3); h < top; h += 0.3) add(p, world.ground(p) + h);
    }
  }
  return cloud;
}

}  // namespace detail

inline Scene make_scene(std::uint64_t seed, const SceneOptions& options = {}) {
  const detail::World world = detail::make_world(seed, options);
  Random random(seed, "street-scene/noise");
  Scene scene;
  scene.vision = detail::drone_view(world, options, random);
  scene.lidar = detail::vehicle_view(world, options, random);
  for (const Eigen::Vector2d& p : world.path) {
    scene.sensor_positions.emplace_back(p.x(), p.y(), world.ground(p) + 1.8);
  }
  return scene;
}

/// A rigid motion with any heading, 2 degrees of tilt and the given shift.
inline Rigid3 random_motion(std::uint64_t seed, double max_shift_m, double max_yaw_rad) {
  Random random(seed, "street-scene/motion");
  constexpr double kTilt = 2.0 * std::numbers::pi / 180.0;
  const Eigen::AngleAxisd yaw(random.uniform(-max_yaw_rad, max_yaw_rad), Eigen::Vector3d::UnitZ());
  const Eigen::AngleAxisd pitch(random.uniform(-kTilt, kTilt), Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd roll(random.uniform(-kTilt, kTilt), Eigen::Vector3d::UnitX());
  return {.rotation = Eigen::Quaterniond(yaw * pitch * roll),
          .translation = {random.uniform(-max_shift_m, max_shift_m),
                          random.uniform(-max_shift_m, max_shift_m),
                          random.uniform(-4.0, 4.0)}};
}

/// The points within `radius_m` of `centre` in x-y.
inline PointCloud cropped(const PointCloud& cloud, const Eigen::Vector3d& centre, double radius_m) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector2d gap = cloud.points[i].head<2>().cast<double>() - centre.head<2>();
    if (gap.norm() < radius_m) kept.push_back(i);
  }
  return select(cloud, kept);
}

}  // namespace hybridfusion::test
