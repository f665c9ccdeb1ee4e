#include "recording_editor.hpp"
#include "street_drive.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using Messages = std::vector<RawMessage>;
using Change = std::function<void(RawMessage&)>;

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

/// What drivers, clocks, plugs and people do to a recording.
struct Fault {
  std::string name = {};
  std::function<void(Messages&)> break_it = {};
  std::string flag = {};     ///< Of a scan in quality.csv; "": no scan has any.
  std::string message = {};  ///< On stderr; "": nothing is said.
};

/// Changes messages number `first` .. `last` of a type.
auto each(const char* type, const Change& change, std::size_t first = 0, std::size_t last = kAll) {
  return [=](Messages& messages) {
    std::size_t number = 0;
    for (RawMessage& message : messages) {
      if (message.type != type) continue;
      if (number >= first && number <= last) change(message);
      ++number;
    }
  };
}

Change later_by(std::int64_t ns) {
  return [ns](RawMessage& message) { set_stamp(stamp_ns(message) + ns, message); };
}

/// Removes messages of a type by their number among them.
auto without(const char* type, const std::function<bool(std::size_t)>& condition) {
  return [=](Messages& messages) {
    std::size_t number = 0;
    std::erase_if(messages, [&](const RawMessage& message) {
      return message.type == type && condition(number++);
    });
  };
}

/// Without the messages of the first seconds.
auto without_start(double seconds) {
  return [seconds](Messages& messages) {
    const std::int64_t begin =
        messages.front().recorded_ns + static_cast<std::int64_t>(1e9 * seconds);
    std::erase_if(messages, [&](const RawMessage& message) { return message.recorded_ns < begin; });
  };
}

Change times_scaled(float scale) {
  return [scale](RawMessage& message) {
    edit_field(message, "time", [scale](float time) { return scale * time; });
  };
}

void spoil_every_third(RawMessage& message) {
  int number = 0;
  edit_field(message, "x", [&](float x) {
    return number++ % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : x;
  });
}

void empty(RawMessage& message) {
  edit_rows(message, [](std::vector<std::string>& rows) { rows.clear(); });
}

void reverse(RawMessage& message) {
  edit_rows(message, [](std::vector<std::string>& rows) { std::ranges::reverse(rows); });
}

void saturate(RawMessage& message) {
  edit_imu(message, [](ImuValues& values) {
    values.angular_velocity.z() = 4.36;
    values.specific_force.x() = 39.2;
  });
}

void to_g(RawMessage& message) {
  edit_imu(message, [](ImuValues& values) { values.specific_force /= 9.80665; });
}

// The drive stands still for its first 3 s; scan 100 and IMU sample 2000 are after 10 s.
const std::vector<Fault> kLidarFaults = {
    {.name = "NaN points", .break_it = each(kCloudType, spoil_every_third)},
    {.name = "empty scans",
     .break_it =
         [](Messages& messages) {
           for (std::size_t i = 30; i < 150; i += 20) each(kCloudType, empty, i, i)(messages);
         },
     .flag = "few_points",
     .message = "6 scans could not be matched"},
    {.name = "unsorted points", .break_it = each(kCloudType, reverse)},
    {.name = "zero point times",
     .break_it = each(kCloudType, times_scaled(0.0F)),
     .message = "made up from the azimuth"},
    {.name = "point times in ms", .break_it = each(kCloudType, times_scaled(1e3F))},
    {.name = "point times a thousand times too short",
     .break_it = each(kCloudType, times_scaled(1e-3F)),
     .message = "made up from the azimuth"},
    {.name = "point times ten times too long",
     .break_it = each(kCloudType, times_scaled(10.0F)),
     .flag = "no_point_times",
     .message = "made up from the azimuth"},
    {.name = "no scan for 2 s",
     .break_it = without(kCloudType, [](std::size_t i) { return i >= 100 && i < 120; }),
     .flag = "lidar_gap",
     .message = "1 gaps between LiDAR scans"},
    {.name = "a LiDAR stamp that goes back",
     .break_it = each(kCloudType, later_by(-3 * kSecond_ns), 100, 100),
     .message = "LiDAR messages: 1 older than the one before"},
};

const std::vector<Fault> kImuFaults = {
    {.name = "IMU at 100 Hz",
     .break_it = without(kImuType, [](std::size_t i) { return i % 2 == 1; })},
    {.name = "no IMU for 1 s",
     .break_it = without(kImuType, [](std::size_t i) { return i >= 2000 && i < 2200; }),
     .flag = "imu_gap",
     .message = "1 gaps in the IMU stream"},
    {.name = "IMU stamps that go back",
     .break_it = each(kImuType, later_by(-3 * kSecond_ns), 2000, 2003),
     .message = "IMU messages: 4 older than the one before"},
    {.name = "IMU stamps 20 ms behind",
     .break_it = each(kImuType, later_by(-20'000'000)),
     .message = "time offset"},
    {.name = "IMU stamps 20 ms ahead",
     .break_it = each(kImuType, later_by(20'000'000)),
     .message = "time offset"},
    {.name = "a saturated IMU",
     .break_it = each(kImuType, saturate, 2000, 2060),
     .flag = "saturated"},
    {.name = "an IMU in g", .break_it = each(kImuType, to_g), .message = "speaks in g"},
    {.name = "no standstill",
     .break_it = without_start(7.0),
     .flag = "imu_gap",
     .message = "no standstill"},
};

