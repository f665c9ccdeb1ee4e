#include "street_scene.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A workspace whose photo model leans by one degree and whose drive knows the vertical.
class LeaningPhotos : public testing::Test {
 protected:
  void SetUp() override {
    root_ =
        std::filesystem::path(testing::TempDir()) / ("leaning_photos_" + std::to_string(getpid()));
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_ / "vision");
    std::filesystem::create_directories(root_ / "lidar");
    const test::Scene scene =
        test::make_scene(7, {.half_extent_m = 35.0, .lidar_half_extent_m = 40.0, .slope = 0.0});
    lean_.rotation = Eigen::AngleAxisd(kDegree, Eigen::Vector3d(1.0, 2.0, 0.0).normalized());
    ASSERT_TRUE(write_ply(root_ / "vision/dense.ply", transformed(lean_, scene.vision)));
    ASSERT_TRUE(write_ply(root_ / "lidar/map.ply", scene.lidar));
    write("vision/cameras.txt", "1 PINHOLE 100 80 90 90 50 40\n");
    // Cameras that look down, at (-10, 0, 60) and (30, 0, 60) in the frame of the model.
    write("vision/images.txt", "1 0 1 0 0 10 0 60 1 a.jpg\n\n2 0 1 0 0 -30 0 60 1 b.jpg\n\n");
    write("vision/points3D.txt", "# no point\n");
    const std::string numbers =
        ",1,1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0.0001,0,0,0.0001,0,0.0001\n";
    write("vision/pose_covariance.csv", "header\na.jpg" + numbers + "b.jpg" + numbers);
    write("lidar/level.json", "{\"vertical_sigma_deg\": 0.02}");
  }
  void TearDown() override { std::filesystem::remove_all(root_); }
  void write(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(write_file_atomically(root_ / name, text));
  }
  StoredRegistration registered(const PipelineOptions& options) const {
    auto workspace = Workspace::open(root_);
    if (!workspace) return {};
    Project project{*std::move(workspace), options, {"register"}};
    const auto outcome = register_stage(project,
                                        {.vision = root_ / "vision/dense.ply",
                                         .lidar = root_ / "lidar/map.ply",
                                         .near_identity = true},
                                        {});
    EXPECT_TRUE(outcome) << outcome.error().message;
    const auto stored = read_registration(root_ / "registration/registration.json");
    EXPECT_TRUE(stored);
    return stored.value_or(StoredRegistration{});
  }

  std::filesystem::path root_;
  Rigid3 lean_;
};

TEST_F(LeaningPhotos, GiveALevelFusedCloudThatKeepsThePlaceOfTheCameras) {
  const StoredRegistration stored = registered({});
  ASSERT_TRUE(stored.ok) << stored.reason;
  const auto tilt_deg = [](const Eigen::Quaterniond& rotation) {
    return std::acos(std::min(1.0, (rotation * Eigen::Vector3d::UnitZ()).z())) / kDegree;
  };
  EXPECT_GT(tilt_deg(stored.vision_from_lidar.rotation), 0.9);
  EXPECT_LT(tilt_deg(stored.fused_from_lidar.rotation), 1e-6);
  // The scene is level where the LiDAR is: so is what becomes of the leaning photo cloud.
  EXPECT_LT(tilt_deg(stored.fused_from_vision.rotation * lean_.rotation), 0.03);
  const Eigen::Vector3d middle(10.0, 0.0, 60.0);
  EXPECT_LT((stored.fused_from_vision * middle - middle).norm(), 0.02);
  // Both ways into the fused frame agree: the clouds were in one frame before the photos leant.
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(20, 10, 0), Eigen::Vector3d(-15, 5, 8)}) {
    EXPECT_LT((stored.fused_from_vision * (lean_ * p) - stored.fused_from_lidar * p).norm(), 0.05);
  }
  const auto fused = read_ply(root_ / "fused/fused.ply");
  ASSERT_TRUE(fused);
  EXPECT_GT(fused->size(), 1000U);
}

TEST_F(LeaningPhotos, KeepTheirVerticalWhenAsked) {
  PipelineOptions options;
  options.fusion.level_vision = false;
  const StoredRegistration stored = registered(options);
  ASSERT_TRUE(stored.ok) << stored.reason;
  EXPECT_EQ(stored.fused_from_lidar.translation, stored.vision_from_lidar.translation);
  EXPECT_LT(
      rotation_distance_rad(stored.fused_from_vision.rotation, Eigen::Quaterniond::Identity()),
      0.003);
}

}  // namespace
}  // namespace hybridfusion
