#include "test_files.hpp"

#include <hybridfusion/io/colmap_model.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::content_of;
using ::testing::HasSubstr;
using testing::TempFolder;

ColmapModel sample() {
  ColmapModel model;
  model.cameras.push_back({.id = 7,
                           .model = "FULL_OPENCV",
                           .width_px = 640,
                           .height_px = 480,
                           .params = {500, 501, 320, 240, 1e-2, 2e-3, 3e-4, 4e-5, 5e-6, 6, 7, 8}});
  model.cameras.push_back(
      {.id = 8, .model = "SIMPLE_RADIAL", .width_px = 9, .height_px = 8, .params = {5, 4, 3, 0.1}});
  ColmapImage image{.id = 3, .camera = 7, .name = "cam 0/two  blanks (1).jpg"};
  image.camera_from_world = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5);
  image.camera_from_world_translation = {1.5, -2.25, 1e6};
  image.points = {{.pixel = {10.25, 20.5}, .point3d = 42}, {.pixel = {1, 2}}};
  model.images.push_back(image);
  model.images.push_back({.id = 4, .camera = 8, .name = "none.jpg"});
  model.points.push_back({.id = 42,
                          .point_in_world = {1, 2, 3},
                          .color = {9, 8, 7},
                          .error_px = 0.5,
                          .track = {{.image = 3, .point2d = 0}}});
  return model;
}

void expect_same(const ColmapModel& a, const ColmapModel& b) {
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) {
    EXPECT_EQ(a.cameras[i].id, b.cameras[i].id);
    EXPECT_EQ(a.cameras[i].model, b.cameras[i].model);
    EXPECT_EQ(a.cameras[i].width_px, b.cameras[i].width_px);
    EXPECT_EQ(a.cameras[i].params, b.cameras[i].params);
  }
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t i = 0; i < a.images.size(); ++i) {
    EXPECT_EQ(a.images[i].name, b.images[i].name);
    EXPECT_EQ(a.images[i].camera, b.images[i].camera);
    EXPECT_LE(a.images[i].camera_from_world.angularDistance(b.images[i].camera_from_world), 1e-12);
    EXPECT_EQ(a.images[i].camera_from_world_translation, b.images[i].camera_from_world_translation);
    ASSERT_EQ(a.images[i].points.size(), b.images[i].points.size());
    for (std::size_t k = 0; k < a.images[i].points.size(); ++k) {
      EXPECT_EQ(a.images[i].points[k].pixel, b.images[i].points[k].pixel);
      EXPECT_EQ(a.images[i].points[k].point3d, b.images[i].points[k].point3d);
    }
  }
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.points[0].id, b.points[0].id);
  EXPECT_EQ(a.points[0].point_in_world, b.points[0].point_in_world);
  EXPECT_EQ(a.points[0].color, b.points[0].color);
  EXPECT_EQ(a.points[0].track.size(), b.points[0].track.size());
}

TEST(ColmapBinary, TextAndBinaryHoldTheSameModel) {
  const TempFolder text;
  const TempFolder binary;
  ASSERT_TRUE(write_colmap_model(text.path(), sample()));
  ASSERT_TRUE(write_colmap_binary(binary.path(), sample()));
  for (const TempFolder* folder : {&text, &binary}) {
    const auto back = read_colmap_model(folder->path());
    ASSERT_TRUE(back) << back.error().message;
    expect_same(sample(), *back);
  }
}

TEST(ColmapBinary, TheLayoutIsThatOfTheDocumentation) {
  const TempFolder folder;
  ASSERT_TRUE(write_colmap_binary(folder.path(), sample()));
  // count, then id, model number, width, height and the parameters of each camera
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "cameras.bin"),
            8U + (4 + 4 + 8 + 8 + 12 * 8) + (4 + 4 + 8 + 8 + 4 * 8));
  const std::string cameras = content_of(folder.path() / "cameras.bin");
  EXPECT_EQ(cameras.substr(0, 16), std::string("\2\0\0\0\0\0\0\0\7\0\0\0\6\0\0\0", 16));
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "images.bin"),
            8U + (4 + 56 + 4 + 26 + 8 + 2 * 24) + (4 + 56 + 4 + 9 + 8));
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "points3D.bin"),
            8U + (8 + 24 + 3 + 8 + 8 + 8));
}

TEST(ColmapBinary, CutAndDamagedFilesAreErrorsThatNameTheFile) {
  const TempFolder folder;
  ASSERT_TRUE(write_colmap_binary(folder.path(), sample()));
  for (const char* name : {"cameras.bin", "images.bin", "points3D.bin"}) {
    const std::string whole = content_of(folder.path() / name);
    for (std::size_t length = 1; length < whole.size(); length += 3) {
      static_cast<void>(folder.file(name, whole.substr(0, length)));
      const auto back = read_colmap_model(folder.path());
      ASSERT_FALSE(back) << name << " " << length;
      EXPECT_THAT(back.error().message, HasSubstr(name));
    }
    std::string huge = whole;
    huge.replace(0, 8, 8, '\xff');
    static_cast<void>(folder.file(name, huge));
    EXPECT_FALSE(read_colmap_model(folder.path())) << name;
    static_cast<void>(folder.file(name, whole));
  }
  std::string unknown = content_of(folder.path() / "cameras.bin");
  unknown[12] = 99;
  static_cast<void>(folder.file("cameras.bin", unknown));
  EXPECT_THAT(read_colmap_model(folder.path()).error().message, HasSubstr("model number 99"));
}

TEST(ColmapBinary, AFolderAboveTheModelIsToldWhereItIs) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path() / "sparse/0");
  ASSERT_TRUE(write_colmap_binary(folder.path() / "sparse/0", sample()));
  const auto back = read_colmap_model(folder.path());
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(back.error().message, AllOf(HasSubstr("no COLMAP model"), HasSubstr("sparse/0")));
}

}  // namespace
}  // namespace hybridfusion
