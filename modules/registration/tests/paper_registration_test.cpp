#include "paper/boundary_alignment.hpp"
#include "paper/isolated_points.hpp"
#include "paper/patch_voting.hpp"
#include "street_scene.hpp"

#include <hybridfusion/geometry/ground.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/registration/paper_registration.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A small block: the chain is the same, the test takes a second or two.
test::Scene small_block(std::uint64_t seed) {
  return test::make_scene(seed, {.half_extent_m = 30.0, .lidar_half_extent_m = 36.0, .trees = 6});
}

struct Prepared {
  explicit Prepared(const PointCloud& cloud)
      : points(voxel_mean(cloud, 0.2).points),
        heights(heights_above(*fit_ground(points), points)) {}
  [[nodiscard]] GroundedCloud view() const { return {.points = points, .heights = heights}; }

  std::vector<Eigen::Vector3f> points;
  std::vector<float> heights;
};

/// 2 m and 3 degrees off, about the middle of the block.
Rigid3 small_offset() {
  return {.rotation = Eigen::Quaterniond(
              Eigen::AngleAxisd(3.0 * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ())),
          .translation = {1.6, -1.2, 0.0}};
}

/// Outlines of two boxes, a point every 0.2 m.
std::vector<Eigen::Vector2f> outlines() {
  std::vector<Eigen::Vector2f> points;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    const Eigen::Vector2d a(x0, y0);
    const Eigen::Vector2d way = Eigen::Vector2d(x1, y1) - a;
    for (double s = 0.0; s < way.norm(); s += 0.2) {
      points.emplace_back((a + s * way.normalized()).cast<float>());
    }
  };
  for (const auto& [x, y, w, h] : {std::array{0.0, 0.0, 9.0, 6.0}, {13.0, 2.0, 7.0, 12.0}}) {
    line(x, y, x + w, y);
    line(x + w, y, x + w, y + h);
    line(x + w, y + h, x, y + h);
    line(x, y + h, x, y);
  }
  return points;
}

TEST(SupportedPoints, KeepsASurfaceAndDropsWhatFloatsAlone) {
  std::vector<Eigen::Vector3f> points;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      points.emplace_back(Eigen::Vector3d(0.2 * x, 0.2 * y, 0.0).cast<float>());
    }
  }
  const auto surface = static_cast<std::uint32_t>(points.size());
  points.emplace_back(2.0F, 2.0F, 6.0F);
  points.emplace_back(2.1F, 2.0F, 6.0F);
  const auto kept = supported_points(points, 0.6, 8);
  EXPECT_EQ(kept.size(), surface);
  EXPECT_TRUE(std::ranges::all_of(kept, [&](std::uint32_t i) { return i < surface; }));
  EXPECT_EQ(supported_points(points, 0.6, 0).size(), points.size());
}

TEST(AlignBoundaries2d, FindsAPlantedMotionFromTheCoarsePoseAndFromAfar) {
  const std::vector<Eigen::Vector2f> target_points = outlines();
  const BoundaryTarget target(target_points);
  for (const Eigen::Vector2d& shift : {Eigen::Vector2d(0.8, -0.6), Eigen::Vector2d(25.0, -40.0)}) {
    const Rigid2 truth{.yaw_rad = 0.05, .translation = shift};
    std::vector<Eigen::Vector2f> source;
    for (const auto& p : target_points) {
      const Eigen::Rotation2D<double> back(-truth.yaw_rad);
      source.emplace_back((back * (p.cast<double>() - shift)).cast<float>());
    }
    const auto match = align_boundaries_2d(source, target, {});
    ASSERT_TRUE(match);
    EXPECT_NEAR(match->target_from_source.yaw_rad, truth.yaw_rad, 0.01);
    EXPECT_LT(match->mean_distance_m, 0.1);
  }
}

/// One patch pose per entry, shifted along x by that much.
PaperResult voted(const std::vector<double>& shifts_m) {
  PaperResult result;
  for (const double x : shifts_m) {
    PatchMatch match{.outcome = PatchOutcome::kPose};
    match.vision_from_lidar.translation.x() = x;
    result.patches.push_back(match);
  }
  cluster_poses(Eigen::Vector3d(100.0, 50.0, 0.0), {}, result);
  return result;
}

