#include "mutations.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/sensors_yaml.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TempFolder;

TEST(SensorsYaml, EveryKeyIsReadAndAbsentKeysAreEmpty) {
  const TempFolder folder;
  const auto config =
      read_sensors_yaml(folder.file("sensors.yaml",
                                    "lidar_topic: /points\n"
                                    "point_time_unit: us\n"
                                    "imu_from_lidar: [1,0,0,0.1, 0,1,0,0.2, 0,0,1,0.3, 0,0,0,1]\n"
                                    "gnss_antenna_in_imu: [-0.45, 0.1, 0.52]\n"
                                    "gyro_noise_density: 2.4e-4\n"));
  ASSERT_TRUE(config) << config.error().message;
  EXPECT_EQ(config->lidar_topic, "/points");
  EXPECT_EQ(config->point_time_unit, "us");
  EXPECT_EQ(config->imu_from_lidar->translation, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(config->gnss_antenna_in_imu, Eigen::Vector3d(-0.45, 0.1, 0.52));
  EXPECT_EQ(config->gyro_noise_density, 2.4e-4);
  EXPECT_FALSE(config->imu_topic || config->accel_bias_walk);
  EXPECT_TRUE(read_sensors_yaml(folder.file("comment.yaml", "# nothing\n")));
}

TEST(SensorsYaml, MistakesAreNamedWithTheirLine) {
  const TempFolder folder;
  const auto error = [&](const char* content) {
    const auto config = read_sensors_yaml(folder.file("s.yaml", content));
    EXPECT_FALSE(config) << content;
    return config ? std::string() : config.error().message;
  };
  EXPECT_THAT(error("imu_topic: /i\nlidar_topik: /p\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("lidar_topik"), HasSubstr("lidar_topic")));
  EXPECT_THAT(error("gyro_noise_density: many\n"), HasSubstr("line 1"));
  EXPECT_THAT(error("gyro_noise_density: -1\n"), HasSubstr("outside"));
  EXPECT_THAT(error("gyro_noise_density: .nan\n"), HasSubstr("outside"));
  EXPECT_THAT(error("\nimu_from_lidar: [1, 2]\n"), AllOf(HasSubstr("line 2"), HasSubstr("16")));
  EXPECT_THAT(error("imu_from_lidar: [2,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]\n"),
              HasSubstr("rotation"));
  EXPECT_THAT(error("gnss_antenna_in_imu: [1, 2]\n"), HasSubstr("3"));
  EXPECT_THAT(error("point_time_unit: hours\n"), HasSubstr("hours"));
  EXPECT_THAT(error("a: [1, 2\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(error("- a\n- b\n"), HasSubstr("not a map"));
}

TEST(SensorsYaml, RandomDamageNeverCrashes) {
  const TempFolder folder;
  const std::string good =
      "lidar_topic: /p\nimu_from_lidar: [1,0,0,0.1, 0,1,0,0.2, 0,0,1,0.3, 0,0,0,1]\n"
      "gnss_antenna_in_imu: [-0.45, 0.1, 0.52]\ngyro_noise_density: 2.4e-4\n";
  for (std::uint64_t i = 0; i < 400; ++i) {
    static_cast<void>(read_sensors_yaml(folder.file("bad.yaml", testing::mutated(good, i))));
  }
}

TEST(SensorsYaml, EveryKeyReadsBackAsWritten) {
  const TempFolder folder;
  const SensorConfig full = {
      .lidar_topic = "/points: #1",
      .imu_topic = "/imu/data",
      .gnss_topic = "none",
      .lidar_frame = "livox_frame#2",
      .imu_frame = "/imu",
      .point_time_field = "offset_time",
      .point_time_unit = "ns",
      .imu_from_lidar = Rigid3{.rotation = Eigen::Quaterniond(0.9, 0.3, -0.2, 0.25).normalized(),
                               .translation = {0.123456789, -2.0, 1e-4}},
      .imu_time_offset_s = -0.0123456789,
      .gnss_antenna_in_imu = Eigen::Vector3d(-0.45, 0.1, 0.52),
      .gyro_noise_density = 2.4e-4,
      .accel_noise_density = 1.7e-3,
      .gyro_bias_walk = 2e-5,
      .accel_bias_walk = 2e-4};
  const auto back = read_sensors_yaml(folder.file("sensors.yaml", to_yaml(full)));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->lidar_topic, full.lidar_topic);
  EXPECT_EQ(back->imu_topic, full.imu_topic);
  EXPECT_EQ(back->gnss_topic, full.gnss_topic);
  EXPECT_EQ(back->lidar_frame, full.lidar_frame);
  EXPECT_EQ(back->imu_frame, full.imu_frame);
  EXPECT_EQ(back->point_time_field, full.point_time_field);
  EXPECT_EQ(back->point_time_unit, full.point_time_unit);
  EXPECT_LT(rotation_distance_rad(back->imu_from_lidar->rotation, full.imu_from_lidar->rotation),
            1e-9);
  EXPECT_EQ(back->imu_from_lidar->translation, full.imu_from_lidar->translation);
  EXPECT_EQ(back->imu_time_offset_s, full.imu_time_offset_s);
  EXPECT_EQ(back->gnss_antenna_in_imu, full.gnss_antenna_in_imu);
  EXPECT_EQ(back->gyro_noise_density, full.gyro_noise_density);
  EXPECT_EQ(back->accel_noise_density, full.accel_noise_density);
  EXPECT_EQ(back->gyro_bias_walk, full.gyro_bias_walk);
  EXPECT_EQ(back->accel_bias_walk, full.accel_bias_walk);
  // Written again it is the same text, so that calibrating from a calibration changes nothing else.
  EXPECT_EQ(to_yaml(*back), to_yaml(full));
}

TEST(SensorsYaml, AbsentValuesStayAbsent) {
  const TempFolder folder;
  const auto back =
      read_sensors_yaml(folder.file("sensors.yaml", to_yaml({.imu_time_offset_s = 0.02})));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->imu_time_offset_s, 0.02);
  EXPECT_FALSE(back->imu_from_lidar || back->lidar_topic || back->gnss_antenna_in_imu ||
               back->gyro_noise_density);
  EXPECT_TRUE(read_sensors_yaml(folder.file("empty.yaml", to_yaml({}))));
}

}  // namespace
}  // namespace hybridfusion
