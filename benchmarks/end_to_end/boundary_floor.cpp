/// Boundary accuracy of HybridFusion IV-A against pose errors that were put in on purpose: a table
/// of what the metric says at the true pose and beside it (docs/explanation/evaluation.md).
///
///     boundary_floor [first seed] [scenes]

#include "pair_scene.hpp"

#include <hybridfusion/evaluation/boundary_accuracy.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

constexpr int kDirections = 6;
constexpr double kVoxel_m = 0.2;

struct Figures {
  double mean_m = 0.0;
  double share = 0.0;
  double trimmed_m = 0.0;
  double count = 0.0;

  void add(const BoundaryAccuracy& accuracy) {
    mean_m += accuracy.mean_m;
    share += accuracy.share_with_partner;
    trimmed_m += accuracy.trimmed_mean_m;
    count += 1.0;
  }
};

/// The true boundary of L moved by `shift_m` in several directions, or turned by `yaw_deg`.
void add_errors(const std::vector<Eigen::Vector2f>& vision,
                const std::vector<Eigen::Vector2f>& lidar,
                double shift_m,
                double yaw_deg,
                Figures& figures) {
  const int directions = shift_m > 0.0 ? kDirections : 1;
  const Eigen::Rotation2Df turn(static_cast<float>(yaw_deg * std::numbers::pi / 180.0));
  for (int k = 0; k < directions; ++k) {
    const double bearing = 2.0 * std::numbers::pi * k / directions;
    const Eigen::Vector2f shift =
        (shift_m * Eigen::Vector2d(std::cos(bearing), std::sin(bearing))).cast<float>();
    std::vector<Eigen::Vector2f> moved;
    for (const Eigen::Vector2f& p : lidar) moved.emplace_back(turn * p + shift);
    figures.add(boundary_accuracy(vision, moved, BoundaryAccuracyOptions{}.partner_m));
  }
}

int run(std::uint64_t first_seed, int scenes) {
  struct Row {
    double shift_m;
    double yaw_deg;
    Figures figures = {};
  };
  std::vector<Row> rows = {
      {0, 0}, {0.1, 0}, {0.2, 0}, {0.5, 0}, {1, 0}, {2, 0}, {5, 0}, {0, 1}, {0, 5}};
  const RunContext ctx{.num_threads = 1};
  for (int i = 0; i < scenes; ++i) {
    const auto clouds = make_scene({.seed = first_seed + static_cast<std::uint64_t>(i)}, ctx);
    if (!clouds) {
      fmt::print(stderr, "{}\n", clouds.error().message);
      return 1;
    }
    const BoundaryAccuracyOptions options;
    const PointCloud vision = concatenate(clouds->nadir, clouds->oblique);
    const auto vision_boundary =
        standing_boundary(voxel_mean(vision, kVoxel_m).points, options, ctx);
    const auto lidar_boundary =
        standing_boundary(voxel_mean(clouds->lidar, kVoxel_m).points, options, ctx);
    if (!vision_boundary || !lidar_boundary) continue;
    for (Row& row : rows) {
      add_errors(*vision_boundary, *lidar_boundary, row.shift_m, row.yaw_deg, row.figures);
    }
  }
  fmt::print(
      "| error put in | boundary accuracy [m] | share with a partner | mean of these [m] |\n"
      "|---|---|---|---|\n");
  for (const Row& row : rows) {
    const Figures& f = row.figures;
    if (f.count < 1.0) continue;
    fmt::print("| {} | {:.3f} | {:.2f} | {:.3f} |\n",
               row.yaw_deg > 0.0 ? fmt::format("{} deg of heading", row.yaw_deg)
                                 : fmt::format("{} m", row.shift_m),
               f.mean_m / f.count,
               f.share / f.count,
               f.trimmed_m / f.count);
  }
  return 0;
}

}  // namespace
}  // namespace hybridfusion::benchmark

int main(int argc, char** argv) try {
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : 1;
  const int scenes = argc > 2 ? std::stoi(argv[2]) : 1;
  return hybridfusion::benchmark::run(seed, scenes);
} catch (const std::exception& error) {
  std::fprintf(stderr, "usage: boundary_floor [first seed] [scenes]: %s\n", error.what());
  return 2;
}