TEST(ClusterPoses, AClearMajorityIsSupportedAndARivalOfNearlyItsSizeIsNot) {
  const PaperResult clear = voted({0.0, 0.2, 0.4, 0.6, 20.0, 20.1, -30.0});
  EXPECT_TRUE(clear.supported) << clear.reason;
  EXPECT_EQ(clear.num_cluster_members, 4U);
  EXPECT_EQ(clear.num_runner_up, 2U);
  EXPECT_NEAR(clear.vision_from_lidar.translation.x(), 0.3, 1e-9);
  EXPECT_EQ(clear.patches[0].outcome, PatchOutcome::kInCluster);
  EXPECT_EQ(clear.patches[6].outcome, PatchOutcome::kPose);
  EXPECT_FALSE(voted({0.0, 0.2, 0.4, 20.0, 20.1}).supported);  // 3 against 2
  EXPECT_FALSE(voted({0.0, 0.2}).supported);                   // two patches
  EXPECT_TRUE(voted({0.0, 0.2, 0.4, 1.5, 1.6}).supported);     // beside the cluster: no rival
}

TEST(RegisterByPatches, RecoversASmallOffsetAndSaysWhichPatchesAgreed) {
  const test::Scene scene = small_block(3);
  const Prepared vision(scene.vision);
  const Prepared lidar(scene.lidar);
  const auto result = register_by_patches(
      vision.view(), lidar.view(), small_offset(), {.esf_samples = 5000}, {}, {.num_threads = 2});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->supported) << result->reason;
  // Facades lock onto one side of the roof overhang of 0.4 m.
  EXPECT_LT(result->vision_from_lidar.translation.norm(), 0.5);
  EXPECT_LT(rotation_distance_rad(result->vision_from_lidar.rotation, {1, 0, 0, 0}), 0.02);
  const auto count = [&](PatchOutcome outcome) {
    return static_cast<std::size_t>(
        std::ranges::count(result->patches, outcome, &PatchMatch::outcome));
  };
  EXPECT_EQ(count(PatchOutcome::kInCluster), result->num_cluster_members);
  EXPECT_EQ(count(PatchOutcome::kInCluster) + count(PatchOutcome::kPose), result->num_poses);
}

TEST(RegisterByPatches, TheImprovedVariantMakesMorePatchesAgree) {
  const test::Scene scene = small_block(3);
  const Prepared vision(scene.vision);
  const Prepared lidar(scene.lidar);
  PaperOptions options{.esf_samples = 5000};
  const auto published =
      register_by_patches(vision.view(), lidar.view(), small_offset(), options, {}, {});
  options.variant = "improved";
  const auto improved =
      register_by_patches(vision.view(), lidar.view(), small_offset(), options, {}, {});
  ASSERT_TRUE(published && improved);
  EXPECT_TRUE(improved->supported) << improved->reason;
  EXPECT_GT(improved->patches.size(), 2 * published->patches.size());  // four grids
  EXPECT_GT(improved->num_cluster_members, published->num_cluster_members);
  EXPECT_LT(improved->vision_from_lidar.translation.norm(), 0.5);
}

TEST(RegisterByPatches, CandidatesByRankAreNoMoreThanAskedFor) {
  const test::Scene scene = small_block(3);
  const Prepared vision(scene.vision);
  const Prepared lidar(scene.lidar);
  PaperOptions options{.variant = "improved", .esf_samples = 5000};
  options.improved = {.half_step_patches = false,
                      .describe_spliced = true,
                      .describe_above_m = 2.0,
                      .best_candidates = 2,
                      .min_overlap = 0.0};
  const auto ranked =
      register_by_patches(vision.view(), lidar.view(), small_offset(), options, {}, {});
  ASSERT_TRUE(ranked) << ranked.error().message;
  EXPECT_GT(ranked->num_poses, 0U);
  std::size_t limited = 0;
  for (const PatchMatch& match : ranked->patches) {
    EXPECT_LE(match.num_similar, 2U);
    limited += match.num_candidates > match.num_similar ? 1 : 0;
  }
  EXPECT_GT(limited, 0U);
}

