#include "structure_level.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A street of leaning facades on a sloping road, in a map that is tilted by `map_from_world`.
std::vector<MapFace> street(const Eigen::Quaterniond& map_from_world,
                            double lean_rad,
                            double slope_rad,
                            bool crossing,
                            std::uint64_t seed) {
  Random random(seed, "test/structure_level");
  std::vector<MapFace> faces;
  for (int i = 0; i < 200; ++i) {
    const double x = static_cast<double>(i);
    const double azimuth = crossing && i % 3 == 0 ? 0.0 : 0.5 * M_PI;
    const double lean = lean_rad * random.normal();
    Eigen::Vector3d wall(
        std::cos(azimuth) * std::cos(lean), std::sin(azimuth) * std::cos(lean), std::sin(lean));
    faces.push_back({.normal = map_from_world * wall,
                     .center_m = map_from_world * Eigen::Vector3d(x, 8.0, 3.0),
                     .weight = 20.0});
    Eigen::Vector3d ground(-std::sin(slope_rad), 0.01 * random.normal(), std::cos(slope_rad));
    faces.push_back({.normal = map_from_world * ground.normalized(),
                     .center_m = map_from_world * Eigen::Vector3d(x, 0.0, 0.0),
                     .weight = 20.0});
  }
  return faces;
}

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::min(1.0, a.dot(b)));
}

TEST(LevelByFaces, TrustsWallsAcrossTheRoadsSlope) {
  const Eigen::Quaterniond tilt(
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, 0.5, 0.0).normalized()));
  const auto level =
      level_by_faces(street(tilt, 0.009, 0.04, true, 1), tilt * Eigen::Vector3d(0.2, -0.1, 1.0));
  ASSERT_TRUE(level);
  const double error = angle(level->up_in_map, tilt * Eigen::Vector3d::UnitZ());
  EXPECT_LT(error, 0.005);  // the road alone would say 0.04
  EXPECT_LT(error, 3.0 * level->sigma_rad);
}

TEST(LevelByFaces, KnowsThatOneStreetLeavesItsSlopeOpen) {
  const auto level = level_by_faces(street(Eigen::Quaterniond::Identity(), 0.009, 0.02, false, 2),
                                    Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(level);
  const double error = angle(level->up_in_map, Eigen::Vector3d::UnitZ());
  EXPECT_GT(error, 0.01);  // nothing tells the slope
  EXPECT_LT(error, 3.0 * level->sigma_rad);
  EXPECT_GT(level->sigma_rad, 0.01);
}

TEST(LevelByFaces, TellsAMapThatLiesOnItsHead) {
  for (const double side : {-1.0, 1.0}) {
    std::vector<MapFace> faces = street(Eigen::Quaterniond::Identity(), 0.009, 0.02, true, 3);
    for (MapFace& face : faces) face.from_lidar_m = {5.0, 0.0, 1.5 * side};
    const auto level = level_by_faces(faces, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(level);
    EXPECT_EQ(level->upside_down, side > 0.0);
  }
}

TEST(LevelByFaces, SaysNothingWithoutFaces) {
  EXPECT_FALSE(level_by_faces({}, Eigen::Vector3d::UnitZ()));
}

}  // namespace
}  // namespace hybridfusion
