#include "pinhole_camera.hpp"
#include "render.hpp"
#include "world.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

/// A 10 m cube on the ground as PLY, red or without colour.
fs::path cube_file(bool red) {
  const fs::path path = fs::temp_directory_path() /
                        ("hf_cube_" + std::to_string(getpid()) + (red ? "_red.ply" : ".ply"));
  std::ofstream out(path);
  out << "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
         "property float z\n";
  if (red) out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out << "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 8; ++i) {
    out << (i & 1) * 10 << ' ' << (i >> 1 & 1) * 10 << ' ' << (i >> 2) * 10;
    out << (red ? " 210 20 20\n" : "\n");
  }
  out << "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
  return path;
}

/// Mean RGB of the middle of a photo straight down on the cube's roof.
std::array<double, 3> roof_color(const fs::path& mesh) {
  WorldOptions options;
  options.mesh = mesh.string();
  options.ambient_rays = 4;
  const auto world = build_world(options, 3, {});
  EXPECT_TRUE(world) << world.error().message;
  if (!world) return {};
  const RayTracer tracer(world->scene);
  const PinholeCamera camera(32, 32, 40.0, {15.5, 15.5}, 0.0, 0.0);
  Rigid3 world_from_camera;
  world_from_camera.rotation = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
  world_from_camera.translation = {0.0, 0.0, 20.0};
  const auto photo = render_photo(world->scene, tracer, camera, world_from_camera, {}, {});
  EXPECT_TRUE(photo);
  std::array<double, 3> sum{};
  for (int y = 8; y < 24; ++y) {
    for (int x = 8; x < 24; ++x) {
      for (int c = 0; c < 3; ++c) sum[c] += photo->pixels[3 * (y * 32 + x) + c] / 256.0;
    }
  }
  return sum;
}

TEST(WorldMesh, ColoursOfTheMeshAreSeenInThePhotos) {
  const fs::path file = cube_file(true);
  const auto color = roof_color(file);
  EXPECT_GT(color[0], 2.0 * color[1]);
  EXPECT_GT(color[0], 2.0 * color[2]);
  fs::remove(file);
}

TEST(WorldMesh, WithoutColoursTheMaterialOfTheLabelIsUsed) {
  const fs::path file = cube_file(false);
  const auto color = roof_color(file);
  EXPECT_GT(color[0], color[2]);
  EXPECT_LT(color[0], 2.0 * color[2]);
  fs::remove(file);
}

}  // namespace
}  // namespace hybridfusion
