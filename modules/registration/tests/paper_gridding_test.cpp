#include <hybridfusion/registration/gridding.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// `per_cell` points around the middle of each cell of a `columns` x `rows` board of 10 m cells.
std::vector<Eigen::Vector3f> board(int columns, int rows, int per_cell) {
  std::vector<Eigen::Vector3f> points;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (int k = 0; k < per_cell; ++k) {
        points.emplace_back(
            Eigen::Vector3d(10.0 * x + 0.1 * k, 10.0 * y + 0.1 * k, 1.0).cast<float>());
      }
    }
  }
  return points;
}

TEST(GridIntoPatches, AssignsEveryPointToExactlyOnePatch) {
  const auto points = board(4, 3, 11);
  const auto grid = grid_into_patches(points, 10.0, 0.0);
  ASSERT_TRUE(grid) << grid.error().message;
  std::vector<int> seen(points.size(), 0);
  for (const Patch& patch : grid->patches) {
    EXPECT_EQ(grid->patch_at(patch.cell.x(), patch.cell.y()), &patch - grid->patches.data());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto i : patch.indices) {
      ++seen[i];
      sum += points[i].cast<double>();
      const Eigen::Vector2d corner = grid->origin + grid->step_m * patch.cell.cast<double>();
      EXPECT_GE(points[i].x(), corner.x() - 1e-4);
      EXPECT_LE(points[i].x(), corner.x() + grid->step_m + 1e-4);
    }
    EXPECT_LT((patch.centroid - sum / static_cast<double>(patch.indices.size())).norm(), 1e-9);
  }
  EXPECT_EQ(std::ranges::count(seen, 1), std::ssize(points));
}

TEST(GridIntoPatches, OneTenthOfTheSceneGivesAboutTenColumns) {
  const auto points = board(10, 10, 50);
  const double size_m = scene_size_m(points, 0.0);
  EXPECT_NEAR(size_m, 94.9, 1e-3);  // 9 cells of 10 m and 4.9 m of points in the last
  const auto grid = grid_into_patches(points, size_m / 10.0, 0.0);
  ASSERT_TRUE(grid);
  EXPECT_GE(grid->columns, 10);
  EXPECT_LE(grid->columns, 11);
}

TEST(GridIntoPatches, AShiftMovesTheOriginAndStillHoldsEveryPoint) {
  const auto points = board(4, 3, 11);
  const auto plain = grid_into_patches(points, 10.0, 0.0);
  const auto shifted = grid_into_patches(points, 10.0, 0.0, {0.5, 0.25});
  ASSERT_TRUE(plain && shifted);
  EXPECT_LT((plain->origin - shifted->origin - Eigen::Vector2d(5.0, 2.5)).norm(), 1e-9);
  std::size_t held = 0;
  for (const Patch& patch : shifted->patches) held += patch.indices.size();
  EXPECT_EQ(held, points.size());
}

TEST(SceneSize, IgnoresAFewFarPoints) {
  auto points = board(10, 10, 50);
  points.emplace_back(5000.0F, -3000.0F, 0.0F);
  EXPECT_LT(scene_size_m(points, 0.003), 96.0);
  EXPECT_GT(scene_size_m(points, 0.0), 4000.0);
}

TEST(GridIntoPatches, NeighboursAndSplicesStopAtTheBorderAndAtSmallPatches) {
  auto points = board(3, 3, 5);
  const auto grid = grid_into_patches(points, 10.0, 0.0);
  ASSERT_TRUE(grid);
  const auto corner = static_cast<std::size_t>(grid->patch_at(0, 0));
  const auto middle = static_cast<std::size_t>(grid->patch_at(1, 1));
  EXPECT_EQ(neighbours_of(*grid, corner, 1).size(), 3U);
  EXPECT_EQ(neighbours_of(*grid, middle, 5).size(), 8U);
  EXPECT_TRUE(neighbours_of(*grid, middle, 6).empty());
  EXPECT_EQ(splice_neighbours(*grid, corner).size(), 20U);
  EXPECT_EQ(splice_neighbours(*grid, middle).size(), points.size());
}

TEST(GridIntoPatches, RefusesAnEmptyCloudAndAStepFarTooSmall) {
  EXPECT_EQ(grid_into_patches({}, 1.0, 0.0).error().code, ErrorCode::kInsufficient);
  const auto points = board(10, 10, 5);
  EXPECT_EQ(grid_into_patches(points, 0.01, 0.0).error().code, ErrorCode::kInvalidOptions);
  EXPECT_THROW((void)grid_into_patches(points, 0.0, 0.0), std::logic_error);
}

}  // namespace
}  // namespace hybridfusion
