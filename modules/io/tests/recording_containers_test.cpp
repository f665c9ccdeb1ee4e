#include "container_builders.hpp"
#include "mutations.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/scan_source.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::McapBuilder;
using testing::TempFolder;
using testing::TestRecording;

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;

/// 10 scans, 100 IMU samples, 5 fixes in one second.
TestRecording street() {
  TestRecording recording;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t t = kStart_ns + i * 10'000'000LL;
    const double gyro_x = 0.01 * i;
    recording.messages.push_back(
        {1, t, testing::imu_message(t, gyro_x, 9.81), testing::imu_cdr(t, gyro_x, 9.81)});
    if (i % 10 == 0) {
      std::vector<std::vector<double>> points;
      for (int k = 0; k < 50; ++k) points.push_back({1.0 + k + i, 2.0, 3.0, k * 0.002});
      recording.messages.push_back(
          {0,
           t,
           testing::cloud_message(t, {{"x", 7}, {"y", 7}, {"z", 7}, {"time", 7}}, points),
           testing::cloud_cdr(t, points)});
    }
    if (i % 20 == 0) {
      recording.messages.push_back({2,
                                    t,
                                    testing::fix_message(t, 48.0 + 1e-6 * i, 0, 2.25),
                                    testing::fix_cdr(t, 48.0 + 1e-6 * i, 2.25)});
    }
  }
  return recording;
}

/// Everything a recording delivers, as text that is equal exactly when the values are.
struct Content {
  std::string scans = {};
  std::string imu = {};
  std::string fixes = {};
  RecordingSummary summary = {};
};

void append(Content& content, const SensorMessage& message) {
  if (const auto* scan = std::get_if<LidarScan>(&message)) {
    content.scans += fmt::format("scan {}\n", scan->stamp.count());
    for (const LidarPoint& point : scan->points) {
      content.scans += fmt::format("{} {} {} {}\n",
                                   point.point_in_lidar.x(),
                                   point.point_in_lidar.y(),
                                   point.point_in_lidar.z(),
                                   point.offset_ns);
    }
  } else if (const auto* sample = std::get_if<ImuSample>(&message)) {
    content.imu += fmt::format("{} {} {}\n",
                               sample->time.count(),
                               sample->angular_velocity_radps.x(),
                               sample->specific_force_mps2.z());
  } else if (const auto* fix = std::get_if<GnssFix>(&message)) {
    content.fixes += fmt::format("{} {} {} {} {}\n",
                                 fix->time.count(),
                                 fix->position.latitude_deg,
                                 fix->position.longitude_deg,
                                 fix->position.altitude_m,
                                 fix->sigma_enu_m.z());
  }
}

Content read_all(const std::filesystem::path& path, const RecordingOptions& options = {}) {
  Content content;
  auto source = open_recording(path, options);
  EXPECT_TRUE(source) << source.error().message;
  if (!source) return content;
  for (;;) {
    auto message = (*source)->next();
    EXPECT_TRUE(message) << message.error().message;
    if (!message || !*message) break;
    append(content, **message);
  }
  content.summary = (*source)->summary();
  return content;
}

Content reference(const TempFolder& folder) {
  const Content content = read_all(folder.file("reference.bag", testing::rosbag1_of(street())));
  EXPECT_EQ(content.summary.num_scans, 10U);
  EXPECT_EQ(content.summary.num_imu_samples, 100U);
  EXPECT_EQ(content.summary.num_gnss_fixes, 5U);
  return content;
}

void expect_same(const Content& expected, const std::filesystem::path& path) {
  SCOPED_TRACE(path.string());
  const Content content = read_all(path);
  EXPECT_EQ(content.scans, expected.scans);
  EXPECT_EQ(content.imu, expected.imu);
  EXPECT_EQ(content.fixes, expected.fixes);
  EXPECT_EQ(content.summary.num_damaged_messages, 0U);
  EXPECT_FALSE(content.summary.truncated);
  EXPECT_EQ(content.summary.lidar_topic, "/points");
}

