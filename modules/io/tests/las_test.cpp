#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/las.hpp>

#include <cstring>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using testing::TempFolder;

template <class T>
[[nodiscard]] T at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// Offsets are those of the LAS 1.4 R15 public header block.
struct LasHeader {
  explicit LasHeader(const std::string& bytes)
      : encoding(at<std::uint16_t>(bytes, 6)),
        points_at(at<std::uint32_t>(bytes, 96)),
        num_vlrs(at<std::uint32_t>(bytes, 100)),
        format(at<std::uint8_t>(bytes, 104)),
        point_bytes(at<std::uint16_t>(bytes, 105)),
        count(at<std::uint64_t>(bytes, 247)) {
    std::memcpy(scale, bytes.data() + 131, sizeof(scale));
    std::memcpy(offset, bytes.data() + 155, sizeof(offset));
    std::memcpy(max_min, bytes.data() + 179, sizeof(max_min));
  }
  [[nodiscard]] Eigen::Vector3d point(const std::string& bytes, std::size_t i) const {
    const std::size_t from = points_at + i * point_bytes;
    Eigen::Vector3d result;
    for (int axis = 0; axis < 3; ++axis) {
      result[axis] =
          at<std::int32_t>(bytes, from + 4U * static_cast<unsigned>(axis)) * scale[axis] +
          offset[axis];
    }
    return result;
  }
  std::uint16_t encoding;
  std::uint32_t points_at;
  std::uint32_t num_vlrs;
  std::uint8_t format;
  std::uint16_t point_bytes;
  std::uint64_t count;
  double scale[3] = {};
  double offset[3] = {};
  double max_min[6] = {};
};

TEST(Las, LocalCloudHasItsPointsInMillimetresAndNoCrs) {
  const TempFolder folder;
  PointCloud cloud = testing::sample_cloud(50);
  cloud.sigmas_m.clear();
  cloud.confidences.clear();
  ASSERT_TRUE(write_las(folder.path() / "a.las", cloud));
  const std::string bytes = testing::content_of(folder.path() / "a.las");
  EXPECT_EQ(bytes.substr(0, 4), "LASF");
  EXPECT_EQ(at<std::uint8_t>(bytes, 24), 1);
  EXPECT_EQ(at<std::uint8_t>(bytes, 25), 4);
  EXPECT_EQ(at<std::uint16_t>(bytes, 94), 375);
  const LasHeader header(bytes);
  EXPECT_EQ(header.format, 7);
  EXPECT_EQ(header.point_bytes, 37);  // 36 and one extra byte
  EXPECT_EQ(header.count, 50U);
  EXPECT_EQ(header.num_vlrs, 1U);  // extra bytes
  EXPECT_EQ(bytes.size(), header.points_at + 50U * 37U);
  EXPECT_EQ(bytes.find("PROJCS"), std::string::npos);
  for (std::size_t i = 0; i < 50; ++i) {
    const Eigen::Vector3d point = header.point(bytes, i);
    EXPECT_LE((point - cloud.points[i].cast<double>()).cwiseAbs().maxCoeff(), 0.00051);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(point[axis], header.max_min[2 * axis] + 1e-9);
      EXPECT_GE(point[axis], header.max_min[2 * axis + 1] - 1e-9);
    }
    const std::size_t from = header.points_at + i * 37;
    EXPECT_EQ(at<std::uint16_t>(bytes, from + 30), cloud.colors[i][0] * 257);
    EXPECT_EQ(at<std::uint8_t>(bytes, from + 36), static_cast<std::uint8_t>(cloud.sources[i]));
    const bool is_synthetic = cloud.sources[i] == PointSource::kInterpolated;
    EXPECT_EQ(at<std::uint8_t>(bytes, from + 15), is_synthetic ? 1 : 0);
    // GPS is 18 s ahead of UTC since 2017; adjusted standard time subtracts 1e9 s.
    EXPECT_NEAR(at<double>(bytes, from + 22), cloud.times_s[i] - 315964800.0 + 18.0 - 1e9, 1e-6);
  }
}

