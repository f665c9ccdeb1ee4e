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

TEST(PhotoFolder, CardFoldersAreReadAndNamesThatRepeatKeepTheirFolder) {
  const TempFolder folder;
  const std::string jpeg = sample_jpeg();
  for (const char* name : {"100MEDIA", "101MEDIA", ".trash", "thumbs", "result"}) {
    std::filesystem::create_directory(folder.path() / name);
  }
  for (const char* name : {"100MEDIA/DJI_0001.JPG",
                           "100MEDIA/DJI_0002.jpg",
                           "101MEDIA/DJI_0001.JPG",
                           ".trash/DJI_0009.JPG",
                           "thumbs/DJI_0001.JPG",
                           "result/DJI_0001.JPG",
                           "._DJI_0001.JPG"}) {
    static_cast<void>(folder.file(name, jpeg));
  }
  static_cast<void>(folder.file("result/run.json", "{}"));
  static_cast<void>(folder.file("100MEDIA/DJI_0001.DNG", "x"));
  static_cast<void>(folder.file("101MEDIA/DJI_0003.png", "x"));
  static_cast<void>(folder.file("scan.HEIC", "x"));
  std::filesystem::create_directory_symlink(folder.path(), folder.path() / "101MEDIA/up");
  const auto opened = open_photo_folder(folder.path());
  ASSERT_TRUE(opened) << opened.error().message;
  std::vector<std::string> names;
  for (const Photo& photo : opened->photos) names.push_back(photo.metadata.name);
  EXPECT_THAT(names,
              ::testing::ElementsAre(
                  "100MEDIA/DJI_0001.JPG", "100MEDIA/DJI_0002.jpg", "101MEDIA/DJI_0001.JPG"));
  ASSERT_TRUE(opened->photos[2].load());
  const PhotoFolderNotes notes = notes_of(opened->listing);
  EXPECT_THAT(notes.left_out, ::testing::ElementsAre("101MEDIA/DJI_0003.png", "scan.HEIC"));
  ASSERT_EQ(notes.facts.size(), 3U);
  EXPECT_THAT(notes.facts[0], HasSubstr("3 of 3 photos lie in subfolders: 100MEDIA (2), 101MEDIA"));
  EXPECT_THAT(notes.facts[1], AllOf(HasSubstr("result"), HasSubstr("thumbs")));
  EXPECT_THAT(notes.facts[2], HasSubstr("1 image files"));
}

TEST(PhotoFolder, AFileInThePlaceOfTheFolderAndOtherFormatsAloneAreTold) {
  const TempFolder folder;
  const auto photo = folder.file("a.jpg", sample_jpeg());
  const auto opened = open_photo_folder(photo);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(opened.error().message,
              AllOf(HasSubstr("is a file"), HasSubstr(folder.path().string())));
  std::filesystem::remove(photo);
  static_cast<void>(folder.file("a.tif", "x"));
  EXPECT_THAT(open_photo_folder(folder.path()).error().message,
              AllOf(HasSubstr("other formats"), HasSubstr("a.tif")));
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
