#pragma once

#include "terrain.hpp"

#include <array>
#include <vector>

namespace hybridfusion {

inline constexpr double kPathStep_m = 0.25;

/// The way of a drive: points of the block frame, kPathStep_m apart.
struct DrivePlan {
  std::vector<Eigen::Vector2d> path = {};
};

/// Way around the blocks between the street lines {first x, last x, first y, last y} in the free
/// lane, with rounded corners, and `extra_m` on after the loop has closed. It begins at
/// `start_share` (0..1) of the loop. Without streets: a loop at 60 % of the area.
[[nodiscard]] DrivePlan plan_drive(const StreetPlan& plan,
                                   const std::array<std::size_t, 4>& blocks,
                                   double extra_m,
                                   double start_share);

/// Left around the first block, right around the second, twice through the street between them;
/// begins at `start_share` (0..1) of the way. @pre at least three streets along y
[[nodiscard]] DrivePlan plan_figure_eight(const StreetPlan& plan, double start_share);

/// Straight along x through the origin.
[[nodiscard]] DrivePlan plan_straight(double length_m, double lane_y_m);

/// Convolution with a Gaussian of `sigma` samples; `wrap` for closed curves, else the ends are
/// held.
[[nodiscard]] std::vector<double> smoothed(const std::vector<double>& values,
                                           double sigma,
                                           bool wrap);

}  // namespace hybridfusion
