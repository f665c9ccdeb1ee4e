#include "fine_alignment.hpp"
#include "hybrid.hpp"
#include "patch_votes.hpp"
#include "street_scene.hpp"

#include <hybridfusion/registration/drift.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

DriftCorrection two_knots() {
  DriftCorrection correction{.supported = true, .axis = DriftAxis::kTime};
  correction.knots = {{.at = 10.0, .shift_m = {1.0, 0.0, 0.0}},
                      {.at = 20.0, .pivot = {5.0, 0.0, 0.0}, .turn_rad = {0.0, 0.0, 0.1}}};
  return correction;
}

TEST(DriftCorrection, IsLinearBetweenKnotsAndConstantBeyond) {
  const DriftCorrection correction = two_knots();
  const Eigen::Vector3d p(7.0, 0.0, 3.0);
  EXPECT_TRUE(corrected(correction, p, 0.0).isApprox(Eigen::Vector3d(8.0, 0.0, 3.0)));
  EXPECT_TRUE(corrected(correction, p, 30.0).isApprox(Eigen::Vector3d(7.0, 0.2, 3.0)));
  EXPECT_TRUE(corrected(correction, p, 15.0).isApprox(Eigen::Vector3d(7.5, 0.1, 3.0)));
}

TEST(WithoutDrift, MovesPointsByTheirTimesAndRefusesPointsWithoutAny) {
  PointCloud cloud{.points = {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}}, .times_s = {10.0, 20.0}};
  const auto moved = without_drift(cloud, two_knots(), {});
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_FLOAT_EQ(moved->points[0].x(), 1.0F);
  EXPECT_FLOAT_EQ(moved->points[1].y(), -0.5F);
  cloud.times_s.clear();
  EXPECT_EQ(without_drift(cloud, two_knots(), {}).error().code, ErrorCode::kInsufficient);
  DriftCorrection unsupported = two_knots();
  unsupported.supported = false;
  EXPECT_EQ(without_drift(cloud, unsupported, {})->points, cloud.points);
}

TEST(DriftParameters, AreTheWayOfTheNearestSensorPosition) {
  const std::vector<Eigen::Vector3d> way = {{0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {10, 5, 0}};
  const PointCloud cloud{.points = {{9.0F, -4.0F, 20.0F}, {11.0F, 6.0F, 0.0F}}};
  const auto at = drift_parameters(cloud, DriftAxis::kPath, way, RunContext{});
  ASSERT_TRUE(at) << at.error().message;
  EXPECT_DOUBLE_EQ((*at)[0], 10.0);
  EXPECT_DOUBLE_EQ((*at)[1], 15.0);
  EXPECT_EQ(drift_parameters(cloud, DriftAxis::kPath, {}, RunContext{}).error().code,
            ErrorCode::kInsufficient);
}

/// A block whose LiDAR cloud is bent along the drive by up to `size_m`; times are metres driven.
struct BentBlock {
  test::Scene scene = {};
  PointCloud straight = {};
};

BentBlock bent_block(std::uint64_t seed, double size_m) {
  BentBlock block;
  block.scene = test::make_scene(
      seed, {.half_extent_m = 42.0, .lidar_half_extent_m = 42.0, .facade_share = 0.6});
  block.straight = block.scene.lidar;
  PointCloud& lidar = block.scene.lidar;
  lidar.times_s =
      *drift_parameters(lidar, DriftAxis::kPath, block.scene.sensor_positions, RunContext{});
  const double length_m = std::ranges::max(lidar.times_s);
  for (std::size_t i = 0; i < lidar.size(); ++i) {
    const double phase = 2.0 * std::numbers::pi * lidar.times_s[i] / length_m;
    const Eigen::Vector3d bend(std::sin(phase), std::cos(phase) - 1.0, 0.3 * std::sin(phase));
    lidar.points[i] += (size_m * bend).cast<float>();
  }
  return block;
}

double rms_to_straight(const PointCloud& lidar, const Rigid3& pose, const PointCloud& straight) {
  double squares = 0.0;
  for (std::size_t i = 0; i < lidar.size(); ++i) {
    squares +=
        (pose * lidar.points[i].cast<double>() - straight.points[i].cast<double>()).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(lidar.size()));
}

TEST(RegisterCrossSource, StraightensALidarCloudThatDriftsAlongTheDrive) {
  const BentBlock block = bent_block(41, 0.25);
  for (const bool by_time : {true, false}) {
    PointCloud lidar = block.scene.lidar;
    if (!by_time) lidar.times_s.clear();
    const RegistrationInput input{.sensor_positions = block.scene.sensor_positions};
    const auto result = register_cross_source(block.scene.vision, lidar, input);
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->status, RegistrationStatus::kOk) << result->reason;
    ASSERT_TRUE(result->drift.supported)
        << result->drift.held_out_before_m << " -> " << result->drift.held_out_after_m;
    EXPECT_EQ(result->drift.axis, by_time ? DriftAxis::kTime : DriftAxis::kPath);
    EXPECT_FALSE(result->vision_scale_supported);
    const auto straight = without_drift(lidar, result->drift, input.sensor_positions);
    ASSERT_TRUE(straight) << straight.error().message;
    const double before = rms_to_straight(lidar, result->vision_from_lidar, block.straight);
    const double after = rms_to_straight(*straight, result->vision_from_lidar, block.straight);
    EXPECT_LT(after, 0.4 * before);
    EXPECT_LT(after, 0.08);
  }
}

