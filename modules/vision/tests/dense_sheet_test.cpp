#include "dense/cloud_sheet.hpp"
#include "dense/voxel_choice.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr float kNoise_m = 0.02F;

/// Points 0.1 m apart on a floor and, with `wall`, on a wall that meets it at x = 0, with noise
/// along the normal and directions up to 45 degrees off it.
PointCloud noisy_room(bool wall) {
  Random random(7, "sheet test");
  PointCloud cloud;
  const auto add = [&](Eigen::Vector3f point, const Eigen::Vector3f& normal) {
    point += kNoise_m * static_cast<float>(random.normal()) * normal;
    cloud.points.push_back(point);
    cloud.normals.emplace_back((normal + Eigen::Vector3f(0.3F, 0.3F, 0.3F)).normalized());
    cloud.colors.push_back({1, 2, 3});
    cloud.sigmas_m.push_back(kNoise_m);
    cloud.confidences.push_back(2.0F);
  };
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const float u = 0.1F * static_cast<float>(i) + 0.05F;
      const float v = 0.1F * static_cast<float>(j);
      add({u, v, 0.0F}, Eigen::Vector3f::UnitZ());
      if (wall) add({0.0F, v, u}, Eigen::Vector3f::UnitX());
    }
  }
  return cloud;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(OneSheet, ANoisyFloorBecomesThreeTimesThinnerAndSaysHowWellItIsKnown) {
  const PointCloud sheet = one_sheet(noisy_room(false), {.num_threads = 2});
  ASSERT_GT(sheet.size(), 1550U);
  std::vector<double> heights;
  std::vector<double> errors_in_sigmas;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    heights.push_back(sheet.points[i].z());
    errors_in_sigmas.push_back(std::abs(sheet.points[i].z()) / sheet.sigmas_m[i]);
    EXPECT_GT(sheet.normals[i].z(), 0.9F);
  }
  EXPECT_LT(root_mean_square(heights), kNoise_m / 3.0);
  // Noise without any correlation: the stated deviation is on the safe side of it.
  EXPECT_LT(root_mean_square(errors_in_sigmas), 1.0);
  EXPECT_GT(root_mean_square(errors_in_sigmas), 0.1);
}

TEST(OneSheet, ACornerIsNotRoundedOff) {
  const PointCloud sheet = one_sheet(noisy_room(true), {.num_threads = 1});
  std::vector<double> distances;
  for (const Eigen::Vector3f& p : sheet.points) {
    if (p.x() > 0.3F && p.z() > 0.3F) FAIL() << "a point in the air: " << p.transpose();
    if (p.x() < 0.25F && p.z() < 0.25F)
      distances.push_back(std::min(std::abs(p.x()), std::abs(p.z())));
  }
  ASSERT_GT(distances.size(), 100U);
  EXPECT_LT(root_mean_square(distances), 1.2 * kNoise_m);
}

TEST(OneSheet, ASpeckInTheAirIsLeftOut) {
  PointCloud room = noisy_room(false);
  room.points[20] = {2.0F, 2.0F, 3.0F};
  const PointCloud sheet = one_sheet(room, {});
  EXPECT_TRUE(std::ranges::all_of(sheet.points, [](const auto& p) { return p.z() < 1.0F; }));
}

/// A floor of 100 depths a point, above whose middle, 1 m wide, lie points of `num_depths`.
std::size_t points_above_a_floor(float num_depths, float height_m) {
  PointCloud room = noisy_room(false);
  std::ranges::fill(room.confidences, 100.0F);
  const std::size_t size = room.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Eigen::Vector3f p = room.points[i];
    if (std::abs(p.x() - 2.0F) > 0.5F || std::abs(p.y() - 2.0F) > 0.5F) continue;
    room.points.emplace_back(p.x() + 0.05F, p.y() + 0.05F, height_m);
    room.normals.push_back(room.normals[i]);
    room.colors.push_back(room.colors[i]);
    room.sigmas_m.push_back(kNoise_m);
    room.confidences.push_back(num_depths);
  }
  const PointCloud sheet = one_sheet(room, {});
  return static_cast<std::size_t>(
      std::ranges::count_if(sheet.points, [&](const auto& p) { return p.z() > 0.5F * height_m; }));
}

TEST(OneSheet, FewDepthsBesideASheetOfManyAreLeftOut) {
  EXPECT_EQ(points_above_a_floor(3.0F, 0.15F), 0U);
}

TEST(OneSheet, AStepSeenAsOftenAsTheFloorStays) {
  EXPECT_GT(points_above_a_floor(60.0F, 0.15F), 90U);
}

TEST(OneSheet, TwoPointsStayAsTheyAre) {
  PointCloud two = noisy_room(false);
  two = select(two, std::vector<std::size_t>{0, 1});
  const PointCloud sheet = one_sheet(two, {});
  EXPECT_EQ(sheet.points, two.points);
  EXPECT_EQ(sheet.sigmas_m, two.sigmas_m);
}

