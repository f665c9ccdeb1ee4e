#include "recorded_content.hpp"

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::Content;
using testing::expect_same;
using ::testing::HasSubstr;
using testing::kStart_ns;
using testing::McapBuilder;
using testing::read_all;
using testing::reference;
using testing::street;
using testing::TempFolder;
using testing::TestRecording;

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

TEST(RecordingContainers, McapMessagesThatTheIndexLeavesOutAreRead) {
  const TempFolder folder;
  const Content expected = reference(folder);
  int number = 0;
  const auto check = [&](const McapBuilder::Layout& layout) {
    const auto path =
        folder.file(fmt::format("{}.mcap", number++), McapBuilder::build(street(), layout));
    expect_same(expected, path);
    return read_all(path).summary.warnings;
  };
  for (const char* const compression : {"", "lz4", "zstd"}) {
    // Clouds have some 900 bytes, fixes 160, IMU samples 340: some or all stand between the chunks.
    for (const std::size_t outside_above : {500U, 250U, 1U}) {
      EXPECT_THAT(check({.compression = compression, .outside_above = outside_above}),
                  ::testing::IsEmpty());
    }
    check({.compression = compression, .outside_above = 500, .unindexed_chunks = 1});
    EXPECT_THAT(check({.compression = compression, .unindexed_chunks = 2}), ::testing::IsEmpty());
  }
  EXPECT_THAT(check({.channel_counts = false}), ::testing::IsEmpty());
  EXPECT_THAT(
      check({.miscounted = 7}),
      ::testing::ElementsAre(AllOf(HasSubstr("122 messages"), HasSubstr("115 were found"))));
  check({.miscounted = -7});
}

TEST(RecordingContainers, PartsOfARos2BagAreReadInTheOrderOfTheirTimes) {
  const TempFolder folder;
  const Content expected = reference(folder);
  const TestRecording recording = street();
  const std::size_t all = recording.messages.size();
  const auto bag = folder.path() / "bag";
  std::filesystem::create_directory(bag);
  for (std::size_t part = 0; part < 12; ++part) {
    testing::write_db3(
        bag / fmt::format("bag_{}.db3", part), recording, part * all / 12, (part + 1) * all / 12);
  }
  const auto listed = [&](std::vector<int> order) {
    std::vector<std::string> files;
    for (const int part : order) files.push_back(fmt::format("bag_{}.db3", part));
    static_cast<void>(
        folder.file("bag/metadata.yaml", testing::metadata_yaml(recording, files, "")));
  };
  listed({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  expect_same(expected, bag);
  listed({0, 1, 10, 11, 2, 3, 4, 5, 6, 7, 8, 9});  // as a program sorts names
  expect_same(expected, bag);
  listed({11, 3, 2, 5, 7, 1, 9, 10, 8, 6, 4, 0});
  expect_same(expected, bag);
  listed({});  // as a killed recorder leaves it
  expect_same(expected, bag);
  std::filesystem::remove(bag / "metadata.yaml");
  expect_same(expected, bag);
}

TEST(RecordingContainers, MetadataOfEveryVersionIsRead) {
  const TempFolder folder;
  const Content expected = reference(folder);
  const TestRecording recording = street();
  std::filesystem::create_directory(folder.path() / "bag");
  testing::write_db3(folder.path() / "bag/a_0.db3", recording, 0, recording.messages.size());
  for (int version = 4; version <= 9; ++version) {
    std::string text = fmt::format(
        "rosbag2_bagfile_information:\n  version: {}\n  storage_identifier: sqlite3\n"
        "  duration:\n    nanoseconds: 990000000\n  starting_time:\n"
        "    nanoseconds_since_epoch: 1700000000000000000\n  message_count: 115\n"
        "  compression_format: \"\"\n  compression_mode: \"\"\n"
        "  relative_file_paths:\n    - a_0.db3\n  topics_with_message_count:\n",
        version);
    for (const testing::TestTopic& topic : recording.topics) {
      text += fmt::format(
          "    - topic_metadata:\n        name: {}\n        type: {}\n"
          "        serialization_format: cdr\n",
          topic.name,
          topic.ros2_type());
      text += version < 9 ? "        offered_qos_profiles: \"- history: 1\\n  depth: 10\"\n"
                          : "        offered_qos_profiles:\n          - history: keep_last\n"
                            "            depth: 10\n            deadline:\n              sec: 1\n";
      if (version >= 7) text += "        type_description_hash: RIHS01_00ff\n";
      text += "      message_count: 50\n";
    }
    if (version >= 5) {
      text +=
          "  files:\n    - path: a_0.db3\n      starting_time:\n"
          "        nanoseconds_since_epoch: 1700000000000000000\n      message_count: 115\n";
    }
    if (version >= 6) text += "  custom_data: ~\n";
    if (version >= 8) text += "  ros_distro: jazzy\n";
    static_cast<void>(folder.file("bag/metadata.yaml", text));
    expect_same(expected, folder.path() / "bag");
  }
}

TEST(RecordingContainers, OfSeveralDrivesInOneFolderOneMustBeChosen) {
  const TempFolder folder;
  const TestRecording recording = street();
  const auto refusal = [&] {
    const auto source = open_recording(folder.path());
    EXPECT_FALSE(source);
    return source ? std::string() : source.error().message;
  };
  static_cast<void>(folder.file("monday.bag", testing::rosbag1_of(recording)));
  EXPECT_THAT(refusal(), AllOf(HasSubstr("monday.bag"), HasSubstr("this one itself")));
  std::filesystem::create_directory(folder.path() / "tuesday");
  static_cast<void>(folder.file("tuesday/metadata.yaml", "x"));
  EXPECT_THAT(refusal(), AllOf(HasSubstr("monday.bag, tuesday"), HasSubstr("one of these")));
  static_cast<void>(folder.file("a_0.mcap", McapBuilder::build(recording, {})));
  static_cast<void>(folder.file("b_0.mcap", McapBuilder::build(recording, {})));
  EXPECT_THAT(refusal(), AllOf(HasSubstr("a_0.mcap, b_0.mcap"), HasSubstr("several recordings")));
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

  // A row of another hour holds nothing up.
  std::string displaced = imu;
  displaced.insert(displaced.find(fmt::format("{},", kStart_ns + 300'000'000LL)),
                   fmt::format("{},9,0,0,0,0,9.81\n", kStart_ns + 3'600'000'000'000LL));
  static_cast<void>(folder.file("rec/imu.csv", displaced));
  const Content repaired = read_all(folder.path() / "rec");
  EXPECT_EQ(repaired.imu, expected.imu);
  EXPECT_EQ(repaired.summary.imu_stamps.dropped, 1U);
  static_cast<void>(folder.file("rec/imu.csv", imu));

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
