#include "comparison_files.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kVoxel_m = 0.2;
constexpr float kHalfThickness_m = 0.25F;
constexpr float kFar_m = 1.0F;

/// Rows of the points within half a slice of the two vertical planes through `centre`.
void add_slices(std::string_view cloud_name,
                const std::vector<Eigen::Vector3f>& points,
                const Eigen::Vector3d& centre,
                std::string& text) {
  constexpr std::array<std::string_view, 2> kNames = {"east", "north"};
  for (int along = 0; along < 2; ++along) {
    const auto plane = static_cast<float>(centre[1 - along]);
    for (const Eigen::Vector3f& p : points) {
      if (std::abs(p[1 - along] - plane) > kHalfThickness_m) continue;
      fmt::format_to(std::back_inserter(text),
                     "{},{},{:.3f},{:.3f}\n",
                     kNames[static_cast<std::size_t>(along)],
                     cloud_name,
                     p[along],
                     p.z());
    }
  }
}

Expected<void> write_difference(const std::filesystem::path& path,
                                const PointCloud& vision,
                                PointCloud lidar,
                                const RunContext& ctx) {
  const KdTree tree(vision.points);
  lidar.intensities.resize(lidar.size());
  parallel_for(ctx, lidar.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float distance_m = std::sqrt(tree.nearest(lidar.points[i]).squared_distance_m2);
      lidar.intensities[i] = std::min(kFar_m, distance_m);
    }
  });
  return write_ply(
      path, lidar, {.comments = {"intensity: distance to the vision cloud [m], cut at 1"}});
}

}  // namespace

Expected<void> write_comparison(const Workspace& workspace,
                                const RegisteredPair& pair,
                                const RunContext& ctx) {
  const PointCloud vision = voxel_mean({.points = pair.vision.points}, kVoxel_m);
  const PointCloud lidar = voxel_mean({.points = pair.lidar.points}, kVoxel_m);
  const PointCloud after = transformed(pair.vision_from_lidar, lidar);
  if (vision.empty() || after.empty()) return {};
  if (auto made = workspace.make_folder("evaluation"); !made) return made;
  std::string text = "section,cloud,along_m,height_m\n";
  const Eigen::Vector3d centre = centroid(after);
  add_slices("vision", vision.points, centre, text);
  if (pair.initial) {
    add_slices("lidar_before", transformed(*pair.initial, lidar).points, centre, text);
  }
  add_slices("lidar_after", after.points, centre, text);
  if (auto written = write_file_atomically(workspace.path(workspace_file::kCrossSection), text);
      !written) {
    return written;
  }
  return write_difference(workspace.path(workspace_file::kDifference), vision, after, ctx);
}

}  // namespace hybridfusion
