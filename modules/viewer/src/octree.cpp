#include "octree_output.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr int kMaxDepth = 20;  // cells below a micrometre: only equal points share a leaf there

/// The whole cloud, in memory as far as it may be there, and what it spans.
struct Intake {
  std::vector<OctreePoint> held = {};
  std::optional<PointSpill> spilled = {};  ///< Holds all points once they are too many.
  std::size_t num_points = 0;
  Eigen::Vector3f min_m = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Vector3f max_m = Eigen::Vector3f::Constant(-std::numeric_limits<float>::infinity());
  OctreeAttributes attributes = {};
};

Expected<void> spill(Intake& intake, const std::filesystem::path& folder) {
  HF_TRY(intake.spilled, PointSpill::create(folder));
  for (const OctreePoint& point : intake.held) {
    if (auto added = intake.spilled->add(point); !added) return added;
  }
  intake.held = {};
  return {};
}

Expected<void> take_in(const OctreePoint& point,
                       const std::filesystem::path& folder,
                       const OctreeOptions& options,
                       Intake& intake) {
  ++intake.num_points;
  intake.min_m = intake.min_m.cwiseMin(point.point);
  intake.max_m = intake.max_m.cwiseMax(point.point);
  OctreeAttributes& attributes = intake.attributes;
  attributes.max_intensity = std::max(attributes.max_intensity, point.intensity);
  attributes.max_distance_m = std::max(attributes.max_distance_m, point.distance_m);
  if (!intake.spilled && intake.num_points > options.max_memory_points) {
    if (auto moved = spill(intake, folder); !moved) return moved;
  }
  if (intake.spilled) return intake.spilled->add(point);
  intake.held.push_back(point);
  return {};
}

Expected<Intake> take_in(const PointBatches& points,
                         const std::filesystem::path& folder,
                         const OctreeOptions& options) {
  Intake intake;
  auto read =
      points([&](const PointCloud& batch, std::span<const float> distances_m) -> Expected<void> {
        intake.attributes.has_intensity = !batch.intensities.empty();
        intake.attributes.has_source = !batch.sources.empty();
        intake.attributes.has_distance = !distances_m.empty();
        for (std::size_t i = 0; i < batch.size(); ++i) {
          if (!batch.points[i].allFinite()) continue;
          OctreePoint point{.point = batch.points[i], .color = {200, 200, 200}};
          if (!batch.colors.empty()) point.color = batch.colors[i];
          if (!batch.intensities.empty()) point.intensity = batch.intensities[i];
          if (!batch.sources.empty()) point.source = batch.sources[i];
          if (!distances_m.empty()) point.distance_m = distances_m[i];
          if (auto taken = take_in(point, folder, options, intake); !taken) return taken;
        }
        return {};
      });
  if (!read) return std::unexpected(read.error());
  return intake;
}

/// A cube around the cloud, a little larger, so that rounding leaves no point outside.
OctreeCube root_cube(const Intake& cloud) {
  const Eigen::Vector3d size = (cloud.max_m - cloud.min_m).cast<double>();
  return {.min_m = cloud.min_m.cast<double>(), .side_m = std::max(1.0, 1.001 * size.maxCoeff())};
}

class OctreeBuilder {
 public:
  OctreeBuilder(const std::filesystem::path& folder,
                const OctreeOptions& options,
                const RunContext& ctx,
                OctreeOutput& output,
                std::size_t num_points)
      : folder_(folder), options_(options), ctx_(ctx), output_(output), total_(num_points) {}

