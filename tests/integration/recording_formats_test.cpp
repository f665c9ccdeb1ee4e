#include "container_builders.hpp"
#include "recording_editor.hpp"
#include "street_drive.hpp"

#include <hybridfusion/core/error.hpp>

#include <gmock/gmock.h>

namespace hybridfusion::testing {
namespace {

/// Serialises a ROS 1 message anew for ROS 2: same values, without the header's sequence number,
/// aligned, texts with their closing zero.
class Transcoder {
 public:
  explicit Transcoder(const std::string& ros1) : in_(ros1) { at_ = 4; }

  template <class T>
  T copy() {
    T value{};
    std::memcpy(&value, in_.substr(at_, sizeof(T)).data(), sizeof(T));
    at_ += sizeof(T);
    out_.put_value(value);
    return value;
  }
  void copy_doubles(int count) {
    for (int i = 0; i < count; ++i) copy<double>();
  }
  void copy_text() {
    const std::uint32_t size = take_size();
    out_.put_text(in_.substr(at_, size));
    at_ += size;
  }
  void copy_header() {
    copy<std::uint32_t>();
    copy<std::uint32_t>();
    copy_text();
  }
  void copy_bytes() {
    const auto size = copy<std::uint32_t>();
    out_.put_bytes(in_.substr(at_, size));
    at_ += size;
  }
  [[nodiscard]] std::string message() const {
    HF_CHECK(at_ == in_.size());
    return out_.message();
  }

 private:
  std::uint32_t take_size() {
    std::uint32_t size = 0;
    std::memcpy(&size, in_.substr(at_, 4).data(), 4);
    at_ += 4;
    return size;
  }

  const std::string& in_;
  std::size_t at_ = 0;
  CdrWriter out_ = {};
};

std::string cdr_of(const RawMessage& message) {
  Transcoder to(message.data);
  to.copy_header();
  if (message.type == kImuType) {
    to.copy_doubles(4 + 9 + 3 + 9 + 3 + 9);
  } else if (message.type == kFixType) {
    to.copy<std::int8_t>();
    to.copy<std::uint16_t>();
    to.copy_doubles(3 + 9);
    to.copy<std::uint8_t>();
  } else {
    to.copy<std::uint32_t>();
    to.copy<std::uint32_t>();
    const auto num_fields = to.copy<std::uint32_t>();
    for (std::uint32_t i = 0; i < num_fields; ++i) {
      to.copy_text();
      to.copy<std::uint32_t>();
      to.copy<std::uint8_t>();
      to.copy<std::uint32_t>();
    }
    to.copy<std::uint8_t>();
    to.copy<std::uint32_t>();
    to.copy<std::uint32_t>();
    to.copy_bytes();
    to.copy<std::uint8_t>();
  }
  return to.message();
}

TestRecording recording_of(const std::vector<RawMessage>& messages) {
  TestRecording recording;
  recording.topics.clear();
  for (const RawMessage& message : messages) {
    auto topic = std::ranges::find(recording.topics, message.topic, &TestTopic::name);
    if (topic == recording.topics.end()) {
      recording.topics.push_back({.name = message.topic, .type = message.type});
      topic = recording.topics.end() - 1;
    }
    recording.messages.push_back(
        {.topic = static_cast<std::uint16_t>(topic - recording.topics.begin()),
         .time_ns = message.recorded_ns,
         .ros1 = message.data,
         .cdr = cdr_of(message)});
  }
  return recording;
}

using RecordingFormats = StreetTest;

TEST_F(RecordingFormats, MapGivesTheSameBytesFromEveryContainer) {
  const std::string bag = (street() / "street.bag").string();
  ASSERT_EQ(map(bag, "reference").exit_code, 0);
  const TestRecording recording = recording_of(read_messages(bag));
  write("zst/a.bag.zst", zstd_packed(read_file(bag)));
  write("mcap/a.mcap", McapBuilder::build(recording, {.compression = "lz4"}));
  write("mcap_zstd/a.mcap", McapBuilder::build(recording, {.compression = "zstd"}));
  std::filesystem::create_directories(path("db3"));
  write_db3(path("db3/a.db3"), recording, 0, recording.messages.size());
  for (const char* const file : {"zst/a.bag.zst", "mcap/a.mcap", "mcap_zstd/a.mcap", "db3/a.db3"}) {
    SCOPED_TRACE(file);
    const ProgramResult result = map(path(file), "ws");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    for (const char* const name : {"lidar/map.ply", "lidar/trajectory.tum", "lidar/gnss.json"}) {
      EXPECT_TRUE(read_file(folder_ / "ws" / name) == read_file(folder_ / "reference" / name))
          << name;
    }
  }
}

TEST_F(RecordingFormats, AGivenTimeOffsetTakesBackThatOfTheImu) {
  std::vector<RawMessage> messages = read_messages(street() / "street.bag");
  for (RawMessage& message : messages) {
    if (message.type == kImuType) set_stamp(stamp_ns(message) - 50'000'000, message);
  }
  write_messages(path("late.bag"), messages);
  ASSERT_EQ(map((street() / "street.bag").string(), "reference").exit_code, 0);
  const ProgramResult result =
      map(path("late.bag"), "ws", {"--set", "lidar.odometry.imu_time_offset_s=0.05"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  // Where the IMU starts with respect to the scans is another sample now.
  EXPECT_NEAR(error_m("ws"), error_m("reference"), 0.002);
  EXPECT_THAT(result.err, ::testing::Not(::testing::HasSubstr("time offset")));
}

}  // namespace
}  // namespace hybridfusion::testing
