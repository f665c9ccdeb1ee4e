#include <hybridfusion/io/geo_tags.hpp>

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

class GeoTags : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("hf_geo_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text) {
    std::ofstream(folder_ / "file.txt", std::ios::binary) << text;
    return folder_ / "file.txt";
  }

  std::filesystem::path folder_;
};

TEST_F(GeoTags, DegreesInTheOrderOfOpenDroneMap) {
  const auto tags =
      read_geo_tags(write("EPSG:4326\n# comment\n\nA.JPG 11.5 48.25 512.5\r\n"
                          "B.JPG 11.6 48.26 513 0 0 0 0.02 0.05\n"));
  ASSERT_TRUE(tags) << tags.error().message;
  ASSERT_EQ(tags->size(), 2U);
  EXPECT_EQ((*tags)[0].photo, "A.JPG");
  EXPECT_DOUBLE_EQ((*tags)[0].latitude_deg, 48.25);
  EXPECT_DOUBLE_EQ((*tags)[0].longitude_deg, 11.5);
  EXPECT_DOUBLE_EQ((*tags)[0].altitude_m.value(), 512.5);
  EXPECT_FALSE((*tags)[0].sigma_horizontal_m);
  EXPECT_DOUBLE_EQ((*tags)[1].sigma_horizontal_m.value(), 0.02);
  EXPECT_DOUBLE_EQ((*tags)[1].sigma_vertical_m.value(), 0.05);
}

TEST_F(GeoTags, UtmByNameCodeAndProjStringAreOnePlace) {
  for (const char* system :
       {"WGS84 UTM 32N", "EPSG:32632", "+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs"}) {
    // The central meridian: 9 degrees east, false easting 500 km.
    const auto tags = read_geo_tags(write(std::string(system) + "\nA.JPG 500000 5000000 7\n"));
    ASSERT_TRUE(tags) << tags.error().message;
    EXPECT_NEAR((*tags)[0].longitude_deg, 9.0, 1e-9) << system;
    EXPECT_NEAR((*tags)[0].latitude_deg, 45.1535, 1e-3) << system;
    EXPECT_NEAR((*tags)[0].altitude_m.value(), 7.0, 1e-6) << system;
  }
}

TEST_F(GeoTags, TableWithCommasWithAndWithoutHeading) {
  for (const char* heading : {"", "name,lat,lon,alt,sx,sz\n"}) {
    const auto tags =
        read_geo_tags(write(std::string(heading) + "A.JPG,48.25,11.5,512.5,0.02,0.03\n"
                                                   "B.JPG,48.26,11.5,,,\n"));
    ASSERT_TRUE(tags) << tags.error().message;
    ASSERT_EQ(tags->size(), 2U);
    EXPECT_DOUBLE_EQ((*tags)[0].latitude_deg, 48.25);
    EXPECT_FALSE((*tags)[1].altitude_m);
  }
}

TEST_F(GeoTags, WhatIsNoPositionIsNamedWithItsLine) {
  for (const char* text : {"EPSG:4326\nA.JPG eleven 48\n",
                           "EPSG:4326\nA.JPG 11\n",
                           "EPSG:4326\nA.JPG 11 148 5\n",
                           "EPSG:4326\nA.JPG nan 48 5\n",
                           "A.JPG,48.2,11.5,5\nB.JPG,north,11.5\n"}) {
    const auto tags = read_geo_tags(write(text));
    ASSERT_FALSE(tags) << text;
    EXPECT_EQ(tags.error().code, ErrorCode::kParse) << text;
    EXPECT_THAT(tags.error().message, HasSubstr("line")) << text;
  }
}

TEST_F(GeoTags, UnknownCoordinateSystemsAreRefused) {
  for (const char* system : {"my own system",
                             "EPSG:99999999",
                             "WGS84 UTM 99N",
                             "+proj=utm +zone=32 +nadgrids=/etc/passwd",
                             "/etc/passwd"}) {
    const auto tags = read_geo_tags(write(std::string(system) + "\nA.JPG 1 2 3\n"));
    ASSERT_FALSE(tags) << system;
    EXPECT_EQ(tags.error().code, ErrorCode::kInvalidOptions) << system;
  }
  EXPECT_EQ(read_geo_tags(folder_ / "none.txt").error().code, ErrorCode::kNotFound);
}

TEST_F(GeoTags, ReplacePositionsAndForgetTheirAccuracy) {
  std::vector<Photo> photos(2);
  photos[0].metadata.name = "A.JPG";
  photos[0].metadata.rtk_sigma_enu_m = Eigen::Vector3d(0.01, 0.01, 0.02);
  photos[0].metadata.altitude_m = 3.0;
  photos[1].metadata.name = "B.JPG";
  photos[1].metadata.latitude_deg = 1.0;
  const std::vector<GeoTag> tags = {{.photo = "A.JPG", .latitude_deg = 48.0, .longitude_deg = 11.0},
                                    {.photo = "C.JPG"}};
  EXPECT_EQ(apply_geo_tags(tags, photos), 1U);
  EXPECT_EQ(photos[0].metadata.latitude_deg, 48.0);
  EXPECT_FALSE(photos[0].metadata.altitude_m);
  EXPECT_FALSE(photos[0].metadata.rtk_sigma_enu_m);
  EXPECT_EQ(photos[1].metadata.latitude_deg, 1.0);
}

TEST_F(GeoTags, MarksOfOnePointAreGatheredAndCountedFromThePixelCentre) {
  const auto points =
      read_surveyed_points(write("EPSG:4326\n"
                                 "11.5 48.25 500 100.5 200.5 A.JPG p1\n"
                                 "11.5 48.25 500 300 400 B.JPG p1\n"
                                 "11.6 48.25 500 1 2 A.JPG\n"
                                 "11.6 48.25 500 3 4 B.JPG\n"));
  ASSERT_TRUE(points) << points.error().message;
  ASSERT_EQ(points->size(), 2U);
  EXPECT_EQ((*points)[0].name, "p1");
  ASSERT_EQ((*points)[0].marks.size(), 2U);
  EXPECT_EQ((*points)[0].marks[0].pixel, Eigen::Vector2d(100.0, 200.0));
  EXPECT_EQ((*points)[1].marks[1].photo, "B.JPG");
  EXPECT_FALSE(read_surveyed_points(write("EPSG:4326\n11.5 48.25 500 100.5 A.JPG\n")));
  EXPECT_FALSE(read_surveyed_points(write("EPSG:4326\n11.5 48.25 500 100.5 200.5\n")));
}

}  // namespace
}  // namespace hybridfusion
