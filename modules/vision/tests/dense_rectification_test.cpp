#include "dense/image_warp.hpp"
#include "dense_box_scene.hpp"

#include <hybridfusion/core/random.hpp>

#include <string>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr double kPi = std::numbers::pi;

struct PairCase {
  std::string name;
  Rigid3 first;
  Rigid3 second;
};

class AnyPair : public ::testing::TestWithParam<PairCase> {};

const Eigen::Vector3d kDown(0.05, -0.03, -1.0);

INSTANTIATE_TEST_SUITE_P(
    Rectification,
    AnyPair,
    ::testing::Values(PairCase{"AlongTheRows",
                               testing::looking({-4, 0, 50}, kDown, 0.02),
                               testing::looking({4, 1, 51}, {-0.06, 0.02, -1}, -0.03)},
                      PairCase{"AlongTheColumns",
                               testing::looking({0, -4, 50}, kDown, 0.0),
                               testing::looking({0.5, 4, 50}, kDown, 0.05)},
                      PairCase{"RightToLeft",
                               testing::looking({4, 0, 50}, kDown, 0.0),
                               testing::looking({-4, 0, 50}, kDown, 0.0)},
                      PairCase{"TurnedByHalfATurn",
                               testing::looking({-4, 0, 50}, kDown, 0.0),
                               testing::looking({4, 1, 50}, kDown, kPi)},
                      PairCase{"TurnedByAQuarter",
                               testing::looking({-4, 3, 50}, kDown, 0.3),
                               testing::looking({4, 0, 48}, kDown, 0.3 + kPi / 2)},
                      PairCase{"Oblique",
                               testing::looking({-40, -8, 50}, {1, 0.1, -1}, 0.0),
                               testing::looking({-39, 8, 50}, {1, -0.2, -1}, 0.0)}),
    [](const auto& pair) { return pair.param.name; });

/// Points that a survey would see, about the origin.
std::vector<Eigen::Vector3d> scene_points() {
  Random random(3, "rectification test");
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 300; ++i) {
    points.emplace_back(random.uniform(-15, 15), random.uniform(-15, 15), random.uniform(0, 8));
  }
  return points;
}

TEST_P(AnyPair, RowsCoincideAndDepthFollowsFromTheDisparity) {
  const PosedCamera first{testing::small_camera(), GetParam().first};
  const PosedCamera second{testing::small_camera(), GetParam().second};
  double near_m = 1e9;
  double far_m = 0.0;
  for (const Eigen::Vector3d& p : scene_points()) {
    near_m = std::min(near_m, rectified_depth_m(first, second, p));
    far_m = std::max(far_m, rectified_depth_m(first, second, p));
  }
  const auto geometry =
      rectify(first, second, {.focal_px = 250.0, .near_m = near_m, .far_m = far_m});
  ASSERT_TRUE(geometry) << geometry.error().message;
  EXPECT_EQ(geometry->num_disparities % 4, 1);
  EXPECT_EQ(geometry->right.width_px, geometry->left.width_px + geometry->num_disparities - 1);
  const Rigid3 left{.rotation = geometry->enu_from_rectified,
                    .translation = first.enu_from_camera.translation};
  const Rigid3 right{.rotation = geometry->enu_from_rectified,
                     .translation = second.enu_from_camera.translation};
  for (const Eigen::Vector3d& p : scene_points()) {
    const Eigen::Vector2d a = pixel_of(geometry->left, left.inverse() * p);
    const Eigen::Vector2d b = pixel_of(geometry->right, right.inverse() * p);
    EXPECT_NEAR(a.y(), b.y(), 1e-8);
    const double k = a.x() - b.x() + geometry->num_disparities - 1;
    EXPECT_GE(k, -1e-6);
    EXPECT_LE(k, geometry->num_disparities - 1 + 1e-6);
    EXPECT_NEAR(geometry->depth_m(k), rectified_depth_m(first, second, p), 1e-7);
    EXPECT_GT((left.inverse() * p).z(), 0.0);
  }
}

/// Least-squares shift of `seen` against what the scene shows at each rectified pixel.
Eigen::Vector2d shift_against_scene(const cv::Mat& seen,
                                    const cv::Mat& mask,
                                    const PinholeGrid& grid,
                                    const Rigid3& enu_from_rectified,
                                    const testing::BoxScene& scene) {
  const auto expected = [&](double x, double y) {
    const Eigen::Vector3d ray = enu_from_rectified.rotation * ray_of(grid, {x, y});
    return scene.cast(enu_from_rectified.translation, ray).grey;
  };
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right_side = Eigen::Vector2d::Zero();
  for (int y = 2; y + 2 < grid.height_px; ++y) {
    for (int x = 2; x + 2 < grid.width_px; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      const Eigen::Vector2d gradient((expected(x + 1, y) - expected(x - 1, y)) / 2.0,
                                     (expected(x, y + 1) - expected(x, y - 1)) / 2.0);
      normal += gradient * gradient.transpose();
      right_side += gradient * (seen.at<std::uint8_t>(y, x) - expected(x, y));
    }
  }
  return normal.ldlt().solve(right_side);
}

