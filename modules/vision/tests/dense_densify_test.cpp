#include "dense_box_scene.hpp"

#include <hybridfusion/vision/densify.hpp>

#include <string>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// Six photos from 30 m: four looking down in two strips of opposite heading, two oblique ones that
/// see the horizon of the finite ground and blank sky above it.
const testing::Survey& box_survey() {
  static const testing::Survey kSurvey = [] {
    const testing::BoxScene scene{.ground_half_m = 40.0, .texture_m = 0.4};
    const Eigen::Vector3d down(0.03, 0.02, -1.0);
    return testing::survey(scene,
                           {testing::looking({-3, -3, 30}, down, 0.0),
                            testing::looking({3, -3, 30}, down, 0.05),
                            testing::looking({3, 3, 30}, down, std::numbers::pi),
                            testing::looking({-3, 3, 30}, down, std::numbers::pi + 0.04),
                            testing::looking({-25, -3, 20}, {1.0, 0.1, -0.6}, 0.0),
                            testing::looking({-25, 3, 20}, {1.0, -0.1, -0.6}, 0.0)},
                           testing::small_camera());
  }();
  return kSurvey;
}

double distance_to_scene(const Eigen::Vector3f& p) {
  const testing::BoxScene scene;
  const Eigen::Array3d q = p.cast<double>().array().abs();
  const Eigen::Array3d outside(
      q.x() - scene.box_half_m, q.y() - scene.box_half_m, p.z() - scene.box_height_m);
  const double inside = outside.maxCoeff();
  const double to_box = inside < 0.0 ? -inside : outside.max(0.0).matrix().norm();
  return std::min(to_box, q.z());
}

const PointCloud& box_cloud() {
  static const PointCloud kCloud = [] {
    auto cloud = densify(box_survey().photos, box_survey().reconstruction, {}, {.num_threads = 2});
    return cloud ? *std::move(cloud) : PointCloud{};
  }();
  return kCloud;
}

TEST(Densify, PointsLieOnTheSceneAndNoneInTheSky) {
  const PointCloud& cloud = box_cloud();
  ASSERT_TRUE(validate(cloud));
  ASSERT_GT(cloud.size(), 5000U);
  std::vector<double> errors;
  for (const Eigen::Vector3f& p : cloud.points) errors.push_back(distance_to_scene(p));
  std::ranges::sort(errors);
  // GSD 0.11 m, base to height 0.2: one tenth of a pixel of disparity is 0.055 m.
  EXPECT_LT(errors[errors.size() / 2], 0.06);
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.3);
  EXPECT_LT(errors[errors.size() * 999 / 1000], 1.0);
}

TEST(Densify, RoofGroundAndFacadeAreCovered) {
  int roof = 0;
  int ground = 0;
  int facade = 0;
  for (const Eigen::Vector3f& p : box_cloud().points) {
    if (distance_to_scene(p) > 0.3) continue;
    roof += p.z() > 5.7F ? 1 : 0;
    ground += p.z() < 0.3F ? 1 : 0;
    facade += p.z() > 1.0F && p.z() < 5.0F && p.x() < -4.7F ? 1 : 0;
  }
  // Voxels of 0.22 m: 2066 on the roof; half of them is what occlusion and edges may cost.
  EXPECT_GT(roof, 1000);
  EXPECT_GT(ground, 3000);
  EXPECT_GT(facade, 50);
}

TEST(Densify, NormalsPointToThePhotosAndEveryPointHasItsSigma) {
  const PointCloud& cloud = box_cloud();
  ASSERT_EQ(cloud.normals.size(), cloud.size());
  ASSERT_EQ(cloud.sigmas_m.size(), cloud.size());
  int upright = 0;
  int flat = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_GT(cloud.sigmas_m[i], 0.0F);
    EXPECT_GE(cloud.confidences[i], 1.0F);
    if (std::abs(cloud.points[i].z()) > 0.2F) continue;
    ++flat;
    upright += cloud.normals[i].z() > 0.8F ? 1 : 0;
  }
  EXPECT_GT(upright, 0.9 * flat);
}

