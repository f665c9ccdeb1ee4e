#include "mutations.hpp"
#include "sample_photo.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/photo_metadata.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::ExifBuilder;
using testing::sample_jpeg;
using testing::TempFolder;
using Tag = ExifBuilder;

/// An EXIF with everything the product reads.
ExifBuilder full_exif(std::endian order) {
  ExifBuilder exif(order);
  exif.text(Tag::kImage, 0x010f, "Maker");
  exif.text(Tag::kImage, 0x0110, "Model 1");
  exif.text(Tag::kPhoto, 0x9003, "2026:05:01 21:00:24");
  exif.text(Tag::kPhoto, 0x9291, "198");
  exif.rationals(Tag::kPhoto, 0x920a, {{5177, 1000}});
  exif.shorts(Tag::kPhoto, 0xa405, {28});
  exif.shorts(Tag::kPhoto, 0xa002, {64});
  exif.rationals(Tag::kPhoto, 0xa20e, {{4'000'000, 244}});
  exif.shorts(Tag::kPhoto, 0xa210, {2});
  exif.text(Tag::kPhoto, 0xa431, "SN42");
  exif.text(Tag::kGps, 1, "S");
  exif.rationals(Tag::kGps, 2, {{48'150'321, 1'000'000}, {0, 1}, {0, 1}});
  exif.text(Tag::kGps, 3, "W");
  exif.rationals(Tag::kGps, 4, {{11, 1}, {34, 1}, {399303, 100000}});
  exif.bytes(Tag::kGps, 5, {1});
  exif.rationals(Tag::kGps, 6, {{1234567, 1000}});
  exif.rationals(Tag::kGps, 11, {{12, 10}});
  exif.rationals(Tag::kGps, 31, {{15, 10}});
  return exif;
}

TEST(PhotoMetadata, ExifOfEitherByteOrderIsReadWithFullPrecision) {
  const TempFolder folder;
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto photo =
        read_photo_metadata(folder.file("a.jpg", sample_jpeg(full_exif(order).build())));
    ASSERT_TRUE(photo) << photo.error().message;
    EXPECT_EQ(photo->name, "a.jpg");
    EXPECT_EQ(photo->width, 64);
    EXPECT_EQ(photo->height, 48);
    EXPECT_EQ(photo->make, "Maker");
    EXPECT_EQ(photo->model, "Model 1");
    EXPECT_EQ(photo->serial, "SN42");
    EXPECT_DOUBLE_EQ(photo->focal_mm.value(), 5.177);
    EXPECT_EQ(photo->focal_35mm, 28.0);
    EXPECT_NEAR(photo->focal_plane_px_per_mm.value(), 4e6 / 244 / 25.4, 1e-9);
    EXPECT_EQ(photo->original_width, 64);
    EXPECT_EQ(photo->time->count(), 1'777'669'224'198'000'000);  // 2026-05-01T21:00:24.198Z
    EXPECT_DOUBLE_EQ(photo->latitude_deg.value(), -48.150321);
    EXPECT_DOUBLE_EQ(photo->longitude_deg.value(), -(11.0 + 34.0 / 60 + 3.99303 / 3600));
    EXPECT_DOUBLE_EQ(photo->altitude_m.value(), -1234.567);
    EXPECT_DOUBLE_EQ(photo->gps_dop.value(), 1.2);
    EXPECT_DOUBLE_EQ(photo->gps_horizontal_error_m.value(), 1.5);
    EXPECT_FALSE(photo->gimbal || photo->rtk_sigma_enu_m || photo->absolute_altitude_m);
  }
}

