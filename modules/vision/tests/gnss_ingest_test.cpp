#include <hybridfusion/vision/gnss_ingest.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

/// A straight flight of `count` photos, 10 m apart to the north, 2 s apart in time.
std::vector<PhotoMetadata> straight_flight(int count) {
  std::vector<PhotoMetadata> photos;
  const GeodeticOrigin start{.latitude_deg = 48.0, .longitude_deg = 11.0, .altitude_m = 550.0};
  for (int i = 0; i < count; ++i) {
    const GeodeticPosition at = geodetic_from_enu(start, {0.0, 10.0 * i, 0.0});
    PhotoMetadata photo;
    photo.name = "IMG_" + std::to_string(i) + ".JPG";
    photo.time = from_seconds(1000.0 + 2.0 * i);
    photo.latitude_deg = at.latitude_deg;
    photo.longitude_deg = at.longitude_deg;
    photo.altitude_m = at.altitude_m;
    photos.push_back(photo);
  }
  return photos;
}

TEST(GnssIngest, OriginIsTheMedianAndPositionsAreMetresFromIt) {
  const auto ingest = ingest_gnss(straight_flight(9), {});
  ASSERT_TRUE(ingest);
  EXPECT_NEAR(ingest->fixes[4].position_in_enu->norm(), 0.0, 1e-3);
  EXPECT_NEAR(ingest->fixes[8].position_in_enu->y(), 40.0, 1e-3);
  EXPECT_TRUE(ingest->warnings.empty());
}

TEST(GnssIngest, SigmaComesFromRtkThenErrorThenDopThenTheDefault) {
  auto photos = straight_flight(6);
  photos[0].rtk_sigma_enu_m = Eigen::Vector3d(0.01, 0.03, 0.05);
  photos[1].gps_horizontal_error_m = 1.5;
  photos[2].gps_dop = 2.0;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_EQ(ingest->fixes[0].sigma_m, Eigen::Vector3d(0.02, 0.03, 0.05));  // floor 0.02
  EXPECT_TRUE(ingest->fixes[0].is_rtk);
  EXPECT_EQ(ingest->fixes[1].sigma_m, Eigen::Vector3d(1.5, 1.5, 5.0));  // vertical floor 5
  EXPECT_EQ(ingest->fixes[2].sigma_m, Eigen::Vector3d(6.0, 6.0, 12.0));
  EXPECT_EQ(ingest->fixes[3].sigma_m, Eigen::Vector3d(3.0, 3.0, 6.0));
}

TEST(GnssIngest, ZeroCoordinatesAreMissingAndDoNotMoveTheOrigin) {
  auto photos = straight_flight(9);
  photos[2].latitude_deg = 0.0;
  photos[2].longitude_deg = 0.0;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_FALSE(ingest->fixes[2].position_in_enu);
  EXPECT_THAT(ingest->fixes[2].rejection, HasSubstr("0, 0"));
  EXPECT_NEAR(ingest->origin.latitude_deg, 48.0, 0.001);
}

TEST(GnssIngest, ZeroAltitudeDisablesTheAltitudeOfThatPhotoOnly) {
  auto photos = straight_flight(9);
  photos[3].altitude_m = 0.0;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_TRUE(ingest->fixes[3].position_in_enu);
  EXPECT_FALSE(ingest->fixes[3].has_altitude);
  EXPECT_TRUE(ingest->fixes[4].has_altitude);
  EXPECT_NEAR(ingest->origin.altitude_m, 550.0, 0.1);
}

TEST(GnssIngest, AltitudesComeFromOneSourceForAllPhotos) {
  // EXIF is 40 m below XMP: taking XMP where present and EXIF elsewhere would bend the flight.
  auto photos = straight_flight(9);
  for (std::size_t i = 0; i < 8; ++i) photos[i].absolute_altitude_m = 590.0;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_NEAR(ingest->origin.altitude_m, 550.0, 0.1);  // EXIF: all nine have it
  for (auto& photo : photos) photo.absolute_altitude_m = 590.0;
  EXPECT_NEAR(ingest_gnss(photos, {})->origin.altitude_m, 590.0, 0.1);
}

TEST(GnssIngest, JumpOfFiveKilometresIsRejectedAndItsNeighboursAreNot) {
  auto photos = straight_flight(12);
  *photos[5].latitude_deg += 0.045;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    EXPECT_EQ(ingest->fixes[i].position_in_enu.has_value(), i != 5) << i;
  }
  EXPECT_THAT(ingest->fixes[5].rejection, HasSubstr("neighbours in time"));
}

TEST(GnssIngest, JumpOfTheFirstPhotoIsRejectedToo) {
  auto photos = straight_flight(12);
  *photos[0].latitude_deg += 0.045;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_FALSE(ingest->fixes[0].position_in_enu);
  EXPECT_TRUE(ingest->fixes[1].position_in_enu);
}

TEST(GnssIngest, AltitudeSpikeLosesTheAltitudeNotThePosition) {
  auto photos = straight_flight(12);
  *photos[6].altitude_m += 300.0;
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_TRUE(ingest->fixes[6].position_in_enu);
  EXPECT_FALSE(ingest->fixes[6].has_altitude);
}

TEST(GnssIngest, OnePositionForMostPhotosIsRefused) {
  auto photos = straight_flight(10);
  for (std::size_t i = 0; i < 6; ++i) {
    photos[i].latitude_deg = 48.0;
    photos[i].longitude_deg = 11.0;
  }
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_FALSE(ingest);
  EXPECT_EQ(ingest.error().code, ErrorCode::kInsufficient);
  EXPECT_THAT(ingest.error().message, HasSubstr("same GNSS position"));
}

TEST(GnssIngest, PhotosWithoutGnssAreRefusedWithTheNextStep) {
  auto photos = straight_flight(5);
  for (auto& photo : photos) photo.latitude_deg.reset();
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_FALSE(ingest);
  EXPECT_EQ(ingest.error().code, ErrorCode::kInsufficient);
  EXPECT_THAT(ingest.error().message, HasSubstr("geotag"));
}

TEST(GnssIngest, LongGapInTimeStartsAnotherFlight) {
  auto photos = straight_flight(8);
  for (std::size_t i = 4; i < 8; ++i) *photos[i].time += from_seconds(3600.0);
  const auto ingest = ingest_gnss(photos, {});
  ASSERT_TRUE(ingest);
  EXPECT_EQ(ingest->fixes[3].flight, 0);
  EXPECT_EQ(ingest->fixes[4].flight, 1);
  EXPECT_EQ(ingest->fixes[5].flight_time_s, 2.0);
}

}  // namespace
}  // namespace hybridfusion
