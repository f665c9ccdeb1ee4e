#include "mutations.hpp"
#include "recorded_content.hpp"

namespace hybridfusion {
namespace {

using testing::Content;
using ::testing::HasSubstr;
using testing::McapBuilder;
using testing::read_all;
using testing::reference;
using testing::street;
using testing::TempFolder;
using testing::TestRecording;

TEST(DamagedRecordings, CutFilesGiveTheirStartAndSaySo) {
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

TEST(DamagedRecordings, DamagedFilesEndInMessagesOrAnErrorNeverInACrash) {
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

TEST(DamagedRecordings, HostileFilesAreRefused) {
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

TEST(DamagedRecordings, WhatIsNoRecordingIsNamedWithTheWayOut) {
  const TempFolder folder;
  const auto refusal = [&](const std::filesystem::path& path) {
    const auto source = open_recording(path);
    EXPECT_FALSE(source);
    return source ? std::string() : source.error().message;
  };
  EXPECT_THAT(refusal(folder.file("a.bag",
                                  "version https://git-lfs.github.com/spec/v1\noid "
                                  "sha256:00\nsize 1234\n")),
              ::testing::AllOf(HasSubstr("Git LFS"), HasSubstr("git lfs pull")));
  for (const char* const magic : {"\xd4\xc3\xb2\xa1", "\x0a\x0d\x0d\x0a", "\xa1\xb2\xc3\xd4"}) {
    EXPECT_THAT(refusal(folder.file("a.pcap", std::string(magic) + "....................")),
                HasSubstr("pcap"));
  }
  for (const auto& [type, decoder] :
       {std::pair("velodyne_msgs/VelodyneScan", "velodyne_pointcloud"),
        std::pair("ouster_sensor_msgs/msg/PacketMsg", "ouster_ros"),
        std::pair("rslidar_msg/msg/RslidarPacket", "rslidar_sdk")}) {
    testing::BagBuilder bag;
    const auto packets = bag.add_topic("/packets", type);
    const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
    bag.add_message(packets, testing::kStart_ns, "x");
    bag.add_message(imu, testing::kStart_ns, testing::imu_message(testing::kStart_ns, 0.0, 9.81));
    EXPECT_THAT(
        refusal(folder.file("p.bag", bag.finish())),
        ::testing::AllOf(HasSubstr("/packets holds undecoded packets"), HasSubstr(decoder)));
  }
}

TEST(DamagedRecordings, UnpackingStopsWhenAsked) {
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

}  // namespace
}  // namespace hybridfusion