TEST(PhotoMetadata, FocalPlaneResolutionIsReadInAnyKnownUnit) {
  const TempFolder folder;
  const auto resolution = [&](std::uint32_t unit) {
    ExifBuilder exif(std::endian::little);
    exif.rationals(Tag::kPhoto, 0xa20e, {{5000, 2}});
    exif.rationals(Tag::kPhoto, 0xa210, {{unit, 1}});  // a short by the standard; beyond int here
    const auto photo = read_photo_metadata(folder.file("a.jpg", sample_jpeg(exif.build())));
    EXPECT_TRUE(photo);
    return photo->focal_plane_px_per_mm;
  };
  EXPECT_DOUBLE_EQ(resolution(2).value(), 2500.0 / 25.4);
  EXPECT_DOUBLE_EQ(resolution(3).value(), 250.0);
  EXPECT_DOUBLE_EQ(resolution(4).value(), 2500.0);
  EXPECT_DOUBLE_EQ(resolution(5).value(), 2.5e6);
  for (const std::uint32_t unknown : {0U, 1U, 6U, 4'000'000'000U}) {
    EXPECT_EQ(resolution(unknown), std::nullopt) << unknown;
  }
}

TEST(PhotoMetadata, ImpossiblePositionsAreAbsent) {
  const TempFolder folder;
  const auto position =
      [&](std::uint32_t latitude, std::uint32_t denominator, std::uint32_t longitude) {
        ExifBuilder exif(std::endian::little);
        exif.rationals(Tag::kGps, 2, {{latitude, denominator}});
        exif.rationals(Tag::kGps, 4, {{longitude, denominator}});
        const auto photo = read_photo_metadata(folder.file("a.jpg", sample_jpeg(exif.build())));
        EXPECT_TRUE(photo);
        EXPECT_EQ(photo->latitude_deg.has_value(), photo->longitude_deg.has_value());
        return photo->latitude_deg;
      };
  EXPECT_EQ(position(10, 1, 20), 10.0);
  EXPECT_EQ(position(0, 1, 0), std::nullopt);
  EXPECT_EQ(position(91, 1, 20), std::nullopt);
  EXPECT_EQ(position(10, 1, 181), std::nullopt);
  EXPECT_EQ(position(10, 0, 20), std::nullopt);
}

constexpr const char* kDjiXmp = R"(<x:xmpmeta><rdf:Description
   drone-dji:AbsoluteAltitude="+349.58" drone-dji:RelativeAltitude="-4.47"
   drone-dji:GpsLatitude="45.03159568" drone-dji:GpsLongtitude = "7.62046587"
   drone-dji:GimbalRollDegree="+0.10" drone-dji:GimbalYawDegree="+106.80"
   drone-dji:CalibratedFocalLength="60.5" drone-dji:RtkFlag="50"
   drone-dji:RtkStdLon="0.01" drone-dji:RtkStdLat="0.02" drone-dji:RtkStdHgt="0.03">
   <drone-dji:GimbalPitchDegree>-90.00</drone-dji:GimbalPitchDegree>
   </rdf:Description></x:xmpmeta>)";

TEST(PhotoMetadata, DjiXmpIsReadAsAttributeAndAsElement) {
  const TempFolder folder;
  const auto photo = read_photo_metadata(folder.file("a.jpg", sample_jpeg({}, kDjiXmp)));
  ASSERT_TRUE(photo) << photo.error().message;
  EXPECT_EQ(photo->absolute_altitude_m, 349.58);
  EXPECT_EQ(photo->relative_altitude_m, -4.47);
  EXPECT_EQ(photo->latitude_deg, 45.03159568);
  EXPECT_EQ(photo->longitude_deg, 7.62046587);
  ASSERT_TRUE(photo->gimbal);
  EXPECT_EQ(photo->gimbal->yaw_deg, 106.8);
  EXPECT_EQ(photo->gimbal->pitch_deg, -90.0);
  EXPECT_EQ(photo->gimbal->roll_deg, 0.1);
  EXPECT_EQ(photo->rtk_sigma_enu_m, Eigen::Vector3d(0.01, 0.02, 0.03));
  EXPECT_EQ(photo->calibrated_focal_px, 60.5);
}

