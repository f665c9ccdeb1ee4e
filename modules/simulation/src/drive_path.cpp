#include "drive_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

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

/// Curvature of a closed way over a metre to either side [1/m].
double curvature(const std::vector<Eigen::Vector2d>& loop, std::size_t i) {
  constexpr auto kReach = static_cast<std::size_t>(1.0 / kPathStep_m);
  const std::size_t n = loop.size();
  const Eigen::Vector2d first = loop[i % n] - loop[(i + n - kReach) % n];
  const Eigen::Vector2d second = loop[(i + kReach) % n] - loop[i % n];
  const double turn =
      std::atan2(first.x() * second.y() - first.y() * second.x(), first.dot(second));
  return std::abs(turn) / std::max(kPathStep_m, 0.5 * (first.norm() + second.norm()));
}

std::size_t start_index(const std::vector<Eigen::Vector2d>& loop, const RouteStart& start) {
  constexpr double kCorner_per_m = 1.0 / 12.0;     // corners are 5 m wide
  constexpr double kStraight_per_m = 1.0 / 500.0;  // 30 m/s feel 1.8 m/s^2
  const auto first = static_cast<std::size_t>(start.share * static_cast<double>(loop.size()));
  if (start.place == "random") return first;
  const std::size_t end = first + loop.size();
  std::size_t i = first;
  while (i < end && curvature(loop, i) < kCorner_per_m) ++i;
  if (start.place == "corner") return i;
  while (i < end && curvature(loop, i) > kStraight_per_m) ++i;
  return i;
}

/// Once around a closed way, and `extra_m` on.
DrivePlan around(const std::vector<Eigen::Vector2d>& loop, const RouteStart& from, double extra_m) {
  const std::size_t start = start_index(loop, from);
  const auto extra = static_cast<std::size_t>(extra_m / kPathStep_m);
  DrivePlan drive;
  for (std::size_t i = 0; i < loop.size() + extra; ++i) {
    drive.path.push_back(loop[(start + i) % loop.size()]);
  }
  return drive;
}

}  // namespace

DrivePlan plan_figure_eight(const StreetPlan& plan, double extra_m, const RouteStart& start) {
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
  return around(smoothed_loop(resampled(corners), kCornerSigma_m), start, extra_m);
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
                     const RouteStart& start) {
  const double lane = free_lane_m(plan);
  Eigen::Vector2d low(plan.street_x[blocks[0]] + lane, plan.street_y[blocks[2]] + lane);
  Eigen::Vector2d high(plan.street_x[blocks[1]] + lane, plan.street_y[blocks[3]] + lane);
  if (!plan.streets) {
    low = -0.6 * plan.core_half_m;
    high = 0.6 * plan.core_half_m;
  }
  const std::vector<Eigen::Vector2d> loop = smoothed_loop(
      resampled({low, {high.x(), low.y()}, high, {low.x(), high.y()}}), kCornerSigma_m);
  return around(loop, start, extra_m);
}

void add_weave(double amplitude_m, double speed_mps, DrivePlan& plan) {
  if (amplitude_m == 0.0 || plan.path.size() < 3) return;
  constexpr double kLateral_mps2 = 1.5;
  constexpr double kShortest_m = 20.0;
  // A sine of length L bends by amplitude * (2 pi / L)^2 at its crests.
  const double length_m = std::max(
      kShortest_m, 2.0 * std::numbers::pi * speed_mps * std::sqrt(amplitude_m / kLateral_mps2));
  const std::vector<Eigen::Vector2d> straight = plan.path;
  for (std::size_t i = 0; i < straight.size(); ++i) {
    const Eigen::Vector2d along =
        (straight[std::min(i + 1, straight.size() - 1)] - straight[i == 0 ? 0 : i - 1])
            .normalized();
    const double phase = 2.0 * std::numbers::pi * static_cast<double>(i) * kPathStep_m / length_m;
    plan.path[i] += amplitude_m * std::sin(phase) * Eigen::Vector2d(-along.y(), along.x());
  }
}

}  // namespace hybridfusion
