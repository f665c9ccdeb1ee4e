#include "imu_propagation.hpp"
#include "levelling.hpp"
#include "plane_adjustment.hpp"
#include "rigid3_matchers.hpp"
#include "scan_store.hpp"
#include "segments.hpp"

#include <hybridfusion/core/random.hpp>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

TEST(PackedPoint, ComesBackWithinItsGrid) {
  const UnpackedPoint point{
      .point_in_imu = {-123.4567F, 900.001F, 0.0004F}, .intensity = 201.0F, .share = 0.25F};
  const UnpackedPoint back = unpack(pack(point));
  EXPECT_LT((back.point_in_imu - point.point_in_imu).cwiseAbs().maxCoeff(), 6e-4F);
  EXPECT_EQ(back.intensity, 201.0F);
  EXPECT_NEAR(back.share, 0.25F, 1e-5F);
  EXPECT_EQ(sizeof(PackedPoint), 12U);
  // Beyond the grid points stick to its border and never wrap round.
  EXPECT_NEAR(unpack(pack({.point_in_imu = {5000.0F, 0, 0}})).point_in_imu.x(), 1048.575F, 1e-2F);
}

TEST(ScanStore, KeepsEveryNthPointOfADenseScan) {
  ScanEstimate scan{.time = from_seconds(1.0)};
  scan.deskewed.resize(1000, {.point_in_lidar = {1, 2, 3}});
  ScanStore store(300);
  ASSERT_TRUE(store.add(scan));
  std::vector<PackedPoint> points;
  ASSERT_TRUE(store.read(store.scans()[0], points));
  EXPECT_EQ(points.size(), 250U);
}

/// Points of three orthogonal walls seen by three segments, as clusters at the true poses.
std::vector<PlaneCluster> wall_clusters(const std::vector<Rigid3>& map_from_segment) {
  std::vector<PlaneCluster> clusters;
  Random random(11, "test/walls");
  for (std::uint64_t cell = 0; cell < 30; ++cell) {
    const int axis = static_cast<int>(cell % 3);
    Eigen::Vector3d corner(random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-8, 8));
    corner[axis] = -10.0;
    for (std::uint32_t s = 0; s < map_from_segment.size(); ++s) {
      std::vector<Eigen::Vector3d> points;
      for (int i = 0; i < 30; ++i) {
        Eigen::Vector3d p =
            corner + Eigen::Vector3d(random.uniform(), random.uniform(), random.uniform());
        p[axis] = -10.0;
        points.push_back(map_from_segment[s].inverse() * p);
      }
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const auto& p : points) mean += p / 30.0;
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      for (const auto& p : points) covariance += (p - mean) * (p - mean).transpose() / 30.0;
      clusters.push_back({.cell = cell,
                          .segment = s,
                          .count = 30,
                          .mean = mean.cast<float>(),
                          .covariance = covariance.cast<float>()});
    }
  }
  return clusters;
}

TEST(AdjustPlanes, BringsDisplacedSegmentsBack) {
  const std::vector<Rigid3> truth{
      {},
      {.rotation = Eigen::Quaterniond(so3_exp({0, 0, 0.3})), .translation = {1, 0, 0}},
      {.rotation = Eigen::Quaterniond(so3_exp({0.1, 0, 0.6})), .translation = {2, 0.5, 0}}};
  const auto clusters = wall_clusters(truth);
  std::vector<Rigid3> poses = truth;
  poses[1].translation += Eigen::Vector3d(0.02, -0.01, 0.015);
  poses[2].rotation = poses[2].rotation * Eigen::Quaterniond(so3_exp({0.002, -0.001, 0.003}));
  // Links that believe the displaced poses, far less than the planes do.
  std::vector<RelativePose> links;
  for (std::uint32_t i = 0; i < 2; ++i) {
    links.push_back({.first = i,
                     .second = i + 1,
                     .first_from_second = poses[i].inverse() * poses[i + 1],
                     .information = information_of(0.03, 3e-3)});
  }
  for (int pass = 0; pass < 4; ++pass) {
    PlaneAdjustment adjustment(0.05, poses);
    adjustment.add(clusters);
    ASSERT_TRUE(adjustment.solve(links));
    poses = adjustment.map_from_segment();
  }
  for (int i = 0; i < 3; ++i) EXPECT_THAT(poses[i], Rigid3Near(truth[i], 1e-3, 1e-4)) << i;
}

TEST(AdjustPlanes, FollowsTheLinksWhereThereIsNoPlane) {
  PlaneAdjustment adjustment(0.05, std::vector<Rigid3>(3));
  std::vector<RelativePose> links(2, {.first_from_second = {.translation = {1, 0, 0}}});
  links[0].second = 1;
  links[1].first = 1;
  links[1].second = 2;
  ASSERT_TRUE(adjustment.solve(links));
  EXPECT_THAT(adjustment.map_from_segment()[2],
              Rigid3Near(Rigid3{.translation = {2, 0, 0}}, 1e-9, 1e-9));
}

