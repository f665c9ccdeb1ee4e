#include "imported_poses.hpp"

#include "colmap_intrinsics.hpp"
#include "vision_files.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/core/geodetic.hpp>

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

constexpr GeodeticOrigin kOrigin = {.latitude_deg = 48.0, .longitude_deg = 11.5, .altitude_m = 520};

class ImportedPoses : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("hf_poses_" + std::to_string(::getpid()) + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Six photos on a bent strip, eight points, every point seen from two photos.
  static Reconstruction truth() {
    Reconstruction truth;
    truth.origin = kOrigin;
    truth.cameras.push_back({.width_px = 640,
                             .height_px = 480,
                             .focal_px = 500.5,
                             .principal_point_px = {319.25, 240.75},
                             .k1 = -0.02,
                             .k2 = 0.003});
    for (int i = 0; i < 6; ++i) {
      View view = {.name = "photo" + std::to_string(i) + ".jpg"};
      const Eigen::AngleAxisd tilt(0.05 * i, Eigen::Vector3d::UnitX());
      view.enu_from_camera =
          Rigid3{.rotation = Eigen::Quaterniond(0, 1, 0, 0) * Eigen::Quaterniond(tilt),
                 .translation = {10.0 * i, 3.0 * (i % 2) + 0.2 * i * i, 60.0 + (i % 3)}};
      truth.views.push_back(std::move(view));
    }
    for (std::uint32_t p = 0; p < 8; ++p) {
      ScenePoint point = {.point_in_enu = {5.0 * p, 4.0, 1.0}, .color = {1, 2, 3}};
      point.mean_error_px = 0.5F;
      for (const std::uint32_t v : {p % 5, p % 5 + 1}) {
        auto& observations = truth.views[v].observations;
        point.track.push_back(
            {.view = v, .observation = static_cast<std::uint32_t>(observations.size())});
        observations.push_back({.point = p, .pixel = {100.25F + static_cast<float>(p), 50.5F}});
      }
      truth.points.push_back(std::move(point));
    }
    return truth;
  }

  static std::vector<Photo> photos_of(const Reconstruction& truth) {
    std::vector<Photo> photos;
    for (const View& view : truth.views) {
      const GeodeticPosition at = geodetic_from_enu(kOrigin, view.enu_from_camera->translation);
      Photo photo;
      photo.metadata.name = view.name;
      photo.metadata.width = 640;
      photo.metadata.height = 480;
      photo.metadata.latitude_deg = at.latitude_deg;
      photo.metadata.longitude_deg = at.longitude_deg;
      photo.metadata.altitude_m = at.altitude_m;
      photos.push_back(std::move(photo));
    }
    return photos;
  }

  static Expected<Reconstruction> imported(const fs::path& folder,
                                           std::span<const Photo> photos,
                                           const PositionLimits& limits) {
    HF_TRY(PosedPhotos poses, import_poses(folder, photos, limits));
    return std::move(poses.reconstruction);
  }

  void store(const ColmapModel& model) const { ASSERT_TRUE(write_colmap_model(folder_, model)); }

  fs::path folder_ = {};
};

