#include "mutations.hpp"
#include "sample_photo.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/jpeg.hpp>

#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <jpeglib.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::sample_image;
using testing::sample_jpeg;
using testing::TempFolder;

[[nodiscard]] int largest_difference(const Image8& a, const Image8& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  }
  return largest;
}

/// A JPEG written by libjpeg itself with settings that write_jpeg does not offer.
[[nodiscard]] std::string special_jpeg(J_COLOR_SPACE space, int components, bool progressive) {
  jpeg_compress_struct info = {};
  jpeg_error_mgr errors = {};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = 64;
  info.image_height = 48;
  info.input_components = components;
  info.in_color_space = space;
  jpeg_set_defaults(&info);
  if (progressive) jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  std::vector<JSAMPLE> row(64U * static_cast<unsigned>(components));
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<JSAMPLE>(i);
  JSAMPROW pointer = row.data();
  while (info.next_scanline < info.image_height) jpeg_write_scanlines(&info, &pointer, 1);
  jpeg_finish_compress(&info);
  std::string result(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&info);
  std::free(bytes);
  return result;
}

TEST(Jpeg, EncodedBytesAreThoseThatAreWritten) {
  const TempFolder folder;
  const Image8 image = sample_image();
  ASSERT_TRUE(write_jpeg(folder.path() / "a.jpg", image, 90));
  EXPECT_EQ(encode_jpeg(image, 90).value(), testing::content_of(folder.path() / "a.jpg"));
}

TEST(Jpeg, PixelsComeBackUpToCompression) {
  const TempFolder folder;
  ASSERT_TRUE(write_jpeg(folder.path() / "a.jpg", sample_image(), 98));
  const auto image = decode_jpeg(folder.path() / "a.jpg");
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->width, 64);
  EXPECT_EQ(image->height, 48);
  ASSERT_EQ(image->channels, 3);
  EXPECT_LE(largest_difference(*image, sample_image()), 4);  // quality 98 of a smooth image
  const auto size = read_jpeg_size(folder.path() / "a.jpg");
  ASSERT_TRUE(size);
  EXPECT_EQ(size->width, 64);
  EXPECT_EQ(size->height, 48);
}

TEST(Jpeg, GreyBecomesRgb) {
  const TempFolder folder;
  ASSERT_TRUE(write_jpeg(folder.path() / "a.jpg", sample_image(1), 98));
  const auto image = decode_jpeg(folder.path() / "a.jpg");
  ASSERT_TRUE(image) << image.error().message;
  ASSERT_EQ(image->channels, 3);
  EXPECT_EQ(image->pixels[30], image->pixels[31]);
  EXPECT_EQ(image->pixels[30], image->pixels[32]);
}

TEST(Jpeg, EveryTruncationIsTruncatedOrDamaged) {
  const TempFolder folder;
  for (const bool progressive : {false, true}) {
    const std::string good = special_jpeg(JCS_RGB, 3, progressive);
    ASSERT_TRUE(decode_jpeg(folder.file("a.jpg", good)));
    for (std::size_t size = 2; size < good.size(); size += 7) {
      const auto image = decode_jpeg(folder.file("cut.jpg", good.substr(0, size)));
      ASSERT_FALSE(image) << size;
      EXPECT_EQ(image.error().code, ErrorCode::kParse);
      EXPECT_THAT(image.error().message,
                  AllOf(HasSubstr("cut.jpg"), HasSubstr("truncated or damaged")));
    }
  }
}

TEST(Jpeg, CmykIsRefusedWithTheWayOut) {
  const TempFolder folder;
  const auto image = decode_jpeg(folder.file("a.jpg", special_jpeg(JCS_CMYK, 4, false)));
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, AllOf(HasSubstr("CMYK"), HasSubstr("convert")));
}

TEST(Jpeg, AnnouncedSizeThatTheFileCannotHoldTakesNoMemory) {
  const TempFolder folder;
  std::string jpeg = sample_jpeg();
  const std::size_t frame = jpeg.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  jpeg.replace(frame + 5, 4, "\xff\xdc\xff\xdc");  // 65500 x 65500
  const auto image = decode_jpeg(folder.file("huge.jpg", jpeg));
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, HasSubstr("65500"));
  jpeg.replace(frame + 5, 4, "\x27\x10\x27\x10");  // 10000 x 10000
  const auto lying = decode_jpeg(folder.file("lying.jpg", jpeg));
  ASSERT_FALSE(lying);
  EXPECT_THAT(lying.error().message, HasSubstr("fewer bytes"));
}

TEST(Jpeg, OtherFilesAreNamedForWhatTheyAreNot) {
  const TempFolder folder;
  EXPECT_THAT(decode_jpeg(folder.file("a.jpg", "\x89PNG....")).error().message,
              HasSubstr("not a JPEG"));
  EXPECT_THAT(decode_jpeg(folder.file("b.jpg", "")).error().message, HasSubstr("empty"));
  EXPECT_EQ(decode_jpeg(folder.path() / "c.jpg").error().code, ErrorCode::kNotFound);
}

TEST(Jpeg, RandomDamageNeverCrashes) {
  const TempFolder folder;
  for (const bool progressive : {false, true}) {
    const std::string good = special_jpeg(JCS_RGB, 3, progressive);
    for (std::uint64_t i = 0; i < 300; ++i) {
      static_cast<void>(decode_jpeg(folder.file("bad.jpg", testing::mutated(good, i))));
    }
  }
}

}  // namespace
}  // namespace hybridfusion