/// Mean residuals of held-out pieces as simulated drives leave them.
DriftCorrection judged(bool supported, double before_m, double after_m) {
  return {.supported = supported, .held_out_before_m = before_m, .held_out_after_m = after_m};
}

TEST(ScaleStands, WhereItExplainsTheDriveWithoutABend) {
  const DriftCorrection bend = judged(true, 0.0320, 0.0226);
  EXPECT_TRUE(scale_stands(judged(false, 0.0242, 0.0225), bend, {}));
}

TEST(ScaleStands, NotWhereABendIsNeededBesideIt) {
  EXPECT_FALSE(scale_stands(judged(true, 0.0420, 0.0327), judged(true, 0.0894, 0.0318), {}));
}

TEST(ScaleStands, NotWhereABendAloneIsBetter) {
  EXPECT_FALSE(scale_stands(judged(false, 0.0300, 0.0267), judged(true, 0.0452, 0.0233), {}));
}

TEST(ScaleStands, NotWhereNothingFits) {
  EXPECT_FALSE(scale_stands(judged(false, 0.0564, 0.0702), judged(true, 0.0760, 0.0615), {}));
}

TEST(RegisterCrossSource, LeavesALidarCloudWithoutDriftAsItIs) {
  const BentBlock block = bent_block(42, 0.0);
  const auto with = register_cross_source(block.scene.vision, block.scene.lidar);
  RegistrationOptions options;
  options.drift.enabled = false;
  const auto without = register_cross_source(block.scene.vision, block.scene.lidar, {}, options);
  ASSERT_TRUE(with && without);
  EXPECT_FALSE(with->drift.supported) << with->drift.size_m;
  EXPECT_EQ(with->vision_from_lidar.translation, without->vision_from_lidar.translation);
  EXPECT_FALSE(with->drift.knots.empty());
  EXPECT_TRUE(without->drift.knots.empty());
}

TEST(VoteByPatches, PatchesStayAtTheTruePoseAndLeaveAWrongOne) {
  const test::Scene scene =
      test::make_scene(43, {.half_extent_m = 38.0, .lidar_half_extent_m = 38.0});
  const RegistrationOptions options;
  const RunContext ctx;
  const auto clouds = prepare_clouds(scene.vision, scene.lidar, {}, options, ctx);
  ASSERT_TRUE(clouds) << clouds.error().message;
  const auto votes_at = [&](const Rigid3& pose) {
    FineInputs inputs = make_fine_inputs(clouds->vision, clouds->lidar, pose, options.fine, ctx);
    return vote_by_patches(inputs, *clouds, pose, 0.0, options, ctx);
  };
  const auto right = votes_at(Rigid3{});
  ASSERT_TRUE(right) << right.error().message;
  EXPECT_GE(right->num_tried, 10U);
  EXPECT_GT(right->share(), 0.4);  // few facades in G: half of the patches have one direction only
  EXPECT_LT(right->spread_m, 0.3);
  Rigid3 pose;
  pose.translation = {4.0, 3.0, 0.0};
  const auto wrong = votes_at(pose);
  ASSERT_TRUE(wrong) << wrong.error().message;
  EXPECT_LT(wrong->share(), 0.5 * right->share());
}

TEST(VoteByPatches, SaysNothingWhereNothingStands) {
  PointCloud flat;
  for (float x = -20.0F; x < 20.0F; x += 0.2F) {
    for (float y = -20.0F; y < 20.0F; y += 0.2F) flat.points.emplace_back(x, y, 0.0F);
  }
  const RegistrationOptions options;
  const RunContext ctx;
  const auto clouds = prepare_clouds(flat, flat, {}, options, ctx);
  ASSERT_TRUE(clouds) << clouds.error().message;
  FineInputs inputs = make_fine_inputs(clouds->vision, clouds->lidar, {}, options.fine, ctx);
  const auto votes = vote_by_patches(inputs, *clouds, {}, 0.0, options, ctx);
  ASSERT_TRUE(votes) << votes.error().message;
  EXPECT_EQ(votes->num_tried, 0U);
  EXPECT_EQ(votes->share(), 0.0);
}

}  // namespace
}  // namespace hybridfusion