TEST_F(ImportedPoses, OwnModelWithItsOriginComesBackAsItWas) {
  const Reconstruction expected = truth();
  store(colmap_model_of(expected));
  ASSERT_TRUE(write_origin(folder_ / "origin.json", kOrigin));
  const auto back = imported(folder_, photos_of(expected), {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->origin.latitude_deg, kOrigin.latitude_deg);
  ASSERT_EQ(back->views.size(), expected.views.size());
  ASSERT_EQ(back->points.size(), expected.points.size());
  const CameraIntrinsics& camera = back->cameras.at(0);
  EXPECT_EQ(camera.focal_px, 500.5);
  EXPECT_LE((camera.principal_point_px - Eigen::Vector2d(319.25, 240.75)).norm(), 1e-9);
  EXPECT_EQ(camera.k2, 0.003);
  for (std::size_t i = 0; i < expected.views.size(); ++i) {
    const Rigid3& pose = *back->views[i].enu_from_camera;
    const Rigid3& wanted = *expected.views[i].enu_from_camera;
    EXPECT_LE((pose.translation - wanted.translation).norm(), 1e-9);
    EXPECT_LE(pose.rotation.angularDistance(wanted.rotation), 1e-9);
    EXPECT_EQ(back->views[i].observations.size(), expected.views[i].observations.size());
  }
  for (std::size_t p = 0; p < expected.points.size(); ++p) {
    ASSERT_EQ(back->points[p].track.size(), 2U);
    const ViewObservation& seen = back->points[p].track[1];
    EXPECT_EQ(seen.view, expected.points[p].track[1].view);
    const Observation& observation = back->views[seen.view].observations[seen.observation];
    EXPECT_EQ(observation.point, p);
    EXPECT_NEAR(observation.pixel.x(), 100.25F + static_cast<float>(p), 1e-3);
  }
}

TEST_F(ImportedPoses, AModelWithItsOriginIsComparedWithGnssButNotMoved) {
  const Reconstruction expected = truth();
  store(colmap_model_of(expected));
  ASSERT_TRUE(write_origin(folder_ / "origin.json", kOrigin));
  auto photos = photos_of(expected);
  for (Photo& photo : photos) *photo.metadata.altitude_m += 2.0;
  const auto back = imported(folder_, photos, {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_NEAR(back->quality.gnss_vertical_rms_m, 2.0, 1e-3);
  EXPECT_NEAR(back->quality.gnss_horizontal_rms_m, 0.0, 1e-3);
  EXPECT_NEAR(back->views[0].enu_from_camera->translation.z(), 60.0, 1e-9);
}

TEST_F(ImportedPoses, ForeignModelIsMovedTurnedAndScaledOntoThePhotosPositions) {
  const Reconstruction expected = truth();
  Reconstruction foreign = expected;
  // Another world: 1/20 of the scale, tilted, elsewhere.
  const Sim3 world_from_enu{
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized())),
      .translation = {7, -8, 9},
      .scale = 0.05};
  for (View& view : foreign.views) {
    view.enu_from_camera = world_from_enu.map_pose(*view.enu_from_camera);
  }
  for (ScenePoint& point : foreign.points) point.point_in_enu = world_from_enu * point.point_in_enu;
  store(colmap_model_of(foreign));
  const auto back = imported(folder_, photos_of(expected), {});
  ASSERT_TRUE(back) << back.error().message;
  // The origin is the median of the positions, so compare in the plane at kOrigin.
  const Rigid3 expected_from_back = enu_from_enu(kOrigin, back->origin);
  for (std::size_t i = 0; i < expected.views.size(); ++i) {
    const Rigid3 pose = expected_from_back * *back->views[i].enu_from_camera;
    const Rigid3& wanted = *expected.views[i].enu_from_camera;
    EXPECT_LE((pose.translation - wanted.translation).norm(), 1e-3);
    EXPECT_LE(pose.rotation.angularDistance(wanted.rotation), 1e-4);
  }
  // points3D.txt keeps micrometres of a world of a twentieth of the size.
  const Eigen::Vector3d point = expected_from_back * back->points[3].point_in_enu;
  EXPECT_LE((point - expected.points[3].point_in_enu).norm(), 2e-3);
  EXPECT_LE(back->quality.gnss_horizontal_rms_m, 1e-3);
}

TEST_F(ImportedPoses, AnOriginThatContradictsThePhotosIsRefusedWithBothPlacesAndTheCause) {
  const Reconstruction expected = truth();
  store(colmap_model_of(expected));
  const auto refusal = [&](const GeodeticOrigin& origin) {
    EXPECT_TRUE(write_origin(folder_ / "origin.json", origin));
    const auto back = imported(folder_, photos_of(expected), {});
    return back ? std::string("taken") : back.error().message;
  };
  const std::string swapped = refusal({.latitude_deg = 11.5, .longitude_deg = 48.0});
  EXPECT_THAT(swapped, HasSubstr("latitude and longitude swapped"));
  EXPECT_THAT(swapped, HasSubstr("km"));
  EXPECT_THAT(refusal({.latitude_deg = 48.0, .longitude_deg = -11.5, .altitude_m = 520}),
              HasSubstr("sign of the longitude"));
  EXPECT_THAT(refusal({.latitude_deg = 48.001, .longitude_deg = 11.5, .altitude_m = 520}),
              HasSubstr("111 m apart"));
  EXPECT_THAT(refusal({.latitude_deg = 5.3e6, .longitude_deg = 6.9e5, .altitude_m = 520}),
              HasSubstr("no place on Earth"));
  // 8 m off is within what two receivers may differ by.
  EXPECT_EQ(refusal({.latitude_deg = 48.00007, .longitude_deg = 11.5, .altitude_m = 520}), "taken");
}

TEST_F(ImportedPoses, PosesOfOtherPhotosUnderTheirNamesAreRefused) {
  const Reconstruction expected = truth();
  Reconstruction exchanged = expected;
  for (std::size_t i = 0; i < exchanged.views.size(); ++i) {
    exchanged.views[i].enu_from_camera->translation *= i % 2 == 0 ? 40.0 : -30.0;
  }
  std::vector<Photo> photos = photos_of(exchanged);
  std::swap(photos[0].metadata.name, photos[4].metadata.name);
  std::swap(photos[1].metadata.name, photos[5].metadata.name);
  store(colmap_model_of(exchanged));
  const auto back = imported(folder_, photos, {});
  ASSERT_FALSE(back);
  EXPECT_THAT(back.error().message, HasSubstr("is the limit"));
}

TEST_F(ImportedPoses, PhotosWithoutAPoseStayUnregistered) {
  const Reconstruction expected = truth();
  ColmapModel model = colmap_model_of(expected);
  model.images.erase(model.images.begin() + 2);
  for (ColmapImage& image : model.images) image.name = "sub/folder/" + image.name;
  store(model);
  ASSERT_TRUE(write_origin(folder_ / "origin.json", kOrigin));
  const auto back = imported(folder_, photos_of(expected), {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_FALSE(back->views[2].enu_from_camera);
  EXPECT_EQ(back->views[2].reason, "not in the given poses");
  EXPECT_TRUE(back->views[3].enu_from_camera);
  for (const ScenePoint& point : back->points) EXPECT_LE(point.track.size(), 2U);
}

TEST_F(ImportedPoses, WhatDoesNotFitIsRefusedWithTheReason) {
  const Reconstruction expected = truth();
  const ColmapModel good = colmap_model_of(expected);
  const auto refusal = [&](const ColmapModel& model, std::vector<Photo> photos) {
    store(model);
    const auto back = imported(folder_, photos, {});
    EXPECT_FALSE(back);
    return back ? std::string() : back.error().message;
  };
  std::vector<Photo> larger = photos_of(expected);
  larger[0].metadata.width = 1280;
  EXPECT_THAT(refusal(good, larger), HasSubstr("1280 x 480"));
  std::vector<Photo> others = photos_of(expected);
  for (Photo& photo : others) photo.metadata.name += ".other";
  EXPECT_THAT(refusal(good, others), HasSubstr("none of its 6 images"));
  std::vector<Photo> nowhere = photos_of(expected);
  for (Photo& photo : nowhere) photo.metadata.latitude_deg.reset();
  EXPECT_NE(refusal(good, nowhere), "");
  ColmapModel orphan = good;
  orphan.images[1].camera = 77;
  EXPECT_THAT(refusal(orphan, photos_of(expected)), HasSubstr("camera 77"));
}

TEST_F(ImportedPoses, ColmapReadsTheModel) {
  if (std::system("command -v colmap > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "colmap is not installed (apt-get install colmap)";
  }
  const Reconstruction expected = truth();
  store(colmap_model_of(expected));
  const auto convert = [&](const fs::path& from, const fs::path& to, const char* type) {
    fs::create_directories(to);
    const std::string command = "QT_QPA_PLATFORM=offscreen colmap model_converter --input_path '" +
                                from.string() + "' --output_path '" + to.string() +
                                "' --output_type " + type + " > /dev/null 2>&1";
    return std::system(command.c_str());
  };
  ASSERT_EQ(convert(folder_, folder_ / "bin", "BIN"), 0);
  ASSERT_EQ(convert(folder_ / "bin", folder_ / "txt", "TXT"), 0);
  ASSERT_TRUE(write_origin(folder_ / "txt/origin.json", kOrigin));
  const auto back = imported(folder_ / "txt", photos_of(expected), {});
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->points.size(), expected.points.size());
  for (std::size_t i = 0; i < expected.views.size(); ++i) {
    EXPECT_LE((back->views[i].enu_from_camera->translation -
               expected.views[i].enu_from_camera->translation)
                  .norm(),
              1e-9);
    EXPECT_EQ(back->views[i].observations.size(), expected.views[i].observations.size());
  }
}

TEST(IntrinsicsOf, EveryModelFindsItsParameters) {
  const auto read = [](const char* model, std::vector<double> params) {
    return intrinsics_of(
        {.id = 1, .model = model, .width_px = 640, .height_px = 480, .params = std::move(params)});
  };
  EXPECT_EQ(read("SIMPLE_PINHOLE", {500, 320, 240})->principal_point_px.x(), 319.5);
  EXPECT_EQ(read("PINHOLE", {500, 500, 320, 240})->focal_px, 500.0);
  EXPECT_EQ(read("SIMPLE_RADIAL", {500, 320, 240, 0.1})->k1, 0.1);
  EXPECT_EQ(read("RADIAL", {500, 320, 240, 0.1, 0.2})->k2, 0.2);
  EXPECT_EQ(read("OPENCV", {500, 500, 320, 240, 1, 2, 3, 4})->p2, 4.0);
  EXPECT_EQ(read("FULL_OPENCV", {500, 500, 320, 240, 1, 2, 3, 4, 5, 0, 0, 0})->k3, 5.0);
  for (const auto& refused : {read("PINHOLE", {500, 500, 320}),
                              read("PINHOLE", {500, -510, 320, 240}),
                              read("OPENCV_FISHEYE", {500, 500, 320, 240, 0, 0, 0, 0}),
                              read("SIMPLE_PINHOLE", {-1, 320, 240}),
                              read("FISHEYE", {500, 320, 240})}) {
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kParse);
  }
}

}  // namespace
}  // namespace hybridfusion
