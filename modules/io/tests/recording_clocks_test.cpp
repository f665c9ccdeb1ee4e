#include "recorded_content.hpp"

#include <limits>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kStart_ns;
using testing::McapBuilder;
using testing::TempFolder;
using testing::TestMessage;
using testing::TestRecording;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSecond = 1000 * kMs;
constexpr int kSamples = 2000;  // 10 s of 200 Hz

/// What the message of tick `i` (5 ms) of a sensor says instead.
struct Times {
  /// Header stamp for the true time; IMU at every tick, LiDAR at every 20th.
  std::function<std::int64_t(bool lidar, int i, std::int64_t t)> stamp =
      [](bool, int, std::int64_t t) { return t; };
  std::function<std::int64_t(bool lidar, int i, std::int64_t t)> recorded =
      [](bool, int, std::int64_t t) { return t; };
};

/// The number of a message is in its data: gyro x = i, x of the points = i.
TestRecording drive(const Times& times) {
  TestRecording recording;
  for (int i = 0; i < kSamples; ++i) {
    const std::int64_t t = kStart_ns + i * 5 * kMs;
    const std::int64_t imu = times.stamp(false, i, t);
    recording.messages.push_back({1,
                                  times.recorded(false, i, t + kMs),
                                  testing::imu_message(imu, i, 9.81),
                                  testing::imu_cdr(imu, i, 9.81)});
    if (i % 20 != 0) continue;
    std::vector<std::vector<double>> points;
    for (int k = 0; k < 50; ++k) points.push_back({1.0 + i, 2.0, 3.0, k * 0.002});
    const std::int64_t scan = times.stamp(true, i, t);
    recording.messages.push_back(
        {0,
         times.recorded(true, i, t + 100 * kMs),
         testing::cloud_message(scan, {{"x", 7}, {"y", 7}, {"z", 7}, {"time", 7}}, points),
         testing::cloud_cdr(scan, points)});
  }
  return recording;
}

struct Read {
  std::vector<std::pair<int, std::int64_t>> imu;  ///< Number and time since the start.
  std::vector<std::pair<int, std::int64_t>> scans;
  RecordingSummary summary;
};

Read read(const std::filesystem::path& path) {
  Read out;
  auto source = open_recording(path);
  EXPECT_TRUE(source) << source.error().message;
  if (!source) return out;
  for (;;) {
    auto message = (*source)->next();
    EXPECT_TRUE(message);
    if (!message || !*message) break;
    if (const auto* imu = std::get_if<ImuSample>(&**message)) {
      out.imu.emplace_back(static_cast<int>(imu->angular_velocity_radps.x()),
                           imu->time.count() - kStart_ns);
    } else if (const auto* scan = std::get_if<LidarScan>(&**message)) {
      out.scans.emplace_back(static_cast<int>(scan->points.at(0).point_in_lidar.x()) - 1,
                             scan->stamp.count() - kStart_ns);
    }
  }
  out.summary = (*source)->summary();
  return out;
}

/// Every message that is delivered has its true time, but for `tolerance_ns`, in ascending order.
void expect_true_times(const std::vector<std::pair<int, std::int64_t>>& read,
                       std::size_t at_least,
                       std::int64_t tolerance_ns) {
  EXPECT_GE(read.size(), at_least);
  for (std::size_t k = 0; k < read.size(); ++k) {
    ASSERT_NEAR(static_cast<double>(read[k].second),
                static_cast<double>(read[k].first) * 5.0 * kMs,
                static_cast<double>(tolerance_ns))
        << "message " << k;
    ASSERT_TRUE(k == 0 || read[k].second > read[k - 1].second) << "message " << k;
  }
}

struct ClockCase {
  const char* name;
  Times times;
  std::size_t lost_imu = 0;
  std::size_t lost_scans = 0;
  std::int64_t tolerance_ns = 0;
  const char* warning = "";
};
void PrintTo(const ClockCase& value, std::ostream* out) {
  *out << value.name;
}

bool some(int i) {
  return i == 700 || i == 1300 || i == 1301 || i == 1640;
}

