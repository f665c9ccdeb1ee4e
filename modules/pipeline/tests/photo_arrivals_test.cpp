#include "photo_arrivals.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/jpeg.hpp>

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// A folder of its own and a clock that the test moves.
class PhotoArrivalsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("hf_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static std::string jpeg(std::uint8_t grey) {
    Image8 image{.width = 32, .height = 24, .channels = 3};
    image.pixels.assign(32 * 24 * 3, grey);
    return encode_jpeg(image, 90).value();
  }
  void put(const std::string& name, const std::string& bytes) const {
    ASSERT_TRUE(write_file_atomically(folder_ / name, bytes));
  }
  std::vector<PhotoArrival> look_after(std::chrono::milliseconds time) {
    now_ += time;
    auto arrived = arrivals_.look(now_);
    EXPECT_TRUE(arrived) << arrived.error().message;
    return arrived ? *std::move(arrived) : std::vector<PhotoArrival>{};
  }

  std::filesystem::path folder_;
  PhotoArrivals::Clock::time_point now_ = {};
  PhotoArrivals arrivals_{
      std::filesystem::temp_directory_path() /
      ("hf_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))};
};

TEST_F(PhotoArrivalsTest, AFileHasArrivedWhenItStaysTheSame) {
  EXPECT_TRUE(look_after(0ms).empty());
  put("a.JPG", jpeg(10));
  put("notes.txt", "no photo");
  EXPECT_TRUE(look_after(100ms).empty());
  EXPECT_TRUE(arrivals_.expects_more());
  EXPECT_TRUE(look_after(40ms).empty());
  const auto arrived = look_after(40ms);
  ASSERT_EQ(arrived.size(), 1U);
  ASSERT_TRUE(arrived[0].photo) << arrived[0].reason;
  EXPECT_EQ(arrived[0].photo->metadata.name, "a.JPG");
  EXPECT_EQ(arrived[0].seen, PhotoArrivals::Clock::time_point{} + 100ms);
  EXPECT_FALSE(arrivals_.expects_more());
  EXPECT_TRUE(look_after(10s).empty());
}

TEST_F(PhotoArrivalsTest, AHalfCopiedPhotoIsWaitedFor) {
  const std::string whole = jpeg(50);
  put("a.jpg", whole.substr(0, whole.size() / 2));
  EXPECT_TRUE(look_after(0ms).empty());
  EXPECT_TRUE(look_after(1s).empty());  // at rest, but no photo yet
  EXPECT_TRUE(arrivals_.expects_more());
  put("a.jpg", whole);
  EXPECT_TRUE(look_after(1s).empty());
  const auto arrived = look_after(400ms);
  ASSERT_EQ(arrived.size(), 1U);
  EXPECT_TRUE(arrived[0].photo);
}

TEST_F(PhotoArrivalsTest, ADamagedPhotoIsGivenUpAndTakenWhenItChanges) {
  put("a.jpg", "no jpeg at all");
  EXPECT_TRUE(look_after(0ms).empty());
  EXPECT_TRUE(look_after(4s).empty());
  auto arrived = look_after(2s);
  ASSERT_EQ(arrived.size(), 1U);
  EXPECT_FALSE(arrived[0].photo);
  EXPECT_THAT(arrived[0].reason, HasSubstr("a.jpg"));
  EXPECT_FALSE(arrivals_.expects_more());
  EXPECT_TRUE(look_after(60s).empty());
  put("a.jpg", jpeg(70));
  EXPECT_TRUE(look_after(100ms).empty());
  arrived = look_after(400ms);
  ASSERT_EQ(arrived.size(), 1U);
  EXPECT_TRUE(arrived[0].photo);
}

TEST_F(PhotoArrivalsTest, ACopyOfAPhotoIsToldAsSuch) {
  put("a.jpg", jpeg(10));
  put("b.jpg", jpeg(10));
  put("c.jpg", jpeg(11));
  EXPECT_TRUE(look_after(0ms).empty());
  const auto arrived = look_after(1s);
  ASSERT_EQ(arrived.size(), 3U);
  EXPECT_TRUE(arrived[0].photo);
  EXPECT_FALSE(arrived[1].photo);
  EXPECT_THAT(arrived[1].reason, HasSubstr("a.jpg"));
  EXPECT_TRUE(arrived[2].photo);
}

TEST_F(PhotoArrivalsTest, PhotosComeInTheOrderOfTheirChange) {
  put("b.jpg", jpeg(10));
  put("a.jpg", jpeg(20));
  const auto time = std::filesystem::last_write_time(folder_ / "b.jpg");
  std::filesystem::last_write_time(folder_ / "a.jpg", time + 5s);
  EXPECT_TRUE(look_after(0ms).empty());
  const auto arrived = look_after(1s);
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_EQ(arrived[0].path.filename(), "b.jpg");
}

TEST_F(PhotoArrivalsTest, AMissingFolderIsAnError) {
  std::filesystem::remove_all(folder_);
  EXPECT_EQ(arrivals_.look(now_).error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace hybridfusion
