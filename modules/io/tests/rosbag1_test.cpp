#include "bag_builder.hpp"
#include "mutations.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/rosbag1.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::BagBuilder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::TempFolder;

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;

struct ReadBack {
  std::vector<std::int64_t> times_ms;  ///< After kStart_ns.
  std::vector<std::string> data;
};

ReadBack read_all(Rosbag1Reader& reader) {
  ReadBack result;
  for (;;) {
    const auto message = reader.next();
    EXPECT_TRUE(message) << message.error().message;
    if (!message || !*message) return result;
    result.times_ms.push_back(((*message)->time.count() - kStart_ns) / 1'000'000);
    result.data.emplace_back(reinterpret_cast<const char*>((*message)->data.data()),
                             (*message)->data.size());
  }
}

/// Two topics, four chunks of ten messages; every tenth message was recorded late.
std::string forty_messages(const std::string& compression,
                           BagBuilder::Index index = BagBuilder::Index::kWritten) {
  BagBuilder bag(compression);
  const auto a = bag.add_topic("/a", "std_msgs/String");
  const auto b = bag.add_topic("/b", "sensor_msgs/Imu");
  for (int i = 0; i < 40; ++i) {
    bag.add_message(
        i % 2 == 0 ? a : b, kStart_ns + i * 1'000'000LL, "message " + std::to_string(i));
    if (i % 10 == 9) bag.end_chunk();
  }
  return bag.finish(index);
}

class EveryCompression : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Rosbag1, EveryCompression, ::testing::Values("none", "bz2", "lz4"));

TEST_P(EveryCompression, DeliversAllMessagesWithTheirTopics) {
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(folder.file("a.bag", forty_messages(GetParam())));
  ASSERT_TRUE(reader) << reader.error().message;
  ASSERT_EQ(reader->connections().size(), 2U);
  EXPECT_EQ(reader->connections()[1].topic, "/b");
  EXPECT_EQ(reader->connections()[1].type, "sensor_msgs/Imu");
  EXPECT_EQ(reader->connections()[1].messages, 20U);
  const ReadBack all = read_all(*reader);
  ASSERT_EQ(all.data.size(), 40U);
  EXPECT_EQ(all.data[17], "message 17");
  EXPECT_EQ(all.times_ms[17], 17);
  EXPECT_FALSE(reader->truncated());
  EXPECT_TRUE(reader->warnings().empty());
}

TEST_P(EveryCompression, WithoutIndexTheSameMessagesComeWithAWarning) {
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(
      folder.file("a.bag", forty_messages(GetParam(), BagBuilder::Index::kMissing)));
  ASSERT_TRUE(reader) << reader.error().message;
  ASSERT_EQ(reader->connections().size(), 2U);
  EXPECT_EQ(reader->connections()[0].messages, std::nullopt);
  EXPECT_EQ(read_all(*reader).data.size(), 40U);
  EXPECT_FALSE(reader->truncated());
  ASSERT_EQ(reader->warnings().size(), 1U);
  EXPECT_THAT(reader->warnings()[0], HasSubstr("no usable index"));
}

TEST_P(EveryCompression, CutAnywhereGivesWhatPrecedesTheCut) {
  const TempFolder folder;
  const std::string good = forty_messages(GetParam());
  std::size_t last_count = 0;
  for (std::size_t size = 5000; size < good.size(); size += 97) {
    auto reader = Rosbag1Reader::open(folder.file("cut.bag", good.substr(0, size)));
    ASSERT_TRUE(reader) << reader.error().message;
    const ReadBack all = read_all(*reader);
    EXPECT_GE(all.data.size(), last_count) << "a longer file must not give less";
    last_count = all.data.size();
    for (std::size_t i = 0; i < all.data.size(); ++i) {
      EXPECT_EQ(all.data[i], "message " + std::to_string(i));
    }
    EXPECT_TRUE(reader->truncated() || all.data.size() == 40U) << size;
  }
  EXPECT_EQ(last_count, 40U);  // the last cuts only hit the index
}

TEST_P(EveryCompression, RandomDamageNeverCrashes) {
  const TempFolder folder;
  const std::string good = forty_messages(GetParam());
  for (std::uint64_t i = 0; i < 300; ++i) {
    auto reader = Rosbag1Reader::open(folder.file("bad.bag", testing::mutated(good, i)));
    if (!reader) continue;
    for (auto message = reader->next(); message && *message; message = reader->next()) {
    }
  }
}

TEST(Rosbag1, TruncationIsReportedWithItsByte) {
  BagBuilder bag;
  const auto topic = bag.add_topic("/a", "std_msgs/String");
  for (int i = 0; i < 3; ++i) {
    bag.add_message(topic, kStart_ns + i, std::string(1000, 'x'));
    bag.end_chunk();
  }
  const TempFolder folder;
  const std::uint64_t third_chunk = bag.chunk_positions()[2];
  auto reader =
      Rosbag1Reader::open(folder.file("a.bag", bag.finish().substr(0, third_chunk + 300)));
  ASSERT_TRUE(reader);
  EXPECT_EQ(read_all(*reader).data.size(), 2U);
  EXPECT_TRUE(reader->truncated());
  EXPECT_THAT(reader->warnings().back(), HasSubstr("byte " + std::to_string(third_chunk)));
}

TEST(Rosbag1, OneDamagedChunkCostsOnlyItself) {
  std::string bag = forty_messages("bz2");
  const std::size_t second = bag.find("BZh", bag.find("BZh") + 1);
  bag[second + 20] ^= '\x40';
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(folder.file("a.bag", bag));
  ASSERT_TRUE(reader);
  const ReadBack all = read_all(*reader);
  EXPECT_EQ(all.data.size(), 30U);
  EXPECT_EQ(all.data[10], "message 20");
  ASSERT_EQ(reader->warnings().size(), 1U);
  EXPECT_THAT(reader->warnings()[0], HasSubstr("damaged"));
  EXPECT_FALSE(reader->truncated());
}