TEST(RegisterByPatches, GivesTheSameBytesAtAnyThreadCount) {
  const test::Scene scene = small_block(4);
  const Prepared vision(scene.vision);
  const Prepared lidar(scene.lidar);
  const PaperOptions quick{.esf_samples = 1000, .min_correlation = 0.8};
  const auto one = register_by_patches(
      vision.view(), lidar.view(), small_offset(), quick, {}, {.num_threads = 1});
  const auto four = register_by_patches(
      vision.view(), lidar.view(), small_offset(), quick, {}, {.num_threads = 4});
  ASSERT_TRUE(one && four);
  EXPECT_EQ(one->vision_from_lidar.matrix(), four->vision_from_lidar.matrix());
  ASSERT_EQ(one->patches.size(), four->patches.size());
  for (std::size_t i = 0; i < one->patches.size(); ++i) {
    EXPECT_EQ(one->patches[i].outcome, four->patches[i].outcome);
    EXPECT_EQ(one->patches[i].score_2d_m, four->patches[i].score_2d_m);
  }
}

TEST(RegisterByPatches, WithoutAnyPoseTheCoarsePoseComesBackUnsupported) {
  const test::Scene scene = small_block(3);
  const Prepared vision(scene.vision);
  const Prepared lidar(scene.lidar);
  const auto result = register_by_patches(
      vision.view(), lidar.view(), small_offset(), {.esf_samples = 500, .min_correlation = 1.0});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->supported);
  EXPECT_EQ(result->num_poses, 0U);
  EXPECT_EQ(result->vision_from_lidar.matrix(), small_offset().matrix());
  EXPECT_NE(result->reason.find("gave a pose"), std::string::npos) << result->reason;
}

TEST(RegisterByPatches, AClusterOfTooFewPatchesIsNotSupported) {
  const test::Scene scene = small_block(3);
  const Prepared vision(scene.vision);
  const Prepared lidar(scene.lidar);
  const auto result = register_by_patches(vision.view(),
                                          lidar.view(),
                                          small_offset(),
                                          {.esf_samples = 5000, .min_cluster_members = 1000});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->supported);
  EXPECT_FALSE(result->adjusted);
  EXPECT_NE(result->reason.find("patch poses agree"), std::string::npos) << result->reason;
}

TEST(RegisterByPatches, RefusesEmptyCloudsAndStopsWhenAsked) {
  const std::vector<Eigen::Vector3f> none;
  const std::vector<Eigen::Vector3f> some(200, Eigen::Vector3f(1, 2, 3));
  const std::vector<float> heights(200, 0.0F);
  EXPECT_EQ(register_by_patches({}, {some, heights}, {}).error().code, ErrorCode::kInsufficient);
  EXPECT_EQ(register_by_patches({some, heights}, {some, heights}, {}).error().code,
            ErrorCode::kDegenerate);
  EXPECT_THROW((void)register_by_patches({some, {}}, {some, heights}, {}), std::logic_error);
  const test::Scene scene = small_block(3);
  const Prepared vision(scene.vision);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(
      register_by_patches(vision.view(), vision.view(), {}, {}, {}, {.stop = stop.get_token()})
          .error()
          .code,
      ErrorCode::kCancelled);
}

TEST(RegisterCrossSource, PaperReportsItsPatchesInTheCommonResult) {
  const test::Scene scene = small_block(3);
  RegistrationOptions options{.method = "paper"};
  options.paper.esf_samples = 5000;
  const auto result = register_cross_source(
      scene.vision, scene.lidar, {.vision_from_lidar_initial = small_offset()}, options);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->method, "paper");
  EXPECT_EQ(result->score("patches"), static_cast<double>(result->patches.size()));
  EXPECT_GT(result->patches.size(), 0U);
  const bool refused = result->status == RegistrationStatus::kRefused;
  EXPECT_EQ(refused, !result->reason.empty());
  EXPECT_EQ(refused, result->confidence < options.verdict.min_confidence);
}

}  // namespace
}  // namespace hybridfusion
