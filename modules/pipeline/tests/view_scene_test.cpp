#include "sample_workspace.hpp"

#include <hybridfusion/pipeline/view_scene.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace hybridfusion {
namespace {

using Json = nlohmann::json;

class Scene : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() / ("hf_scene_" + std::to_string(::getpid()));
    std::filesystem::remove_all(root_);
    testing::write_sample_workspace(root_);
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  std::filesystem::path root_ = {};
};

TEST_F(Scene, HasAllLayersWithColourIntensityAndDistance) {
  const auto scene = view_scene(root_, {});
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->layers.size(), 3U);
  for (const ViewLayer& layer : scene->layers) {
    std::size_t count = 0;
    float nearest_m = kMaxViewDistance_m;
    std::size_t between = 0;
    const auto read = layer.batches(
        [&](const PointCloud& batch, std::span<const float> distances_m) -> Expected<void> {
          count += batch.size();
          EXPECT_EQ(batch.colors.size(), batch.size());
          EXPECT_EQ(distances_m.size(), batch.size());
          nearest_m = std::min(nearest_m, *std::ranges::min_element(distances_m));
          EXPECT_LE(*std::ranges::max_element(distances_m), kMaxViewDistance_m);
          for (const float value : batch.intensities) {
            EXPECT_TRUE(value >= 0.0F && value <= 1.0F);
            between += value > 0.0F && value < 1.0F ? 1 : 0;
          }
          return {};
        });
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_GT(count, 1000U);
    EXPECT_EQ(between > 100, layer.name != "vision") << layer.name << ": the street is not black";
    EXPECT_LT(nearest_m, 0.1F) << layer.name << ": the registered clouds share walls and street";
  }
  const Json json = Json::parse(scene->json);
  EXPECT_EQ(json["cameras"].size(), 12U);
  EXPECT_EQ(json["trajectory_in_lidar"].size(), 200U);
  EXPECT_EQ(json["registration"]["status"], "ok");
  EXPECT_TRUE(json["registration"]["before"].is_array());
}

TEST_F(Scene, OfOneModuleHasOneLayerWithoutDistance) {
  for (const char* gone : {"vision", "fused", "registration"})
    std::filesystem::remove_all(root_ / gone);
  const auto scene = view_scene(root_, {});
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->layers.size(), 1U);
  EXPECT_EQ(scene->layers.front().name, "lidar");
  ASSERT_TRUE(scene->layers.front().batches(
      [&](const PointCloud& batch, std::span<const float> distances_m) -> Expected<void> {
        EXPECT_TRUE(distances_m.empty());
        EXPECT_NE(batch.colors.front(), batch.colors[1]) << "grey by intensity: wall and street";
        return {};
      }));
  EXPECT_TRUE(Json::parse(scene->json)["registration"].is_null());
}

TEST_F(Scene, KeyFollowsTheFiles) {
  const std::string before = view_scene(root_, {})->key;
  EXPECT_EQ(view_scene(root_, {})->key, before);
  std::filesystem::remove_all(root_ / "fused");
  EXPECT_NE(view_scene(root_, {})->key, before);
}

TEST_F(Scene, WithoutAnyCloudIsRefusedWithARemedy) {
  std::filesystem::remove_all(root_);
  const auto scene = view_scene(root_, {});
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace hybridfusion