TEST(RecordingContainers, CompressedBagGivesTheSameAndLeavesNoFile) {
  const TempFolder folder;
  const Content expected = reference(folder);
  const auto packed = testing::zstd_packed(testing::rosbag1_of(street()));
  std::filesystem::create_directory(folder.path() / "own");
  const auto path = folder.file("own/street.bag.zst", packed);
  expect_same(expected, path);
  EXPECT_THAT(read_all(path).summary.format, HasSubstr("zstd"));
  const auto files = std::distance(std::filesystem::directory_iterator(path.parent_path()), {});
  EXPECT_EQ(files, 1);
}

TEST(RecordingContainers, McapGivesTheSameInEveryLayout) {
  const TempFolder folder;
  const Content expected = reference(folder);
  int number = 0;
  for (const char* const compression : {"", "lz4", "zstd"}) {
    for (const bool summary : {true, false}) {
      const std::string bytes =
          McapBuilder::build(street(), {.compression = compression, .summary = summary});
      expect_same(expected, folder.file(fmt::format("{}.mcap", number++), bytes));
    }
  }
  expect_same(
      expected,
      folder.file("ros1.mcap", McapBuilder::build(street(), {.wire = McapBuilder::Wire::kRos1})));
  expect_same(expected, folder.file("flat.mcap", McapBuilder::build(street(), {.chunked = false})));
  const std::string plain = McapBuilder::build(street(), {.compression = "lz4"});
  expect_same(expected, folder.file("packed.mcap.zst", testing::zstd_packed(plain)));
  const auto summary = inspect_recording(folder.path() / "0.mcap");
  ASSERT_TRUE(summary);
  ASSERT_EQ(summary->topics.size(), 3U);
  EXPECT_EQ(summary->topics[1].messages, 100U);
  EXPECT_EQ(summary->topics[2].type, "sensor_msgs/msg/PointCloud2");
}

TEST(RecordingContainers, Db3AndRos2FoldersGiveTheSame) {
  const TempFolder folder;
  const Content expected = reference(folder);
  const TestRecording recording = street();
  const std::size_t all = recording.messages.size();
  const auto made = [&](const char* name) {
    std::filesystem::create_directory(folder.path() / name);
    return folder.path() / name;
  };
  testing::write_db3(folder.path() / "street.db3", recording, 0, all);
  expect_same(expected, folder.path() / "street.db3");

  const auto split = made("split");
  testing::write_db3(split / "split_0.db3", recording, 0, all / 2);
  testing::write_db3(split / "split_1.db3", recording, all / 2, all);
  expect_same(expected, split);  // without metadata.yaml
  static_cast<void>(
      folder.file("split/metadata.yaml",
                  // As recorders of version 1 wrote it, with the folder in front.
                  testing::metadata_yaml(recording, {"elsewhere/split_0.db3", "split_1.db3"}, "")));
  expect_same(expected, split);
  const auto summary = inspect_recording(split);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->topics[1].messages, 100U);

  const auto packed = made("packed");
  const std::string db3 = testing::content_of(folder.path() / "street.db3");
  static_cast<void>(folder.file("packed/a_0.db3.zstd", testing::zstd_packed(db3)));
  static_cast<void>(folder.file("packed/metadata.yaml",
                                testing::metadata_yaml(recording, {"a_0.db3.zstd"}, "FILE")));
  expect_same(expected, packed);

  const auto messages = made("messages");
  testing::write_db3(messages / "a_0.db3", recording, 0, all, true);
  static_cast<void>(folder.file("messages/metadata.yaml",
                                testing::metadata_yaml(recording, {"a_0.db3"}, "MESSAGE")));
  expect_same(expected, messages);

  const auto mcap = made("mcap");
  static_cast<void>(folder.file("mcap/a_0.mcap", McapBuilder::build(recording, {})));
  static_cast<void>(
      folder.file("mcap/metadata.yaml", testing::metadata_yaml(recording, {"a_0.mcap"}, "")));
  expect_same(expected, mcap);
}

