#include "fine_alignment.hpp"

#include "street_scene.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(PlaneResidual, JacobianMatchesDifferences) {
  const Eigen::Vector3d moved(3.0, -2.0, 5.0);
  const Eigen::Vector3d on_plane(2.5, -2.2, 4.0);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
  const Eigen::Vector3d centre(1.0, 1.0, 1.0);
  Vector7d jacobian;
  const double residual = plane_residual(moved, on_plane, normal, centre, jacobian);
  EXPECT_NEAR(residual, normal.dot(moved - on_plane), 1e-12);
  for (int k = 0; k < 7; ++k) {
    const auto at = [&](double step) {
      const Vector7d update = step * Vector7d::Unit(k);
      const Eigen::Vector3d p = apply_update(update, centre, Sim3{}) * moved;
      Vector7d unused;
      return plane_residual(p, on_plane, normal, centre, unused);
    };
    EXPECT_NEAR(jacobian[k], (at(1e-6) - at(-1e-6)) / 2e-6, 1e-7) << k;
  }
}

struct Block {
  std::vector<Eigen::Vector3f> vision;
  std::vector<Eigen::Vector3f> lidar;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};

Block block(std::uint64_t seed, double facade_share, double vision_noise_m = 0.02) {
  const test::Scene scene = test::make_scene(seed,
                                             {.half_extent_m = 35.0,
                                              .lidar_half_extent_m = 35.0,
                                              .vision_noise_m = vision_noise_m,
                                              .facade_share = facade_share});
  Block result{voxel_mean(scene.vision, 0.2).points, voxel_mean(scene.lidar, 0.2).points};
  for (const Eigen::Vector3f& p : result.lidar) {
    result.centroid += p.cast<double>() / static_cast<double>(result.lidar.size());
  }
  return result;
}

Expected<FineResult> align_block(const Block& b, const Rigid3& start) {
  FineInputs inputs = make_fine_inputs(b.vision, b.lidar, start, FineOptions{}, RunContext{});
  return align_fine(inputs, start, b.centroid, FineOptions{}, RunContext{});
}

Rigid3 small_error() {
  Rigid3 start;
  start.rotation = Eigen::AngleAxisd(0.01, Eigen::Vector3d(0.2, 0.1, 1.0).normalized());
  start.translation = {0.3, -0.2, 0.1};
  return start;
}

TEST(AlignFine, RecoversTheTruePoseFromNearby) {
  const Block b = block(11, 0.6);
  const auto fine = align_block(b, small_error());
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_TRUE(fine->horizontal_updated);
  EXPECT_LT((fine->vision_from_lidar * b.centroid - b.centroid).norm(), 0.02);
  EXPECT_LT(rotation_distance_rad(fine->vision_from_lidar.rotation, Eigen::Quaterniond::Identity()),
            0.001);
  EXPECT_LT(fine->held_out_median_m, 0.05);
  EXPECT_GT(fine->covariance.diagonal().minCoeff(), 0.0);
}

TEST(AlignFine, FindsTheScaleOfAStretchedVisionCloud) {
  Block b = block(12, 0.6);
  constexpr double kScale = 1.003;
  for (Eigen::Vector3f& p : b.vision) p *= static_cast<float>(kScale);
  const auto fine = align_block(b, small_error());
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_TRUE(fine->scale_supported) << fine->scale_sigma;
  EXPECT_NEAR(fine->similarity.scale, kScale, 5e-4);
  // The rigid pose agrees with the similarity at the centroid.
  EXPECT_LT((fine->vision_from_lidar * b.centroid - kScale * b.centroid).norm(), 0.03);
}

TEST(AlignFine, DoesNotInventAScale) {
  const Block b = block(13, 0.6);
  const auto fine = align_block(b, small_error());
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_TRUE(!fine->scale_supported || std::abs(fine->similarity.scale - 1.0) < 1e-3);
}

TEST(AlignFine, LeavesPositionAndHeadingAloneWithoutFacades) {
  Block b = block(14, 0.0);
  // Without the walls under it a roof keeps a rim of steep neighbours: drop all but the ground.
  std::erase_if(b.vision, [](const Eigen::Vector3f& p) { return p.z() > 4.5F; });
  const Rigid3 start = small_error();
  const auto fine = align_block(b, start);
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_FALSE(fine->horizontal_updated);
  const Eigen::Vector3d moved = fine->vision_from_lidar * b.centroid - start * b.centroid;
  EXPECT_LT(moved.head<2>().norm(), 0.05);
  EXPECT_NEAR((fine->vision_from_lidar * b.centroid - b.centroid).z(), 0.0, 0.03);
}

TEST(AlignFine, RefusesCloudsThatDoNotMeet) {
  Block b = block(15, 0.5);
  Rigid3 far;
  far.translation = {500.0, 0.0, 0.0};
  EXPECT_EQ(align_block(b, far).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
