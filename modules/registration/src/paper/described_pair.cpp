#include "described_pair.hpp"

#include "isolated_points.hpp"

#include <utility>

namespace hybridfusion {
namespace {

CleanCloud cleaned(const GroundedCloud& cloud,
                   const Rigid3& vision_from_cloud,
                   const PaperOptions& options) {
  CleanCloud clean;
  for (const std::uint32_t i :
       supported_points(cloud.points, options.isolation_cell_m, options.min_supporting_points)) {
    clean.points.emplace_back((vision_from_cloud * cloud.points[i].cast<double>()).cast<float>());
    clean.heights.push_back(cloud.heights[i]);
  }
  return clean;
}

Expected<PatchedCloud> cut_into_patches(const CleanCloud& clean,
                                        double step_m,
                                        const Eigen::Vector2d& shift,
                                        const PaperOptions& options,
                                        const RunContext& ctx) {
  PatchedCloud cloud{.points = clean.points, .heights = clean.heights};
  HF_TRY(cloud.grid, grid_into_patches(cloud.points, step_m, options.cut_share, shift));
  HF_TRY(cloud.signatures, describe_patches(cloud.points, cloud.heights, cloud.grid, options, ctx));
  return cloud;
}

/// Origins of the LiDAR grids, in steps.
std::vector<Eigen::Vector2d> grid_shifts(const PaperOptions& options) {
  if (!changes_of(options).half_step_patches) return {Eigen::Vector2d::Zero()};
  return {{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}};
}

}  // namespace

Expected<DescribedPair> describe_pair(const GroundedCloud& vision,
                                      const GroundedCloud& lidar,
                                      const Rigid3& vision_from_lidar_coarse,
                                      const PaperOptions& options,
                                      const RunContext& ctx) {
  DescribedPair pair;
  pair.clean_vision = cleaned(vision, Rigid3{}, options);
  pair.clean_lidar = cleaned(lidar, vision_from_lidar_coarse, options);
  const double step_m = scene_size_m(pair.clean_vision.points, options.cut_share) /
                        options.grid_divisions;  // III-C.1
  if (!(step_m > 0.0)) {
    return fail(ErrorCode::kDegenerate, "the vision cloud has no extent in x and y");
  }
  ctx.report({.stage = "registration/paper/describe", .total = 2});
  HF_TRY(pair.vision,
         cut_into_patches(pair.clean_vision, step_m, Eigen::Vector2d::Zero(), options, ctx));
  ctx.report({.stage = "registration/paper/describe", .done = 1, .total = 2});
  for (const Eigen::Vector2d& shift : grid_shifts(options)) {
    HF_TRY(PatchedCloud cut, cut_into_patches(pair.clean_lidar, step_m, shift, options, ctx));
    pair.lidar.push_back(std::move(cut));
  }
  return pair;
}

}  // namespace hybridfusion
