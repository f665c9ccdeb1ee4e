#include "bag_writer.hpp"
#include "gnss_model.hpp"
#include "imu_model.hpp"
#include "noise.hpp"
#include "pinhole_camera.hpp"
#include "ros_messages.hpp"
#include "vehicle_motion.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/io/rosbag1.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

VehicleMotion wavy_motion() {
  VehicleMotion::Channels channels;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.05 * i;
    channels[0].push_back(5.0 * t);
    channels[1].push_back(std::sin(1.3 * t));
    channels[2].push_back(0.05 * std::cos(4.0 * t));
    channels[3].push_back(0.6 * std::sin(0.9 * t));
    channels[4].push_back(0.05 * std::sin(3.0 * t));
    channels[5].push_back(0.04 * std::cos(2.0 * t));
  }
  return {std::move(channels), 0.05};
}

TEST(VehicleMotion, DerivativesAgreeWithDifferencesOfThePose) {
  const VehicleMotion motion = wavy_motion();
  constexpr double kStep = 1e-4;
  for (const double time : {0.31, 0.777, 1.5, 2.03}) {
    const MotionState state = motion.at(time);
    const MotionState before = motion.at(time - kStep);
    const MotionState after = motion.at(time + kStep);
    const Eigen::Vector3d velocity =
        (after.world_from_body.translation - before.world_from_body.translation) / (2 * kStep);
    const Eigen::Vector3d acceleration = (after.velocity_mps - before.velocity_mps) / (2 * kStep);
    const Eigen::AngleAxisd turn(before.world_from_body.rotation.conjugate() *
                                 after.world_from_body.rotation);
    const Eigen::Vector3d rate = turn.axis() * turn.angle() / (2 * kStep);
    EXPECT_LT((state.velocity_mps - velocity).norm(), 1e-5);
    EXPECT_LT((state.acceleration_mps2 - acceleration).norm(), 1e-3);
    EXPECT_LT((state.angular_velocity_radps - rate).norm(), 1e-5);
  }
}

TEST(ImuModel, AtRestWithoutErrorsItFeelsGravityAndNoTurn) {
  const ImuModelOptions ideal{.gyro_noise_density = 0,
                              .accel_noise_density = 0,
                              .gyro_bias_sd_radps = 0,
                              .accel_bias_sd_mps2 = 0,
                              .gyro_bias_walk = 0,
                              .accel_bias_walk = 0};
  ImuModel imu(ideal, 1, 0);
  const ImuSample sample = imu.measure({}, {});
  EXPECT_EQ(sample.angular_velocity_radps.norm(), 0.0);
  EXPECT_NEAR(sample.specific_force_mps2.z(), kGravity_mps2, 1e-12);
}

TEST(ImuModel, WhiteNoiseHasTheDeclaredDensity) {
  ImuModel imu({.gyro_bias_sd_radps = 0, .accel_bias_sd_mps2 = 0, .gyro_bias_walk = 0}, 3, 0);
  double square = 0.0;
  constexpr int kSamples = 4000;
  for (int i = 0; i < kSamples; ++i) {
    square += imu.measure({}, {}).angular_velocity_radps.squaredNorm() / 3.0;
  }
  // 12000 draws know their variance to 1.3 %, 1 sigma.
  EXPECT_NEAR(std::sqrt(square / kSamples), 2.4e-4 * std::sqrt(200.0), 0.03 * 2.4e-4 * 14.2);
}

TEST(GnssError, SharesAddUpToTheDeclaredSigma) {
  Eigen::Vector3d square = Eigen::Vector3d::Zero();
  constexpr int kReceivers = 3000;
  for (std::uint64_t i = 0; i < kReceivers; ++i) {
    GnssError error({}, i, "gnss/test", 0);
    (void)error.at(0.0);
    square += error.at(100.0).cwiseAbs2();
  }
  const Eigen::Vector3d sigma = (square / kReceivers).cwiseSqrt();
  EXPECT_NEAR(sigma.x(), 1.5, 0.08);
  EXPECT_NEAR(sigma.z(), 3.0, 0.16);
}

