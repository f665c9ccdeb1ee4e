#include "mutations.hpp"
#include "rigid3_matchers.hpp"
#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/io/dataset_truth.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>
#include <hybridfusion/io/transform_json.hpp>
#include <hybridfusion/io/tum.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Rigid3Near;
using testing::TempFolder;

[[nodiscard]] Rigid3 some_motion(double angle_rad) {
  return {.rotation = Eigen::Quaterniond(
              Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(1, 2, 3).normalized())),
          .translation = {1.5, -2.25, 100.125}};
}

TEST(Tum, TimesAreExactAndPosesKeepSixDecimals) {
  const TempFolder folder;
  Trajectory trajectory;
  for (int i = 0; i < 10; ++i) {
    trajectory.poses.push_back(
        {.time = Timestamp(1'777'674'600'123'456'789 + i), .map_from_body = some_motion(0.3 * i)});
  }
  ASSERT_TRUE(write_tum(folder.path() / "t.tum", trajectory));
  const auto back = read_tum(folder.path() / "t.tum");
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->poses.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(back->poses[i].time, trajectory.poses[i].time);
    EXPECT_THAT(back->poses[i].map_from_body,
                Rigid3Near(trajectory.poses[i].map_from_body, 1e-6, 1e-7));
  }
}

TEST(Tum, BadLinesAreNamed) {
  const TempFolder folder;
  const auto message = [&](const char* content) {
    const auto result = read_tum(folder.file("t.tum", content));
    EXPECT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kParse);
    return result.error().message;
  };
  EXPECT_THAT(message("# c\n1 2 3\n"), AllOf(HasSubstr("t.tum"), HasSubstr("line 2")));
  EXPECT_THAT(message("1 0 0 0 0 0 0 0\n"), HasSubstr("line 1"));
  EXPECT_THAT(message("1 0 0 nan 0 0 0 1\n"), HasSubstr("line 1"));
  EXPECT_THAT(message("2 0 0 0 0 0 0 1\n1.5 0 0 0 0 0 0 1\n"), HasSubstr("ascend"));
  EXPECT_EQ(read_tum(folder.path() / "none").error().code, ErrorCode::kNotFound);
}

TEST(Tum, TrueTrajectoryOfADataSetIsRead) {
  const auto path = testing::test_data("block-11/truth/trajectory_imu.tum");
  if (!path) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  const auto trajectory = read_tum(*path);
  ASSERT_TRUE(trajectory) << trajectory.error().message;
  EXPECT_GT(trajectory->poses.size(), 5000U);
  EXPECT_EQ(trajectory->poses[1].time.count(), 1'777'674'600'010'000'000);
}

TEST(ColmapModel, ReadsBackAsWritten) {
  ColmapModel model;
  model.cameras = {{.id = 1,
                    .model = "FULL_OPENCV",
                    .width_px = 1600,
                    .height_px = 1200,
                    .params = {1290.37, 1290.37, 799.5, 595.6, -0.045, 0.018, 0, 0, 0, 0, 0, 0}}};
  ColmapImage with_points = {.id = 3, .camera = 1, .name = "photo with space.jpg"};
  with_points.camera_from_world = some_motion(1.0).rotation;
  with_points.camera_from_world_translation = {1, 2, 3};
  with_points.points = {{.pixel = {10.5, 20.25}, .point3d = 7}, {.pixel = {1.0, 2.0}}};
  model.images = {with_points, {.id = 4, .camera = 1, .name = "empty.jpg"}};
  model.points = {{.id = 7,
                   .point_in_world = {-1.5, 2.5, 3.5},
                   .color = {1, 2, 255},
                   .error_px = 0.25,
                   .track = {{.image = 3, .point2d = 0}, {.image = 4, .point2d = 9}}}};
  const TempFolder folder;
  ASSERT_TRUE(write_colmap_model(folder.path(), model));
  const auto back = read_colmap_model(folder.path());
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->cameras.at(0).params, model.cameras[0].params);
  ASSERT_EQ(back->images.size(), 2U);
  EXPECT_EQ(back->images[0].name, "photo with space.jpg");
  EXPECT_LT(rotation_distance_rad(back->images[0].camera_from_world, with_points.camera_from_world),
            1e-12);
  ASSERT_EQ(back->images[0].points.size(), 2U);
  EXPECT_EQ(back->images[0].points[0].point3d, 7U);
  EXPECT_EQ(back->images[0].points[1].point3d, std::nullopt);
  EXPECT_TRUE(back->images[1].points.empty());
  EXPECT_EQ(back->points.at(0).track.at(1).point2d, 9U);
  EXPECT_EQ(back->points[0].color, (Rgb8{1, 2, 255}));
}

TEST(ColmapModel, DamageIsNamedAndNeverCrashes) {
  const TempFolder folder;
  const std::string images = "1 1 0 0 0 0 0 0 1 a.jpg\n1 2 -1 3 4 5\n2 1 0 0 0 0 0 0 1 b.jpg\n\n";
  static_cast<void>(folder.file("cameras.txt", "1 PINHOLE 10 10 5 5 5 5\n"));
  static_cast<void>(folder.file("points3D.txt", "1 0 0 0 1 2 3 0.5 1 0 2 1\n"));
  static_cast<void>(folder.file("images.txt", "1 1 0 0 0 0 0 0 1 a.jpg\n1 2\n"));
  EXPECT_THAT(read_colmap_model(folder.path()).error().message,
              AllOf(HasSubstr("images.txt"), HasSubstr("line 2")));
  for (std::uint64_t i = 0; i < 300; ++i) {
    static_cast<void>(folder.file("images.txt", testing::mutated(images, i)));
    static_cast<void>(read_colmap_model(folder.path()));
  }
}

