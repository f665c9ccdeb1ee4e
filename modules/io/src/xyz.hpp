#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/atomic_file.hpp>

#include <filesystem>
#include <utility>

namespace hybridfusion {

/// Reads a text cloud: a point on each line, its fields separated by white space, commas,
/// semicolons or tabs. A heading names the columns; without one they must tell by what they hold
/// that they are x y z, perhaps with intensity, red green blue or nx ny nz. Comments (# or //) and
/// lines with only the number of points that follow (.pts) are accepted.
[[nodiscard]] Expected<PointCloud> read_xyz(const std::filesystem::path& path);

/// Writes "x y z", with intensity and colour when the cloud has them, so that read_xyz understands.
/// @param offset_m  Added to the points.
[[nodiscard]] Expected<void> write_xyz(const std::filesystem::path& path,
                                       const PointCloud& cloud,
                                       const Eigen::Vector3d& offset_m);

/// The same file from pieces, without holding it. It appears when commit() is called.
class XyzPieceWriter {
 public:
  /// @returns kIo.
  [[nodiscard]] static Expected<XyzPieceWriter> create(
      const std::filesystem::path& path,
      const Eigen::Vector3d& offset_m,
      const Eigen::Vector3d& units_m = Eigen::Vector3d::Ones());
  /// @pre validate(piece); every piece has the channels of the first.
  void add(const PointCloud& piece);
  [[nodiscard]] Expected<void> commit();

 private:
  XyzPieceWriter(AtomicFile file, const Eigen::Vector3d& offset_m, const Eigen::Vector3d& units_m)
      : file_(std::move(file)), offset_m_(offset_m), units_m_(units_m) {}

  AtomicFile file_;
  Eigen::Vector3d offset_m_;
  Eigen::Vector3d units_m_;
};

}  // namespace hybridfusion
