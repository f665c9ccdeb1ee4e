#include "truth_alignments.hpp"

#include <hybridfusion/io/ply.hpp>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

/// A flat square of 2 x 2 m as truth, and a fused cloud of it with a point every 0.3 m.
class TruthClouds : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() /
            std::string("hf_truth_clouds_").append(std::to_string(getpid()));
    std::filesystem::create_directories(root_ / "truth");
    std::ofstream samples(root_ / "truth/samples.ply");
    samples << "ply\nformat ascii 1.0\nelement vertex 1681\nproperty float x\nproperty float y\n"
               "property float z\nproperty int drone\nproperty int vehicle\nend_header\n";
    for (int i = 0; i <= 40; ++i) {
      for (int j = 0; j <= 40; ++j) samples << 0.05 * i << ' ' << 0.05 * j << " 0 2 1\n";
    }
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void add_points(float step, float begin, PointSource source) {
    for (float x = begin; x < 2.01F; x += step) {
      for (float y = begin; y < 2.01F; y += step) {
        cloud_.points.emplace_back(x, y, 0.0F);
        cloud_.sources.push_back(source);
      }
    }
  }

  Json compared() const {
    auto workspace = Workspace::open(root_ / "ws");
    EXPECT_TRUE(workspace);
    EXPECT_TRUE(workspace->make_folder("fused"));
    EXPECT_TRUE(write_ply(workspace->path(workspace_file::kFusedPly), cloud_));
    TruthMetrics metrics;
    const auto done = compare_clouds(*workspace,
                                     root_ / "truth",
                                     {.truth_from_vision = Sim3{}, .fused_from_vision = Sim3{}},
                                     {},
                                     {},
                                     metrics);
    EXPECT_TRUE(done) << done.error().message;
    return metrics.json.at("clouds");
  }

  std::filesystem::path root_;
  PointCloud cloud_;
};

TEST_F(TruthClouds, InterpolatedPointsCountInTheFusedCloudAndNotInTheMeasuredOne) {
  add_points(0.3F, 0.0F, PointSource::kLidar);
  add_points(0.1F, 0.0F, PointSource::kInterpolated);
  const Json clouds = compared();
  const auto complete = [&](const char* name) {
    return clouds.at(name).at("similarity").at("completeness").at("within_0.1_m").get<double>();
  };
  EXPECT_GT(complete("fused"), 0.95);
  EXPECT_LT(complete("fused_measured"), 0.6);
  EXPECT_EQ(clouds.at("fused_measured").at("num_points"), 49);
  EXPECT_EQ(clouds.at("fused_interpolated").at("num_points"), 441);
}

TEST_F(TruthClouds, ACloudOfMeasuredPointsAloneIsReportedOnce) {
  add_points(0.3F, 0.0F, PointSource::kVision);
  const Json clouds = compared();
  EXPECT_TRUE(clouds.contains("fused"));
  EXPECT_FALSE(clouds.contains("fused_measured"));
  EXPECT_FALSE(clouds.contains("fused_interpolated"));
}

}  // namespace
}  // namespace hybridfusion
