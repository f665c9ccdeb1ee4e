#include "street_points.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>

namespace hybridfusion::bench {
namespace {

constexpr float kVoxel_m = 0.5F;
constexpr float kStreetLength_m = 600.0F;
constexpr float kStreetDistance_m = 60.0F;
constexpr int kColumnsOfGround = 32;  // 16 m
constexpr int kRowsOfFront = 24;      // 12 m
constexpr int kSlices = static_cast<int>(kStreetLength_m / kVoxel_m);

float somewhere_in_voxel(Random& random) {
  return kVoxel_m * static_cast<float>(random.uniform(0.02, 0.98));
}

float range_noise(Random& random) {
  return 0.25F + 0.02F * static_cast<float>(random.normal());  // about the middle of a voxel
}

/// Point of one street at a voxel along it and one across: ground first, then the two fronts.
Eigen::Vector3f surface_point(int slice, int around, int rows_of_front, Random& random) {
  const float x = kVoxel_m * static_cast<float>(slice) + somewhere_in_voxel(random);
  if (around < kColumnsOfGround) {
    return {
        x, kVoxel_m * static_cast<float>(around) + somewhere_in_voxel(random), range_noise(random)};
  }
  const int on_front = around - kColumnsOfGround;
  const int row = on_front % rows_of_front;
  // Every fourth voxel along the street the front stands back: doors, windows, side roads.
  const float set_back = slice % 4 == 0 ? kVoxel_m : 0.0F;
  const float y = on_front < rows_of_front
                      ? -kVoxel_m - set_back
                      : kVoxel_m * static_cast<float>(kColumnsOfGround) + set_back;
  return {x,
          y + range_noise(random),
          kVoxel_m * static_cast<float>(row + 1) + somewhere_in_voxel(random)};
}

}  // namespace

Points town_map(std::size_t size) {
  Random random(1, "bench/town_map");
  Points points;
  points.reserve(size);
  for (int street = 0;; ++street) {
    const Eigen::Vector3f origin(0.0F, kStreetDistance_m * static_cast<float>(street), 0.0F);
    for (int slice = 0; slice < kSlices; ++slice) {
      for (int around = 0; around < kColumnsOfGround + 2 * kRowsOfFront; ++around) {
        if (points.size() == size) return points;
        points.push_back(origin + surface_point(slice, around, kRowsOfFront, random));
      }
    }
  }
}

Points stops(std::size_t map_size, int count) {
  constexpr auto kSlice = static_cast<double>(kColumnsOfGround + 2 * kRowsOfFront);
  const double length_m = kVoxel_m * static_cast<double>(map_size) / kSlice;
  Points places;
  for (int i = 0; i < count; ++i) {
    const double along_m = length_m * (i + 0.5) / count;
    const double street = std::floor(along_m / kStreetLength_m);
    places.emplace_back(static_cast<float>(along_m - street * kStreetLength_m),
                        static_cast<float>(street * kStreetDistance_m) + 8.0F,
                        2.0F);
  }
  return places;
}

Points scan_at(const Eigen::Vector3f& place,
               std::size_t size,
               std::size_t new_every,
               std::uint64_t seed) {
  constexpr float kReach_m = 40.0F;
  constexpr int kRowsSeen = 2 * kRowsOfFront;
  Random random(seed, "bench/scan");
  const float street_y = place.y() - 8.0F;
  Points points;
  while (points.size() < size) {
    const int slice = static_cast<int>(
        (place.x() + static_cast<float>(random.uniform(-kReach_m, kReach_m))) / kVoxel_m);
    if (slice < 0 || slice >= kSlices) continue;
    const bool is_new = points.size() % new_every == 0;
    const int row = static_cast<int>(random.index(kRowsOfFront)) + (is_new ? kRowsOfFront : 0);
    const int around = is_new || random.index(2) == 0
                           ? kColumnsOfGround + row + (random.index(2) == 0 ? kRowsSeen : 0)
                           : static_cast<int>(random.index(kColumnsOfGround));
    points.push_back(Eigen::Vector3f(0.0F, street_y, 0.0F) +
                     surface_point(slice, around, kRowsSeen, random));
  }
  return points;
}

}  // namespace hybridfusion::bench
