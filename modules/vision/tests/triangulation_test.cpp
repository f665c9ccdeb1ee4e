#include "triangulation.hpp"

#include "synthetic_flight.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

std::vector<std::uint32_t> all_tracks(const SfmModel& model) {
  std::vector<std::uint32_t> all(model.tracks.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(IntersectRays, CrossingRaysMeetAtTheirPoint) {
  const Eigen::Vector3d point(1, 2, 3);
  const std::array<WorldRay, 2> rays{
      WorldRay{{0, 0, 0}, point.normalized()},
      WorldRay{{5, 0, 0}, (point - Eigen::Vector3d(5, 0, 0)).normalized()}};
  ASSERT_TRUE(intersect_rays(rays));
  EXPECT_LT((*intersect_rays(rays) - point).norm(), 1e-9);
}

TEST(IntersectRays, ParallelRaysHaveNoPoint) {
  const std::array<WorldRay, 2> rays{WorldRay{{0, 0, 0}, {0, 0, 1}},
                                     WorldRay{{5, 0, 0}, {0, 0, 1}}};
  EXPECT_FALSE(intersect_rays(rays));
}

TEST(LargestAngle, IsThatOfTheWidestPair) {
  const std::array<WorldRay, 3> rays{
      WorldRay{{-1, 0, 0}, {}}, WorldRay{{0, 0, 0}, {}}, WorldRay{{1, 0, 0}, {}}};
  EXPECT_NEAR(largest_angle_rad(rays, {0, 0, 1}), M_PI / 2.0, 1e-12);
}

TEST(TriangulateTracks, FindsThePointsWithinTheNoise) {
  const auto flight = testing::make_flight({.noise_px = 0.2});
  SfmModel model = flight.truth;
  for (auto& point : model.points) point.reset();
  triangulate_tracks(model, all_tracks(model), {}, {});
  double sum2 = 0.0;
  int count = 0;
  for (std::size_t t = 0; t < model.points.size(); ++t) {
    if (!model.points[t] || model.tracks[t].size() < 4) continue;
    sum2 += (*model.points[t] - *flight.truth.points[t]).squaredNorm();
    ++count;
  }
  ASSERT_GT(count, 100);
  // 0.2 px is 1 cm on the ground; depth is about four times worse at these base lengths.
  EXPECT_LT(std::sqrt(sum2 / count), 0.06);
}

TEST(TriangulateTracks, WrongElementIsLeftOut) {
  auto flight = testing::make_flight({.noise_px = 0.0});
  SfmModel& model = flight.truth;
  std::uint32_t track = 0;
  while (model.tracks[track].size() < 5) ++track;
  const Eigen::Vector3d truth = *model.points[track];
  model.tracks[track][2].pixel += Eigen::Vector2d(60.0, -40.0);
  triangulate_tracks(model, std::array{track}, {}, {});
  ASSERT_TRUE(model.points[track]);
  EXPECT_LT((*model.points[track] - truth).norm(), 1e-6);
  EXPECT_FALSE(model.tracks[track][2].active);
  EXPECT_TRUE(model.tracks[track][0].active);
}

TEST(TriangulateTracks, TooSmallAnAngleGivesNoPoint) {
  auto flight = testing::make_flight({.spacing_m = 0.05});
  SfmModel& model = flight.truth;
  for (auto& pose : model.world_from_view) pose->translation = {0.0, 0.0, 65.0};
  model.world_from_view[1]->translation.x() = 0.3;  // 0.26 degrees at 65 m
  triangulate_tracks(model, all_tracks(model), {}, {});
  for (const auto& point : model.points) EXPECT_FALSE(point);
}

}  // namespace
}  // namespace hybridfusion
