#include "recorded_content.hpp"

#include <limits>

namespace hybridfusion {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::kStart_ns;
using testing::TempFolder;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kRateAt = 4 + 8 + 4 + 5 + 13 * 8;  // behind header and orientation
constexpr std::size_t kForceAt = kRateAt + 12 * 8;

void set(std::string& message, std::size_t at, double value) {
  message.replace(at, sizeof value, testing::as_bytes(value));
}

/// Two seconds of 200 Hz; `change` edits the serialised message of tick i.
std::string bag_of(const std::function<void(int, std::string&)>& change) {
  testing::BagBuilder bag;
  const auto points = bag.add_topic("/points", "sensor_msgs/PointCloud2");
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  for (int i = 0; i < 400; ++i) {
    const std::int64_t t = kStart_ns + i * 5'000'000LL;
    std::string message = testing::imu_message(t, 0.25, 9.81);
    change(i, message);
    bag.add_message(imu, t, message);
    if (i % 20 != 0) continue;
    std::vector<std::vector<double>> cloud;
    for (int k = 0; k < 50; ++k) cloud.push_back({1.0 + k, 2.0, 3.0, k * 0.002});
    bag.add_message(
        points, t, testing::cloud_message(t, {{"x", 7}, {"y", 7}, {"z", 7}, {"time", 7}}, cloud));
  }
  return bag.finish();
}

void remove_force(std::string& message) {
  for (std::size_t axis = 0; axis < 3; ++axis) set(message, kForceAt + axis * 8, 0.0);
  set(message, kForceAt + 3 * 8, -1.0);
}

TEST(RecordingImu, RatesAndAccelerationsThatComeApartAreJoined) {
  const TempFolder folder;
  // Every other message has the one or the other, as unjoined RealSense streams of one topic.
  const auto path = folder.file("a.bag", bag_of([](int i, std::string& message) {
                                  if (i % 2 == 0) {
                                    for (std::size_t axis = 0; axis < 3; ++axis) {
                                      set(message, kRateAt + axis * 8, kNan);
                                    }
                                  } else {
                                    remove_force(message);
                                  }
                                }));
  const auto content = testing::read_all(path);
  EXPECT_EQ(content.summary.num_imu_samples, 200U);
  EXPECT_EQ(content.summary.num_damaged_messages, 0U);
  EXPECT_THAT(content.imu, HasSubstr(" 0.25 9.81"));
  EXPECT_EQ(content.summary.imu_dialect.without_rate, 200U);
  EXPECT_THAT(content.summary.warnings, Contains(HasSubstr("without angular velocity")));
}

TEST(RecordingImu, SamplesWithoutAccelerationAreLeftOutAndAnImuWithoutAnyIsRefused) {
  const TempFolder folder;
  const auto some = folder.file("a.bag", bag_of([](int i, std::string& message) {
                                  if (i % 100 < 20) remove_force(message);
                                }));
  EXPECT_GE(testing::read_all(some).summary.num_imu_samples, 320U);
  for (const double value : {0.0, kNan}) {
    const auto none = folder.file("b.bag", bag_of([value](int, std::string& message) {
                                    remove_force(message);
                                    set(message, kForceAt, value);
                                  }));
    auto source = open_recording(none);
    ASSERT_TRUE(source);
    auto message = (*source)->next();
    while (message && *message) message = (*source)->next();
    ASSERT_FALSE(message);
    EXPECT_THAT(message.error().message, HasSubstr("none of the 400 IMU samples"));
  }
  // -1 beside values says only that their sigma is not known.
  const auto valued = folder.file(
      "c.bag", bag_of([](int, std::string& message) { set(message, kForceAt + 3 * 8, -1.0); }));
  EXPECT_EQ(testing::read_all(valued).summary.imu_dialect.without_force, 0U);
}

TEST(RecordingImu, UnitsOfGAndMissingGravityAreFound) {
  const TempFolder folder;
  const auto dialect = [&](const std::function<double(int)>& force) {
    return testing::read_all(folder.file("a.bag", bag_of([&](int i, std::string& message) {
                                           set(message, kForceAt, 0.01);
                                           set(message, kForceAt + 16, force(i));
                                         })))
        .summary.imu_dialect;
  };
  EXPECT_FALSE(dialect([](int) { return 9.81; }).in_g);
  EXPECT_FALSE(dialect([](int) { return 9.81; }).gravity_removed);
  EXPECT_TRUE(dialect([](int i) { return 1.0 + 0.1 * std::sin(i); }).in_g);
  EXPECT_TRUE(dialect([](int) { return 0.02; }).gravity_removed);
  // A drive that accelerates and brakes.
  const ImuDialect moving = dialect([](int i) { return 2.0 * std::sin(0.05 * i); });
  EXPECT_TRUE(moving.gravity_removed);
  EXPECT_FALSE(moving.in_g);
}

}  // namespace
}  // namespace hybridfusion
