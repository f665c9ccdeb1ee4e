#include "test_files.hpp"

#include <hybridfusion/io/surface_raster.hpp>

#include <array>
#include <cmath>
#include <memory>

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using testing::TempFolder;

/// 8 m x 6 m of ground at height 1 with a roof at 5 over its east half, a point each 0.25 m; the
/// ground goes on below the roof.
PlacedCloud house() {
  PlacedCloud placed;
  for (int i = 0; i < 32; ++i) {
    for (int k = 0; k < 24; ++k) {
      const float x = 0.125F + 0.25F * static_cast<float>(i);
      const float y = 0.125F + 0.25F * static_cast<float>(k);
      placed.cloud.points.emplace_back(x, y, 1.0F);
      placed.cloud.colors.push_back({10, 200, 30});
      if (i < 16) continue;
      placed.cloud.points.emplace_back(x, y, 5.0F);
      placed.cloud.colors.push_back({180, 20, 40});
    }
  }
  return placed;
}

TEST(SurfaceRaster, ShowsTheHighestPointOfEachCell) {
  const auto raster = make_surface_raster(house(), {.cell_m = 0.5, .fill_cells = 0});
  ASSERT_TRUE(raster);
  ASSERT_EQ(raster->columns, 16);
  ASSERT_EQ(raster->rows, 12);
  EXPECT_EQ(raster->north_west, Eigen::Vector2d(0, 6));
  for (std::size_t cell = 0; cell < raster->heights_m.size(); ++cell) {
    const bool roof = cell % 16 >= 8;
    EXPECT_EQ(raster->heights_m[cell], roof ? 5.0F : 1.0F);
    EXPECT_EQ(raster->colors[cell], roof ? (Rgb8{180, 20, 40}) : (Rgb8{10, 200, 30}));
  }
}

TEST(SurfaceRaster, ClosesNarrowGapsAndLeavesWideOnes) {
  PlacedCloud placed = house();
  PointCloud holed;
  for (std::size_t i = 0; i < placed.cloud.size(); ++i) {
    const Eigen::Vector3f& at = placed.cloud.points[i];
    const bool narrow = at.x() > 1.0F && at.x() < 1.5F;
    const bool wide = at.y() < 4.0F && at.x() > 2.0F;
    if (narrow || wide) continue;
    holed.points.push_back(at);
    holed.colors.push_back(placed.cloud.colors[i]);
  }
  const auto raster = make_surface_raster({.cloud = holed}, {.cell_m = 0.5, .fill_cells = 1});
  ASSERT_TRUE(raster);
  const auto height = [&raster](std::size_t row, std::size_t column) {
    return raster->heights_m[row * 16 + column];
  };
  EXPECT_EQ(height(0, 2), 1.0F);  // the narrow gap, away from its ends as well
  EXPECT_EQ(height(8, 2), 1.0F);
  EXPECT_TRUE(std::isnan(height(9, 10)));
}

TEST(SurfaceRaster, RefusesWhatCannotBeDrawn) {
  EXPECT_EQ(make_surface_raster({}).error().code, ErrorCode::kInsufficient);
  PlacedCloud far = house();
  far.cloud.points[0].x() = 1e7F;
  const auto huge = make_surface_raster(far, {.cell_m = 0.05});
  ASSERT_FALSE(huge);
  EXPECT_THAT(huge.error().message, HasSubstr("larger cells"));
}

TEST(SurfaceRaster, GeoTiffsHavePlaceSystemAndValues) {
  const TempFolder folder;
  const GeodeticOrigin origin = {.latitude_deg = 48.0, .longitude_deg = 9.0, .altitude_m = 500.0};
  const auto projector = CloudProjector::create({.origin = origin});
  ASSERT_TRUE(projector) << projector.error().message;
  auto projected = (*projector)(house().cloud);
  ASSERT_TRUE(projected) << projected.error().message;
  const PlacedCloud placed = {
      .cloud = std::move(*projected), .offset_m = projector->offset_m(), .crs = projector->crs()};
  const auto raster = make_surface_raster(placed, {.cell_m = 0.5});
  ASSERT_TRUE(raster);
  ASSERT_TRUE(write_dsm(folder.path() / "dsm.tif", *raster));
  ASSERT_TRUE(write_orthophoto(folder.path() / "ortho.tif", *raster));
  GDALAllRegister();
  const auto open = [&folder](const char* name) {
    return std::unique_ptr<GDALDataset>(
        static_cast<GDALDataset*>(GDALOpen((folder.path() / name).c_str(), GA_ReadOnly)));
  };
  const auto dsm = open("dsm.tif");
  ASSERT_TRUE(dsm);
  std::array<double, 6> transform = {};
  ASSERT_EQ(dsm->GetGeoTransform(transform.data()), CE_None);
  // The origin lies on the central meridian, so the cloud begins at 500 km east.
  EXPECT_NEAR(transform[0], 500'000.0, 0.51);
  EXPECT_EQ(transform[1], 0.5);
  EXPECT_EQ(transform[5], -0.5);
  EXPECT_THAT(std::string(dsm->GetSpatialRef()->GetName()), HasSubstr("UTM zone 32N"));
  EXPECT_EQ(dsm->GetRasterBand(1)->GetNoDataValue(), -9999.0);
  std::array<double, 2> range = {};
  ASSERT_EQ(dsm->GetRasterBand(1)->ComputeRasterMinMax(FALSE, range.data()), CE_None);
  EXPECT_NEAR(range[0], 501.0, 0.01);
  EXPECT_NEAR(range[1], 505.0, 0.01);
  const auto ortho = open("ortho.tif");
  ASSERT_TRUE(ortho);
  ASSERT_EQ(ortho->GetRasterCount(), 4);
  EXPECT_EQ(ortho->GetRasterBand(4)->GetColorInterpretation(), GCI_AlphaBand);
  std::array<std::uint8_t, 4> pixel = {};
  ASSERT_EQ(ortho->RasterIO(
                GF_Read, 12, 6, 1, 1, pixel.data(), 1, 1, GDT_Byte, 4, nullptr, 0, 0, 0, nullptr),
            CE_None);
  EXPECT_EQ(pixel, (std::array<std::uint8_t, 4>{180, 20, 40, 255}));
}

TEST(SurfaceRaster, CloudWithoutColoursHasNoOrthophoto) {
  const TempFolder folder;
  PlacedCloud grey = house();
  grey.cloud.colors.clear();
  const auto raster = make_surface_raster(grey);
  ASSERT_TRUE(raster);
  EXPECT_EQ(write_orthophoto(folder.path() / "a.tif", *raster).error().code,
            ErrorCode::kInsufficient);
  EXPECT_TRUE(write_dsm(folder.path() / "a.tif", *raster));
  const auto unwritable = write_dsm(folder.path() / "none" / "a.tif", *raster);
  ASSERT_FALSE(unwritable);
  EXPECT_EQ(unwritable.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace hybridfusion
