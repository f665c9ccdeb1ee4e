#include "resection.hpp"

#include "rigid3_matchers.hpp"
#include "synthetic_flight.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

const Rigid3 kWorldFromCamera{.rotation = testing::looking_down(0.7, 0.2),
                              .translation = {12.0, -7.0, 64.0}};

struct Scene {
  std::vector<Eigen::Vector2d> pixels;
  std::vector<Eigen::Vector3d> points;
};

Scene scene(int count, double noise_px, double outliers) {
  Random random(5, "test/resection");
  Scene result;
  while (static_cast<int>(result.points.size()) < count) {
    const Eigen::Vector3d point(
        random.uniform(-40, 60), random.uniform(-50, 40), random.uniform(0, 12));
    const Eigen::Vector3d in_camera = kWorldFromCamera.inverse() * point;
    if (in_camera.z() < 1.0) continue;
    Eigen::Vector2d pixel = project(testing::flight_camera(), in_camera);
    if (pixel.x() < 0 || pixel.x() > 1599 || pixel.y() < 0 || pixel.y() > 1199) continue;
    pixel += noise_px * Eigen::Vector2d(random.normal(), random.normal());
    if (random.uniform() < outliers) {
      pixel = {random.uniform(0, 1599), random.uniform(0, 1199)};
    }
    result.points.push_back(point);
    result.pixels.push_back(pixel);
  }
  return result;
}

TEST(ThreePointPose, OneSolutionIsTheTruth) {
  for (int start = 0; start < 30; start += 3) {
    const Scene s = scene(33, 0.0, 0.0);
    std::array<Eigen::Vector2d, 3> normalized;
    std::array<Eigen::Vector3d, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = static_cast<std::size_t>(start) + k;
      normalized[k] = unproject(testing::flight_camera(), s.pixels[i]);
      points[k] = s.points[i];
    }
    double nearest_m = 1e9;
    for (const Rigid3& pose : world_from_camera_by_three_points(normalized, points)) {
      nearest_m = std::min(nearest_m, (pose.translation - kWorldFromCamera.translation).norm());
    }
    EXPECT_LT(nearest_m, 1e-3) << start;
  }
}

TEST(ThreePointPose, CoincidentPointsGiveNoPose) {
  const std::array<Eigen::Vector2d, 3> normalized{Eigen::Vector2d(0, 0), {0.1, 0}, {0, 0.1}};
  const std::array<Eigen::Vector3d, 3> points{
      Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 0, 0)};
  EXPECT_TRUE(world_from_camera_by_three_points(normalized, points).empty());
}

TEST(ResectCamera, FindsThePoseAmongHalfOutliers) {
  const Scene s = scene(200, 0.4, 0.5);
  const auto result =
      resect_camera(testing::flight_camera(), s.pixels, s.points, {}, Random(1, "test"));
  ASSERT_TRUE(result);
  // 0.4 px at 64 m and f = 1290 px is 2 cm on the ground; 100 inliers average it down.
  EXPECT_THAT(result->world_from_camera, Rigid3Near(kWorldFromCamera, 0.05, 0.001));
  EXPECT_GT(result->inliers.size(), 80U);
}

TEST(ResectCamera, RandomPointsGiveNothing) {
  const Scene s = scene(100, 0.4, 1.0);
  EXPECT_FALSE(resect_camera(testing::flight_camera(), s.pixels, s.points, {}, Random(1, "test")));
}

}  // namespace
}  // namespace hybridfusion
