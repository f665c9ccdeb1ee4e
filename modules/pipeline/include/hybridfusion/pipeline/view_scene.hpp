#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// A cloud of a workspace, to be shown.
struct ViewLayer {
  std::string name = {};            ///< "vision", "lidar" or "fused".
  std::filesystem::path file = {};  ///< The PLY it comes from.
  /// Hands the cloud over batch by batch; `distances_m` is empty or how far each point is from the
  /// other sensor's cloud (at most kMaxViewDistance_m). Every point has a colour; intensities are
  /// 0..1.
  std::function<Expected<void>(
      const std::function<Expected<void>(const PointCloud&, std::span<const float> distances_m)>&)>
      batches = {};
};

inline constexpr float kMaxViewDistance_m = 5.0F;

/// What the viewer shows of a workspace.
struct ViewScene {
  std::vector<ViewLayer> layers = {};
  /// Poses as 4x4 row-major: where each layer stands (the LiDAR cloud before and after the
  /// registration), cameras, trajectory, verdict.
  std::string json = {};
  /// Changes with every file that the layers are drawn from.
  std::string key = {};
};

/// Reads what a workspace holds, whichever stages ran. The shown frame is that of the vision cloud,
/// or of the LiDAR cloud where there is no other. Memory: one point per 0.1 m voxel of each cloud,
/// once a layer is asked for its batches.
/// @returns kNotFound when the folder holds no cloud; errors of damaged files.
[[nodiscard]] Expected<ViewScene> view_scene(const std::filesystem::path& root,
                                             const RunContext& ctx);

}  // namespace hybridfusion