TEST(TransformJson, ReadsBackToTheSameMatrix) {
  const TempFolder folder;
  const Rigid3 motion = some_motion(0.7);
  ASSERT_TRUE(write_transform_json(folder.path() / "t.json", "vision_from_lidar", motion));
  const auto back = read_transform_json(folder.path() / "t.json", "vision_from_lidar");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_THAT(*back, Rigid3Near(motion, 0.0, 1e-15));
}

TEST(TransformJson, WhatIsNoRigidMotionIsRefused) {
  const TempFolder folder;
  const auto error = [&](const std::string& content) {
    const auto result = read_transform_json(folder.file("t.json", content), "a_from_b");
    EXPECT_FALSE(result) << content;
    return result ? std::string() : result.error().message;
  };
  EXPECT_THAT(error("{}"), AllOf(HasSubstr("t.json"), HasSubstr("no 'a_from_b'")));
  EXPECT_THAT(error("[1]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(error("{\"a_from_b\": [1,2]}"), HasSubstr("16 numbers"));
  EXPECT_THAT(error("{\"a_from_b\": [2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}"), HasSubstr("rotation"));
  EXPECT_THAT(error("{\"a_from_b\": [-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}"), HasSubstr("rotation"));
  EXPECT_THAT(error("{\"a_from_b\": [1,0,0,1e999,0,1,0,0,0,0,1,0,0,0,0,1]}"), HasSubstr("t.json"));
  EXPECT_THAT(error(std::string(100'000, '[')), HasSubstr("t.json"));
}

TEST(DatasetTruth, OfADataSetIsRead) {
  const auto truth = testing::test_data("block-11/truth");
  if (!truth) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  const auto dataset = read_dataset_truth(*truth / "dataset.json");
  ASSERT_TRUE(dataset) << dataset.error().message;
  EXPECT_EQ(dataset->origin.altitude_m, 520.0);
  EXPECT_EQ(dataset->camera->width_px, 1600);
  EXPECT_NEAR(dataset->camera->focal_px, 1290.37, 0.01);
  EXPECT_NEAR(dataset->imu_from_lidar->translation.z(), 0.36, 1e-12);
  const auto poses = read_true_photo_poses(*truth / "cameras.csv");
  ASSERT_TRUE(poses) << poses.error().message;
  ASSERT_EQ(poses->size(), 29U);
  EXPECT_EQ(poses->front().name, "IMG_0001.JPG");
  EXPECT_NEAR(poses->front().enu_from_camera.translation.z(), 65.27, 0.01);
  EXPECT_NEAR(poses->front().gnss_in_enu->z(), 64.206, 1e-9);
  // A nadir photo looks down: z forward in the camera is down in ENU.
  EXPECT_LT((poses->front().enu_from_camera.rotation * Eigen::Vector3d::UnitZ()).z(), -0.99);
}

TEST(PointCloudFile, FormatFollowsTheExtension) {
  const TempFolder folder;
  PointCloud cloud = {.points = {{1.5, -2.25, 3.1F}, {4, 5, 6}}};
  cloud.colors = {{1, 2, 3}, {255, 128, 0}};
  cloud.intensities = {0.5F, 7.0F};
  for (const char* const name : {"a.ply", "a.PCD", "a.xyz"}) {
    ASSERT_TRUE(write_point_cloud(folder.path() / name, cloud)) << name;
    const auto back = read_point_cloud(folder.path() / name);
    ASSERT_TRUE(back) << back.error().message;
    testing::expect_equal(*back, cloud);
  }
  EXPECT_TRUE(write_point_cloud(folder.path() / "a.las", cloud));
  EXPECT_EQ(write_point_cloud(folder.path() / "a.doc", cloud).error().code,
            ErrorCode::kInvalidOptions);
  EXPECT_EQ(read_point_cloud(folder.path() / "a.doc").error().code, ErrorCode::kInvalidOptions);
}

TEST(PointCloudFile, TextCloudsOfManyKindsAreRead) {
  const TempFolder folder;
  const auto read = [&](const char* content) {
    auto cloud = read_point_cloud(folder.file("a.txt", content));
    EXPECT_TRUE(cloud) << cloud.error().message;
    return std::move(cloud).value_or(PointCloud{});
  };
  EXPECT_EQ(read("# c\n1 2 3\n4 5 6").size(), 2U);
  EXPECT_EQ(read("X,Y,Z\n1,2,3\r\n4,5,6\r\n").points[1], Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(read("2\n1 2 3 100\n4 5 6 200\n").intensities[1], 200.0F);
  EXPECT_EQ(read("1;2;3;10;20;30\n").colors.at(0), (Rgb8{10, 20, 30}));
  EXPECT_EQ(read("1 2 3 9.5 10 20 30\n").intensities.at(0), 9.5F);
  for (const char* const bad : {"1 2\n", "1 2 3\n4 5\n", "1 2 3\nx y z\n", "\n", "a b\n"}) {
    const auto cloud = read_point_cloud(folder.file("bad.txt", bad));
    ASSERT_FALSE(cloud) << bad;
    EXPECT_EQ(cloud.error().code, ErrorCode::kParse);
    EXPECT_THAT(cloud.error().message, AllOf(HasSubstr("bad.txt"), HasSubstr("line")));
  }
}

}  // namespace
}  // namespace hybridfusion
