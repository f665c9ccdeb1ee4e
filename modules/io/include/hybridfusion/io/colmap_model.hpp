#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace hybridfusion {

/// Camera of a COLMAP model. Parameter order is COLMAP's for `model`, e.g. FULL_OPENCV:
/// fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6. COLMAP puts the centre of the first pixel at (0.5, 0.5).
struct ColmapCamera {
  std::uint32_t id = 0;
  std::string model = {};
  int width_px = 0;
  int height_px = 0;
  std::vector<double> params = {};
};

struct ColmapPoint2D {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< COLMAP's pixel convention.
  std::optional<std::uint64_t> point3d = {};        ///< ColmapPoint3D::id.
};

struct ColmapImage {
  std::uint32_t id = 0;
  std::uint32_t camera = 0;  ///< ColmapCamera::id.
  std::string name = {};
  Eigen::Quaterniond camera_from_world = Eigen::Quaterniond::Identity();
  Eigen::Vector3d camera_from_world_translation = Eigen::Vector3d::Zero();
  std::vector<ColmapPoint2D> points = {};
};

struct ColmapTrackElement {
  std::uint32_t image = 0;    ///< ColmapImage::id.
  std::uint32_t point2d = 0;  ///< Index into ColmapImage::points.
};

struct ColmapPoint3D {
  std::uint64_t id = 0;
  Eigen::Vector3d point_in_world = Eigen::Vector3d::Zero();
  Rgb8 color = {};
  double error_px = 0.0;
  std::vector<ColmapTrackElement> track = {};
};

struct ColmapModel {
  std::vector<ColmapCamera> cameras = {};
  std::vector<ColmapImage> images = {};
  std::vector<ColmapPoint3D> points = {};
};

/// Writes cameras.txt, images.txt and points3D.txt into an existing folder.
[[nodiscard]] Expected<void> write_colmap_model(const std::filesystem::path& folder,
                                                const ColmapModel& model);
/// Writes cameras.bin, images.bin and points3D.bin. @returns kInvalidOptions for a camera model
/// that has no number.
[[nodiscard]] Expected<void> write_colmap_binary(const std::filesystem::path& folder,
                                                 const ColmapModel& model);
/// Reads the three files, binary where cameras.bin is there, as COLMAP does. @returns kNotFound
/// naming folders below that hold a model; kParse naming file and line or byte.
[[nodiscard]] Expected<ColmapModel> read_colmap_model(const std::filesystem::path& folder);
/// The files that read_colmap_model reads: cameras, images, points.
[[nodiscard]] std::vector<std::filesystem::path> colmap_files(const std::filesystem::path& folder);

}  // namespace hybridfusion