TEST(PhotoMetadata, PositionCorrectedInTheExifOverrulesThatOfTheXmp) {
  const TempFolder folder;
  const auto read_with_exif = [&](std::uint32_t latitude_e6, std::uint32_t longitude_e6) {
    ExifBuilder exif(std::endian::little);
    exif.rationals(Tag::kGps, 2, {{latitude_e6, 1'000'000}});
    exif.rationals(Tag::kGps, 4, {{longitude_e6, 1'000'000}});
    return read_photo_metadata(folder.file("a.jpg", sample_jpeg(exif.build(), kDjiXmp))).value();
  };
  const PhotoMetadata same = read_with_exif(45'031'596, 7'620'466);
  EXPECT_EQ(same.latitude_deg, 45.03159568);
  EXPECT_TRUE(same.rtk_sigma_enu_m);
  const PhotoMetadata corrected = read_with_exif(45'031'700, 7'620'466);  // 12 m north
  EXPECT_EQ(corrected.latitude_deg, 45.0317);
  EXPECT_FALSE(corrected.rtk_sigma_enu_m);
  const PhotoMetadata cut = read_with_exif(45'000'000, 7'000'000);  // firmware that cuts
  EXPECT_EQ(cut.latitude_deg, 45.03159568);
}

TEST(PhotoMetadata, WhatIsNotAJpegIsAnErrorAndMissingExifIsNot) {
  const TempFolder folder;
  EXPECT_EQ(read_photo_metadata(folder.file("a.jpg", "GIF89a")).error().code, ErrorCode::kParse);
  EXPECT_EQ(read_photo_metadata(folder.path() / "none.jpg").error().code, ErrorCode::kNotFound);
  const auto plain = read_photo_metadata(folder.file("b.jpg", sample_jpeg()));
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->latitude_deg || plain->time || plain->focal_mm);
}

TEST(PhotoMetadata, RandomDamageNeverCrashes) {
  const TempFolder folder;
  const std::string good = sample_jpeg(full_exif(std::endian::little).build(), kDjiXmp);
  for (std::uint64_t i = 0; i < 500; ++i) {
    static_cast<void>(read_photo_metadata(folder.file("bad.jpg", testing::mutated(good, i))));
  }
}

TEST(PhotoMetadata, BrokenDirectoriesBelowSeaLevelStillGiveThePosition) {
  const auto folder = testing::test_data("photos/sheffield60");
  if (!folder) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    if (entry.path().extension() != ".JPG") continue;
    const auto photo = read_photo_metadata(entry.path());
    ASSERT_TRUE(photo) << photo.error().message;
    EXPECT_NEAR(photo->latitude_deg.value(), 28.041, 0.01);
    EXPECT_NEAR(photo->longitude_deg.value(), -82.69, 0.01);
    EXPECT_NEAR(photo->altitude_m.value(), -6.0, 2.0);
    EXPECT_EQ(photo->model, "FC300S");
    EXPECT_TRUE(photo->time && photo->focal_mm && photo->focal_35mm);
    ++count;
  }
  EXPECT_EQ(count, 60U);
}

TEST(PhotoMetadata, RtkDroneAndSimulatedPhotosHaveTheirAccuracy) {
  const auto data = testing::test_data("");
  if (!data) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  const auto rtk = read_photo_metadata(*data / "photos/mirafiori/DJI_0010.JPG");
  ASSERT_TRUE(rtk) << rtk.error().message;
  EXPECT_EQ(rtk->rtk_sigma_enu_m, Eigen::Vector3d(0.01053, 0.01380, 0.02050));
  EXPECT_EQ(rtk->latitude_deg, 45.03159568);
  EXPECT_EQ(rtk->gimbal->pitch_deg, -90.0);
  EXPECT_NEAR(rtk->calibrated_focal_px.value(), 1973.09, 0.01);
  EXPECT_EQ(rtk->serial, "7d2ed18fec733f57faa2ea5415a75c9f");
  const auto simulated = read_photo_metadata(*data / "block-11/images/IMG_0010.JPG");
  ASSERT_TRUE(simulated) << simulated.error().message;
  EXPECT_EQ(simulated->gps_horizontal_error_m, 1.5);
  EXPECT_EQ(simulated->focal_35mm, 28.0);
  EXPECT_NEAR(simulated->focal_mm.value(), 5.177, 1e-3);
  EXPECT_EQ(simulated->width, 1600);
}

}  // namespace
}  // namespace hybridfusion
