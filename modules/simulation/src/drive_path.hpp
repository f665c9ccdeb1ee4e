#pragma once

#include "terrain.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace hybridfusion {

inline constexpr double kPathStep_m = 0.25;

/// The way of a drive: points of the block frame, kPathStep_m apart.
struct DrivePlan {
  std::vector<Eigen::Vector2d> path = {};
};

/// Where on a loop a drive begins.
struct RouteStart {
  double share = 0.0;  ///< Of the loop, 0..1.
  std::string_view place =
      "random";  ///< Or the first "corner", or "straight" behind one, from there.
};

/// Way around the blocks between the street lines {first x, last x, first y, last y} in the free
/// lane, with rounded corners, and `extra_m` on after the loop has closed. Without streets: a loop
/// at 60 % of the area.
[[nodiscard]] DrivePlan plan_drive(const StreetPlan& plan,
                                   const std::array<std::size_t, 4>& blocks,
                                   double extra_m,
                                   const RouteStart& start);

/// Left around the first block, right around the second, twice through the street between them,
/// and `extra_m` on. @pre at least three streets along y
[[nodiscard]] DrivePlan plan_figure_eight(const StreetPlan& plan,
                                          double extra_m,
                                          const RouteStart& start);

/// Straight along x through the origin.
[[nodiscard]] DrivePlan plan_straight(double length_m, double lane_y_m);

/// Weaves to either side by up to `amplitude_m`, so gently that `speed_mps` can be held.
void add_weave(double amplitude_m, double speed_mps, DrivePlan& plan);

/// Convolution with a Gaussian of `sigma` samples; `wrap` for closed curves, else the ends are
/// held.
[[nodiscard]] std::vector<double> smoothed(const std::vector<double>& values,
                                           double sigma,
                                           bool wrap);

}  // namespace hybridfusion
