#include "drive_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hybridfusion {

/// Convolution with a Gaussian; `wrap` for closed curves, ends are held otherwise.
std::vector<double> smoothed(const std::vector<double>& values, double sigma, bool wrap) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  const auto n = static_cast<std::int64_t>(values.size());
  std::vector<double> weights;
  for (int k = -reach; k <= reach; ++k) weights.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
  double total = 0.0;
  for (const double weight : weights) total += weight;
  std::vector<double> out(values.size(), 0.0);
  for (std::int64_t i = 0; i < n; ++i) {
    for (int k = -reach; k <= reach; ++k) {
      const std::int64_t j =
          wrap ? ((i + k) % n + n) % n : std::clamp<std::int64_t>(i + k, 0, n - 1);
      out[static_cast<std::size_t>(i)] += weights[static_cast<std::size_t>(k + reach)] / total *
                                          values[static_cast<std::size_t>(j)];
    }
  }
  return out;
}

namespace {

/// Points `kPathStep_m` apart along a closed polygon.
std::vector<Eigen::Vector2d> resampled(const std::vector<Eigen::Vector2d>& polygon) {
  std::vector<Eigen::Vector2d> points;
  double carry = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double length = (b - a).norm();
    for (; carry < length; carry += kPathStep_m) points.push_back(a + carry / length * (b - a));
    carry -= length;
  }
  return points;
}

std::vector<Eigen::Vector2d> smoothed_loop(const std::vector<Eigen::Vector2d>& points,
                                           double sigma_m) {
  std::vector<double> x;
  std::vector<double> y;
  for (const auto& point : points) {
    x.push_back(point.x());
    y.push_back(point.y());
  }
  x = smoothed(x, sigma_m / kPathStep_m, true);
  y = smoothed(y, sigma_m / kPathStep_m, true);
  std::vector<Eigen::Vector2d> out;
  for (std::size_t i = 0; i < points.size(); ++i) out.emplace_back(x[i], y[i]);
  return out;
}

// Cars park on the +x and +y sides of the streets; the free lane is left of the middle.
double free_lane_m(const StreetPlan& plan) {
  return -0.12 * plan.street_width_m;
}

constexpr double kCornerSigma_m = 2.6;

/// Once around a closed way from `start_share` of it, and `extra_m` on.
DrivePlan around(const std::vector<Eigen::Vector2d>& loop, double start_share, double extra_m) {
  const auto start = static_cast<std::size_t>(start_share * static_cast<double>(loop.size()));
  const auto extra = static_cast<std::size_t>(extra_m / kPathStep_m);
  DrivePlan drive;
  for (std::size_t i = 0; i < loop.size() + extra; ++i) {
    drive.path.push_back(loop[(start + i) % loop.size()]);
  }
  return drive;
}

}  // namespace

DrivePlan plan_figure_eight(const StreetPlan& plan, double start_share) {
  const double lane = free_lane_m(plan);
  const auto corner = [&](std::size_t x, std::size_t y) {
    return Eigen::Vector2d(plan.street_x[x] + lane, plan.street_y[y] + lane);
  };
  const std::vector<Eigen::Vector2d> corners = {corner(1, 0),
                                                corner(1, 1),
                                                corner(0, 1),
                                                corner(0, 0),
                                                corner(1, 0),
                                                corner(1, 1),
                                                corner(2, 1),
                                                corner(2, 0)};
  return around(smoothed_loop(resampled(corners), kCornerSigma_m), start_share, 0.0);
}

DrivePlan plan_straight(double length_m, double lane_y_m) {
  DrivePlan drive;
  for (double x = -0.5 * length_m; x <= 0.5 * length_m; x += kPathStep_m) {
    drive.path.emplace_back(x, lane_y_m);
  }
  return drive;
}

DrivePlan plan_drive(const StreetPlan& plan,
                     const std::array<std::size_t, 4>& blocks,
                     double extra_m,
                     double start_share) {
  const double lane = free_lane_m(plan);
  Eigen::Vector2d low(plan.street_x[blocks[0]] + lane, plan.street_y[blocks[2]] + lane);
  Eigen::Vector2d high(plan.street_x[blocks[1]] + lane, plan.street_y[blocks[3]] + lane);
  if (!plan.streets) {
    low = -0.6 * plan.core_half_m;
    high = 0.6 * plan.core_half_m;
  }
  const std::vector<Eigen::Vector2d> loop = smoothed_loop(
      resampled({low, {high.x(), low.y()}, high, {low.x(), high.y()}}), kCornerSigma_m);
  return around(loop, start_share, extra_m);
}

}  // namespace hybridfusion
