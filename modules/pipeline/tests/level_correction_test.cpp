#include "level_correction.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Eigen::Quaterniond turn_deg(double angle_deg, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * kDegree, axis.normalized()));
}

/// A pose whose photo model leans by 0.7 degrees and is turned by 40.
RegistrationResult leaning_result() {
  RegistrationResult result{.status = RegistrationStatus::kOk};
  result.vision_from_lidar = {
      .rotation = turn_deg(0.7, {1.0, -1.0, 0.0}) * turn_deg(40.0, {0.0, 0.0, 1.0}),
      .translation = {3.0, -2.0, -60.0}};
  result.covariance.diagonal().setConstant(1e-10);
  return result;
}

LevelEvidence good_evidence() {
  return {.lidar_sigma_rad = 0.02 * kDegree,
          .vision_sigma_rad = 0.6 * kDegree,
          .cameras_middle = Eigen::Vector3d(5.0, 7.0, 1.0)};
}

TEST(LevelCorrection, MakesTheLidarVerticalTheVerticalAndLeavesTheCamerasWhereTheyWere) {
  const RegistrationResult result = leaning_result();
  const LevelCorrection level = level_correction(result, good_evidence());
  ASSERT_TRUE(level.applied) << level.reason;
  const Rigid3 fused_from_lidar = level.level_from_vision * result.vision_from_lidar;
  EXPECT_LT(
      (fused_from_lidar.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(),
      1e-12);
  const Eigen::Vector3d middle = *good_evidence().cameras_middle;
  EXPECT_LT((level.level_from_vision * middle - middle).norm(), 1e-12);
  // The least turn has no part about the vertical.
  EXPECT_NEAR(level.level_from_vision.rotation.z(), 0.0, 1e-12);
  EXPECT_NEAR(level.tilt_rad, 0.7 * kDegree, 1e-9);
}

TEST(LevelCorrection, LeavesAModelThatIsLevelledAsWellAsTheLidarMap) {
  LevelEvidence evidence = good_evidence();
  evidence.vision_sigma_rad = 0.03 * kDegree;  // ground control or RTK
  const LevelCorrection level = level_correction(leaning_result(), evidence);
  EXPECT_FALSE(level.applied);
  EXPECT_NE(level.reason.find("0.030 deg"), std::string::npos) << level.reason;
  EXPECT_EQ(level.level_from_vision.translation, Eigen::Vector3d::Zero());
}

TEST(LevelCorrection, CountsTheUncertaintyOfThePose) {
  RegistrationResult result = leaning_result();
  result.covariance.diagonal().setConstant(std::pow(0.5 * kDegree, 2));
  EXPECT_FALSE(level_correction(result, good_evidence()).applied);
}

TEST(LevelCorrection, RefusesATiltThatNeitherSideExplains) {
  LevelEvidence evidence = good_evidence();
  evidence.vision_sigma_rad = 0.1 * kDegree;
  const LevelCorrection level = level_correction(leaning_result(), evidence);
  EXPECT_FALSE(level.applied);
  EXPECT_NE(level.reason.find("contradicts"), std::string::npos) << level.reason;
}

TEST(LevelCorrection, NeedsToKnowBothVerticals) {
  for (int missing = 0; missing < 3; ++missing) {
    LevelEvidence evidence = good_evidence();
    if (missing == 0) evidence.lidar_sigma_rad.reset();
    if (missing == 1) evidence.vision_sigma_rad.reset();
    if (missing == 2) evidence.cameras_middle.reset();
    EXPECT_FALSE(level_correction(leaning_result(), evidence).applied) << missing;
  }
}

class LevelEvidenceFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(testing::TempDir()) / ("level_evidence_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("cameras.txt", "1 PINHOLE 100 80 90 90 50 40\n");
    // Looks down (camera z = -up), at (0, 0, 10) and (4, 0, 10).
    write("images.txt",
          "1 0 1 0 0 0 0 10 1 a.jpg\n\n"
          "2 0 1 0 0 -4 0 10 1 b.jpg\n\n");
    write("points3D.txt", "# no point\n");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(write_file_atomically(folder_ / name, text));
  }
  std::filesystem::path folder_;
};

TEST_F(LevelEvidenceFiles, GiveTheTiltOfAHorizontalAxisInTheWorldNotInTheCamera) {
  // About the camera's x and y 0.01 rad, about its optical axis, which is vertical, 1 rad.
  const std::string numbers = ",1,1,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0.0001,0,0,0.0001,0,1\n";
  write("pose_covariance.csv", "header\na.jpg" + numbers + "b.jpg" + numbers);
  write("level.json", "{\"vertical_sigma_deg\": 0.05}");
  const auto evidence =
      read_level_evidence(folder_ / "pose_covariance.csv", folder_ / "level.json");
  ASSERT_TRUE(evidence) << evidence.error().message;
  EXPECT_NEAR(evidence->vision_sigma_rad.value_or(0.0), 0.01, 1e-9);
  EXPECT_NEAR(evidence->lidar_sigma_rad.value_or(0.0), 0.05 * kDegree, 1e-12);
  ASSERT_TRUE(evidence->cameras_middle);
  EXPECT_LT((*evidence->cameras_middle - Eigen::Vector3d(2, 0, 10)).norm(), 1e-9);
}

TEST_F(LevelEvidenceFiles, DamagedFilesAreErrorsThatNameThem) {
  write("pose_covariance.csv", "header\na.jpg,1,2\n");
  const auto covariance = read_level_evidence(folder_ / "pose_covariance.csv", std::nullopt);
  ASSERT_FALSE(covariance);
  EXPECT_NE(covariance.error().message.find("pose_covariance.csv"), std::string::npos);
  write("level.json", "{}");
  const auto level = read_level_evidence(std::nullopt, folder_ / "level.json");
  ASSERT_FALSE(level);
  EXPECT_NE(level.error().message.find("level.json"), std::string::npos);
}

}  // namespace
}  // namespace hybridfusion
