#include "sample_photo.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/photo_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::sample_jpeg;
using testing::TempFolder;

TEST(PhotoFolder, PhotosAreSortedAndBadOnesQuarantinedWithTheirReason) {
  const TempFolder folder;
  const std::string good = sample_jpeg();
  static_cast<void>(folder.file("b.JPG", good));
  static_cast<void>(
      folder.file("a.jpeg", good + std::string(1000, '\0')));  // padding of some cameras
  static_cast<void>(folder.file("notes.txt", "x"));
  static_cast<void>(folder.file("empty.jpg", ""));
  static_cast<void>(folder.file("cut.jpg", good.substr(0, good.size() - 50)));
  static_cast<void>(folder.file("text.jpg", "not a photo"));
  std::filesystem::create_directory(folder.path() / "folder.jpg");
  const auto opened = open_photo_folder(folder.path());
  ASSERT_TRUE(opened) << opened.error().message;
  ASSERT_EQ(opened->photos.size(), 2U);
  EXPECT_EQ(opened->photos[0].metadata.name, "a.jpeg");
  EXPECT_EQ(opened->photos[1].metadata.name, "b.JPG");
  EXPECT_EQ(opened->photos[1].metadata.width, 64);
  const auto image = opened->photos[1].load();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 64);
  ASSERT_EQ(opened->quarantined.size(), 3U);
  EXPECT_EQ(opened->quarantined[0].name, "cut.jpg");
  EXPECT_THAT(opened->quarantined[0].reason, ::testing::StartsWith("truncated or damaged"));
  EXPECT_THAT(opened->quarantined[1].reason, HasSubstr("empty"));
  EXPECT_THAT(opened->quarantined[2].reason, HasSubstr("not a JPEG"));
}

TEST(PhotoFolder, ErrorsNameFolderCauseAndNextStep) {
  const TempFolder folder;
  const auto missing = open_photo_folder(folder.path() / "none");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(missing.error().message, AllOf(HasSubstr("none"), HasSubstr("no such folder")));
  const auto empty = open_photo_folder(folder.path());
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(empty.error().message, AllOf(HasSubstr("empty"), HasSubstr("give the folder")));
  static_cast<void>(folder.file("a.txt", "x"));
  EXPECT_THAT(open_photo_folder(folder.path()).error().message, HasSubstr("1 files"));
  static_cast<void>(folder.file("a.jpg", "x"));
  const auto unusable = open_photo_folder(folder.path());
  ASSERT_FALSE(unusable);
  EXPECT_EQ(unusable.error().code, ErrorCode::kInsufficient);
  EXPECT_THAT(unusable.error().message, HasSubstr("a.jpg"));
}

TEST(PhotoFolder, RealFlightsOpenCompletely) {
  const auto data = testing::test_data("");
  if (!data) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  const auto simulated = open_photo_folder(*data / "block-11/images");
  ASSERT_TRUE(simulated) << simulated.error().message;
  EXPECT_EQ(simulated->photos.size(), 29U);
  const auto flight = open_photo_folder(*data / "photos/sheffield60");
  ASSERT_TRUE(flight) << flight.error().message;
  EXPECT_EQ(flight->photos.size(), 60U);
  EXPECT_TRUE(flight->quarantined.empty());
  const auto image = flight->photos.front().load();
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 800);
}

}  // namespace
}  // namespace hybridfusion
