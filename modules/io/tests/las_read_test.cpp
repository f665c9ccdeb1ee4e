#include "mutations.hpp"
#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TempFolder;

template <class T>
void put_at(std::string& bytes, std::size_t place, T value) {
  std::memcpy(bytes.data() + place, &value, sizeof(T));
}

/// A LAS file of one format, built from the description of the format. Point i lies at (i, 2i, 3i).
std::string las_file(std::uint8_t minor, std::uint8_t format, std::uint16_t extra = 0) {
  constexpr std::uint16_t kSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38};
  constexpr std::size_t kTime[] = {0, 20, 0, 20, 20, 20, 22, 22, 22};
  constexpr std::size_t kColor[] = {0, 0, 20, 28, 0, 28, 0, 30, 30};
  constexpr std::uint32_t kPoints = 5;
  const std::uint16_t header_bytes = minor == 4 ? 375 : minor == 3 ? 235 : 227;
  const auto point_bytes = static_cast<std::uint16_t>(kSizes[format] + extra);
  std::string out(header_bytes + std::size_t{kPoints} * point_bytes, '\0');
  out.replace(0, 4, "LASF");
  put_at(out, 6, std::uint16_t{1});
  put_at(out, 24, std::uint8_t{1});
  put_at(out, 25, minor);
  put_at(out, 94, header_bytes);
  put_at(out, 96, std::uint32_t{header_bytes});
  put_at(out, 104, format);
  put_at(out, 105, point_bytes);
  if (minor < 4) put_at(out, 107, kPoints);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put_at(out, 131 + 8 * axis, 0.01);
    put_at(out, 155 + 8 * axis, 100.0 * static_cast<double>(axis));
  }
  if (minor == 4) put_at(out, 247, std::uint64_t{kPoints});
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const std::size_t at = header_bytes + std::size_t{i} * point_bytes;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const auto steps = static_cast<std::int32_t>(i * (axis + 1) * 100);
      put_at(out, at + 4 * axis, steps - static_cast<std::int32_t>(axis * 10000));
    }
    put_at(out, at + 12, static_cast<std::uint16_t>(1000 + i));
    // 1 hour after the start of 2020: 1577840400 UNIX.
    if (kTime[format] != 0) put_at(out, at + kTime[format], 1577840400.0 - 315964800.0 + 18 - 1e9);
    if (kColor[format] != 0) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        put_at(out, at + kColor[format] + 2 * k, static_cast<std::uint16_t>((10 * i + k) * 257));
      }
    }
  }
  return out;
}

class LasFormats : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(LasFormats, AreReadByTheirDescription) {
  const auto [minor, format] = GetParam();
  const TempFolder folder;
  const auto file = las_file(
      static_cast<std::uint8_t>(minor), static_cast<std::uint8_t>(format), format == 3 ? 7 : 0);
  const auto las = read_las(folder.file("a.las", file));
  ASSERT_TRUE(las) << las.error().message;
  const PointCloud& cloud = las->cloud;
  ASSERT_EQ(cloud.size(), 5U);
  EXPECT_TRUE(las->offset_m.isZero());
  const bool timed = format != 0 && format != 2;
  const bool coloured = format == 2 || format == 3 || format >= 7;
  EXPECT_EQ(cloud.times_s.empty(), !timed);
  EXPECT_EQ(cloud.colors.empty(), !coloured);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto n = static_cast<float>(i);
    EXPECT_LE((cloud.points[i] - Eigen::Vector3f(n, 2 * n, 3 * n)).norm(), 1e-4F);
    EXPECT_EQ(cloud.intensities[i], 1000.0F + n);
    if (timed) {
      EXPECT_NEAR(cloud.times_s[i], 1577840400.0, 1e-5);
    }
    if (coloured) {
      EXPECT_EQ(cloud.colors[i][2], 10 * i + 2);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(AllFormats,
                         LasFormats,
                         ::testing::Values(std::pair(0, 0),
                                           std::pair(1, 1),
                                           std::pair(2, 2),
                                           std::pair(2, 3),
                                           std::pair(3, 1),
                                           std::pair(4, 6),
                                           std::pair(4, 7),
                                           std::pair(4, 8)));

TEST(LasRead, WithheldPointsAreLeftOutAndEightBitColoursKept) {
  std::string bytes = las_file(2, 2);
  put_at(bytes, 227 + 26 + 15, std::uint8_t{0x81});
  for (std::size_t i = 0; i < 5; ++i) put_at(bytes, 227 + 26 * i + 20, std::uint16_t{200});
  for (std::size_t i = 0; i < 10; ++i) {
    put_at(bytes, 227 + 26 * (i / 2) + 22 + 2 * (i % 2), std::uint16_t{3});
  }
  const TempFolder folder;
  const auto las = read_las(folder.file("a.las", bytes));
  ASSERT_TRUE(las);
  EXPECT_EQ(las->cloud.size(), 4U);
  EXPECT_EQ(las->cloud.colors[0], (Rgb8{200, 3, 3}));
  ASSERT_EQ(las->warnings.size(), 1U);
  EXPECT_THAT(las->warnings[0], HasSubstr("1 withheld"));
}

TEST(LasRead, GivesBackWhatWasWritten) {
  const TempFolder folder;
  const PointCloud cloud = testing::sample_cloud(200);
  ASSERT_TRUE(write_las(folder.path() / "a.las", cloud));
  const auto back = read_las(folder.path() / "a.las");
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->cloud.size(), cloud.size());
  EXPECT_EQ(back->cloud.colors, cloud.colors);
  EXPECT_EQ(back->cloud.sources, cloud.sources);
  EXPECT_EQ(back->crs.name, "");
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    // Half a millimetre, and the spacing of floats.
    EXPECT_LE((back->cloud.points[i] - cloud.points[i]).cwiseAbs().maxCoeff(), 0.00055F);
    EXPECT_NEAR(back->cloud.times_s[i], cloud.times_s[i], 1e-6);
  }
  EXPECT_TRUE(read_point_cloud(folder.path() / "a.las"));
}