class RecordingFaults : public StreetTest {
 protected:
  std::string broken(const std::function<void(Messages&)>& break_it) const {
    Messages messages = read_messages(street() / "street.bag");
    break_it(messages);
    write_messages(path("broken.bag"), messages);
    return path("broken.bag");
  }
  [[nodiscard]] double clean_error_m() const {
    EXPECT_EQ(map((street() / "street.bag").string(), "clean").exit_code, 0);
    EXPECT_TRUE(quality_flags(path("clean")).empty());
    return error_m("clean");
  }

  /// Every one is mapped as well as the clean drive, and what was bridged is told.
  void expect_bridged(const std::vector<Fault>& faults) const {
    const double clean_m = clean_error_m();
    EXPECT_LT(clean_m, 0.01);
    for (const Fault& fault : faults) {
      SCOPED_TRACE(fault.name);
      const ProgramResult result = map(broken(fault.break_it), "ws");
      ASSERT_EQ(result.exit_code, 0) << result.err;
      // A tenth of the range noise besides: the clean run errs by less than that.
      constexpr double kFloor_m = 0.002;
      EXPECT_LT(error_m("ws"), 1.5 * clean_m + kFloor_m);
      const std::set<std::string> flags = quality_flags(path("ws"));
      if (fault.flag.empty()) {
        EXPECT_TRUE(flags.empty()) << *flags.begin();
      } else {
        EXPECT_THAT(flags, Contains(fault.flag));
      }
      if (fault.message.empty()) continue;
      EXPECT_THAT(result.err, HasSubstr(fault.message));
    }
  }
};

TEST_F(RecordingFaults, OfTheLidarAreBridgedAndTold) {
  expect_bridged(kLidarFaults);
}

TEST_F(RecordingFaults, OfTheImuAreBridgedAndTold) {
  expect_bridged(kImuFaults);
}

TEST_F(RecordingFaults, ACutFileGivesAnAccurateDriveUpToTheCut) {
  std::string bytes = read_file(street() / "street.bag");
  bytes.resize(bytes.size() * 7 / 10);
  const ProgramResult result = map(write("cut.bag", bytes), "ws", {"--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out).at("stages").at("map").at("result");
  EXPECT_TRUE(json.at("recording_truncated"));
  EXPECT_GT(json.at("num_scans"), 100);
  EXPECT_LT(json.at("num_scans"), 150);
  EXPECT_THAT(result.err, HasSubstr("cut off"));
  EXPECT_LT(error_m("ws"), 0.01);
}

TEST_F(RecordingFaults, ASingleImuSampleLeavesTheLidarAloneAndIsTold) {
  const ProgramResult result =
      map(broken(without(kImuType, [](std::size_t i) { return i > 0; })), "ws");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("without an IMU: motion from the LiDAR alone"));
  EXPECT_LT(error_m("ws"), 0.1);
}

TEST_F(RecordingFaults, WithoutImuTheRecordingIsRefused) {
  const auto none = [](std::size_t) { return true; };
  const ProgramResult result = map(broken(without(kImuType, none)), "ws");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("IMU topic"));
  EXPECT_FALSE(std::filesystem::exists(path("ws/lidar/trajectory.tum")));
}

TEST_F(RecordingFaults, WithOneScanTheRecordingIsRefused) {
  const ProgramResult result =
      map(broken(without(kCloudType, [](std::size_t i) { return i > 0; })), "ws");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("1 located scans gave no map point"));
  EXPECT_FALSE(std::filesystem::exists(path("ws/lidar/map.ply")));
}

TEST_F(RecordingFaults, ACoveredLidarMakesTheResultUnreliable) {
  const std::string bag = broken(each(kCloudType, empty, 90));
  const ProgramResult result = map(bag, "ws", {"--json"});
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_THAT(result.err, HasSubstr("lidar.odometry.max_blind_s"));
  EXPECT_EQ(nlohmann::json::parse(result.out).at("stages").at("map").at("status"), "refused");
  // What there is can be looked at: every scan has its row and says that it is a prediction.
  EXPECT_THAT(quality_flags(path("ws")), Contains("unmatched"));
  EXPECT_TRUE(std::filesystem::exists(path("ws/lidar/map.ply")));
  const ProgramResult trusted =
      map(bag, "ws", {"--set", "lidar.odometry.max_blind_s=60", "--quiet"});
  EXPECT_EQ(trusted.exit_code, 0) << trusted.err;
}

}  // namespace
}  // namespace hybridfusion::testing
