#include "imu_vibration.hpp"
#include "simulated_block.hpp"

#include <hybridfusion/core/trajectory.hpp>
#include <hybridfusion/io/tum.hpp>

#include <cmath>
#include <numbers>
#include <set>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kGravity_mps2 = 9.80665;

struct Recorded {
  Trajectory truth = {};
  std::vector<ImuSample> imu = {};
  std::vector<GnssFix> gnss = {};
};

SimulationOptions rolling_options() {
  SimulationOptions options = tiny_options();
  options.flight.enabled = false;
  options.world.ambient_rays = 4;
  options.samples_per_m2 = 0.5;
  options.lidar.columns = 60;
  options.drive.duration_s = 8.0;
  options.drive.start_speed_mps = 10.0;
  options.drive.start_place = "straight";
  options.drive.bump_sd_m = 0.0;
  options.world.relief_m = 0.0;
  options.world.size_m = 120.0;
  // Differences between a sound and a faulty recording are then the fault alone.
  options.imu = {.rate_hz = 50.0,
                 .gyro_noise_density = 0,
                 .accel_noise_density = 0,
                 .gyro_bias_sd_radps = 0,
                 .accel_bias_sd_mps2 = 0,
                 .gyro_bias_walk = 0,
                 .accel_bias_walk = 0};
  return options;
}

Recorded record(const SimulationOptions& options, const std::string& name) {
  const fs::path folder = fresh_folder(name);
  const auto made = simulate(folder, options, {.seed = kSeed});
  EXPECT_TRUE(made) << made.error().message;
  Recorded out;
  if (const auto truth = read_tum(folder / "truth/trajectory_imu.tum")) out.truth = *truth;
  auto source = open_recording(folder / "street.bag");
  EXPECT_TRUE(source);
  for (auto message = (*source)->next(); message && *message; message = (*source)->next()) {
    if (const auto* imu = std::get_if<ImuSample>(&**message)) out.imu.push_back(*imu);
    if (const auto* fix = std::get_if<GnssFix>(&**message)) out.gnss.push_back(*fix);
  }
  fs::remove_all(folder);
  return out;
}

double speed_at(const Trajectory& way, std::size_t i) {
  const StampedPose& a = way.poses[i];
  const StampedPose& b = way.poses[i + 5];
  return (b.map_from_body.translation - a.map_from_body.translation).norm() /
         to_seconds(b.time - a.time);
}

TEST(RollingDrive, HasItsSpeedFromTheFirstSampleAndDoesNotStop) {
  const Recorded drive = record(rolling_options(), "rolling");
  ASSERT_GT(drive.truth.poses.size(), 500U);
  EXPECT_NEAR(speed_at(drive.truth, 0), 10.0, 0.1);
  EXPECT_NEAR(speed_at(drive.truth, 50), 10.0, 0.2);
  EXPECT_GT(speed_at(drive.truth, drive.truth.poses.size() - 6), 1.0);
}

TEST(RollingDrive, StartsTurningInACorner) {
  SimulationOptions options = rolling_options();
  options.drive.start_speed_mps = 3.0;
  options.drive.start_place = "corner";
  const Recorded drive = record(options, "corner");
  ASSERT_GT(drive.imu.size(), 100U);
  EXPECT_GT(std::abs(drive.imu.front().angular_velocity_radps.z()), 10.0 * kDegree);
}

TEST(RollingDrive, ABoatSwaysFromTheFirstMoment) {
  SimulationOptions options = rolling_options();
  options.drive.boat_sway_deg = 8.0;
  const Recorded drive = record(options, "boat");
  double largest = 0.0;
  for (const StampedPose& pose : drive.truth.poses) {
    largest =
        std::max(largest, std::acos((pose.map_from_body.rotation * Eigen::Vector3d::UnitZ()).z()));
  }
  EXPECT_GT(largest, 6.0 * kDegree);
  EXPECT_LT(largest, 13.0 * kDegree);
}

TEST(SensorFaults, ChangeTheSamplesAsTheySay) {
  SimulationOptions options = rolling_options();
  const Recorded sound = record(options, "sound");
  options.faults = {.imu_turn = "x90", .gyro_scale = 2.0, .accel_scale = 0.5, .imu_delay_s = 1.0};
  const Recorded turned = record(options, "turned");
  ASSERT_EQ(sound.imu.size(), turned.imu.size());
  for (std::size_t i = 0; i < sound.imu.size(); i += 50) {
    const Eigen::Vector3d force = sound.imu[i].specific_force_mps2;
    const Eigen::Vector3d rate = sound.imu[i].angular_velocity_radps;
    EXPECT_LT((turned.imu[i].specific_force_mps2 -
               0.5 * Eigen::Vector3d(force.x(), force.z(), -force.y()))
                  .norm(),
              1e-9);
    EXPECT_LT((turned.imu[i].angular_velocity_radps -
               2.0 * Eigen::Vector3d(rate.x(), rate.z(), -rate.y()))
                  .norm(),
              1e-9);
    EXPECT_NEAR(to_seconds(turned.imu[i].time - sound.imu[i].time), 1.0, 1e-6);
  }
}

TEST(SensorFaults, GravityGoesASecondImuComesAndTheGnssTrackGrows) {
  SimulationOptions options = rolling_options();
  const Recorded sound = record(options, "plain");
  options.faults = {.second_imu = true};
  // Told apart by frame_id: without a choice none of them is read.
  EXPECT_TRUE(record(options, "two").imu.empty());
  options.faults = {.gravity_removed = true, .gnss_stretch = 2.0};
  const Recorded faulty = record(options, "faulty");
  ASSERT_EQ(faulty.imu.size(), sound.imu.size());
  EXPECT_NEAR(
      (sound.imu.front().specific_force_mps2 - faulty.imu.front().specific_force_mps2).norm(),
      kGravity_mps2,
      1e-6);
  ASSERT_EQ(sound.gnss.size(), faulty.gnss.size());
  const auto length_deg = [](const std::vector<GnssFix>& fixes) {
    const double north = fixes.back().position.latitude_deg - fixes.front().position.latitude_deg;
    const double east = fixes.back().position.longitude_deg - fixes.front().position.longitude_deg;
    return std::hypot(north, east);
  };
  EXPECT_NEAR(length_deg(faulty.gnss) / length_deg(sound.gnss), 2.0, 0.1);
}

TEST(CarVibration, HasTheMeasuredRmsAtTheMeasuredSpeedAndIdlesAtRest) {
  const CarVibration vibration(kSeed, 0);
  Eigen::Vector3d moving = Eigen::Vector3d::Zero();
  Eigen::Vector3d idle = Eigen::Vector3d::Zero();
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    moving += vibration.at(0.01 * i, 2.8).accel_mps2.cwiseAbs2();
    idle += vibration.at(0.01 * i, 0.0).accel_mps2.cwiseAbs2();
  }
  // The bands of the measurement added up; 0.0077 to 0.0087 m/s^2 of the engine at rest.
  EXPECT_NEAR(std::sqrt(moving.z() / kSamples), 0.129, 0.01);
  EXPECT_NEAR(std::sqrt(moving.x() / kSamples), 0.053, 0.006);
  EXPECT_NEAR(std::sqrt(idle.z() / kSamples), 0.0087, 0.001);
}

}  // namespace
}  // namespace hybridfusion