TEST(RecordingContainers, Db3OfAKilledRecorderIsReadWithItsLogAndLeftAlone) {
  const TempFolder folder;
  const Content expected = reference(folder);
  const TestRecording recording = street();
  const auto open_path = folder.path() / "open.db3";
  testing::write_db3(open_path, recording, 0, 0);
  sqlite3* db = nullptr;
  sqlite3_open(open_path.c_str(), &db);
  // Having read once, this connection keeps the log alive when the writer closes.
  sqlite3_exec(
      db, "PRAGMA journal_mode=WAL; SELECT count(*) FROM messages", nullptr, nullptr, nullptr);
  testing::write_db3(open_path, recording, 0, recording.messages.size());
  // As a kill leaves it: the messages are in the log only.
  std::filesystem::create_directory(folder.path() / "killed");
  const auto killed = folder.path() / "killed/a.db3";
  std::filesystem::copy_file(open_path, killed);
  std::filesystem::copy_file(open_path.string() + "-wal", killed.string() + "-wal");
  sqlite3_close(db);
  const std::string before = testing::content_of(killed);
  expect_same(expected, killed);
  EXPECT_EQ(testing::content_of(killed), before);
  const auto files = std::distance(std::filesystem::directory_iterator(killed.parent_path()), {});
  EXPECT_EQ(files, 2);
}

TEST(RecordingContainers, FolderOfPcdScansGivesTheSameWithTimesInNamesOrInAFile) {
  const TempFolder folder;
  const Content expected = reference(folder);
  std::filesystem::create_directories(folder.path() / "rec/scans");
  std::string imu = "time,gx,gy,gz,ax,ay,az\n";
  std::string gnss;
  std::string times;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t t = kStart_ns + i * 10'000'000LL;
    imu += fmt::format("{},{},0,0,0,0,9.81\n", t, 0.01 * i);
    if (i % 20 == 0) {
      gnss += fmt::format("{}.{:09},{},11.5,520,1.5,1.5,1.5\n",
                          t / 1'000'000'000,
                          t % 1'000'000'000,
                          48.0 + 1e-6 * i);
    }
    if (i % 10 != 0) continue;
    std::string pcd =
        "VERSION 0.7\nFIELDS x y z time\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 50\n"
        "HEIGHT 1\nPOINTS 50\nDATA binary\n";
    for (int k = 0; k < 50; ++k) {
      for (const double value : {1.0 + k + i, 2.0, 3.0, k * 0.002}) {
        testing::put(pcd, static_cast<float>(value));
      }
    }
    static_cast<void>(folder.file(fmt::format("rec/scans/{}.pcd", t), pcd));
    times += fmt::format("{}.pcd {}\n", t, t);
  }
  static_cast<void>(folder.file("rec/imu.csv", imu));
  static_cast<void>(folder.file("rec/gnss.csv", gnss));
  const auto compare = [&] {
    const Content content = read_all(folder.path() / "rec");
    EXPECT_EQ(content.scans, expected.scans);
    EXPECT_EQ(content.imu, expected.imu);
    EXPECT_EQ(content.fixes, expected.fixes);
    EXPECT_THAT(content.summary.point_time, HasSubstr("'time'"));
  };
  compare();
  static_cast<void>(folder.file("rec/times.txt", "# name time\n" + times));
  compare();
  EXPECT_EQ(read_all(folder.path() / "rec", {.gnss_topic = "none"}).fixes, "");

  static_cast<void>(folder.file("rec/times.txt", times.substr(0, times.size() / 2)));
  const auto untimed = open_recording(folder.path() / "rec");
  ASSERT_FALSE(untimed);
  EXPECT_THAT(untimed.error().message, AllOf(HasSubstr(".pcd"), HasSubstr("times.txt")));
}