// Forgetting that pixel centres are whole numbers shifts a photo by half a pixel of the original;
// turned by half a turn the two shifts add up instead of cancelling.
TEST_P(AnyPair, BothReducedPhotosLandWhereTheSceneIsWithinATenthOfAPixel) {
  const testing::BoxScene scene{.box_height_m = 0.0, .texture_m = 3.0};
  const CameraIntrinsics camera = testing::small_camera(400, 300);
  const PosedCamera first{camera, GetParam().first};
  const PosedCamera second{camera, GetParam().second};
  const double depth_m = rectified_depth_m(first, second, Eigen::Vector3d::Zero());
  const auto geometry =
      rectify(first, second, {.focal_px = 170.0, .near_m = 0.7 * depth_m, .far_m = 1.5 * depth_m});
  ASSERT_TRUE(geometry) << geometry.error().message;
  for (const bool is_first : {true, false}) {
    const PosedCamera& posed = is_first ? first : second;
    const PinholeGrid& grid = is_first ? geometry->left : geometry->right;
    const WorkImage work = reduce(testing::photograph(scene, posed), camera, 200);
    const WarpMap map =
        warp_map(work.intrinsics,
                 grid,
                 posed.enu_from_camera.rotation.conjugate() * geometry->enu_from_rectified);
    const Eigen::Vector2d shift =
        shift_against_scene(resample(work.grey, map),
                            map.mask,
                            grid,
                            {geometry->enu_from_rectified, posed.enu_from_camera.translation},
                            scene);
    EXPECT_LT(shift.norm(), 0.1) << (is_first ? "first" : "second");
  }
}

TEST(Rectification, ReducedIntrinsicsKeepThePixelGrid) {
  CameraIntrinsics camera = testing::small_camera(400, 300);
  camera.principal_point_px = {-0.5, -0.5};  // the photo's corner stays its corner
  EXPECT_EQ(scaled(camera, 200, 150).principal_point_px, Eigen::Vector2d(-0.5, -0.5));
  camera.principal_point_px = {0.5, 0.5};  // the centre of the first four pixels
  EXPECT_EQ(scaled(camera, 200, 150).principal_point_px, Eigen::Vector2d(0.0, 0.0));
}

// 20 rows at 2/3 are 13.3: a whole number of them must not squeeze the photo.
TEST(Rectification, AReducedPhotoKeepsItsShapeWhereItsRowsDoNotDivide) {
  const CameraIntrinsics camera = testing::small_camera(300, 20);
  Image8 photo{.width = 300, .height = 20, .channels = 1};
  for (int y = 0; y < photo.height; ++y) {
    photo.pixels.insert(photo.pixels.end(), 300, static_cast<std::uint8_t>(12 * y));
  }
  const WorkImage work = reduce(photo, camera, 200);
  EXPECT_DOUBLE_EQ(work.intrinsics.focal_px, camera.focal_px * 2.0 / 3.0);
  for (int y = 0; y < 13; ++y) {
    const double row = (y + 0.5) * camera.focal_px / work.intrinsics.focal_px - 0.5;
    EXPECT_NEAR(work.grey.at<std::uint8_t>(y, 100), 12.0 * row, 1.5) << y;
  }
}

TEST(Rectification, RefusesOneCentreForwardMotionAndPhotosThatShareNothing) {
  const PosedCamera down{testing::small_camera(), testing::looking({0, 0, 50}, kDown, 0.0)};
  const RectificationRequest request{.focal_px = 250.0, .near_m = 40.0, .far_m = 60.0};
  const auto refused = [&](const Rigid3& second) {
    const auto result = rectify(down, {testing::small_camera(), second}, request);
    return !result && result.error().code == ErrorCode::kDegenerate;
  };
  EXPECT_TRUE(refused(down.enu_from_camera));
  EXPECT_TRUE(refused(testing::looking({0, 0, 40}, kDown, 0.0)));
  EXPECT_TRUE(refused(testing::looking({5, 0, 50}, {3.0, 0.0, -1.0}, 0.0)));
  EXPECT_TRUE(refused(testing::looking({500, 0, 50}, kDown, 0.0)));
  EXPECT_FALSE(refused(testing::looking({5, 0, 50}, kDown, 0.0)));
}

TEST(UndistortedGrid, EnclosesThePhotoOfABarrelLensAndNoMore) {
  const CameraIntrinsics barrel{.width_px = 800,
                                .height_px = 600,
                                .focal_px = 1000.0,
                                .principal_point_px = {395.0, 304.0},
                                .k1 = -0.4,
                                .k2 = 0.3};
  const PinholeGrid grid = undistorted_grid(barrel);
  Eigen::Vector2d low(1e9, 1e9);
  Eigen::Vector2d high(-1e9, -1e9);
  for (int x = 0; x < 800; ++x) {
    for (int y = 0; y < 600; ++y) {
      const Eigen::Vector2d at = pixel_of(grid, unproject(barrel, {x, y}).homogeneous());
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
  EXPECT_NEAR(low.x(), 0.5, 0.5);
  EXPECT_NEAR(low.y(), 0.5, 0.5);
  EXPECT_NEAR(high.x(), grid.width_px - 1.5, 0.5);
  EXPECT_NEAR(high.y(), grid.height_px - 1.5, 0.5);
  EXPECT_GT(grid.width_px, 850);
}

TEST(UndistortedGrid, IsThePhotoItselfWithoutDistortionAndStaysSmallWhateverTheLens) {
  CameraIntrinsics camera{
      .width_px = 800, .height_px = 600, .focal_px = 900.0, .principal_point_px = {395.0, 304.0}};
  const PinholeGrid same = undistorted_grid(camera);
  EXPECT_EQ(same.width_px, 800);
  EXPECT_EQ(same.height_px, 600);
  EXPECT_NEAR((same.principal_point_px - camera.principal_point_px).norm(), 0.0, 1e-9);
  for (const double k1 : {-3.0, 3.0}) {
    camera.k1 = k1;
    const PinholeGrid grid = undistorted_grid(camera);
    EXPECT_LE(grid.width_px, 1202) << k1;
    EXPECT_LE(grid.height_px, 902) << k1;
    EXPECT_GT(grid.width_px, 100) << k1;
  }
}

}  // namespace
}  // namespace hybridfusion
