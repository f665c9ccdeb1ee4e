/// Memory and time of the registration against the area of the photo cloud
/// (docs/reference/registration-benchmark.md).

#include "process_meter.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

constexpr double kBlock_m = 80.0;  // from street to street
constexpr double kStreet_m = 12.0;
constexpr double kOverhang_m = 0.4;

/// An upright box, turned about its centre.
struct Building {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d half = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  double height_m = 0.0;
};

/// Buildings of one block, all different, on the lots of a street grid.
std::vector<Building> block_at(int column, int row, std::uint64_t seed) {
  Random random(seed, fmt::format("block {} {}", column, row));
  std::vector<Building> buildings;
  constexpr double kLot_m = (kBlock_m - kStreet_m) / 3.0;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      if (random.uniform() < 0.25) continue;  // a yard
      const Eigen::Vector2d lot =
          kLot_m * Eigen::Vector2d(x + 0.5, y + 0.5) +
          Eigen::Vector2d(column * kBlock_m + 0.5 * kStreet_m, row * kBlock_m + 0.5 * kStreet_m);
      buildings.push_back(
          {.centre = lot + Eigen::Vector2d(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)),
           .half = {random.uniform(4.0, 9.0), random.uniform(4.0, 9.0)},
           .yaw_rad = random.uniform(-0.15, 0.15),
           .height_m = random.uniform(5.0, 20.0)});
    }
  }
  return buildings;
}

struct City {
  PointCloud vision = {};
  PointCloud lidar = {};  ///< In the world frame.
  std::vector<Eigen::Vector3d> sensors = {};
};

/// Ground and roofs as photos from above show them, one point in each square of `step_m`.
void see_from_above(const std::vector<Building>& buildings,
                    const Eigen::Vector2d& corner,
                    double step_m,
                    Random& random,
                    PointCloud& cloud) {
  for (double y = 0.0; y < kBlock_m; y += step_m) {
    for (double x = 0.0; x < kBlock_m; x += step_m) {
      const Eigen::Vector2d p = corner + Eigen::Vector2d(x, y) +
                                step_m * Eigen::Vector2d(random.uniform(), random.uniform());
      double height_m = 0.0;
      for (const Building& b : buildings) {
        const Eigen::Vector2d q =
            (Eigen::Rotation2Dd(-b.yaw_rad) * (p - b.centre)).cwiseAbs() - b.half;
        if ((q.array() < kOverhang_m).all()) height_m = b.height_m;
      }
      cloud.points.push_back(
          Eigen::Vector3d(p.x(), p.y(), height_m + 0.03 * random.normal()).cast<float>());
    }
  }
}

/// Street and walls within 40 m of a drive around the block that starts at `corner`.
void drive_around(const std::vector<Building>& buildings,
                  const Eigen::Vector2d& corner,
                  Random& random,
                  City& city) {
  constexpr double kReach_m = 40.0;
  const Eigen::Vector2d middle = corner + Eigen::Vector2d::Constant(0.5 * kBlock_m);
  for (int k = 0; k < 4; ++k) {
    const double angle = 0.5 * std::numbers::pi * k;
    const Eigen::Rotation2Dd turn(angle);
    for (double s = -0.5 * kBlock_m; s < 0.5 * kBlock_m; s += 2.0) {
      const Eigen::Vector2d p = middle + turn * Eigen::Vector2d(s, -0.5 * kBlock_m);
      city.sensors.emplace_back(p.x(), p.y(), 2.0);
      for (int i = 0; i < 120; ++i) {
        const Eigen::Vector2d q =
            p + turn * Eigen::Vector2d(random.uniform(0.0, 2.0), random.uniform(-5.0, 5.0));
        city.lidar.points.push_back(
            Eigen::Vector3d(q.x(), q.y(), 0.02 * random.normal()).cast<float>());
      }
    }
  }
  for (const Building& b : buildings) {
    for (int side = 0; side < 4; ++side) {
      const Eigen::Rotation2Dd turn(b.yaw_rad + 0.5 * std::numbers::pi * side);
      const double half = side % 2 == 0 ? b.half.x() : b.half.y();
      const double depth = side % 2 == 0 ? b.half.y() : b.half.x();
      const Eigen::Vector2d outward = turn * -Eigen::Vector2d::UnitY();
      for (double s = -half; s < half; s += 0.15) {
        const Eigen::Vector2d p = b.centre + turn * Eigen::Vector2d(s, -depth);
        const bool seen = std::ranges::any_of(city.sensors, [&](const Eigen::Vector3d& at) {
          const Eigen::Vector2d way = at.head<2>() - p;
          return way.norm() < kReach_m && way.dot(outward) > 0.0;
        });
        if (!seen) continue;
        for (double z = 0.2; z < b.height_m; z += 0.25) {
          const Eigen::Vector2d q = p + 0.02 * random.normal() * outward;
          city.lidar.points.push_back(Eigen::Vector3d(q.x(), q.y(), z).cast<float>());
        }
      }
    }
  }
}

