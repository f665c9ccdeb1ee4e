#include "doctor_checks.hpp"
#include "doctor_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class DoctorPhotos : public DoctorTest {
 protected:
  [[nodiscard]] std::vector<std::string> findings_of(const std::vector<PhotoSpec>& photos) const {
    write_flight(photos);
    return ids_of(report_of({.images = images()}));
  }
};

TEST_F(DoctorPhotos, AHealthyFlightHasNoFindings) {
  EXPECT_THAT(findings_of(healthy_flight()), IsEmpty());
}

TEST_F(DoctorPhotos, AMissingOrEmptyFolderIsAnError) {
  EXPECT_THAT(ids_of(report_of({.images = images()})), ElementsAre("photos.folder"));
  std::filesystem::create_directories(images());
  const DoctorReport report = report_of({.images = images()});
  EXPECT_THAT(ids_of(report), ElementsAre("photos.folder"));
  EXPECT_TRUE(report.has_errors());
  EXPECT_FALSE(report.only_resource_errors());
}

TEST_F(DoctorPhotos, TruncatedAndEmptyPhotosAreNamed) {
  write_flight(healthy_flight());
  std::filesystem::resize_file(images() / "IMG_03.JPG", 3000);
  std::filesystem::resize_file(images() / "IMG_05.JPG", 0);
  const DoctorReport report = report_of({.images = images()});
  ASSERT_THAT(ids_of(report), ElementsAre("photos.unreadable"));
  EXPECT_THAT(report.findings[0].subjects, ElementsAre("IMG_03.JPG", "IMG_05.JPG"));
  EXPECT_FALSE(report.has_errors());
}

TEST_F(DoctorPhotos, TwoPhotosAreTooFewAndFiveAreFew) {
  auto photos = healthy_flight();
  photos.resize(5);
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.few"));
  for (const char* name : {"IMG_02.JPG", "IMG_03.JPG", "IMG_04.JPG"}) {
    std::filesystem::remove(images() / name);
  }
  EXPECT_THAT(ids_of(report_of({.images = images()})),
              ElementsAre("photos.too_few", "photos.no_positions"));
}

TEST_F(DoctorPhotos, PhotosWithoutPositionAreAnErrorWhenFewerThanThreeAreLeft) {
  auto photos = healthy_flight();
  photos[4].latitude_deg.reset();
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.some_without_position"));
  for (PhotoSpec& photo : photos) photo.latitude_deg.reset();
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.no_positions"));
}

TEST_F(DoctorPhotos, ThePositionZeroZeroIsToldFromNone) {
  auto photos = healthy_flight();
  photos[4].latitude_deg = photos[4].longitude_deg = 0.0;
  write_flight(photos);
  const DoctorReport report = report_of({.images = images()});
  EXPECT_THAT(finding(report, "photos.null_position").subjects, ElementsAre("IMG_04.JPG"));
}

TEST_F(DoctorPhotos, IdenticalPositionsAreAnError) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) {
    photo.latitude_deg = kSiteLatitude_deg;
    photo.longitude_deg = kSiteLongitude_deg;
  }
  EXPECT_THAT(findings_of(photos), Contains("photos.same_position"));
}

TEST_F(DoctorPhotos, ARepeatedPositionIsAWarning) {
  auto photos = healthy_flight();
  for (const std::size_t i : {5U, 6U}) {
    photos[i].latitude_deg = photos[4].latitude_deg;
    photos[i].longitude_deg = photos[4].longitude_deg;
  }
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.repeated_position"));
}

TEST_F(DoctorPhotos, OnePositionFarAwayIsNamed) {
  auto photos = healthy_flight();
  *photos[4].latitude_deg += 5000.0 * kDegPerMeter;
  write_flight(photos);
  const DoctorReport report = report_of({.images = images()});
  ASSERT_THAT(ids_of(report), ElementsAre("photos.bad_position"));
  EXPECT_THAT(report.findings[0].subjects, ElementsAre("IMG_04.JPG"));
}

