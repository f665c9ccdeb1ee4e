#include "gnss_difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

CoarsePose by_gnss(const Eigen::Vector3d& translation) {
  PoseCovariance covariance = PoseCovariance::Identity();
  covariance.diagonal() << 9.0, 9.0, 64.0, 1e-3, 1e-3, 1e-3;
  return {.vision_from_lidar = Rigid3{.translation = translation}, .covariance = covariance};
}

PointCloud square(float half_m) {
  PointCloud cloud;
  cloud.points = {{-half_m, -half_m, 0.0F}, {half_m, half_m, 5.0F}};
  return cloud;
}

TEST(GnssDifference, DroneAgainstVehicleIsToldWithItsSign) {
  const auto told =
      gnss_difference(by_gnss({10.0, 0.0, 4.0}), Rigid3{.translation = {10.5, -1.0, 0.0}}, {});
  ASSERT_TRUE(told);
  EXPECT_LE((told->difference_m - Eigen::Vector3d(0.5, -1.0, -4.0)).norm(), 1e-12);
  EXPECT_THAT(told->text, HasSubstr("0.5 m west, 1.0 m north and 4.0 m above"));
  EXPECT_FALSE(told->beyond);
  EXPECT_TRUE(gnss_difference(by_gnss({0, 0, 46.0}), Rigid3{}, {})->beyond);
  EXPECT_FALSE(gnss_difference({}, Rigid3{}, {}));
}

TEST(SitesApart, CloudsThatCannotMeetByGnssAreOfTwoPlaces) {
  EXPECT_FALSE(sites_apart(square(50), square(40), by_gnss({100.0, 0.0, 0.0}), 5.0));
  const auto apart = sites_apart(square(50), square(40), by_gnss({446000.0, 0.0, 0.0}), 5.0);
  ASSERT_TRUE(apart);
  EXPECT_THAT(*apart, HasSubstr("446 km apart"));
  EXPECT_FALSE(sites_apart(square(50), square(40), {}, 5.0));
}

}  // namespace
}  // namespace hybridfusion
