#include "pair_disturbances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace hybridfusion::benchmark {
namespace {

void keep_lidar(SceneClouds& clouds, const std::vector<std::size_t>& kept) {
  clouds.lidar = select(clouds.lidar, kept);
  std::vector<float> path;
  path.reserve(kept.size());
  for (const std::size_t i : kept) path.push_back(clouds.lidar_path_m[i]);
  clouds.lidar_path_m = std::move(path);
}

}  // namespace

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

void add_drift(SceneClouds& clouds, double drift, Random& random) {
  const double bearing = random.uniform(0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3f along(
      static_cast<float>(std::cos(bearing)), static_cast<float>(std::sin(bearing)), 0.2F);
  for (std::size_t i = 0; i < clouds.lidar.size(); ++i) {
    clouds.lidar.points[i] += static_cast<float>(drift) * clouds.lidar_path_m[i] * along;
  }
}

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

}  // namespace hybridfusion::benchmark