TEST_F(DoctorPhotos, FlippedAltitudesAreNamed) {
  auto photos = healthy_flight();
  photos[2].altitude_ref = photos[7].altitude_ref = 1;
  write_flight(photos);
  const DoctorReport report = report_of({.images = images()});
  // The reconstruction sees that these two do not fit their neighbours and does without.
  EXPECT_THAT(finding(report, "photos.altitude_ref").subjects,
              ElementsAre("IMG_02.JPG", "IMG_07.JPG"));
  EXPECT_FALSE(report.has_errors());
}

TEST_F(DoctorPhotos, AFlightBelowEveryShoreHasItsSignWrong) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.altitude_ref = 1;
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.altitude_sign"));
}

TEST_F(DoctorPhotos, AFlightOverTheDeadSeaIsFine) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) {
    photo.altitude_ref = 1;
    photo.altitude_m = 350.0;
  }
  EXPECT_THAT(findings_of(photos), IsEmpty());
}

TEST_F(DoctorPhotos, MissingAltitudesAreAWarning) {
  auto photos = healthy_flight();
  photos[3].altitude_m.reset();
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.no_altitude"));
}

TEST_F(DoctorPhotos, AFlightTooSparseForItsHeightHasNoOverlap) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) {
    photo.latitude_deg = kSiteLatitude_deg + 10.0 * (*photo.latitude_deg - kSiteLatitude_deg);
    photo.longitude_deg = kSiteLongitude_deg + 10.0 * (photo.longitude_deg - kSiteLongitude_deg);
  }
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.no_overlap", "photos.low_overlap"));
}

TEST_F(DoctorPhotos, ASecondBlockFarAwayIsAnIsland) {
  auto photos = healthy_flight();
  for (std::size_t i = 8; i < 12; ++i) *photos[i].latitude_deg += 1000.0 * kDegPerMeter;
  write_flight(photos);
  const DoctorReport report = report_of({.images = images()});
  EXPECT_THAT(finding(report, "photos.islands").subjects,
              ElementsAre("IMG_08.JPG", "IMG_09.JPG", "IMG_10.JPG", "IMG_11.JPG"));
}

TEST_F(DoctorPhotos, WideSpacingIsLowOverlap) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.relative_altitude_m = 35.0;
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.low_overlap"));
}

TEST_F(DoctorPhotos, MixedCamerasAreNamed) {
  auto photos = healthy_flight();
  photos[1].model = "Other";
  write_flight(photos);
  const DoctorReport report = report_of({.images = images()});
  ASSERT_THAT(ids_of(report), ElementsAre("photos.mixed_cameras"));
  EXPECT_THAT(report.findings[0].subjects, ElementsAre("IMG_01.JPG"));
}

TEST_F(DoctorPhotos, AMissingFocalLengthIsAWarning) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.focal_35mm.reset();
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.no_focal"));
}

TEST_F(DoctorPhotos, ASizeThatTheMetadataContradictIsAWarning) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.exif_width = 4000;
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.exif_size"));
}

TEST_F(DoctorPhotos, ACopyUnderAnotherNameIsNamed) {
  write_flight(healthy_flight());
  std::filesystem::copy(images() / "IMG_03.JPG", images() / "IMG_03 (1).JPG");
  const DoctorReport report = report_of({.images = images()});
  EXPECT_EQ(finding(report, "photos.duplicate").subjects.size(), 1U);
}

TEST_F(DoctorPhotos, ABlurredPhotoIsNamed) {
  auto photos = healthy_flight();
  photos[6].image = blurred(textured_image(6), 2);
  write_flight(photos);
  const DoctorReport report = report_of({.images = images()});
  ASSERT_THAT(ids_of(report), ElementsAre("photos.blurred"));
  EXPECT_THAT(report.findings[0].subjects, ElementsAre("IMG_06.JPG"));
}

TEST_F(DoctorPhotos, ABlackPhotoIsNamed) {
  auto photos = healthy_flight();
  photos[6].image = textured_image(6);
  for (std::uint8_t& value : photos[6].image.pixels) value = static_cast<std::uint8_t>(value / 40);
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.exposure"));
}

