#include <hybridfusion/io/geo_tags.hpp>
#include <hybridfusion/io/photo_names.hpp>

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
  ASSERT_EQ(tags->tags.size(), 2U);
  EXPECT_EQ(tags->tags[0].photo, "A.JPG");
  EXPECT_DOUBLE_EQ(tags->tags[0].latitude_deg, 48.25);
  EXPECT_DOUBLE_EQ(tags->tags[0].longitude_deg, 11.5);
  EXPECT_DOUBLE_EQ(tags->tags[0].altitude_m.value(), 512.5);
  EXPECT_FALSE(tags->tags[0].sigma_horizontal_m);
  EXPECT_DOUBLE_EQ(tags->tags[1].sigma_horizontal_m.value(), 0.02);
  EXPECT_DOUBLE_EQ(tags->tags[1].sigma_vertical_m.value(), 0.05);
}

TEST_F(GeoTags, UtmByNameCodeAndProjStringAreOnePlace) {
  for (const char* system :
       {"WGS84 UTM 32N", "EPSG:32632", "+proj=utm +zone=32 +datum=WGS84 +units=m +no_defs"}) {
    // The central meridian: 9 degrees east, false easting 500 km.
    const auto tags = read_geo_tags(write(std::string(system) + "\nA.JPG 500000 5000000 7\n"));
    ASSERT_TRUE(tags) << tags.error().message;
    EXPECT_NEAR(tags->tags[0].longitude_deg, 9.0, 1e-9) << system;
    EXPECT_NEAR(tags->tags[0].latitude_deg, 45.1535, 1e-3) << system;
    EXPECT_NEAR(tags->tags[0].altitude_m.value(), 7.0, 1e-6) << system;
  }
}

TEST_F(GeoTags, TableWithCommasWithAndWithoutHeading) {
  for (const char* heading : {"", "name,lat,lon,alt,sx,sz\n"}) {
    const auto tags =
        read_geo_tags(write(std::string(heading) + "A.JPG,48.25,11.5,512.5,0.02,0.03\n"
                                                   "B.JPG,48.26,11.5,,,\n"));
    ASSERT_TRUE(tags) << tags.error().message;
    ASSERT_EQ(tags->tags.size(), 2U);
    EXPECT_DOUBLE_EQ(tags->tags[0].latitude_deg, 48.25);
    EXPECT_FALSE(tags->tags[1].altitude_m);
  }
}

TEST_F(GeoTags, EveryUsualSpellingIsTheSameTable) {
  struct Case {
    const char* what;
    const char* text;
  };
  for (const Case& each :
       {Case{"tabs", "EPSG:4326\nA 1.JPG\t11.5\t48.25\t512.5\n"},
        Case{"tabs twice", "EPSG:4326\nA 1.JPG\t\t11.5\t\t48.25\t512.5\n"},
        Case{"several blanks", "EPSG:4326\n  A 1.JPG   11.5    48.25  512.5  \n"},
        Case{"tabs and blanks", "EPSG:4326\nA 1.JPG\t11.5 48.25 512.5\n"},
        Case{"quoted", "EPSG:4326\n\"A 1.JPG\" 11.5 48.25 512.5\n"},
        Case{"byte order mark",
             "\xef\xbb\xbf"
             "EPSG:4326\nA 1.JPG 11.5 48.25 512.5\n"},
        Case{"ends of Windows", "EPSG:4326\r\nA 1.JPG 11.5 48.25 512.5\r\n"},
        Case{"comments", "# made by hand\nEPSG:4326\n# x\n\nA 1.JPG 11.5 48.25 512.5\n"},
        Case{"lower case", "epsg:4326\nA 1.JPG 11.5 48.25 512.5\n"},
        Case{"blank in the code", "EPSG: 4326\nA 1.JPG 11.5 48.25 512.5\n"},
        Case{"init", "+init=epsg:4326\nA 1.JPG 11.5 48.25 512.5\n"},
        Case{"degrees by PROJ", "+proj=longlat +datum=WGS84 +no_defs\nA 1.JPG 11.5 48.25 512.5\n"},
        Case{"commas", "EPSG:4326\nA 1.JPG,11.5,48.25,512.5\n"},
        Case{"commas and blanks", "EPSG:4326\nA 1.JPG, 11.5, 48.25, 512.5\n"},
        Case{"semicolons", "EPSG:4326\nA 1.JPG;11.5;48.25;512.5\n"},
        Case{"decimal commas", "EPSG:4326\nA 1.JPG;11,5;48,25;512,5\n"},
        Case{"decimal commas, tabs", "EPSG:4326\nA 1.JPG\t11,5\t48,25\t512,5\n"},
        Case{"heading behind the system",
             "EPSG:4326\nname,lon,lat,alt\nA 1.JPG,11.5,48.25,512.5\n"},
        Case{"heading in the other order",
             "EPSG:4326\nname,latitude,longitude,alt\nA 1.JPG,48.25,11.5,512.5\n"},
        Case{"Pix4D", "A 1.JPG,48.25,11.5,512.5\n"},
        Case{"Pix4D with heading",
             "imagename,latitude [decimal degrees],longitude [decimal degrees],altitude [meter],"
             "accuracy horizontal [meter],accuracy vertical [meter]\n"
             "A 1.JPG,48.25,11.5,512.5,,\n"},
        Case{"Metashape",
             "# CoordinateSystem: GEOGCS[\"WGS 84\",DATUM[\"x\"]]\n"
             "#Label,X/Longitude,Y/Latitude,Z/Altitude,Yaw,Pitch,Roll\n"
             "A 1.JPG,11.5,48.25,512.5,0,0,0\n"},
        Case{"exiftool",
             "SourceFile,GPSLatitude,GPSLongitude,GPSAltitude\n"
             "./A 1.JPG,48.25,11.5,512.5\n"},
        Case{"RealityCapture", "#name;longitude;latitude;altitude\nA 1.JPG;11.5;48.25;512.5\n"},
        Case{"name last", "lat,lon,height,filename\n48.25,11.5,512.5,A 1.JPG\n"}}) {
    const auto file = read_geo_tags(write(each.text));
    ASSERT_TRUE(file) << each.what << ": " << file.error().message;
    ASSERT_EQ(file->tags.size(), 1U) << each.what;
    const GeoTag& tag = file->tags[0];
    EXPECT_THAT(tag.photo, ::testing::EndsWith("A 1.JPG")) << each.what;
    EXPECT_NEAR(tag.latitude_deg, 48.25, 1e-9) << each.what;
    EXPECT_NEAR(tag.longitude_deg, 11.5, 1e-9) << each.what;
    EXPECT_NEAR(tag.altitude_m.value_or(0.0), 512.5, 1e-9) << each.what;
  }
}

