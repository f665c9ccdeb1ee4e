#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// How the ground is told from roofs, facades and trees. Lengths in metres.
struct GroundOptions {
  double cell_m = 2.0;        ///< Ground candidates: one height per cell.
  double percentile = 0.08;   ///< Of the heights in a cell.
  int min_points = 5;         ///< Cells with fewer points have no candidate.
  double block_m = 20.0;      ///< The start plane sees the lowest cell of each block.
  double start_gate_m = 1.5;  ///< Residual gate of the first refit ...
  double final_gate_m = 0.4;  ///< ... shrinking to this one.
  double tile_m = 50.0;       ///< Spacing of the blended local corrections.
  int min_cells = 8;          ///< Fewer inlier cells: no ground.
};

template <>
struct OptionFields<GroundOptions> {
  using T = GroundOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::cell_m,
            {.key = "cell_m",
             .unit = "m",
             .min = 0.2,
             .max = 20.0,
             .doc = "Side of the cells that give one ground candidate each.",
             .source = "ours"}},
      Field{&T::percentile,
            {.key = "percentile",
             .unit = "1",
             .min = 0.0,
             .max = 0.5,
             .doc = "Share of a cell's points below its ground candidate.",
             .source = "ours"}},
      Field{&T::min_points,
            {.key = "min_points",
             .unit = "points",
             .min = 1.0,
             .max = 1e6,
             .doc = "Cells with fewer points give no candidate.",
             .source = "ours"}},
      Field{&T::block_m,
            {.key = "block_m",
             .unit = "m",
             .min = 1.0,
             .max = 200.0,
             .doc = "Blocks whose lowest cell starts the robust plane.",
             .source = "ours"}},
      Field{&T::start_gate_m,
            {.key = "start_gate_m",
             .unit = "m",
             .min = 0.1,
             .max = 20.0,
             .doc = "Residual gate of the first refit.",
             .source = "ours"}},
      Field{&T::final_gate_m,
            {.key = "final_gate_m",
             .unit = "m",
             .min = 0.05,
             .max = 5.0,
             .doc = "Residual gate of the last refit and of the inliers.",
             .source = "ours"}},
      Field{&T::tile_m,
            {.key = "tile_m",
             .unit = "m",
             .min = 10.0,
             .max = 1000.0,
             .doc = "Spacing of the blended local corrections that follow real terrain.",
             .source = "ours"}},
      Field{&T::min_cells,
            {.key = "min_cells",
             .unit = "cells",
             .min = 3.0,
             .max = 1e6,
             .doc = "With fewer inlier cells there is no ground.",
             .source = "ours"}},
  };
};

/// Smooth ground surface z(x, y): a quadratic about `centre` plus tile corrections (planes about
/// grid nodes, blended bilinearly). Outside the box of its inlier cells the curvature is frozen.
struct GroundModel {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();                           ///< [m]
  Eigen::Matrix<double, 6, 1> surface = Eigen::Matrix<double, 6, 1>::Zero();  ///< 1 x y xx xy yy.
  Eigen::Vector2d box_min = Eigen::Vector2d::Zero();  ///< Of the inlier cells [m].
  Eigen::Vector2d box_max = Eigen::Vector2d::Zero();
  double tile_m = 0.0;
  int tiles_x = 0;  ///< Nodes along x; 0: no corrections.
  int tiles_y = 0;
  std::vector<Eigen::Vector3d> tiles = {};  ///< Row-major by y: offset, slope x, slope y at a node.
  std::size_t num_cells = 0;                ///< Cells with a candidate.
  std::size_t num_inliers = 0;              ///< Candidates within the final gate.
  double rms_m = 0.0;                       ///< Of the inliers' residuals.

  /// Ground height [m] at (x, y) in the cloud's frame.
  [[nodiscard]] double height_at(double x, double y) const;
};

/// Ground of a cloud whose z axis is up to within some 15 degrees: a robust plane through low cells
/// (asymmetric Cauchy: 0.6 m above, 2.4 m below), then shrinking refits, linear before quadratic.
/// @returns kInsufficient when too few cells support one surface.
[[nodiscard]] Expected<GroundModel> fit_ground(std::span<const Eigen::Vector3f> points,
                                               const GroundOptions& options = {});

/// z - ground(x, y) of each point [m].
[[nodiscard]] std::vector<float> heights_above(const GroundModel& ground,
                                               std::span<const Eigen::Vector3f> points,
                                               const RunContext& ctx = {});

}  // namespace hybridfusion
