#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// Takes some points; every batch of a cloud has the same channels. `distances_m` is empty or as
/// long as the batch: how far each point is from the other cloud.
using PointBatchVisitor =
    std::function<Expected<void>(const PointCloud& batch, std::span<const float> distances_m)>;
/// Hands a whole cloud to the visitor batch by batch, ending with the visitor's first error.
using PointBatches = std::function<Expected<void>(const PointBatchVisitor&)>;

struct OctreeOptions {
  int cells_per_side = 128;            ///< An inner node keeps one point per cell of this grid.
  std::size_t max_leaf_points = 8192;  ///< A node with fewer points has no children.
  double scale_m = 0.001;              ///< Step of the stored coordinates.
  /// Points held in memory at a time (28 bytes each, twice); larger subtrees are split on disk.
  std::size_t max_memory_points = 8'000'000;
};

struct OctreeSummary {
  std::size_t num_points = 0;
  std::size_t num_nodes = 0;
  int depth = 0;  ///< Levels below the root.
  Eigen::Vector3d min_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d max_m = Eigen::Vector3d::Zero();
};

/// Names of the files of an octree, in its folder.
namespace octree_file {
inline constexpr std::string_view kMetadata = "metadata.json";
inline constexpr std::string_view kHierarchy = "hierarchy.bin";
inline constexpr std::string_view kPoints = "octree.bin";
}  // namespace octree_file

/// Writes a Potree 2.0 octree (Schuetz et al., "Fast out-of-core octree generation for massive
/// point clouds", 2020; encoding DEFAULT, uncompressed): every point lies in exactly one node, a
/// node refines its parent. Attributes: position, rgb, and intensity, classification (0 vision, 1
/// LiDAR) and distance [m] where the cloud has them. `folder` must exist; metadata.json is written
/// last.
/// @returns kInsufficient for a cloud without a point; kCancelled; kIo; errors of `points`.
[[nodiscard]] Expected<OctreeSummary> write_octree(const std::filesystem::path& folder,
                                                   const PointBatches& points,
                                                   const OctreeOptions& options,
                                                   const RunContext& ctx);

}  // namespace hybridfusion
