#include "mutations.hpp"
#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/convert_cloud.hpp>
#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/pcd.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TempFolder;

constexpr GeodeticOrigin kOrigin = {
    .latitude_deg = 48.0, .longitude_deg = 9.0, .altitude_m = 500.0};

/// More points than go into one batch.
constexpr std::size_t kManyPoints = 70'000;

/// Within some kilometres, so that LAS and floats can hold it anywhere.
PointCloud many_points() {
  PointCloud cloud = testing::sample_cloud(kManyPoints);
  for (Eigen::Vector3f& point : cloud.points) point.z() = std::fmod(point.z(), 1000.0F);
  return cloud;
}

TEST(ConvertCloud, EveryFormatComesOutOfEveryOtherAsItWentIn) {
  const TempFolder folder;
  PointCloud cloud = testing::sample_cloud(1000);
  ASSERT_TRUE(write_ply(folder.path() / "in.ply", cloud));
  std::filesystem::path in = folder.path() / "in.ply";
  for (const char* const name : {"1.pcd", "2.ply", "3.pcd", "4.ply"}) {
    const std::filesystem::path out = folder.path() / name;
    const auto done = convert_cloud({.in = in, .out = out});
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(done->num_points, 1000U);
    in = out;
  }
  const auto kept = read_ply(in);
  ASSERT_TRUE(kept);
  testing::expect_equal(*kept, cloud);
  for (const char* const name : {"5.las", "6.xyz", "7.las", "8.pcd"}) {
    const std::filesystem::path out = folder.path() / name;
    ASSERT_TRUE(convert_cloud({.in = in, .out = out})) << name;
    in = out;
  }
  const auto back = read_pcd(in);
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->size(), 1000U);
  EXPECT_EQ(back->colors, cloud.colors);
  for (std::size_t i = 0; i < 1000; ++i) {
    // Half a millimetre in each LAS file, and the spacing of floats.
    EXPECT_LE((back->points[i] - cloud.points[i]).cwiseAbs().maxCoeff(), 0.0012F);
  }
}

TEST(ConvertCloud, BatchesGiveTheFileOfOnePiece) {
  const TempFolder folder;
  const PointCloud cloud = many_points();
  const PlacedCloud placed = {.cloud = cloud};
  ASSERT_TRUE(write_ply(folder.path() / "in.ply", cloud));
  for (const char* const name : {"a.las", "a.xyz", "a.pcd"}) {
    const std::filesystem::path out = folder.path() / name;
    ASSERT_TRUE(convert_cloud({.in = folder.path() / "in.ply", .out = out}));
    const std::string in_batches = testing::content_of(out);
    ASSERT_TRUE(write_placed_cloud(out, placed));
    EXPECT_TRUE(in_batches == testing::content_of(out)) << name;
  }
  ASSERT_TRUE(write_pcd(folder.path() / "b.pcd", cloud));
  EXPECT_TRUE(testing::content_of(folder.path() / "a.pcd") ==
              testing::content_of(folder.path() / "b.pcd"));
}

TEST(ConvertCloud, StreamedGeoreferenceIsThatOfTheWholeCloud) {
  const TempFolder folder;
  PointCloud cloud = many_points();
  cloud.normals.clear();
  ASSERT_TRUE(write_ply(folder.path() / "in.ply", cloud));
  ASSERT_TRUE(write_las(folder.path() / "whole.las", cloud, {.georeference = {{kOrigin}}}));
  const auto done = convert_cloud({.in = folder.path() / "in.ply",
                                   .out = folder.path() / "batches.las",
                                   .georeference = {{kOrigin}}});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(done->crs.name, "WGS 84 / UTM zone 32N");
  EXPECT_TRUE(done->keeps_offset);
  const auto whole = read_las(folder.path() / "whole.las");
  const auto batches = read_las(folder.path() / "batches.las");
  ASSERT_TRUE(whole);
  ASSERT_TRUE(batches);
  EXPECT_EQ(batches->offset_m, whole->offset_m);
  EXPECT_EQ(batches->crs.wkt, whole->crs.wkt);
  EXPECT_EQ(batches->cloud.colors, whole->cloud.colors);
  EXPECT_EQ(batches->cloud.intensities, whole->cloud.intensities);
  EXPECT_EQ(batches->cloud.times_s, whole->cloud.times_s);
  EXPECT_EQ(batches->cloud.sources, whole->cloud.sources);
  for (std::size_t i = 0; i < kManyPoints; ++i) {
    // Each is rounded to a millimetre; the batches went through floats of up to 15 km.
    ASSERT_LE((batches->cloud.points[i] - whole->cloud.points[i]).cwiseAbs().maxCoeff(), 0.0031F);
  }
}