TEST(Rosbag1, MessagesOfOverlappingChunksComeInTimeOrder) {
  for (const auto index : {BagBuilder::Index::kWritten, BagBuilder::Index::kMissing}) {
    BagBuilder bag;
    const auto topic = bag.add_topic("/a", "std_msgs/String");
    for (const int ms : {5, 1, 7, 30}) bag.add_message(topic, kStart_ns + ms * 1'000'000LL, "x");
    bag.end_chunk();
    for (const int ms : {6, 20, 31}) bag.add_message(topic, kStart_ns + ms * 1'000'000LL, "x");
    const TempFolder folder;
    auto reader = Rosbag1Reader::open(folder.file("a.bag", bag.finish(index)));
    ASSERT_TRUE(reader);
    EXPECT_THAT(read_all(*reader).times_ms, ElementsAre(1, 5, 6, 7, 20, 30, 31));
  }
}

TEST(Rosbag1, EqualTimesKeepTheOrderOfTheFile) {
  BagBuilder bag;
  const auto topic = bag.add_topic("/a", "std_msgs/String");
  for (const char* const text : {"1", "2", "3", "4"}) {
    bag.add_message(topic, kStart_ns, text);
    if (*text == '2') bag.end_chunk();
  }
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(folder.file("a.bag", bag.finish()));
  ASSERT_TRUE(reader);
  EXPECT_THAT(read_all(*reader).data, ElementsAre("1", "2", "3", "4"));
}

TEST(Rosbag1, OnlySelectedTopicsAreDelivered) {
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(folder.file("a.bag", forty_messages("lz4")));
  ASSERT_TRUE(reader);
  reader->select_topics({"/b", "/c"});
  const ReadBack all = read_all(*reader);
  EXPECT_EQ(all.data.size(), 20U);
  EXPECT_EQ(all.data[0], "message 1");
}

TEST(Rosbag1, ABagWithoutMessagesIsEmptyNotAnError) {
  BagBuilder bag;
  static_cast<void>(bag.add_topic("/a", "std_msgs/String"));
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(folder.file("a.bag", bag.finish()));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->connections().size(), 1U);
  EXPECT_TRUE(read_all(*reader).data.empty());
  EXPECT_TRUE(reader->warnings().empty());
}

TEST(Rosbag1, ALyingChunkSizeTakesNoMemory) {
  BagBuilder bag;
  const auto topic = bag.add_topic("/a", "std_msgs/String");
  bag.add_message(topic, kStart_ns, "x");
  std::string bytes = bag.finish();
  const std::size_t size_field = bytes.find("size=");
  bytes.replace(size_field + 5, 4, "\xff\xff\xff\xff");
  const TempFolder folder;
  auto reader = Rosbag1Reader::open(folder.file("a.bag", bytes));
  ASSERT_TRUE(reader);
  EXPECT_TRUE(read_all(*reader).data.empty());
  EXPECT_THAT(reader->warnings().back(), HasSubstr("announces"));
}

TEST(Rosbag1, WhatIsNotABagIsNamedWithTheWayOut) {
  const TempFolder folder;
  const auto message = [&](std::string_view content) {
    const auto reader = Rosbag1Reader::open(folder.file("x.bag", content));
    EXPECT_FALSE(reader);
    EXPECT_EQ(reader.error().code, ErrorCode::kParse);
    EXPECT_THAT(reader.error().message, HasSubstr("x.bag"));
    return reader.error().message;
  };
  EXPECT_THAT(message(""), HasSubstr("empty"));
  EXPECT_THAT(message("hello"), HasSubstr("not a ROS 1 bag"));
  EXPECT_THAT(message("#ROSBAG V1.2\n..."), HasSubstr("rosbag fix"));
  EXPECT_THAT(message("SQLite format 3 ..."), HasSubstr("ROS 2"));
  EXPECT_THAT(message("#ROSBAG V2.0\n"), HasSubstr("header"));
  const auto missing = Rosbag1Reader::open(folder.path() / "none.bag");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
}

TEST(Rosbag1, FoxgloveFixturesGiveMessagesOrAClearError) {
  const auto folder = testing::test_data("formats/rosbag_fixtures/fixtures");
  if (!folder) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  std::vector<std::size_t> counts;
  for (const char* const name : {"example.bag", "example-bz2.bag", "example-lz4.bag"}) {
    auto reader = Rosbag1Reader::open(*folder / name);
    ASSERT_TRUE(reader) << reader.error().message;
    std::size_t announced = 0;
    for (const BagConnection& connection : reader->connections()) announced += *connection.messages;
    std::size_t count = 0;
    for (auto message = reader->next(); message && *message; message = reader->next()) ++count;
    EXPECT_EQ(count, announced);
    EXPECT_TRUE(reader->warnings().empty());
    counts.push_back(count);
  }
  EXPECT_THAT(counts, ElementsAre(8647U, 8647U, 8647U));
  for (const char* const name : {"empty-file.bag", "asci-file.txt"}) {
    const auto reader = Rosbag1Reader::open(*folder / name);
    ASSERT_FALSE(reader);
    EXPECT_EQ(reader.error().code, ErrorCode::kParse);
  }
  auto reader = Rosbag1Reader::open(*folder / "no-messages.bag");
  ASSERT_TRUE(reader);
  EXPECT_FALSE(reader->next().value().has_value());
}

}  // namespace
}  // namespace hybridfusion