TEST(LasRead, UtmCoordinatesComeBackThroughAnOffsetAndKeepTheirSystem) {
  const TempFolder folder;
  const GeodeticOrigin origin = {.latitude_deg = 48.0, .longitude_deg = 9.0, .altitude_m = 500.0};
  const PointCloud cloud = {.points = {{0, 0, 0}, {100.25F, 0, 2}, {0, 100, 0}}};
  ASSERT_TRUE(write_las(
      folder.path() / "utm.las", cloud, {.georeference = LasGeoreference{.origin = origin}}));
  const auto utm = read_placed_cloud(folder.path() / "utm.las");
  ASSERT_TRUE(utm) << utm.error().message;
  EXPECT_EQ(utm->crs.name, "WGS 84 / UTM zone 32N");
  EXPECT_EQ(utm->offset_m.x(), 500'000.0);
  EXPECT_EQ(std::fmod(utm->offset_m.y(), 1000.0), 0.0);
  EXPECT_EQ(utm->offset_m.z(), 0.0);
  EXPECT_NEAR(utm->cloud.points[0].z(), 500.0, 0.001);

  // Through every text or binary format and back to the same places.
  const Eigen::Vector3d first = utm->cloud.points[1].cast<double>() + utm->offset_m;
  for (const char* const name : {"again.las", "a.xyz"}) {
    const auto kept = write_placed_cloud(folder.path() / name, *utm);
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_TRUE(*kept);
    const auto back = read_placed_cloud(folder.path() / name);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_LE((back->cloud.points[1].cast<double>() + back->offset_m - first).norm(), 0.001);
  }
  EXPECT_EQ(read_las(folder.path() / "again.las")->crs.name, "WGS 84 / UTM zone 32N");
  for (const char* const name : {"a.ply", "a.pcd"}) {
    const auto kept = write_placed_cloud(folder.path() / name, *utm);
    ASSERT_TRUE(kept);
    EXPECT_FALSE(*kept);  // these hold the cloud without the offset
    const auto back = read_point_cloud(folder.path() / name);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->points, utm->cloud.points);
  }
  const auto plain = read_point_cloud(folder.path() / "utm.las");
  ASSERT_FALSE(plain);
  EXPECT_THAT(plain.error().message, HasSubstr("convert"));
}

