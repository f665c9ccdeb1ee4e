#include "program.hpp"

#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/evaluation/trajectory_error.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/transform_json.hpp>
#include <hybridfusion/io/tum.hpp>

#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::testing {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

class Chain : public ProgramTest {
 protected:
  [[nodiscard]] Json json(const std::string& name) const {
    return Json::parse(read_file(path(name)));
  }

  [[nodiscard]] static std::string data(const std::string& name) {
    return (*test_data() / name).string();
  }

  /// Copies the first part of a file.
  std::string cut(const std::string& from, const std::string& to, double share) const {
    std::string bytes = read_file(from);
    bytes.resize(static_cast<std::size_t>(static_cast<double>(bytes.size()) * share));
    return write(to, bytes);
  }
};

TEST_F(Chain, RegistersAPairFromNothingAndDoesNotDoItTwice) {
  HF_NEEDS_TEST_DATA();
  const std::vector<std::string> arguments = {"register",
                                              "--vision",
                                              data("pairs/pair-21/G.ply"),
                                              "--lidar",
                                              data("pairs/pair-21/L.ply"),
                                              "--output",
                                              path("ws")};
  const ProgramResult result = run_program(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json registration = json("ws/registration/registration.json");
  EXPECT_EQ(registration.at("status"), "ok");
  EXPECT_EQ(registration.at("vision_from_lidar").size(), 16U);
  EXPECT_EQ(registration.at("covariance").size(), 36U);
  for (const char* key : {"confidence", "reason", "patches", "scores", "seconds", "method"}) {
    EXPECT_TRUE(registration.contains(key)) << key;
  }
  const auto pose =
      read_transform_json(path("ws/registration/registration.json"), "vision_from_lidar");
  const auto truth = read_transform_json(data("pairs/pair-21/truth.json"), "vision_from_lidar");
  const auto lidar = read_ply(data("pairs/pair-21/L.ply"));
  ASSERT_TRUE(pose && truth && lidar);
  EXPECT_TRUE(registration_errors(*truth, *pose, centroid(*lidar)).precise());
  const auto fused = read_ply(path("ws/fused/fused.ply"));
  ASSERT_TRUE(fused);
  EXPECT_EQ(fused->sources.size(), fused->size());
  EXPECT_TRUE(std::filesystem::exists(path("ws/fused/fused.las")));
  EXPECT_TRUE(std::filesystem::exists(path("ws/report/index.html")));

  const ProgramResult again = run_program(arguments);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.out, HasSubstr("up to date"));
}

TEST_F(Chain, RefusesTwoDifferentPlaces) {
  HF_NEEDS_TEST_DATA();
  const ProgramResult result = run_program({"register",
                                            "--vision",
                                            data("pairs/pair-21/G.ply"),
                                            "--lidar",
                                            data("pairs/pair-22/L.ply"),
                                            "--output",
                                            path("ws")});
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(json("ws/registration/registration.json").at("status"), "refused");
  EXPECT_FALSE(std::filesystem::exists(path("ws/fused/fused.ply")));
}