std::vector<ClockCase> cases() {
  constexpr std::int64_t kHuge = std::numeric_limits<std::int64_t>::max();
  const auto stamps = [](auto change) {
    return Times{
        .stamp = [change](bool lidar, int i, std::int64_t t) { return t + change(lidar, i); }};
  };
  return {
      {"AsItShouldBe", {}},
      {"FourLogTimesOfZero",
       {.recorded = [](bool, int i, std::int64_t t) { return some(i) ? 0 : t; }}},
      {"FourLogTimesBeyondAllTime",
       {.recorded = [](bool, int i, std::int64_t t) { return some(i) ? kHuge - i : t; }}},
      {"ALogTimeAnHourAhead",
       {.recorded = [](bool, int i, std::int64_t t) { return i == 700 ? t + 3600 * kSecond : t; }},
       1,
       1,
       0,
       "*"},  // sqlite keeps the message in its place, chunks bring it last
      {"LogTimesOfZeroAtTheStart",
       {.recorded = [](bool, int i, std::int64_t t) { return i < 40 ? 0 : t; }}},
      {"LogClockSetBackForGood",
       {.recorded = [](bool, int i, std::int64_t t) { return i < 900 ? t : t - 3 * kSecond; }}},
      {"FourStampsOfZero",
       {.stamp = [](bool, int i, std::int64_t t) { return some(i) ? 0 : t; }},
       0,
       0,
       2 * kMs,
       "without a stamp"},
      {"StampsGoBackOnce",
       stamps([](bool, int i) { return some(i) ? -3 * kSecond : 0; }),
       4,
       3,
       0,
       "older"},
      {"StampsJumpAheadOnce",
       stamps([](bool, int i) { return some(i) ? 3 * kSecond + 1 : 0; }),
       4,
       3,
       3 * kSecond + 1,
       "far ahead"},
      {"TheFirstStampIsFarAhead",
       stamps([](bool, int i) { return i == 0 ? 3600 * kSecond : 0; }),
       1,
       1,
       0,
       "far ahead"},
      {"StampsRepeat",
       stamps([](bool lidar, int i) {
         return lidar ? (i == 400 || i == 800 ? -100 * kMs : 0) : (i % 10 == 5 ? -5 * kMs : 0);
       }),
       200,
       2,
       0,
       "of the one before"},
      {"ClockSetBackForGood",
       stamps([](bool, int i) { return i < 900 ? 0 : -5 * kSecond; }),
       0,
       0,
       kMs,
       "set back by 5.000 s"},
      {"ClockSetBackALittleForGood",
       stamps([](bool, int i) { return i < 900 ? 0 : -300 * kMs; }),
       0,
       0,
       kMs,
       "set back by 0.300 s"},
      {"ClockSetAheadForGood",
       stamps([](bool, int i) { return i < 900 ? 0 : 3600 * kSecond; }),
       0,
       0,
       kMs,
       "set ahead by 3600.000 s"},
      {"ImuClockSetBackForGood",
       stamps([](bool lidar, int i) { return lidar || i < 900 ? 0 : -5 * kSecond; }),
       0,
       0,
       kMs,
       "IMU clock was set back"},
      {"LidarClockSetBackForGood",
       stamps([](bool lidar, int i) { return !lidar || i < 900 ? 0 : -5 * kSecond; }),
       0,
       0,
       kMs,
       "LiDAR clock was set back"},
      {"ClockAndLogSetBackForGood",
       {.stamp = [](bool, int i, std::int64_t t) { return i < 900 ? t : t - 3 * kSecond; },
        .recorded = [](bool, int i, std::int64_t t) { return i < 900 ? t : t - 3 * kSecond; }},
       0,
       0,
       30 * kMs,  // the LiDAR's own period tells, to a part of it
       "set back by 3.0"},
      {"ClockThatStandsStill",
       {.stamp =
            [](bool, int i, std::int64_t t) { return i < 900 ? t : kStart_ns + 900LL * 5 * kMs; }},
       1,
       1,
       2 * kMs,
       "stand still"},
  };
}

class Clocks : public ::testing::TestWithParam<ClockCase> {};

TEST_P(Clocks, DisplacedMessagesMoveNothingButThemselves) {
  const ClockCase& param = GetParam();
  const TempFolder folder;
  const TestRecording recording = drive(param.times);
  testing::write_db3(folder.path() / "a.db3", recording, 0, recording.messages.size());
  const bool log_fits_ros1 = std::string(param.name).find("BeyondAllTime") == std::string::npos;
  std::vector<std::filesystem::path> paths = {
      folder.file("a.mcap", McapBuilder::build(recording, {.compression = "zstd"})),
      folder.file("b.mcap", McapBuilder::build(recording, {.summary = false})),
      folder.path() / "a.db3"};
  if (log_fits_ros1) paths.push_back(folder.file("a.bag", testing::rosbag1_of(recording)));
  for (const std::filesystem::path& path : paths) {
    SCOPED_TRACE(path.filename());
    const Read got = read(path);
    expect_true_times(got.imu, kSamples - param.lost_imu, param.tolerance_ns);
    expect_true_times(got.scans, kSamples / 20 - param.lost_scans, param.tolerance_ns);
    if (*param.warning == '*') continue;
    if (*param.warning == '\0') {
      EXPECT_THAT(got.summary.warnings, IsEmpty());
    } else {
      EXPECT_THAT(got.summary.warnings, Contains(HasSubstr(param.warning)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Recordings, Clocks, ::testing::ValuesIn(cases()), [](const auto& test) {
  return test.param.name;
});

TEST(Clocks, APauseIsNoStepOfTheClock) {
  const TempFolder folder;
  TestRecording recording = drive({});
  std::erase_if(recording.messages, [](const TestMessage& message) {
    const std::int64_t t = message.time_ns - kStart_ns;
    return t > 4 * kSecond && t < 7 * kSecond;
  });
  const Read got = read(folder.file("a.mcap", McapBuilder::build(recording, {})));
  EXPECT_THAT(got.summary.warnings, IsEmpty());
  expect_true_times(got.imu, kSamples * 69 / 100, 0);
  expect_true_times(got.scans, 68, 0);
}

}  // namespace
}  // namespace hybridfusion
