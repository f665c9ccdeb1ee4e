#include <hybridfusion/core/geodetic.hpp>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(Geodetic, RoundTripsAcrossTheAntimeridianAndTheEquator) {
  const GeodeticOrigin origin{.latitude_deg = -0.001, .longitude_deg = 179.9999, .altitude_m = 12};
  const Eigen::Vector3d enu(250.0, 300.0, 40.0);
  const GeodeticPosition position = geodetic_from_enu(origin, enu);
  EXPECT_LT(position.longitude_deg, 0.0);
  EXPECT_GT(position.latitude_deg, 0.0);
  EXPECT_TRUE(enu_from_geodetic(origin, position).isApprox(enu, 1e-9));
}

TEST(Geodetic, NorthIsTheSecondAxisAndUpTheThird) {
  const GeodeticOrigin origin{.latitude_deg = 48.15, .longitude_deg = 11.57, .altitude_m = 520};
  GeodeticPosition north = origin;
  north.latitude_deg += 0.001;  // 111.2 m on the ellipsoid at this latitude
  north.altitude_m += 10.0;
  const Eigen::Vector3d enu = enu_from_geodetic(origin, north);
  EXPECT_NEAR(enu.x(), 0.0, 1e-6);
  EXPECT_NEAR(enu.y(), 111.2, 0.05);
  EXPECT_NEAR(enu.z(), 10.0, 0.01);
}

}  // namespace
}  // namespace hybridfusion
