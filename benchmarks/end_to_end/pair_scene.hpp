#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion::benchmark {

/// A simulated block and how its two clouds come out.
struct SceneOptions {
  std::uint64_t seed = 1;
  std::string variant = "town";  ///< "town" or "flat".
  int blocks_x = 1;              ///< Blocks side by side; the vehicle drives around the first one.
  double relief_m = 1.0;
  double noise = 1.0;         ///< Factor on the noise of both clouds.
  bool buildings = true;      ///< false: everything built is taken out of both clouds.
  double lidar_reach_m = 80;  ///< Of the LiDAR around the vehicle.

  [[nodiscard]] bool operator==(const SceneOptions&) const = default;
};

/// What a photogrammetric and a mobile LiDAR pipeline would deliver, both in the world frame.
/// The photo cloud comes from rays of every photo with depth noise, a small offset per photo,
/// roofs fattened at their rims and most glass missing; the LiDAR cloud from scans along the drive
/// at their true poses.
struct SceneClouds {
  PointCloud nadir = {};    ///< Of the photos that look down.
  PointCloud oblique = {};  ///< Of the photos that look sideways.
  PointCloud lidar = {};
  std::vector<float> lidar_path_m = {};  ///< Distance driven when each LiDAR point was measured.
  std::vector<Eigen::Vector3d> sensor_positions = {};
};

[[nodiscard]] Expected<SceneClouds> make_scene(const SceneOptions& options, const RunContext& ctx);

/// Keeps the scenes of one seed, which many pairs share.
class SceneCache {
 public:
  [[nodiscard]] Expected<SceneClouds> get(const SceneOptions& options, const RunContext& ctx);
  void clear() { scenes_.clear(); }

 private:
  std::vector<std::pair<SceneOptions, SceneClouds>> scenes_ = {};
};

}  // namespace hybridfusion::benchmark
