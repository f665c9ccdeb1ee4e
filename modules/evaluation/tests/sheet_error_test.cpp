#include <hybridfusion/core/random.hpp>
#include <hybridfusion/evaluation/sheet_error.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct Floor {
  std::vector<Eigen::Vector3f> samples;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector3f> cloud;

  /// 8 m square with a sample every 0.25 m and a point every 0.1 m, `offset_m` above it, plus
  /// noise.
  Floor(double offset_m, double noise_m) {
    Random random(4, "sheet error test");
    for (int i = 0; i < 32; ++i) {
      for (int j = 0; j < 32; ++j) {
        samples.emplace_back(0.25F * static_cast<float>(i), 0.25F * static_cast<float>(j), 0.0F);
        normals.emplace_back(0.0F, 0.0F, 1.0F);
      }
    }
    for (int i = 0; i < 80; ++i) {
      for (int j = 0; j < 80; ++j) {
        cloud.emplace_back(0.1F * static_cast<float>(i),
                           0.1F * static_cast<float>(j),
                           static_cast<float>(offset_m + noise_m * random.normal()));
      }
    }
  }
};

TEST(SheetError, TellsThicknessAndBiasOfAFloor) {
  const Floor floor(-0.02, 0.01);
  const auto error = sheet_error(floor.samples, floor.normals, floor.cloud);
  ASSERT_TRUE(error) << error.error().message;
  EXPECT_EQ(error->num_patches, floor.samples.size());
  EXPECT_NEAR(error->bias_m, 0.02, 0.002);
  EXPECT_NEAR(error->thickness_m, 2 * 1.645 * 0.01, 0.004);  // 5 to 95 % of a normal distribution
}

TEST(SheetError, TwoSheetsAreAThickOne) {
  Floor floor(0.0, 0.001);
  for (std::size_t i = 0; i < floor.cloud.size(); i += 2) floor.cloud[i].z() += 0.1F;
  const auto error = sheet_error(floor.samples, floor.normals, floor.cloud);
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->thickness_m, 0.1, 0.005);
}

TEST(SheetError, CurvedPiecesAndEmptyOnesDoNotCount) {
  Floor floor(0.0, 0.01);
  for (Eigen::Vector3f& sample : floor.samples) sample.z() = 0.1F * sample.x() * sample.x();
  EXPECT_EQ(sheet_error(floor.samples, floor.normals, floor.cloud).error().code,
            ErrorCode::kInsufficient);
  const Floor good(0.0, 0.01);
  EXPECT_EQ(sheet_error(good.samples, good.normals, {}).error().code, ErrorCode::kInsufficient);
  floor.normals.pop_back();
  EXPECT_EQ(sheet_error(floor.samples, floor.normals, floor.cloud).error().code,
            ErrorCode::kInvalidOptions);
}

TEST(SigmaCalibration, IsTwoThirdsWhereErrorsAreAsLargeAsStated) {
  const std::vector<Eigen::Vector3f> vertices = {{-1, -1, 0}, {9, -1, 0}, {9, 9, 0}, {-1, 9, 0}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<std::uint8_t> labels = {1, 1};
  const auto surface = SurfaceDistance::build(vertices, triangles);
  ASSERT_TRUE(surface);
  const Floor floor(0.0, 0.03);
  std::vector<float> sigmas(floor.cloud.size(), 0.03F);
  sigmas[0] = 0.0F;
  const auto found = sigma_calibration(floor.cloud, sigmas, *surface, labels);
  EXPECT_NEAR(found.hard, 0.6745, 0.02);
  EXPECT_DOUBLE_EQ(found.hard, found.by_label[1]);
  EXPECT_TRUE(std::isnan(found.by_label[0]));
}

}  // namespace
}  // namespace hybridfusion