TEST(RecordingContainers, FolderNamesWhatIsMissingOrDamaged) {
  const TempFolder folder;
  const auto refusal = [&](const std::filesystem::path& path) {
    const auto source = open_recording(path);
    EXPECT_FALSE(source);
    return source ? std::string() : source.error().message;
  };
  EXPECT_THAT(refusal(folder.path()), HasSubstr("a folder without a recording"));
  static_cast<void>(folder.file("imu.csv", "1700000000.5,0,0,0,0,0,9.81\nnonsense,1\n"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("no scans"));
  const std::string pcd =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
      "POINTS 1\nDATA ascii\n1 2 3\n";
  const auto numbered = folder.file("000001.pcd", pcd);
  EXPECT_THAT(refusal(folder.path()), AllOf(HasSubstr("000001.pcd"), HasSubstr("no time")));
  std::filesystem::remove(numbered);
  static_cast<void>(folder.file("1700000000.5.pcd", pcd));
  static_cast<void>(folder.file("1700000000.6.pcd", pcd.substr(0, 60)));
  const Content content = read_all(folder.path());
  EXPECT_EQ(content.summary.num_scans, 1U);
  EXPECT_EQ(content.summary.num_imu_samples, 1U);
  EXPECT_EQ(content.summary.num_damaged_messages, 2U);
}

TEST(RecordingContainers, CutFilesGiveTheirStartAndSaySo) {
  const TempFolder folder;
  const Content expected = reference(folder);
  const auto check = [&](const std::filesystem::path& path) {
    SCOPED_TRACE(path.string());
    const Content content = read_all(path);
    EXPECT_GT(content.summary.num_imu_samples, 20U);
    EXPECT_LT(content.summary.num_imu_samples, 100U);
    EXPECT_TRUE(content.summary.truncated);
    EXPECT_TRUE(expected.imu.starts_with(content.imu));
  };
  const std::string mcap = McapBuilder::build(street(), {.compression = "zstd"});
  check(folder.file("cut.mcap", mcap.substr(0, mcap.size() * 6 / 10)));
  const std::string flat = McapBuilder::build(street(), {.chunked = false});
  check(folder.file("flat.mcap", flat.substr(0, flat.size() / 2)));
  const std::string open = McapBuilder::build(street(), {.chunked = true, .finished = false});
  EXPECT_TRUE(read_all(folder.file("open.mcap", open)).summary.truncated);
  // Several frames, of which the first ones are whole.
  const std::string bag = testing::rosbag1_of(street());
  std::string packed;
  for (std::size_t i = 0; i < 10; ++i) {
    const std::size_t begin = i * bag.size() / 10;
    packed += testing::zstd_packed(bag.substr(begin, (i + 1) * bag.size() / 10 - begin));
  }
  check(folder.file("cut.bag.zst", packed.substr(0, packed.size() * 8 / 10)));
}

TEST(RecordingContainers, DamagedFilesEndInMessagesOrAnErrorNeverInACrash) {
  const TempFolder folder;
  const TestRecording recording = street();
  testing::write_db3(folder.path() / "good.db3", recording, 0, recording.messages.size());
  const std::vector<std::string> goods = {McapBuilder::build(recording, {.compression = "lz4"}),
                                          McapBuilder::build(recording, {.chunked = false}),
                                          testing::content_of(folder.path() / "good.db3"),
                                          testing::zstd_packed(testing::rosbag1_of(recording))};
  std::size_t opened = 0;
  for (std::size_t g = 0; g < goods.size(); ++g) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      const std::string bytes = testing::mutated(goods[g], 1000 * g + i);
      const auto path = folder.file("damaged", bytes.empty() ? "x" : bytes);
      auto source = open_recording(path);
      if (!source) {
        EXPECT_FALSE(source.error().message.empty());
        continue;
      }
      ++opened;
      for (auto message = (*source)->next(); message && *message;) message = (*source)->next();
    }
  }
  EXPECT_GT(opened, 60U);
}