TEST(LasRead, OtherSystemsAreWrittenByTheirCode) {
  const TempFolder folder;
  const GeodeticOrigin origin = {.latitude_deg = 48.0, .longitude_deg = 9.0, .altitude_m = 500.0};
  const PointCloud cloud = {.points = {{0, 0, 0}}};
  const auto write = [&](const std::string& crs) {
    return write_las(folder.path() / "a.las",
                     cloud,
                     {.georeference = LasGeoreference{.origin = origin, .crs = crs}});
  };
  ASSERT_TRUE(write("EPSG:25832"));
  const auto etrs = read_las(folder.path() / "a.las");
  ASSERT_TRUE(etrs);
  EXPECT_EQ(etrs->crs.name, "ETRS89 / UTM zone 32N");
  // ETRS89 is taken for WGS 84; the eastings agree.
  EXPECT_NEAR(etrs->cloud.points[0].x() + etrs->offset_m.x(), 500'000.0, 0.01);
  for (const char* const wrong : {"EPSG:999999", "EPSG:4326", "UTM", "/etc/passwd", "EPSG:"}) {
    const auto refused = write(wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::kInvalidOptions);
  }
  // Heights above the geoid need a model; without it the system is refused, not ignored.
  const auto geoid = write("EPSG:32632+5773");
  if (!geoid) {
    EXPECT_THAT(geoid.error().message, HasSubstr("geoid"));
  }
}

TEST(LasRead, WrongFilesAreNamedWithTheWayOut) {
  const TempFolder folder;
  const auto message = [&](const std::string& bytes) {
    const auto las = read_las(folder.file("x.las", bytes));
    EXPECT_FALSE(las);
    if (las) return std::string();
    EXPECT_EQ(las.error().code, ErrorCode::kParse);
    EXPECT_THAT(las.error().message, HasSubstr("x.las"));
    return las.error().message;
  };
  const std::string good = las_file(4, 7);
  EXPECT_THAT(message("LASF"), HasSubstr("shorter"));
  EXPECT_THAT(message(std::string(400, 'x')), HasSubstr("not a LAS file"));
  EXPECT_THAT(message(good.substr(0, good.size() - 1)), HasSubstr("truncated"));
  std::string changed = good;
  put_at(changed, 104, std::uint8_t{0x87});
  EXPECT_THAT(message(changed), HasSubstr("LAZ"));
  changed = good;
  put_at(changed, 247, std::uint64_t{1} << 60);
  EXPECT_THAT(message(changed), HasSubstr("truncated"));
  changed = good;
  put_at(changed, 105, std::uint16_t{35});
  EXPECT_THAT(message(changed), HasSubstr("35 bytes a point"));
  changed = good;
  put_at(changed, 131, 0.0);
  EXPECT_THAT(message(changed), HasSubstr("scale"));
  changed = good;
  put_at(changed, 25, std::uint8_t{9});
  EXPECT_THAT(message(changed), HasSubstr("1.9"));
}

TEST(LasRead, RandomDamageNeverCrashes) {
  const TempFolder folder;
  PointCloud cloud = testing::sample_cloud(20);
  ASSERT_TRUE(write_las(
      folder.path() / "good.las",
      cloud,
      {.georeference = LasGeoreference{.origin = {.latitude_deg = 48.0, .longitude_deg = 9.0}}}));
  const std::string good = testing::content_of(folder.path() / "good.las");
  std::size_t read = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const std::string bytes = testing::mutated(good, i);
    const auto las = read_las(folder.file("x.las", bytes.empty() ? "x" : bytes));
    if (las) ++read;
    if (!las) {
      EXPECT_FALSE(las.error().message.empty());
    }
  }
  EXPECT_GT(read, 30U);
}

TEST(LasRead, FilesOfOtherProgramsAgreeAcrossVersionsOrAreRefusedClearly) {
  const auto root = testing::test_data("formats");
  if (!root) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  // One cloud in several point formats, in two places.
  const auto simple = read_las(*root / "laspy/tests/data/simple.las");
  ASSERT_TRUE(simple) << simple.error().message;
  EXPECT_EQ(simple->cloud.size(), 1065U);
  EXPECT_FALSE(simple->cloud.colors.empty());
  const auto plain = read_las(*root / "lazrs/tests/data/point10.las");
  ASSERT_TRUE(plain) << plain.error().message;
  const auto expect_same_points = [&](const char* name, const PlacedCloud& expected) {
    const auto other = read_las(*root / name);
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_EQ(other->cloud.points, expected.cloud.points) << name;
    EXPECT_EQ(other->offset_m, expected.offset_m) << name;
  };
  expect_same_points("lazrs/tests/data/extra-bytes.las", *simple);
  expect_same_points("lazrs/tests/data/point-time.las", *plain);
  expect_same_points("lazrs/tests/data/point-color.las", *plain);
  expect_same_points("lazrs/tests/data/point-time-color.las", *plain);
  const auto pdal = [&](const char* name) { return read_las(*root / "pdal/test/data/las" / name); };
  const auto utm = pdal("test_utm16.las");
  ASSERT_TRUE(utm) << utm.error().message;
  EXPECT_THAT(utm->crs.name, HasSubstr("UTM zone 16"));
  const auto degrees = pdal("epsg_4326.las");
  ASSERT_FALSE(degrees);
  EXPECT_THAT(degrees.error().message, HasSubstr("degrees"));
  const auto laz = read_las(*root / "laspy/tests/data/simple.laz");
  ASSERT_FALSE(laz);
  EXPECT_THAT(laz.error().message, AllOf(HasSubstr("LAZ"), HasSubstr("laszip")));
  // Each of the others gives a cloud or a message, and never takes more memory than the file.
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*root)) {
    if (entry.path().extension() != ".las") continue;
    const auto las = read_las(entry.path());
    if (!las) {
      EXPECT_FALSE(las.error().message.empty());
    }
  }
}

}  // namespace
}  // namespace hybridfusion