TEST_F(DoctorPhotos, PhotosOfTwoSeasonsAreAWarning) {
  auto photos = healthy_flight();
  photos.back().time = "2026:11:01 10:00:00";
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.several_days"));
}

TEST_F(DoctorPhotos, ASmallBlockOfCodeReceiversIsToldWhatTheReportWillSay) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.rtk = false;
  EXPECT_THAT(findings_of(photos), ElementsAre("photos.weak_georeference"));
  // Not where geo.txt knows the places to centimetres.
  std::string text = "EPSG:4326\n";
  for (const PhotoSpec& photo : photos) {
    text += fmt::format("{} {:.9f} {:.9f} {:.2f} 0 0 0 0.02 0.03\n",
                        photo.name,
                        photo.longitude_deg,
                        *photo.latitude_deg,
                        *photo.altitude_m);
  }
  (void)folder_.file("images/geo.txt", text);
  EXPECT_THAT(ids_of(report_of({.images = images()})), IsEmpty());
}

TEST_F(DoctorPhotos, TheFilesOfPositionsAreReadAndComparedWithThePhotos) {
  const auto photos = healthy_flight();
  write_flight(photos);
  std::string swapped = "EPSG:4326\n";
  for (const PhotoSpec& photo : photos) {
    swapped +=
        fmt::format("{} {:.9f} {:.9f} 600\n", photo.name, *photo.latitude_deg, photo.longitude_deg);
  }
  const DoctorReport geo =
      report_of({.images = images(), .geo_tags = folder_.file("tags.txt", swapped)});
  EXPECT_THAT(finding(geo, "positions.contradict").cause,
              ::testing::HasSubstr("latitude and longitude swapped"));
  EXPECT_TRUE(geo.has_errors());
  (void)folder_.file("images/gcp_list.txt", "EPSG:4326\n11.5 49.15 520 10 10 IMG_00.JPG p\n");
  EXPECT_THAT(ids_of(report_of({.images = images()})), Contains("control.far"));
  (void)folder_.file("images/gcp_list.txt", "my system\n11.5 48.15 520 10 10 IMG_00.JPG p\n");
  EXPECT_THAT(ids_of(report_of({.images = images()})), ElementsAre("positions.unreadable"));
  (void)folder_.file("images/gcp_list.txt", "EPSG:4326\n11.5 48.15 520 10 10 OTHER.JPG p\n");
  EXPECT_THAT(ids_of(report_of({.images = images()})), ElementsAre("control.no_photos"));
}

TEST_F(DoctorPhotos, PhotosWithoutPositionAreNoErrorWhereControlPlacesThem) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.latitude_deg.reset();
  write_flight(photos);
  std::string text = "EPSG:4326\n";
  for (int p = 0; p < 3; ++p) {
    for (int i = 0; i < 2; ++i) {
      text += fmt::format("{:.6f} 48.15 520 10 10 IMG_0{}.JPG p{}\n", 11.5 + 1e-4 * p, i, p);
    }
  }
  (void)folder_.file("images/gcp_list.txt", text);
  EXPECT_THAT(ids_of(report_of({.images = images()})), IsEmpty());
}

TEST_F(DoctorPhotos, SubfoldersAndOtherFormatsAreTold) {
  write_flight(healthy_flight());
  std::filesystem::create_directories(images() / "101MEDIA");
  std::filesystem::rename(images() / "IMG_11.JPG", images() / "101MEDIA/IMG_11.JPG");
  (void)folder_.file("images/IMG_20.png", "x");
  const DoctorReport report = report_of({.images = images()});
  EXPECT_THAT(ids_of(report), ElementsAre("photos.other_formats"));
  EXPECT_THAT(report.facts, Contains(::testing::HasSubstr("101MEDIA (1)")));
}

TEST(Sharpness, FallsWithBlur) {
  const Image8 sharp = textured_image(1, 320, 240);
  double last = sharpness_of(sharp);
  for (const int radius : {1, 2, 4}) {
    const double now = sharpness_of(blurred(sharp, radius));
    EXPECT_LT(now, 0.75 * last) << radius;
    last = now;
  }
}

}  // namespace
}  // namespace hybridfusion::testing
