#include "simulated_block.hpp"

#include <hybridfusion/core/trajectory.hpp>
#include <hybridfusion/io/tum.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

SimulationOptions drive_only() {
  SimulationOptions options = tiny_options();
  options.flight.enabled = false;
  options.lidar.columns = 60;
  options.world.ambient_rays = 4;
  options.samples_per_m2 = 0.5;
  return options;
}

/// The true way of the IMU of a drive with these options.
Trajectory true_way(const SimulationOptions& options, const std::string& name) {
  const fs::path folder = fresh_folder(name);
  const auto made = simulate(folder, options, {.seed = kSeed});
  EXPECT_TRUE(made) << made.error().message;
  const auto trajectory = read_tum(folder / "truth/trajectory_imu.tum");
  EXPECT_TRUE(trajectory);
  fs::remove_all(folder);
  return trajectory ? *trajectory : Trajectory{};
}

/// Largest angle between an axis of the IMU and where it pointed at the start [rad].
double largest_tilt_rad(const Trajectory& way, std::size_t begin, std::size_t end) {
  const Eigen::Vector3d up =
      way.poses.front().map_from_body.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  double largest = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    const double cosine = (way.poses[i].map_from_body.rotation * up).z();
    largest = std::max(largest, std::acos(std::min(1.0, cosine)));
  }
  return largest;
}

TEST(DriveKinds, AFigureEightTurnsOnceRoundToEitherSide) {
  SimulationOptions options = drive_only();
  options.world.blocks_x = 2;
  options.drive.route = "figure-eight";
  options.drive.duration_s = 60.0;
  const Trajectory way = true_way(options, "eight");
  ASSERT_GT(way.poses.size(), 1000U);
  double left_rad = 0.0;
  double right_rad = 0.0;
  for (std::size_t i = 1; i < way.poses.size(); ++i) {
    const Eigen::Quaterniond turn =
        way.poses[i].map_from_body.rotation * way.poses[i - 1].map_from_body.rotation.conjugate();
    const double yaw = 2.0 * turn.z() * (turn.w() < 0.0 ? -1.0 : 1.0);
    (yaw > 0.0 ? left_rad : right_rad) += std::abs(yaw);
  }
  // Right angles at the corners and bumps of the road besides.
  EXPECT_NEAR(left_rad, 2.0 * std::numbers::pi, 1.0);
  EXPECT_NEAR(right_rad, 2.0 * std::numbers::pi, 1.0);
}

TEST(DriveKinds, ASwingingDriveTiltsAsFarAsAskedForButNotWhileItStands) {
  SimulationOptions options = drive_only();
  const Trajectory level = true_way(options, "level");
  options.drive.swing_deg = 15.0;
  const Trajectory swinging = true_way(options, "swinging");
  ASSERT_EQ(level.poses.size(), swinging.poses.size());
  constexpr double kDegree = std::numbers::pi / 180.0;
  const std::size_t still = 200;  // poses at 100 Hz
  EXPECT_LT(largest_tilt_rad(swinging, 0, still), 0.5 * kDegree);
  EXPECT_LT(largest_tilt_rad(level, 0, level.poses.size()), 6.0 * kDegree);
  const double tilt = largest_tilt_rad(swinging, 0, swinging.poses.size());
  EXPECT_GT(tilt, 12.0 * kDegree);
  EXPECT_LT(tilt, 28.0 * kDegree);  // roll and pitch of 15 together, slope and curves besides
  for (std::size_t i = 0; i < level.poses.size(); i += 100) {
    EXPECT_LT(
        (level.poses[i].map_from_body.translation - swinging.poses[i].map_from_body.translation)
            .norm(),
        0.2);
  }
}

TEST(DriveKinds, ATunnelIsStraightAndClosedAllAround) {
  SimulationOptions options = drive_only();
  options.world.variant = "tunnel";
  options.world.size_m = 100.0;
  const fs::path folder = fresh_folder("tunnel");
  ASSERT_TRUE(simulate(folder, options, {.seed = kSeed}));
  const auto way = read_tum(folder / "truth/trajectory_imu.tum");
  ASSERT_TRUE(way);
  const Eigen::Vector3d start = way->poses.front().map_from_body.translation;
  const Eigen::Vector3d end = way->poses.back().map_from_body.translation;
  EXPECT_GT((end - start).norm(), 20.0);  // what 16 s allow
  const Eigen::Vector3d along = (end - start).normalized();
  for (const StampedPose& pose : way->poses) {
    const Eigen::Vector3d from_start = pose.map_from_body.translation - start;
    EXPECT_LT((from_start - from_start.dot(along) * along).norm(), 1.5);  // the road's own waves
  }
  // Whatever looks across meets the lining within its width or height.
  const auto lidar = read_tum(folder / "truth/trajectory_lidar.tum");
  auto source = open_recording(folder / "street.bag");
  ASSERT_TRUE(lidar && source);
  std::size_t across = 0;
  for (auto message = (*source)->next(); message && *message; message = (*source)->next()) {
    const auto* scan = std::get_if<LidarScan>(&**message);
    if (scan == nullptr) continue;
    for (const LidarPoint& point : scan->points) {
      const auto pose = interpolate(*lidar, scan->stamp + Timestamp(point.offset_ns), 0.0);
      if (!pose) continue;
      const Eigen::Vector3d ray = pose->rotation * point.point_in_lidar.cast<double>();
      const Eigen::Vector3d sideways = ray - ray.dot(along) * along;
      ++across;
      EXPECT_LT(sideways.norm(), 10.0);  // 8.8 m wide, niches of 1.5 m, 5.5 m high
    }
  }
  EXPECT_GT(across, 20'000U);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace hybridfusion