TEST(VoxelSums, MeanColorIsThatOfTheFirst8192Depths) {
  VoxelSums sums;
  sums.count_color({10, 0, 255});
  sums.count_color({11, 0, 255});
  sums.count_color({11, 1, 255});
  EXPECT_EQ(sums.mean_color(), (Rgb8{11, 0, 255}));
  VoxelSums many;
  for (int i = 0; i < 8192; ++i) many.count_color({255, 254, 0});
  for (int i = 0; i < 8192; ++i) many.count_color({0, 0, 255});
  EXPECT_EQ(many.mean_color(), (Rgb8{255, 254, 0}));
  EXPECT_EQ(many.count, 16384);
}

/// A table whose voxels are seen from above.
class Voxels {
 public:
  void add(int x, int y, int z, int count) {
    VoxelSums& sums = table_[voxel_key({x, y, z})];
    sums.count = count;
    sums.weight = static_cast<float>(count);
    sums.towards_photo = Eigen::Vector3f(0.1F, 0.0F, 1.0F);
  }
  [[nodiscard]] bool keeps(int x, int y, int z) const {
    const auto chosen = choose_voxels(table_, 2);
    return std::ranges::find(chosen, voxel_key({x, y, z}), &VoxelSums::key) != chosen.end();
  }

 private:
  VoxelTable table_;
};

TEST(ChooseVoxels, ALoneDepthIsDropped) {
  Voxels voxels;
  voxels.add(0, 0, 0, 1);
  voxels.add(5, 0, 0, 2);
  EXPECT_FALSE(voxels.keeps(0, 0, 0));
  EXPECT_TRUE(voxels.keeps(5, 0, 0));
}

TEST(ChooseVoxels, ThinlySampledSurfacesStay) {
  Voxels voxels;
  for (int x = -3; x < 3; ++x) voxels.add(x, -1, 4, 1);
  for (int x = -3; x < 3; ++x) EXPECT_TRUE(voxels.keeps(x, -1, 4)) << x;
}

TEST(ChooseVoxels, NoiseBeforeAndBehindASheetIsDropped) {
  Voxels voxels;
  for (int x = 0; x < 6; ++x) {
    voxels.add(x, 0, 0, 4);
    voxels.add(x, 0, x % 2 == 0 ? 1 : -1, 1);
  }
  for (int x = 0; x < 6; ++x) {
    EXPECT_TRUE(voxels.keeps(x, 0, 0));
    EXPECT_FALSE(voxels.keeps(x, 0, x % 2 == 0 ? 1 : -1));
  }
}

TEST(ChooseVoxels, OfTwoThinSheetsOneStays) {
  Voxels voxels;
  for (int x = 0; x < 4; ++x) {
    voxels.add(x, 0, 0, 1);
    voxels.add(x, 0, 1, 1);
  }
  for (int x = 0; x < 4; ++x) EXPECT_NE(voxels.keeps(x, 0, 0), voxels.keeps(x, 0, 1)) << x;
}

TEST(ChooseVoxels, AgreesWithLookingUpEveryNeighbour) {
  Random random(3, "voxel test");
  VoxelTable table;
  for (int i = 0; i < 4000; ++i) {
    const auto at = [&] { return static_cast<int>(random.uniform(-8.0, 8.0)); };
    VoxelSums& sums = table[voxel_key({at(), at(), at()})];
    sums.count += 1;
    sums.weight += static_cast<float>(random.uniform(0.5, 1.5));
    sums.towards_photo += Eigen::Vector3f(0.0F, 0.4F, 1.0F);
  }
  std::vector<const VoxelSums*> all;
  table.for_each([&](const VoxelSums& sums) { all.push_back(&sums); });
  constexpr int kMinCount = 3;
  std::vector<std::uint64_t> expected;
  for (const VoxelSums* one : all) {
    int count = one->count;
    bool foremost = true;
    for (const VoxelSums* other : all) {
      const VoxelIndex step = voxel_of_key(other->key) - voxel_of_key(one->key);
      if (other == one || step.cwiseAbs().maxCoeff() > 1) continue;
      const float along =
          std::abs(one->towards_photo.normalized().dot(step.cast<float>().normalized()));
      if (along < 0.7F) {
        count += other->count;
      } else if (other->weight >= one->weight) {
        foremost = false;
      }
    }
    if (one->count >= kMinCount || (foremost && count >= kMinCount)) expected.push_back(one->key);
  }
  std::ranges::sort(expected);
  std::vector<std::uint64_t> found;
  for (const VoxelSums* sums : choose_voxels(table, kMinCount)) found.push_back(sums->key);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace hybridfusion
