#pragma once

#include <hybridfusion/core/error.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// One occupied cell of the patch grid (HybridFusion III-C.1: p_g, p_l).
struct Patch {
  Eigen::Vector2i cell = Eigen::Vector2i::Zero();      ///< Column (x) and row (y).
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< Of its points [m].
  std::vector<std::uint32_t> indices = {};             ///< Into the gridded cloud, ascending.
};

/// A cloud cut into square columns.
struct PatchGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< Outer corner of cell (0, 0) [m].
  double step_m = 0.0;
  int columns = 0;
  int rows = 0;
  std::vector<Patch> patches = {};  ///< Occupied cells, row by row.
  std::vector<int> patch_of = {};   ///< Row-major cells: index into `patches`, or -1.

  /// Index into `patches`, or -1 for an empty or outside cell.
  [[nodiscard]] int patch_at(int column, int row) const;
};

/// Larger side [m] of the box in x-y that holds all but `cut_share` of the points on each side: far
/// stray points do not stretch the scene.
[[nodiscard]] double scene_size_m(std::span<const Eigen::Vector3f> points, double cut_share);

/// Cuts a cloud into columns of side `step_m` in x-y (HybridFusion III-C.1; the step is one tenth
/// of the scene size there). Points outside the box of scene_size_m belong to no patch.
/// @returns kInsufficient for an empty cloud, kInvalidOptions when the grid would exceed 10^6
/// cells. @pre step_m > 0, points are finite
/// @param shift  Of the grid's origin towards lower x and y, in steps of [0, 1).
[[nodiscard]] Expected<PatchGrid> grid_into_patches(std::span<const Eigen::Vector3f> points,
                                                    double step_m,
                                                    double cut_share,
                                                    const Eigen::Vector2d& shift = {0.0, 0.0});

/// Of the 8 patches around, those with at least `min_points` points; indices into grid.patches.
[[nodiscard]] std::vector<std::size_t> neighbours_of(const PatchGrid& grid,
                                                     std::size_t patch,
                                                     std::size_t min_points);

/// Point indices of a patch and its 8 neighbours, patch by patch in row order (Algorithm 1,
/// splicing_neighbors).
[[nodiscard]] std::vector<std::uint32_t> splice_neighbours(const PatchGrid& grid,
                                                           std::size_t patch);

}  // namespace hybridfusion