TEST(ConvertCloud, ScalesThatOnlyTheWholeFileTellsHoldInEveryBatch) {
  const TempFolder folder;
  // The colours exceed 1, and the intensities 1, only behind the first batch.
  std::string text;
  for (std::size_t i = 0; i < kManyPoints; ++i) {
    text += i + 1 == kManyPoints ? "500000.25 5400000.5 3 200.0 255 128 0\n"
                                 : "500000.25 5400000.5 3 1.0 1 1 0\n";
  }
  const auto in = folder.file("in.xyz", text);
  ASSERT_TRUE(convert_cloud({.in = in, .out = folder.path() / "a.las"}));
  const auto las = read_las(folder.path() / "a.las");
  ASSERT_TRUE(las);
  EXPECT_EQ(las->cloud.colors.front(), (Rgb8{1, 1, 0}));
  EXPECT_EQ(las->cloud.colors.back(), (Rgb8{255, 128, 0}));
  EXPECT_EQ(las->cloud.intensities.front(), 1.0F);
  EXPECT_EQ(las->cloud.intensities.back(), 200.0F);
  const auto ply = convert_cloud({.in = in, .out = folder.path() / "a.ply"});
  ASSERT_TRUE(ply);
  EXPECT_FALSE(ply->keeps_offset);
  EXPECT_EQ(ply->offset_m, Eigen::Vector3d(500'000, 5'400'000, 0));
  EXPECT_EQ(read_ply(folder.path() / "a.ply")->points.back(), Eigen::Vector3f(0.25F, 0.5F, 3.0F));
}

TEST(ConvertCloud, EncodingsAreThoseOfTheFormat) {
  const TempFolder folder;
  const PointCloud cloud = testing::sample_cloud(5000);
  ASSERT_TRUE(write_ply(folder.path() / "in.ply", cloud));
  const auto data_line = [&](const char* name, CloudEncoding encoding) {
    const std::filesystem::path out = folder.path() / name;
    const auto done = convert_cloud(
        {.in = folder.path() / "in.ply", .out = out, .format = {.encoding = encoding}});
    if (!done) return done.error().message;
    const auto back = read_placed_cloud(out);
    EXPECT_TRUE(back);
    testing::expect_equal(back->cloud, cloud);
    const std::string bytes = testing::content_of(out).substr(0, 400);
    const std::size_t from = std::min(bytes.find("DATA "), bytes.find("format "));
    return bytes.substr(from, bytes.find('\n', from) - from);
  };
  EXPECT_EQ(data_line("a.pcd", CloudEncoding::kAscii), "DATA ascii");
  EXPECT_EQ(data_line("a.pcd", CloudEncoding::kBinary), "DATA binary");
  EXPECT_EQ(data_line("a.pcd", CloudEncoding::kCompressed), "DATA binary_compressed");
  EXPECT_EQ(data_line("a.pcd", CloudEncoding::kDefault), "DATA binary_compressed");
  EXPECT_EQ(data_line("a.ply", CloudEncoding::kAscii), "format ascii 1.0");
  EXPECT_EQ(data_line("a.ply", CloudEncoding::kBinary), "format binary_little_endian 1.0");
  EXPECT_THAT(data_line("a.las", CloudEncoding::kAscii), HasSubstr("no such encoding"));
  EXPECT_THAT(data_line("b.ply", CloudEncoding::kCompressed), HasSubstr("no such encoding"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.ply"));
}

TEST(ConvertCloud, DamagedInputLeavesNoOutput) {
  const TempFolder folder;
  PointCloud cloud = testing::sample_cloud(300);
  for (const PcdFormat format : {PcdFormat::kBinaryCompressed, PcdFormat::kBinary}) {
    ASSERT_TRUE(write_pcd(folder.path() / "good.pcd", cloud, {.format = format}));
    const std::string good = testing::content_of(folder.path() / "good.pcd");
    const auto cut = folder.file("bad.pcd", good.substr(0, good.size() - 1));
    const auto refused = convert_cloud({.in = cut, .out = folder.path() / "out.ply"});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kParse);
    EXPECT_THAT(refused.error().message, HasSubstr("bad.pcd"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.ply"));
    for (std::uint64_t i = 0; i < 150; ++i) {
      const auto in = folder.file("mutated.pcd", testing::mutated(good, i));
      const auto done = convert_cloud({.in = in, .out = folder.path() / "m.las"});
      EXPECT_EQ(done.has_value(), std::filesystem::remove(folder.path() / "m.las"));
    }
  }
}

TEST(ConvertCloud, StopsWhenAsked) {
  const TempFolder folder;
  ASSERT_TRUE(write_ply(folder.path() / "in.ply", many_points()));
  std::stop_source stop;
  RunContext ctx;
  ctx.stop = stop.get_token();
  ctx.progress = [&stop](const ProgressEvent& event) {
    if (event.stage == "convert/points") stop.request_stop();
  };
  const auto stopped =
      convert_cloud({.in = folder.path() / "in.ply", .out = folder.path() / "out.xyz"}, ctx);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out.xyz"));
}

TEST(ConvertCloud, ACloudInASystemIsNotPlacedASecondTime) {
  const TempFolder folder;
  ASSERT_TRUE(write_las(
      folder.path() / "utm.las", testing::sample_cloud(10), {.georeference = {{kOrigin}}}));
  CloudConversion conversion = {.in = folder.path() / "utm.las",
                                .out = folder.path() / "out.las",
                                .georeference = {{kOrigin}}};
  const auto refused = convert_cloud(conversion);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidOptions);
  EXPECT_THAT(refused.error().message, HasSubstr("UTM zone 32N"));
  conversion.keep_placed = true;
  const auto kept = convert_cloud(conversion);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_THAT(kept->crs.name, StartsWith("WGS 84"));
}

}  // namespace
}  // namespace hybridfusion