TEST(Densify, OneThreadGivesTheSameBytesAsTwo) {
  const auto one =
      densify(box_survey().photos, box_survey().reconstruction, {}, {.num_threads = 1});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->points, box_cloud().points);
  EXPECT_EQ(one->normals, box_cloud().normals);
  EXPECT_EQ(one->colors, box_cloud().colors);
  EXPECT_EQ(one->sigmas_m, box_cloud().sigmas_m);
  EXPECT_EQ(one->confidences, box_cloud().confidences);
}

TEST(Densify, RefusesFewerThanTwoRegisteredPhotos) {
  testing::Survey survey = box_survey();
  for (std::size_t v = 1; v < survey.reconstruction.views.size(); ++v) {
    survey.reconstruction.views[v].enu_from_camera.reset();
  }
  const auto cloud = densify(survey.photos, survey.reconstruction, {});
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kInsufficient);
}

TEST(Densify, RefusesPhotosThatShareNoPoints) {
  testing::Survey survey = box_survey();
  for (View& view : survey.reconstruction.views) view.observations.clear();
  for (ScenePoint& point : survey.reconstruction.points) point.track.clear();
  const auto cloud = densify(survey.photos, survey.reconstruction, {});
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kInsufficient);
}

TEST(Densify, RefusesPairsWhoseRowsDoNotCorrespondAndSaysSo) {
  testing::Survey survey = box_survey();
  for (std::size_t v = 0; v < survey.reconstruction.views.size(); ++v) {
    // A wrong pose: every photo turned by its own two degrees.
    Rigid3& pose = *survey.reconstruction.views[v].enu_from_camera;
    const double sign = v % 2 == 0 ? 1.0 : -1.0;
    pose.rotation = pose.rotation *
                    Eigen::AngleAxisd(sign * 0.035, Eigen::Vector3d(1.0, 1.0, 1.0).normalized());
  }
  std::string warnings;
  RunContext ctx{.num_threads = 1};
  ctx.log = [&](LogLevel, std::string_view text) { warnings += text; };
  const auto cloud = densify(survey.photos, survey.reconstruction, {}, ctx);
  EXPECT_NE(warnings.find("vertical parallax"), std::string::npos) << warnings;
}

TEST(Densify, APhotoThatCannotBeReadIsLeftOutWithAWarning) {
  testing::Survey survey = box_survey();
  survey.photos[4].load = []() -> Expected<Image8> { return fail(ErrorCode::kIo, "disk on fire"); };
  std::string warnings;
  RunContext ctx{.num_threads = 2};
  ctx.log = [&](LogLevel, std::string_view text) { warnings += text; };
  const auto cloud = densify(survey.photos, survey.reconstruction, {}, ctx);
  ASSERT_TRUE(cloud) << cloud.error().message;
  EXPECT_NE(warnings.find("disk on fire"), std::string::npos);
}

TEST(Densify, StopsWhenTheCallerAsks) {
  std::stop_source source;
  source.request_stop();
  const auto cloud =
      densify(box_survey().photos, box_survey().reconstruction, {}, {.stop = source.get_token()});
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kCancelled);
}

TEST(Densify, PhotosFartherThanVoxelsReachAreRefusedNotWrapped) {
  Reconstruction far = box_survey().reconstruction;
  const Eigen::Vector3d away(419000.0, 0.0, 0.0);
  for (View& view : far.views) view.enu_from_camera->translation += away;
  for (ScenePoint& point : far.points) point.point_in_enu += away;
  const auto cloud = densify(box_survey().photos, far, {}, {.num_threads = 2});
  ASSERT_FALSE(cloud);
  EXPECT_EQ(cloud.error().code, ErrorCode::kDegenerate);
  EXPECT_NE(cloud.error().message.find("419 km from the origin"), std::string::npos)
      << cloud.error().message;
}

}  // namespace
}  // namespace hybridfusion