TEST(GnssError, TwoReceiversHaveUnrelatedErrors) {
  GnssError drone({}, 5, "gnss/drone", 0);
  GnssError vehicle({}, 5, "gnss/vehicle", 0);
  EXPECT_GT((drone.constant_m() - vehicle.constant_m()).norm(), 0.05);
}

TEST(PinholeCamera, ProjectionUndoesTheViewingDirection) {
  const PinholeCamera camera(1600, 1200, 1290.0, {801.0, 597.0}, -0.045, 0.018);
  for (const double x : {0.0, 412.3, 801.0, 1599.0}) {
    for (const double y : {0.0, 250.7, 1199.0}) {
      Eigen::Vector2d pixel;
      ASSERT_TRUE(camera.project(37.0 * camera.direction(x, y), pixel));
      EXPECT_NEAR(pixel.x(), x, 1e-3);
      EXPECT_NEAR(pixel.y(), y, 1e-3);
    }
  }
}

TEST(Noise, FadesWhenThePixelIsWiderThanThePattern) {
  double near = 0.0;
  double far = 0.0;
  for (int i = 0; i < 200; ++i) {
    const auto x = static_cast<float>(0.37 * i);
    near += std::abs(fractal_noise(x, 1.0F, 0.5F, 4, 0.7F, 9, 0.01F));
    far += std::abs(fractal_noise(x, 1.0F, 0.5F, 4, 0.7F, 9, 0.6F));
  }
  EXPECT_GT(near, 10.0);
  EXPECT_EQ(far, 0.0);
}

TEST(Noise, FilteredPulseKeepsItsMean) {
  for (const float footprint : {0.01F, 0.3F, 1.7F}) {
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) {
      sum += filtered_pulse(static_cast<float>(i) * 0.001F + 0.0005F, 0.2F, footprint);
    }
    EXPECT_NEAR(sum / 1000.0, 0.2, 0.005) << footprint;
  }
}

class BagWriterFormats : public testing::TestWithParam<const char*> {};

TEST_P(BagWriterFormats, ReaderGetsEveryMessageBack) {
  const auto path = std::filesystem::path(testing::TempDir()) /
                    (std::string("simulation_") + GetParam() + std::to_string(getpid()) + ".bag");
  auto bag = BagWriter::create(path, GetParam());
  ASSERT_TRUE(bag);
  const std::uint32_t first = bag->add_connection("/imu/data", kImuMessage);
  const std::uint32_t second = bag->add_connection("/gnss/fix", kNavSatFixMessage);
  constexpr int kMessages = 700;
  for (int i = 0; i < kMessages; ++i) {
    const std::string message(3000, static_cast<char>(i));  // Several chunks.
    ASSERT_TRUE(bag->write(i % 7 == 0 ? second : first, Timestamp(1000000000LL + i), message));
  }
  ASSERT_TRUE(bag->close());
  auto reader = Rosbag1Reader::open(path);
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->connections().size(), 2U);
  int count = 0;
  while (true) {
    auto message = reader->next();
    ASSERT_TRUE(message) << message.error().message;
    if (!message->has_value()) break;
    EXPECT_EQ((*message)->time.count(), 1000000000LL + count);
    EXPECT_EQ((*message)->data.size(), 3000U);
    EXPECT_EQ(static_cast<char>((*message)->data[17]), static_cast<char>(count));
    ++count;
  }
  EXPECT_EQ(count, kMessages);
  EXPECT_FALSE(reader->truncated());
  EXPECT_TRUE(reader->warnings().empty());
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Compressions, BagWriterFormats, testing::Values("none", "bz2", "lz4"));

TEST(SimulationPreset, KnownNamesAreValidAndOthersAreRefused) {
  for (const char* name : {"small", "paper", "city"}) {
    const auto options = simulation_preset(name);
    ASSERT_TRUE(options) << name;
    EXPECT_TRUE(validate(*options)) << name;
  }
  const auto unknown = simulation_preset("village");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::kInvalidOptions);
}

}  // namespace
}  // namespace hybridfusion