/// Faces in front of the sensor, turned away from it by up to 50 degrees, measured along the ray;
/// every third one is `roughness_m` rough besides.
std::vector<PlaneCluster> noisy_faces(double range_sigma_m, double roughness_m) {
  std::vector<PlaneCluster> clusters;
  Random random(3, "test/faces");
  for (std::uint64_t cell = 0; cell < 400; ++cell) {
    const double turn_rad = random.uniform(-0.87, 0.87);
    const Eigen::Vector3d normal(std::cos(turn_rad), std::sin(turn_rad), 0.0);
    const Eigen::Vector3d along(-normal.y(), normal.x(), 0.0);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 40; ++i) {
      const Eigen::Vector3d on_face = Eigen::Vector3d(10.0, 0.0, 0.0) +
                                      random.uniform(-0.25, 0.25) * along +
                                      random.uniform(-0.25, 0.25) * Eigen::Vector3d::UnitZ();
      const double rough_m = cell % 3 == 0 ? roughness_m * random.normal() : 0.0;
      points.emplace_back(on_face + range_sigma_m * random.normal() * on_face.normalized() +
                          rough_m * normal);
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : points) mean += p / 40.0;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& p : points) covariance += (p - mean) * (p - mean).transpose() / 40.0;
    clusters.push_back({.cell = cell,
                        .count = 40,
                        .mean = mean.cast<float>(),
                        .covariance = covariance.cast<float>()});
  }
  return clusters;
}

TEST(RangeNoise, IsFoundFromTheScatterOfFaces) {
  for (const double sigma_m : {0.008, 0.02, 0.03}) {
    RangeNoise noise;
    noise.add(noisy_faces(sigma_m, 0.02), Eigen::Vector3d::Zero());
    ASSERT_TRUE(noise.sigma_m());
    // A third of the faces is rough, and 40 points fit their own plane 4 % too well.
    EXPECT_NEAR(*noise.sigma_m(), sigma_m, 0.12 * sigma_m + 5e-4);
  }
}

TEST(RangeNoise, SaysNothingOfAFewFaces) {
  RangeNoise noise;
  const auto faces = noisy_faces(0.02, 0.0);
  noise.add(std::span(faces).first(100), Eigen::Vector3d::Zero());
  EXPECT_FALSE(noise.sigma_m());
}

std::vector<StoredScan> tilted_drive(const Eigen::Quaterniond& map_from_level) {
  // A turning, accelerating drive; the accelerometer has a bias.
  const Eigen::Vector3d bias(0.08, -0.05, 0.03);
  std::vector<StoredScan> scans;
  NavState state;
  state.velocity_in_map = {2.0, 0.0, 0.0};
  for (int i = 0; i < 150; ++i) {
    StoredScan scan{.time = from_seconds(0.1 * i)};
    if (i > 0) {
      for (int k = 0; k < 10; ++k) {
        const ImuStep truth{.dt_s = 0.01,
                            .angular_velocity_radps = {0.05 * std::sin(0.3 * i), 0.0, 0.5},
                            .specific_force_mps2 = state.map_from_imu.transpose() *
                                                   Eigen::Vector3d(std::sin(0.1 * i), 0.3, 9.81)};
        ImuStep measured = truth;
        measured.specific_force_mps2 += bias;
        integrate(measured, Eigen::Vector3d::Zero(), scan.since_last);
        state = propagated(state, truth);
      }
    }
    scan.map_from_imu = Rigid3{.rotation = map_from_level} * state.pose();
    scan.gravity_in_imu = scan.map_from_imu.rotation.conjugate() * Eigen::Vector3d(0, 0, -9.81);
    scan.gravity_sigma_rad = 0.01;
    scans.push_back(scan);
  }
  return scans;
}

TEST(FitGravity, SeparatesTiltFromAccelerometerBias) {
  const Eigen::Quaterniond tilt(so3_exp({0.02, -0.03, 0.0}));
  auto scans = tilted_drive(tilt);
  const auto fit = fit_gravity(scans);
  ASSERT_TRUE(fit);
  // The vertical bias adds to the length of gravity; only its direction matters.
  const Eigen::Vector3d down = tilt * -Eigen::Vector3d::UnitZ();
  EXPECT_LT(fit->gravity_in_map.normalized().cross(down).norm(), 1e-4);
  EXPECT_LT((fit->accel_bias_mps2 - Eigen::Vector3d(0.08, -0.05, 0.03)).head<2>().norm(), 5e-3);
  const MapLevel level = level_map(scans);
  EXPECT_NEAR(level.turn_rad, Eigen::Vector2d(0.02, 0.03).norm(), 1e-4);
  EXPECT_EQ(level.sigma_rad, fit->tilt_sigma_rad);
  EXPECT_LT(level_map(scans).turn_rad, 1e-4);
}

TEST(FitGravity, IsSilentWithoutEnoughImuData) {
  auto scans = tilted_drive(Eigen::Quaterniond::Identity());
  EXPECT_FALSE(fit_gravity(std::span(scans).first(30)));
  for (auto& scan : scans) scan.since_last.bridged = true;
  EXPECT_FALSE(fit_gravity(scans));
  const MapLevel level = level_map(scans);
  EXPECT_LT(level.turn_rad, 1e-9);  // the filter's gravity: level already
  EXPECT_EQ(level.sigma_rad, 0.01);
}

}  // namespace
}  // namespace hybridfusion