City make_city(int blocks, double step_m, std::uint64_t seed) {
  City city;
  Random random(seed, "city");
  const int at_column = blocks / 2 + static_cast<int>(random.index(3)) - 1;
  const int at_row = blocks / 3;
  std::vector<Building> near;
  for (int row = 0; row < blocks; ++row) {
    for (int column = 0; column < blocks; ++column) {
      const std::vector<Building> block = block_at(column, row, seed);
      see_from_above(block, kBlock_m * Eigen::Vector2d(column, row), step_m, random, city.vision);
      if (std::abs(column - at_column) > 1 || std::abs(row - at_row) > 1) continue;
      near.insert(near.end(), block.begin(), block.end());
    }
  }
  drive_around(near, kBlock_m * Eigen::Vector2d(at_column, at_row), random, city);
  return city;
}

Expected<void> run_area(double side_m, double step_m, std::uint64_t seed, int threads) {
  City city = make_city(static_cast<int>(std::lround(side_m / kBlock_m)), step_m, seed);
  Random random(seed, "pose");
  Rigid3 truth;
  truth.rotation = Eigen::AngleAxisd(random.uniform(-std::numbers::pi, std::numbers::pi),
                                     Eigen::Vector3d::UnitZ());
  truth.translation = {random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), 3.0};
  const PointCloud lidar = transformed(truth.inverse(), std::move(city.lidar));
  RegistrationInput input;
  for (const Eigen::Vector3d& p : city.sensors) {
    input.sensor_positions.push_back(truth.inverse() * p);
  }
  RegistrationOptions options;
  options.max_yaw_rad = std::numbers::pi;  // and no coarse pose: anywhere
  const MemoryMeter memory;
  const double before = cpu_seconds();
  HF_TRY(const RegistrationResult result,
         register_cross_source(city.vision, lidar, input, options, {.num_threads = threads}));
  const double cpu_s = cpu_seconds() - before;
  const RegistrationErrors errors =
      registration_errors(truth, result.vision_from_lidar, centroid(lidar));
  fmt::print("| {:.2f} | {:.1f} | {} | {:.3f} m, {:.2f} deg | {:.2f} | {:.0f} | {:.1f} |\n",
             1e-6 * side_m * side_m,
             1e-6 * static_cast<double>(city.vision.size()),
             result.status == RegistrationStatus::kOk ? "ok" : "refused: " + result.reason,
             errors.at_centroid_m,
             errors.rotation_deg,
             result.score("peak_ratio").value_or(1.0),
             memory.peak_mb(),
             cpu_s);
  std::fflush(stdout);
  return {};
}

}  // namespace
}  // namespace hybridfusion::benchmark

int main(int argc, char** argv) try {
  std::vector<double> sides_m = {480.0, 960.0, 2000.0};
  double step_m = 0.5;
  std::uint64_t seed = 1;
  int threads = 1;
  CLI::App app("Registers one street loop in ever larger photo clouds without any coarse pose.");
  app.add_option("--sides", sides_m, "Sides of the photo clouds [m]")->delimiter(',');
  app.add_option("--step", step_m, "Spacing of its points [m]")->capture_default_str();
  app.add_option("--seed", seed, "Seed of city and pose")->capture_default_str();
  app.add_option("--threads", threads, "Threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  fmt::print(
      "| area [km2] | vision points [M] | answer | error | second / best peak | memory above the "
      "clouds [MB] | CPU s |\n|---|---|---|---|---|---|---|\n");
  for (const double side_m : sides_m) {
    const auto done = hybridfusion::benchmark::run_area(side_m, step_m, seed, threads);
    if (done) continue;
    fmt::print(stderr, "{}\n", done.error().message);
    return 1;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
