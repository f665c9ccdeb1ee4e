#include "intrinsics_prior.hpp"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

PhotoMetadata photo() {
  PhotoMetadata p{.name = "a.jpg", .make = "M", .model = "X"};
  p.width = 1600;
  p.height = 1200;
  return p;
}

TEST(GroupCameras, ThirtyFiveMillimetreEquivalentGoesByTheDiagonal) {
  PhotoMetadata p = photo();
  p.focal_35mm = 28.0;
  const CameraSetup setup = group_cameras(std::array{p}, {}, 1600);
  // 28 / 43.2666 * 2000 px; by the width it would be 1244.
  EXPECT_NEAR(setup.cameras[0].intrinsics.focal_px, 1294.3, 0.05);
  EXPECT_FALSE(setup.cameras[0].focal_guessed);
  EXPECT_EQ(setup.cameras[0].intrinsics.principal_point_px, Eigen::Vector2d(799.5, 599.5));
}

TEST(GroupCameras, FocalPlaneResolutionOfAReducedCopyIsScaled) {
  PhotoMetadata p = photo();
  p.focal_mm = 4.5;
  p.focal_plane_px_per_mm = 645.4;  // of the original, 4000 px wide
  p.original_width = 4000;
  const CameraSetup setup = group_cameras(std::array{p}, {}, 1600);
  EXPECT_NEAR(setup.cameras[0].intrinsics.focal_px, 4.5 * 645.4 * 0.4, 0.1);
}

TEST(GroupCameras, UnknownLensIsGuessedWithAWideSigmaAndSaysSo) {
  const CameraSetup setup = group_cameras(std::array{photo()}, {}, 1600);
  EXPECT_TRUE(setup.cameras[0].focal_guessed);
  EXPECT_EQ(setup.cameras[0].intrinsics.focal_px, 1920.0);
  EXPECT_EQ(setup.cameras[0].focal_sigma, 0.15);
  ASSERT_EQ(setup.warnings.size(), 1U);
  EXPECT_THAT(setup.warnings[0], HasSubstr("vision.reconstruction.intrinsics.focal_px"));
}

TEST(GroupCameras, OptionOverridesTheMetadata) {
  PhotoMetadata p = photo();
  p.focal_35mm = 28.0;
  const CameraSetup setup = group_cameras(std::array{p}, {.focal_px = 1500.0}, 1600);
  EXPECT_EQ(setup.cameras[0].intrinsics.focal_px, 1500.0);
}

TEST(GroupCameras, SourcesThatDisagreeWarn) {
  PhotoMetadata p = photo();
  p.focal_35mm = 28.0;
  p.calibrated_focal_px = 1700.0;
  const CameraSetup setup = group_cameras(std::array{p}, {}, 1600);
  ASSERT_EQ(setup.warnings.size(), 1U);
  EXPECT_THAT(setup.warnings[0], HasSubstr("1294"));
}

TEST(GroupCameras, OneCameraPerSerialAndSize) {
  PhotoMetadata a = photo();
  PhotoMetadata b = photo();
  PhotoMetadata c = photo();
  b.serial.assign(1, '2');
  c.width = 3200;
  c.height = 2400;
  const CameraSetup setup = group_cameras(std::array{a, b, a, c}, {}, 1600);
  EXPECT_EQ(setup.camera_of_photo, (std::vector<std::uint32_t>{0, 1, 0, 2}));
  EXPECT_EQ(setup.cameras[0].pixel_scale, 1.0);
  EXPECT_EQ(setup.cameras[2].pixel_scale, 2.0);
}

}  // namespace
}  // namespace hybridfusion