TEST_F(Chain, EvaluatesAPairAgainstItsTruth) {
  HF_NEEDS_TEST_DATA();
  const std::string truth = data("pairs/pair-21/truth.json");
  const ProgramResult result = run_program({"evaluate",
                                            "--vision",
                                            data("pairs/pair-21/G.ply"),
                                            "--lidar",
                                            data("pairs/pair-21/L.ply"),
                                            "--transform",
                                            truth,
                                            "--truth",
                                            truth,
                                            "--set",
                                            "evaluation.baselines=none",
                                            "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json metrics = Json::parse(result.out).at("result");
  EXPECT_GT(metrics.at("supplement_degree"), 0.0);
  EXPECT_EQ(metrics.at("boundary_accuracy_m"), metrics.at("boundary").at("oracle_m"));
  EXPECT_LT(metrics.at("truth").at("registration").at("at_centroid_m"), 1e-9);
}

TEST_F(Chain, MapsADriveAndMeasuresItAgainstTheTruth) {
  HF_NEEDS_TEST_DATA();
  const ProgramResult result =
      run_program({"map", "--bag", data("block-12-avia/street.bag"), "--output", path("ws")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto trajectory = read_tum(path("ws/lidar/trajectory.tum"));
  const auto truth = read_tum(data("block-12-avia/truth/trajectory_imu.tum"));
  ASSERT_TRUE(trajectory && truth);
  const auto errors = trajectory_errors(*truth, *trajectory);
  ASSERT_TRUE(errors);
  EXPECT_LT(errors->ate_rmse_m, 0.2);  // a narrow view over 132 m without a loop
  const auto map = read_ply(path("ws/lidar/map.ply"));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->intensities.size(), map->size());
  EXPECT_EQ(map->times_s.size(), map->size());
  EXPECT_THAT(read_file(path("ws/lidar/quality.csv")), HasSubstr("time"));
  EXPECT_EQ(json("ws/lidar/gnss.json").at("enu_from_map").size(), 16U);
  const Json run = json("ws/run.json");
  EXPECT_EQ(run.at("inputs").at(0).at("sha256").get<std::string>().size(), 64U);
  EXPECT_TRUE(run.at("stages").at("map").contains("peak_memory_mib"));

  const ProgramResult evaluated = run_program(
      {"evaluate", "--workspace", path("ws"), "--truth", data("block-12-avia/truth"), "--json"});
  ASSERT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_NEAR(json("ws/evaluation/metrics.json").at("truth").at("trajectory").at("ate_rmse_m"),
              errors->ate_rmse_m,
              1e-6);
}

TEST_F(Chain, UsesWhatPrecedesTheCutOfARecordingAndSaysSo) {
  HF_NEEDS_TEST_DATA();
  const std::string bag = cut(data("block-12-avia/street.bag"), "cut.bag", 0.4);
  const ProgramResult result = run_program({"map",
                                            "--bag",
                                            bag,
                                            "--sensors",
                                            data("block-12-avia/sensors.yaml"),
                                            "--output",
                                            path("ws"),
                                            "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json map = Json::parse(result.out).at("stages").at("map").at("result");
  EXPECT_TRUE(map.at("recording_truncated"));
  EXPECT_GT(map.at("num_scans"), 100);
  EXPECT_LT(map.at("num_scans"), 250);
  EXPECT_THAT(result.err, HasSubstr("cut.bag"));
}

TEST_F(Chain, EndsOnASignalAndResumes) {
  HF_NEEDS_TEST_DATA();
  const std::vector<std::string> arguments = {
      "map", "--bag", data("block-12-avia/street.bag"), "--output", path("ws")};
  const ProgramResult stopped = run_program(arguments, {.signal_after_s = 1.0});
  EXPECT_EQ(stopped.exit_code, 143) << stopped.err;
  EXPECT_FALSE(std::filesystem::exists(path("ws/lidar/map.ply")));
  EXPECT_EQ(run_program(arguments).exit_code, 0);
}

TEST_F(Chain, LeavesDamagedPhotosOutAndGoesOn) {
  HF_NEEDS_TEST_DATA();
  std::filesystem::create_directories(path("images"));
  for (int i = 1; i <= 8; ++i) {
    const std::string name = "IMG_000" + std::to_string(i) + ".JPG";
    std::filesystem::copy(data("block-11/images/" + name), path("images/" + name));
  }
  cut(data("block-11/images/IMG_0009.JPG"), "images/IMG_0009.JPG", 0.5);
  write("images/notes.txt", "not a photo");
  // Small settings: this is about the photos that are left out, not about the cloud.
  const ProgramResult result = run_program({"reconstruct",
                                            "--images",
                                            path("images"),
                                            "--output",
                                            path("ws"),
                                            "--set",
                                            "vision.reconstruction.features.min_keypoints=1000",
                                            "--set",
                                            "vision.reconstruction.features.max_keypoints=2000",
                                            "--set",
                                            "vision.densify.max_size_px=500"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("IMG_0009.JPG"));
  const std::string positions = read_file(path("ws/vision/positions.csv"));
  EXPECT_THAT(positions, HasSubstr("IMG_0001.JPG,1,"));
  EXPECT_THAT(positions, HasSubstr("IMG_0009.JPG,0,,,,"));
  for (const char* file :
       {"cameras.txt", "images.txt", "points3D.txt", "dense.ply", "origin.json"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "ws/vision" / file)) << file;
  }

  // With the poses just found, only the dense cloud is made again, and it is the same.
  const ProgramResult posed = run_program({"reconstruct",
                                           "--images",
                                           path("images"),
                                           "--poses",
                                           path("ws/vision"),
                                           "--output",
                                           path("posed"),
                                           "--set",
                                           "vision.densify.max_size_px=500"});
  ASSERT_EQ(posed.exit_code, 0) << posed.err;
  const auto dense = read_ply(path("ws/vision/dense.ply"));
  const auto again = read_ply(path("posed/vision/dense.ply"));
  ASSERT_TRUE(dense && again);
  EXPECT_NEAR(static_cast<double>(again->size()) / static_cast<double>(dense->size()), 1.0, 0.02);
  std::size_t near = 0;
  std::size_t checked = 0;
  for (std::size_t i = 0; i < again->size(); i += again->size() / 200 + 1) {
    float nearest_m = 1e9F;
    for (const Eigen::Vector3f& point : dense->points) {
      nearest_m = std::min(nearest_m, (point - again->points[i]).norm());
    }
    ++checked;
    near += nearest_m < 0.05F ? 1 : 0;
  }
  EXPECT_GE(near, checked * 95 / 100);
}

}  // namespace
}  // namespace hybridfusion::testing
