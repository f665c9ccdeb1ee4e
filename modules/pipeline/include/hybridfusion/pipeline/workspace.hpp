#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>

#include <filesystem>
#include <string_view>

namespace hybridfusion {

/// The folder of one project, held by at most one process at a time (an flock that the system
/// releases when the process ends, however it ends).
class Workspace {
 public:
  /// Creates the folder when it is missing. @returns kIo when it cannot be created or written, or
  /// when another process works in it.
  [[nodiscard]] static Expected<Workspace> open(const std::filesystem::path& root);

  Workspace(Workspace&& other) noexcept;
  Workspace& operator=(Workspace&& other) noexcept;
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  ~Workspace();

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] std::filesystem::path path(std::string_view relative) const {
    return root_ / relative;
  }
  [[nodiscard]] bool has(std::string_view relative) const;
  /// Creates a folder below the root. @returns kIo.
  [[nodiscard]] Expected<void> make_folder(std::string_view relative) const;
  /// Deletes a file if it exists.
  void remove(std::string_view relative) const;

 private:
  Workspace(std::filesystem::path root, int lock) : root_(std::move(root)), lock_(lock) {}

  std::filesystem::path root_ = {};
  int lock_ = -1;
};

/// Names of the files of a workspace, relative to its root.
namespace workspace_file {
inline constexpr std::string_view kConfig = "config.yaml";
inline constexpr std::string_view kRun = "run.json";
inline constexpr std::string_view kCameras = "vision/cameras.txt";
inline constexpr std::string_view kImages = "vision/images.txt";
inline constexpr std::string_view kPoints3d = "vision/points3D.txt";
inline constexpr std::string_view kPositions = "vision/positions.csv";
inline constexpr std::string_view kDense = "vision/dense.ply";
inline constexpr std::string_view kOrigin = "vision/origin.json";
inline constexpr std::string_view kPoseCovariance = "vision/pose_covariance.csv";
inline constexpr std::string_view kFrame = "vision/frame.json";
inline constexpr std::string_view kLiveCameras = "vision/cameras.csv";
inline constexpr std::string_view kPreview = "vision/preview.ply";
inline constexpr std::string_view kPreviewOrigin = "vision/preview_origin.json";
inline constexpr std::string_view kTrajectory = "lidar/trajectory.tum";
inline constexpr std::string_view kMap = "lidar/map.ply";
inline constexpr std::string_view kQuality = "lidar/quality.csv";
inline constexpr std::string_view kGnss = "lidar/gnss.json";
inline constexpr std::string_view kLevel = "lidar/level.json";
inline constexpr std::string_view kCalibratedSensors = "lidar/sensors.yaml";
inline constexpr std::string_view kRegistration = "registration/registration.json";
inline constexpr std::string_view kFusedPly = "fused/fused.ply";
inline constexpr std::string_view kFusedLas = "fused/fused.las";
inline constexpr std::string_view kMetrics = "evaluation/metrics.json";
inline constexpr std::string_view kCrossSection = "evaluation/cross_section.csv";
inline constexpr std::string_view kDifference = "evaluation/difference.ply";
inline constexpr std::string_view kReport = "report/index.html";
}  // namespace workspace_file

/// Reads an origin.json as workspaces have it. @returns kNotFound; kParse naming the file.
[[nodiscard]] Expected<GeodeticOrigin> read_origin(const std::filesystem::path& path);

}  // namespace hybridfusion
