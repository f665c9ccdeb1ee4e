#include "recording_editor.hpp"
#include "street_drive.hpp"

#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>

#include <numbers>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kDegree = std::numbers::pi / 180.0;

class MapCalibrate : public ProgramTest {
 protected:
  /// sensors.yaml of a data set with a mounting 5 degrees and 10 cm off and a clock 20 ms off.
  [[nodiscard]] std::string wrong_sensors(const std::filesystem::path& data_set,
                                          const Eigen::Vector3d& moved_m) const {
    auto sensors = read_sensors_yaml(data_set / "sensors.yaml");
    EXPECT_TRUE(sensors);
    const Eigen::AngleAxisd off(5.0 * kDegree, Eigen::Vector3d(1.0, -0.7, 0.8).normalized());
    sensors->imu_from_lidar->rotation = sensors->imu_from_lidar->rotation * off;
    sensors->imu_from_lidar->translation += moved_m;
    sensors->imu_time_offset_s = 0.02;
    return write("wrong.yaml", to_yaml(*sensors));
  }
  [[nodiscard]] ProgramResult calibrate(const std::filesystem::path& data_set,
                                        const std::string& sensors) const {
    return run_program({"map",
                        "--calibrate",
                        "--bag",
                        (data_set / "street.bag").string(),
                        "--sensors",
                        sensors,
                        "--output",
                        path("ws"),
                        "--json"});
  }
  /// Rotation to 0.3 degrees, clock to 2 ms, and along those axes that the motion shows 2 cm.
  void expect_calibrated(const std::filesystem::path& data_set,
                         const ProgramResult& result,
                         const std::vector<int>& shown_axes) const {
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto truth = read_sensors_yaml(data_set / "sensors.yaml");
    const auto found = read_sensors_yaml(path("ws/lidar/sensors.yaml"));
    ASSERT_TRUE(truth && found);
    const Rigid3& rig = *found->imu_from_lidar;
    EXPECT_LT(rotation_distance_rad(rig.rotation, truth->imu_from_lidar->rotation), 0.3 * kDegree);
    EXPECT_NEAR(*found->imu_time_offset_s, truth->imu_time_offset_s.value_or(0.0), 0.002);
    const auto json = nlohmann::json::parse(result.out).at("stages").at("calibrate").at("result");
    for (const int axis : shown_axes) {
      EXPECT_TRUE(json.at("translation_m").at(axis).at("found")) << axis;
      EXPECT_NEAR(rig.translation[axis], truth->imu_from_lidar->translation[axis], 0.02) << axis;
    }
    // What else the given file says is kept.
    EXPECT_EQ(found->lidar_topic, truth->lidar_topic);
    EXPECT_EQ(found->gnss_antenna_in_imu, truth->gnss_antenna_in_imu);
    EXPECT_EQ(found->gyro_noise_density, truth->gyro_noise_density);
  }
};

TEST_F(MapCalibrate, FindsAWrongMountingAndClockOfASwingingDriveAndMapReadsThem) {
  const std::filesystem::path drive = path("drive");
  simulate_street(drive, {"drive.duration_s=36", "drive.swing_deg=12"});
  const std::string sensors = wrong_sensors(drive, {0.06, -0.06, 0.05});
  const std::string given = read_file(sensors);
  const ProgramResult result = calibrate(drive, sensors);
  expect_calibrated(drive, result, {0, 1, 2});
  EXPECT_EQ(read_file(sensors), given);

  const std::vector<std::string> map = {
      "map", "--bag", (drive / "street.bag").string(), "--output", path("ws"), "--sensors"};
  auto before = map;
  before.push_back(sensors);
  EXPECT_THAT(run_program(before).err, HasSubstr("map --calibrate"));
  auto after = map;
  after.push_back(path("ws/lidar/sensors.yaml"));
  const ProgramResult mapped = run_program(after);
  EXPECT_EQ(mapped.exit_code, 0);
  EXPECT_THAT(mapped.err, Not(HasSubstr("map --calibrate")));
  EXPECT_LT(drive_error_m(path("ws"), drive), 0.01);

  // What calibration writes cannot be where it starts from.
  const ProgramResult again = calibrate(drive, path("ws/lidar/sensors.yaml"));
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.err, HasSubstr("copy it elsewhere"));
  EXPECT_TRUE(std::filesystem::exists(path("ws/lidar/sensors.yaml")));
}

TEST_F(MapCalibrate, RefusesARecordingThatDoesNotMove) {
  const std::filesystem::path drive = path("drive");
  simulate_street(drive, {"drive.duration_s=24", "drive.standstill_s=17"});
  std::vector<RawMessage> messages = read_messages(drive / "street.bag");
  const std::int64_t end_ns = messages.front().recorded_ns + 16'000'000'000;
  std::erase_if(messages, [&](const RawMessage& message) { return message.recorded_ns > end_ns; });
  write_messages(drive / "street.bag", messages);
  const ProgramResult result = calibrate(drive, (drive / "sensors.yaml").string());
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_THAT(result.err, HasSubstr("figure-eight"));
  EXPECT_FALSE(std::filesystem::exists(path("ws/lidar/sensors.yaml")));
}

TEST_F(MapCalibrate, FindsAWrongMountingAndClockOfAStreetRecording) {
  HF_NEEDS_TEST_DATA();
  const std::filesystem::path drive = *test_data() / "block-11";
  // A car on level ground does not show the height of its LiDAR.
  const ProgramResult result = calibrate(drive, wrong_sensors(drive, {0.08, -0.06, 0.0}));
  expect_calibrated(drive, result, {0, 1});
}

}  // namespace
}  // namespace hybridfusion::testing
