#include "pair_selection.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct Flight {
  std::vector<PhotoMetadata> photos;
  GnssIngest gnss;
};

/// Strips of ten photos, 10 m apart both ways, flown to and fro.
Flight strips(int count) {
  Flight flight;
  for (int i = 0; i < count; ++i) {
    const int row = i / 10;
    const int column = row % 2 == 0 ? i % 10 : 9 - i % 10;
    PhotoFix fix;
    fix.position_in_enu = Eigen::Vector3d(10.0 * column, 10.0 * row, 60.0);
    flight.gnss.fixes.push_back(fix);
    flight.gnss.by_time.push_back(static_cast<std::size_t>(i));
    flight.photos.emplace_back();
  }
  return flight;
}

bool contains(const std::vector<PhotoPair>& pairs, std::uint32_t a, std::uint32_t b) {
  return std::ranges::binary_search(pairs, PhotoPair{a, b});
}

TEST(SelectPairs, SmallSetsAreMatchedCompletely) {
  const Flight flight = strips(10);
  EXPECT_EQ(select_pairs(flight.photos, flight.gnss, {}).size(), 45U);
}

TEST(SelectPairs, NeighboursAcrossStripsAreFoundAndFarPhotosAreNot) {
  const Flight flight = strips(50);
  const auto pairs = select_pairs(flight.photos, flight.gnss, {});
  EXPECT_TRUE(contains(pairs, 5, 14));   // one above the other in the next strip
  EXPECT_TRUE(contains(pairs, 20, 23));  // three later in time
  EXPECT_FALSE(contains(pairs, 0, 45));
  EXPECT_LE(pairs.size(), 50U * 8U);
  EXPECT_TRUE(std::ranges::is_sorted(pairs));
}

TEST(SelectPairs, PhotoWithoutPositionIsMatchedWithAllOfASmallSet) {
  Flight flight = strips(30);
  flight.gnss.fixes[7].position_in_enu.reset();
  const auto pairs = select_pairs(flight.photos, flight.gnss, {});
  for (std::uint32_t i = 8; i < 30; ++i) EXPECT_TRUE(contains(pairs, 7, i)) << i;
}

TEST(SelectPairs, ObliquePhotosAreNeighboursWhereTheyLook) {
  // Two rows 200 m apart look at the strip between them; each row also has company behind it.
  Flight flight;
  for (int i = 0; i < 40; ++i) {
    const bool south = i < 20;
    PhotoFix fix;
    fix.position_in_enu = Eigen::Vector3d(10.0 * (i % 20), south ? -60.0 : 60.0, 60.0);
    PhotoMetadata photo;
    photo.relative_altitude_m = 60.0;
    photo.gimbal = GimbalAngles{.yaw_deg = south ? 0.0 : 180.0, .pitch_deg = -45.0};
    flight.gnss.fixes.push_back(fix);
    flight.gnss.by_time.push_back(static_cast<std::size_t>(i));
    flight.photos.push_back(photo);
  }
  EXPECT_TRUE(contains(select_pairs(flight.photos, flight.gnss, {}), 10, 30));
  for (auto& photo : flight.photos) photo.gimbal.reset();
  EXPECT_FALSE(contains(select_pairs(flight.photos, flight.gnss, {}), 10, 30));
}

}  // namespace
}  // namespace hybridfusion