TEST(RecordingContainers, HostileFilesAreRefused) {
  const TempFolder folder;
  const auto refusal = [&](const std::filesystem::path& path) {
    const auto source = open_recording(path);
    EXPECT_FALSE(source);
    return source ? std::string() : source.error().message;
  };
  // A view could run a query of the file's own that never ends.
  sqlite3* db = nullptr;
  sqlite3_open((folder.path() / "view.db3").c_str(), &db);
  sqlite3_exec(db,
               "CREATE TABLE topics(id, name, type, serialization_format);"
               "CREATE VIEW messages AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 "
               "FROM n) SELECT id, 1 AS topic_id, 1 AS timestamp, 'x' AS data FROM n",
               nullptr,
               nullptr,
               nullptr);
  sqlite3_close(db);
  EXPECT_THAT(refusal(folder.path() / "view.db3"), HasSubstr("not a sound ROS 2 bag"));
  // 64 MiB of zeros in a few kilobytes, repeated: unpacking stops long before the disk is full.
  const std::string bomb = testing::zstd_packed(std::string(std::size_t{64} << 20, '\0'));
  std::string bombs;
  for (int i = 0; i < 40; ++i) bombs += bomb;
  EXPECT_THAT(refusal(folder.file("bomb.bag.zst", bombs)), HasSubstr("times its size"));
  std::filesystem::create_directory(folder.path() / "bag");
  static_cast<void>(folder.file("bag/metadata.yaml",
                                "rosbag2_bagfile_information:\n  relative_file_paths: [..]\n"));
  EXPECT_THAT(refusal(folder.path() / "bag"), HasSubstr("is no file"));
  static_cast<void>(folder.file("bag/metadata.yaml", "rosbag2_bagfile_information: [\n"));
  EXPECT_THAT(refusal(folder.path() / "bag"), HasSubstr("line"));
  EXPECT_THAT(refusal(folder.file("x.bag", "hello")), HasSubstr("nor a ROS 2 bag"));
  const auto unwritable = open_recording(folder.file("a.bag.zst", testing::zstd_packed("x")),
                                         {.scratch_folder = "/nowhere"});
  ASSERT_FALSE(unwritable);
  EXPECT_EQ(unwritable.error().code, ErrorCode::kIo);
  EXPECT_THAT(unwritable.error().message, HasSubstr("recording.scratch_folder"));
}

TEST(RecordingContainers, UnpackingStopsWhenAsked) {
  const TempFolder folder;
  std::stop_source stop;
  stop.request_stop();
  const auto source =
      open_recording(folder.file("a.bag.zst", testing::zstd_packed(testing::rosbag1_of(street()))),
                     {},
                     {.stop = stop.get_token()});
  ASSERT_FALSE(source);
  EXPECT_EQ(source.error().code, ErrorCode::kCancelled);
}

TEST(RecordingContainers, Rosbag2FixturesGiveTheirTopicsAndCounts) {
  const auto root = testing::test_data("formats/rosbag2");
  if (!root) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  for (const char* const storage : {"mcap", "sqlite3"}) {
    const auto folder = *root / "rosbag2_py/test/resources" / storage / "wbag";
    const auto summary = inspect_recording(folder);
    ASSERT_TRUE(summary) << summary.error().message;
    std::uint64_t messages = 0;
    for (const RecordingTopic& topic : summary->topics) messages += topic.messages.value_or(0);
    EXPECT_EQ(messages, 6074U) << folder;  // message_count of its metadata.yaml
  }
  for (const char* const file : {"rosbag2_cpp/test/rosbag2_cpp/bags/only_topics.mcap",
                                 "rosbag2_cpp/test/rosbag2_cpp/bags/topics_and_services.db3",
                                 "rosbag2_tests/resources/mcap/cdr_test",
                                 "rosbag2_tests/resources/sqlite3/cdr_test",
                                 "rosbag2_py/test/resources/mcap/talker"}) {
    const auto summary = inspect_recording(*root / file);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_FALSE(summary->topics.empty()) << file;
    const auto source = open_recording(*root / file);
    ASSERT_FALSE(source);
    EXPECT_THAT(source.error().message, HasSubstr("no LiDAR topic"));
  }
  const auto empty = inspect_recording(*root / "ros2bag/test/resources/empty_bag");
  EXPECT_TRUE(empty) << empty.error().message;
}

}  // namespace
}  // namespace hybridfusion
