#pragma once

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/pipeline/view_scene.hpp>

#include <memory>
#include <mutex>
#include <optional>

namespace hybridfusion {

enum class ViewCloud : std::uint8_t { kVision, kLidar, kFused };

/// The clouds of a workspace as the viewer wants them: every point coloured, intensities stretched
/// to 0..1, and how far each point is from the other sensor's cloud.
class ViewClouds {
 public:
  /// An empty path: there is no such cloud.
  ViewClouds(std::filesystem::path vision,
             std::filesystem::path lidar,
             const Sim3& fused_from_vision,
             const Rigid3& fused_from_lidar,
             const RunContext& ctx);

  using Visitor = std::function<Expected<void>(const PointCloud&, std::span<const float>)>;
  [[nodiscard]] Expected<void> visit(const std::filesystem::path& path,
                                     ViewCloud cloud,
                                     bool compares,
                                     const Visitor& visitor);

 private:
  /// A cloud in short: one point per voxel in the fused frame, and its usual intensities.
  struct Digest {
    std::vector<Eigen::Vector3f> points = {};
    std::optional<KdTree> tree = {};
    float low_intensity = 0.0F;
    float high_intensity = 1.0F;
  };
  [[nodiscard]] Expected<const Digest*> digest(ViewCloud cloud);
  [[nodiscard]] Expected<Digest> make_digest(const std::filesystem::path& path,
                                             const Sim3& fused_from_cloud) const;
  [[nodiscard]] Expected<std::vector<float>> distances(const PointCloud& batch, ViewCloud cloud);

  std::filesystem::path vision_path_;
  std::filesystem::path lidar_path_;
  Sim3 fused_from_vision_;
  Sim3 fused_from_lidar_;
  RunContext ctx_;
  std::optional<Digest> vision_ = {};
  std::optional<Digest> lidar_ = {};
};

}  // namespace hybridfusion