TEST(Las, GeoreferencedCloudIsInTheUtmZoneOfItsOrigin) {
  const TempFolder folder;
  // 9 degrees east is the central meridian of zone 32: easting 500 km, grid scale 0.9996 there.
  const GeodeticOrigin origin = {.latitude_deg = 48.0, .longitude_deg = 9.0, .altitude_m = 500.0};
  const PointCloud cloud = {.points = {{0, 0, 0}, {100, 0, 2}, {0, 100, 0}}};
  ASSERT_TRUE(write_las(folder.path() / "a.las", cloud, {.georeference = LasGeoreference{origin}}));
  const std::string bytes = testing::content_of(folder.path() / "a.las");
  const LasHeader header(bytes);
  EXPECT_EQ(header.encoding & 0x10, 0x10);
  EXPECT_EQ(header.num_vlrs, 1U);
  EXPECT_THAT(bytes.substr(375, header.points_at - 375), HasSubstr("UTM zone 32N"));
  const Eigen::Vector3d zero = header.point(bytes, 0);
  EXPECT_NEAR(zero.x(), 500'000.0, 0.001);
  // Meridian arc to 48 N on WGS84 (Snyder, eq. 3-21: 5318364.3 m) times 0.9996, to the metre.
  EXPECT_NEAR(zero.y(), 5'316'300.0, 200.0);
  EXPECT_NEAR(zero.z(), 500.0, 0.001);
  // At 500 m height the grid is smaller than the ground by 0.9996 and by R / (R + 500).
  const double grid_scale = 0.9996 * (1.0 - 500.0 / 6.38e6);
  EXPECT_NEAR(header.point(bytes, 1).x() - zero.x(), 100.0 * grid_scale, 0.003);
  EXPECT_NEAR(header.point(bytes, 2).y() - zero.y(), 100.0 * grid_scale, 0.003);
  EXPECT_NEAR(header.point(bytes, 1).z(), 502.0, 0.003);
}

/// Offsets are those of LAS 1.2 and LAS 1.3 R11.
TEST(Las, OlderVersionsHaveTheirHeaderCountsAndPointFormat) {
  const TempFolder folder;
  PointCloud cloud = testing::sample_cloud(50);
  cloud.sigmas_m.clear();
  cloud.confidences.clear();
  for (const auto& [version, header_bytes] :
       {std::pair{LasVersion::k12, 227U}, std::pair{LasVersion::k13, 235U}}) {
    ASSERT_TRUE(write_las(folder.path() / "a.las", cloud, {.version = version}));
    const std::string bytes = testing::content_of(folder.path() / "a.las");
    EXPECT_EQ(at<std::uint8_t>(bytes, 25), static_cast<std::uint8_t>(version));
    EXPECT_EQ(at<std::uint16_t>(bytes, 94), header_bytes);
    const LasHeader header(bytes);
    EXPECT_EQ(header.encoding, 1);  // no WKT bit
    EXPECT_EQ(header.format, 3);
    EXPECT_EQ(header.point_bytes, 35);  // 34 and one extra byte
    EXPECT_EQ(at<std::uint32_t>(bytes, 107), 50U);
    EXPECT_EQ(at<std::uint32_t>(bytes, 111), 50U);  // first returns
    EXPECT_EQ(bytes.size(), header.points_at + 50U * 35U);
    for (std::size_t i = 0; i < 50; ++i) {
      const std::size_t from = header.points_at + i * 35;
      EXPECT_EQ(at<std::uint8_t>(bytes, from + 14), 0x09);  // return 1 of 1
      const bool is_synthetic = cloud.sources[i] == PointSource::kInterpolated;
      EXPECT_EQ(at<std::uint8_t>(bytes, from + 15), is_synthetic ? 0x21 : 1);  // unclassified
      EXPECT_NEAR(at<double>(bytes, from + 20), cloud.times_s[i] - 315964800.0 + 18.0 - 1e9, 1e-6);
      EXPECT_EQ(at<std::uint16_t>(bytes, from + 28), cloud.colors[i][0] * 257);
      EXPECT_EQ(at<std::uint8_t>(bytes, from + 34), static_cast<std::uint8_t>(cloud.sources[i]));
    }
  }
}

TEST(Las, EveryVersionReadsBackWithItsSystem) {
  const TempFolder folder;
  const GeodeticOrigin origin = {.latitude_deg = 48.0, .longitude_deg = 9.0, .altitude_m = 500.0};
  PointCloud cloud = testing::sample_cloud(50);
  cloud.sigmas_m.clear();
  cloud.confidences.clear();
  ASSERT_TRUE(write_las(folder.path() / "a.las", cloud, {.georeference = LasGeoreference{origin}}));
  const auto expected = read_las(folder.path() / "a.las");
  ASSERT_TRUE(expected);
  for (const LasVersion version : {LasVersion::k12, LasVersion::k13}) {
    ASSERT_TRUE(write_las(folder.path() / "b.las",
                          cloud,
                          {.georeference = LasGeoreference{origin}, .version = version}));
    const auto read = read_las(folder.path() / "b.las");
    ASSERT_TRUE(read) << read.error().message;
    testing::expect_equal(read->cloud, expected->cloud);
    EXPECT_EQ(read->offset_m, expected->offset_m);
    EXPECT_EQ(read->crs.wkt, expected->crs.wkt);
    // Programs of their time know GeoTIFF keys only: ProjectedCSTypeGeoKey = 32632.
    const std::string bytes = testing::content_of(folder.path() / "b.las");
    const std::string key = {'\x00', '\x0c', 0, 0, 1, 0, '\x78', '\x7f'};
    EXPECT_NE(bytes.find(key), std::string::npos);
  }
}

TEST(Las, UtmZonesIncludeTheExceptions) {
  const auto epsg = [](double latitude, double longitude) {
    return utm_epsg({.latitude_deg = latitude, .longitude_deg = longitude}).value_or(0);
  };
  EXPECT_EQ(epsg(48.15, 11.57), 32632);
  EXPECT_EQ(epsg(-33.9, 151.2), 32756);
  EXPECT_EQ(epsg(28.0, -82.7), 32617);
  EXPECT_EQ(epsg(60.4, 5.3), 32632);   // Bergen
  EXPECT_EQ(epsg(78.2, 15.6), 32633);  // Svalbard
  EXPECT_EQ(epsg(0.0, 180.0), 32601);
  EXPECT_EQ(epsg(0.0, -180.0), 32601);
  EXPECT_EQ(utm_epsg({.latitude_deg = 85.0}).error().code, ErrorCode::kDegenerate);
  EXPECT_FALSE(utm_epsg({.latitude_deg = std::numeric_limits<double>::quiet_NaN()}));
}

TEST(Las, EmptyAndEndlessCloudsAreRefusedAndLeaveNoFile) {
  const TempFolder folder;
  EXPECT_EQ(write_las(folder.path() / "a.las", {}).error().code, ErrorCode::kInsufficient);
  const PointCloud wide = {.points = {{0, 0, 0}, {3e6F, 0, 0}}};
  EXPECT_EQ(write_las(folder.path() / "a.las", wide).error().code, ErrorCode::kDegenerate);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace hybridfusion