TEST_F(GeoTags, EverySpellingOfOneZoneIsOnePlace) {
  for (const char* system : {"WGS84 UTM 32N",
                             "wgs84 utm 32n",
                             "WGS84 UTM 32 N",
                             "WGS 84 / UTM zone 32N",
                             "WGS84/UTM zone 32N",
                             "EPSG:32632",
                             "epsg:32632",
                             "EPSG 32632",
                             "+init=epsg:32632",
                             "+proj=utm +zone=32 +ellps=WGS84 +datum=WGS84 +units=m +no_defs",
                             "+datum=WGS84 +proj=utm +zone=32"}) {
    const auto file = read_geo_tags(write(std::string(system) + "\nA.JPG 500000 5000000 7\n"));
    ASSERT_TRUE(file) << system << ": " << file.error().message;
    EXPECT_NEAR(file->tags[0].longitude_deg, 9.0, 1e-9) << system;
    EXPECT_NEAR(file->tags[0].latitude_deg, 45.1535, 1e-3) << system;
  }
}

TEST_F(GeoTags, MarksWithTabsBlanksAndQuotesAreRead) {
  for (const char* row : {"11.5\t48.25\t500\t100.5\t200.5\tA (1).JPG\tP 7\n",
                          "11.5 48.25 500 100.5 200.5 A (1).JPG P\n",
                          "11.5  48.25  500  100.5  200.5  \"A (1).JPG\"  P\n",
                          "11.5,48.25,500,100.5,200.5,A (1).JPG,P\n",
                          "11.5;48.25;500;100,5;200,5;A (1).JPG;P\n",
                          "11.5 48.25 500 100.5 200.5 A (1).JPG\n"}) {
    for (const char* heading : {"", "geo_x geo_y geo_z im_x im_y image_name gcp_name\n"}) {
      const auto file = read_surveyed_points(write(std::string("EPSG:4326\n") + heading + row));
      ASSERT_TRUE(file) << row << file.error().message;
      ASSERT_EQ(file->points.size(), 1U) << row;
      EXPECT_EQ(file->points[0].marks[0].photo, "A (1).JPG") << row;
      EXPECT_EQ(file->points[0].marks[0].pixel, Eigen::Vector2d(100.0, 200.0)) << row;
    }
  }
}

TEST_F(GeoTags, OneNameAtTwoPlacesIsRefused) {
  const auto file = read_surveyed_points(
      write("EPSG:4326\n11.5 48.25 500 1 2 A.JPG p\n11.6 48.25 500 1 2 B.JPG p\n"));
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("other coordinates"));
}

TEST(PhotoNamesIndex, FindsWhatOtherProgramsCallAPhotoAndNeverGuessesBetweenTwo) {
  const std::vector<std::string> names = {
      "100MEDIA/DJI_0001.JPG", "101MEDIA/DJI_0001.JPG", "101MEDIA/DJI_0002.JPG", "top.jpeg"};
  const PhotoNames index(names);
  EXPECT_EQ(index.find("101MEDIA/DJI_0001.JPG"), 1U);
  EXPECT_EQ(index.find("./101MEDIA\\DJI_0001.JPG"), 1U);
  EXPECT_EQ(index.find("DJI_0002.JPG"), 2U);
  EXPECT_EQ(index.find("C:\\flight\\dji_0002.jpg"), 2U);
  EXPECT_EQ(index.find("DJI_0002"), 2U);
  EXPECT_EQ(index.find("TOP"), 3U);
  EXPECT_FALSE(index.find("DJI_0001.JPG"));
  EXPECT_TRUE(index.ambiguous("DJI_0001.JPG"));
  EXPECT_FALSE(index.find("top.tif"));
  EXPECT_FALSE(index.find(""));
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
    EXPECT_EQ(tags.error().code, ErrorCode::kParse) << system;
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
  const TaggedPhotos tagged = apply_geo_tags(tags, photos);
  EXPECT_EQ(tagged.num_tagged, 1U);
  EXPECT_THAT(tagged.unknown, ::testing::ElementsAre("C.JPG"));
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
  ASSERT_EQ(points->points.size(), 2U);
  EXPECT_EQ(points->points[0].name, "p1");
  ASSERT_EQ(points->points[0].marks.size(), 2U);
  EXPECT_EQ(points->points[0].marks[0].pixel, Eigen::Vector2d(100.0, 200.0));
  EXPECT_EQ(points->points[1].marks[1].photo, "B.JPG");
  EXPECT_FALSE(read_surveyed_points(write("EPSG:4326\n11.5 48.25 500 100.5 A.JPG\n")));
  EXPECT_FALSE(read_surveyed_points(write("EPSG:4326\n11.5 48.25 500 100.5 200.5\n")));
}

}  // namespace
}  // namespace hybridfusion
