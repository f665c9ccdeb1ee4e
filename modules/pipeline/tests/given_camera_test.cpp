#include "given_camera.hpp"

#include "imported_poses.hpp"
#include "test_files.hpp"
#include "vision_files.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::TempFolder;

ColmapCamera full_opencv() {
  return {.id = 1,
          .model = "FULL_OPENCV",
          .width_px = 640,
          .height_px = 480,
          .params = {500, 510, 321, 239, 0.02, -0.01, 1e-3, -2e-3, 0.003, 0.01, -0.02, 0.004}};
}

TEST(GivenCamera, PixelsComeBackAndFollowTheFormulaOfOpenCv) {
  const auto camera = given_camera(full_opencv());
  ASSERT_TRUE(camera);
  const Eigen::Vector2d n(0.3, -0.2);
  const double r2 = 0.13;
  const double radial = (1 + 0.02 * r2 - 0.01 * r2 * r2 + 0.003 * r2 * r2 * r2) /
                        (1 + 0.01 * r2 - 0.02 * r2 * r2 + 0.004 * r2 * r2 * r2);
  const double x = 0.3 * radial + 2 * 1e-3 * 0.3 * -0.2 - 2e-3 * (r2 + 2 * 0.09);
  const double y = -0.2 * radial + 1e-3 * (r2 + 2 * 0.04) - 2 * 2e-3 * 0.3 * -0.2;
  EXPECT_LE((camera->pixel_of(n) - Eigen::Vector2d(500 * x + 320.5, 510 * y + 238.5)).norm(), 1e-9);
  EXPECT_LE((camera->normalized_of(camera->pixel_of(n)) - n).norm(), 1e-9);
  for (const char* model : {"OPENCV_FISHEYE", "SIMPLE_RADIAL", "FOV"}) {
    ColmapCamera other = full_opencv();
    other.model = model;
    EXPECT_FALSE(given_camera(other)) << model;
  }
}

TEST(GivenCamera, TheUndistortedCameraSeesOnlyWhatThePhotoHolds) {
  const auto camera = given_camera(full_opencv());
  ASSERT_TRUE(camera);
  const CameraIntrinsics target = undistorted_intrinsics(*camera);
  for (const double x : {0.0, 320.0, 639.0}) {
    for (const double y : {0.0, 240.0, 479.0}) {
      const Eigen::Vector2d at = camera->pixel_of(unproject(target, {x, y}));
      EXPECT_GE(at.minCoeff(), -1e-9);
      EXPECT_LE(at.x(), 639.0 + 1e-9);
      EXPECT_LE(at.y(), 479.0 + 1e-9);
    }
  }
  EXPECT_LT(target.focal_px, 600.0);
}

/// A ramp along a ray's angle: what a pixel holds tells where it looks.
TEST(GivenCamera, AnUndistortedPhotoShowsEachRayWhereTheCameraPutsItToTwoHundredthsOfAPixel) {
  const auto camera = given_camera(full_opencv());
  ASSERT_TRUE(camera);
  Image8 photo{.width = 640, .height = 480, .channels = 3};
  constexpr double kPerUnit = 150.0;
  Random random(3, "test/dither");  // or the rounding of whole columns is one error
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      const Eigen::Vector2d n = camera->normalized_of({x, y});
      for (const double value : {n.x(), n.y(), 0.0}) {
        photo.pixels.push_back(static_cast<std::uint8_t>(
            std::floor(128.0 + kPerUnit * value + random.uniform(0.0, 1.0))));
      }
    }
  }
  const CameraIntrinsics target = undistorted_intrinsics(*camera);
  const Image8 seen = undistorted_image(photo, *camera, target);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      const Eigen::Vector2d n = unproject(target, {x, y});
      const std::size_t at = static_cast<std::size_t>(3 * (y * 640 + x));
      sum += Eigen::Vector2d(seen.pixels[at], seen.pixels[at + 1]) -
             (Eigen::Vector2d::Constant(128.0) + kPerUnit * n);
    }
  }
  // A grey level is 3 px of a ray here: the mean over all pixels shows a shift of 0.02 px.
  const Eigen::Vector2d shift_px = sum / (640.0 * 480.0) * target.focal_px / kPerUnit;
  EXPECT_LT(shift_px.cwiseAbs().maxCoeff(), 0.02);
}

TEST(GivenCamera, AModelOfSuchCamerasIsTakenAndWrittenAsItWasGiven) {
  const TempFolder folder;
  const ColmapCamera lens = full_opencv();
  const auto camera = given_camera(lens);
  ASSERT_TRUE(camera);
  ColmapModel model{.cameras = {lens}};
  std::vector<Photo> photos;
  const Eigen::Vector3d point(1.0, -2.0, 0.5);
  ColmapPoint3D stored{.id = 5, .point_in_world = point};
  for (std::uint32_t i = 0; i < 3; ++i) {
    ColmapImage image{.id = i + 1, .camera = 1, .name = "p" + std::to_string(i) + ".jpg"};
    image.camera_from_world = Eigen::Quaterniond(0, 1, 0, 0);
    image.camera_from_world_translation = {-2.0 * i, 1.0, 20.0};
    const Eigen::Vector3d seen =
        image.camera_from_world * point + image.camera_from_world_translation;
    image.points.push_back(
        {.pixel = camera->pixel_of(seen.hnormalized()).array() + 0.5, .point3d = 5});
    stored.track.push_back({.image = i + 1, .point2d = 0});
    model.images.push_back(image);
    Photo photo;
    photo.metadata.name = image.name;
    photo.metadata.width = 640;
    photo.metadata.height = 480;
    photo.load = [] {
      return Image8{.width = 640,
                    .height = 480,
                    .channels = 3,
                    .pixels = std::vector<std::uint8_t>(3 * 640 * 480, 7)};
    };
    photos.push_back(photo);
  }
  model.points.push_back(stored);
  ASSERT_TRUE(write_colmap_model(folder.path(), model));
  ASSERT_TRUE(write_origin(folder.path() / "origin.json", {48.0, 11.0, 500.0}));
  const auto poses = import_poses(folder.path(), photos, {});
  ASSERT_TRUE(poses) << poses.error().message;
  // Inside, the observation is where the undistorted camera sees the point.
  const Reconstruction& inside = poses->reconstruction;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d seen = inside.views[i].enu_from_camera->inverse() * point;
    EXPECT_LE(
        (project(inside.cameras[0], seen) - inside.views[i].observations[0].pixel.cast<double>())
            .norm(),
        0.02);
  }
  EXPECT_TRUE(poses->photos[0].load());
  const ColmapModel back = model_as_given(*poses, colmap_model_of(inside));
  EXPECT_EQ(back.cameras[0].params, lens.params);
  EXPECT_LE((back.images[1].points[0].pixel - model.images[1].points[0].pixel).norm(), 1e-3);
}

}  // namespace
}  // namespace hybridfusion