  /// Points that fit into memory. @returns index of the subtree's root; reorders `points`.
  Expected<std::size_t> add_subtree(std::span<OctreePoint> points,
                                    const OctreeCube& cube,
                                    int depth) {
    if (points.size() <= options_.max_leaf_points || depth >= kMaxDepth) {
      return add_node(points, depth);
    }
    CellGrid grid(cube, options_.cells_per_side);
    const auto kept = std::stable_partition(
        points.begin(), points.end(), [&](const OctreePoint& p) { return grid.take(p.point); });
    const auto num_kept = static_cast<std::size_t>(kept - points.begin());
    HF_TRY(const std::size_t node, add_node(points.first(num_kept), depth));
    std::span<OctreePoint> rest = points.subspan(num_kept);
    std::ranges::stable_sort(
        rest, {}, [&](const OctreePoint& p) { return cube.octant_of(p.point); });
    for (int octant = 0; octant < 8 && !rest.empty(); ++octant) {
      const auto end = std::ranges::find_if(
          rest, [&](const OctreePoint& p) { return cube.octant_of(p.point) != octant; });
      const auto count = static_cast<std::size_t>(end - rest.begin());
      if (count == 0) continue;
      HF_TRY(const std::size_t child,
             add_subtree(rest.first(count), cube.child(octant), depth + 1));
      output_.set_child(node, octant, child);
      rest = rest.subspan(count);
    }
    return node;
  }

  /// Any number of points: beyond what memory holds, a level is split on disk.
  Expected<std::size_t> add_subtree(PointSpill& points, const OctreeCube& cube, int depth) {
    if (points.size() > options_.max_memory_points && depth < kMaxDepth) {
      return split_on_disk(points, cube, depth);
    }
    std::vector<OctreePoint> held;
    held.reserve(points.size());
    auto read = points.for_each([&](const OctreePoint& point) -> Expected<void> {
      held.push_back(point);
      return {};
    });
    if (!read) return std::unexpected(read.error());
    return add_subtree(held, cube, depth);
  }

 private:
  Expected<std::size_t> split_on_disk(PointSpill& points, const OctreeCube& cube, int depth) {
    CellGrid grid(cube, options_.cells_per_side);
    std::vector<OctreePoint> kept;
    std::array<std::optional<PointSpill>, 8> spills;
    auto read = points.for_each([&](const OctreePoint& point) -> Expected<void> {
      if (grid.take(point.point)) {
        kept.push_back(point);
        return {};
      }
      std::optional<PointSpill>& spill = spills[cube.octant_of(point.point)];
      if (!spill) {
        HF_TRY(spill, PointSpill::create(folder_));
      }
      return spill->add(point);
    });
    if (!read) return std::unexpected(read.error());
    HF_TRY(const std::size_t node, add_node(kept, depth));
    for (int octant = 0; octant < 8; ++octant) {
      std::optional<PointSpill>& spill = spills[octant];
      if (!spill) continue;
      HF_TRY(const std::size_t child, add_subtree(*spill, cube.child(octant), depth + 1));
      output_.set_child(node, octant, child);
      spill.reset();
    }
    return node;
  }

  Expected<std::size_t> add_node(std::span<const OctreePoint> points, int depth) {
    if (ctx_.stopped()) return fail(ErrorCode::kCancelled, "stopped while preparing the viewer");
    const std::size_t node = output_.add_node(points, depth);
    done_ += points.size();
    ctx_.report({.stage = "view/octree",
                 .done = static_cast<std::int64_t>(done_),
                 .total = static_cast<std::int64_t>(total_)});
    return node;
  }

  const std::filesystem::path& folder_;
  const OctreeOptions& options_;
  const RunContext& ctx_;
  OctreeOutput& output_;
  std::size_t total_;
  std::size_t done_ = 0;
};

}  // namespace

Expected<OctreeSummary> write_octree(const std::filesystem::path& folder,
                                     const PointBatches& points,
                                     const OctreeOptions& options,
                                     const RunContext& ctx) {
  HF_CHECK(options.cells_per_side > 0 && options.max_leaf_points > 0 && options.scale_m > 0.0);
  HF_TRY(Intake cloud, take_in(points, folder, options));
  if (cloud.num_points == 0) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: the cloud holds no point to show", folder.string()));
  }
  const OctreeCube cube = root_cube(cloud);
  HF_TRY(OctreeOutput output, OctreeOutput::create(folder, cube, cloud.attributes, options));
  OctreeBuilder builder(folder, options, ctx, output, cloud.num_points);
  HF_TRY(const std::size_t root,
         cloud.spilled ? builder.add_subtree(*cloud.spilled, cube, 0)
                       : builder.add_subtree(cloud.held, cube, 0));
  return output.finish(root);
}

}  // namespace hybridfusion
