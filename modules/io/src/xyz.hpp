#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/atomic_file.hpp>

#include <filesystem>
#include <utility>

namespace hybridfusion {

/// Reads a text cloud: x y z, x y z intensity, x y z r g b or x y z intensity r g b per line,
/// separated by white space, commas or semicolons. Comments (# or //), a heading line of names and
/// a first line with only the number of points (.pts) are accepted.
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
  [[nodiscard]] static Expected<XyzPieceWriter> create(const std::filesystem::path& path,
                                                       const Eigen::Vector3d& offset_m);
  /// @pre validate(piece); every piece has the channels of the first.
  void add(const PointCloud& piece);
  [[nodiscard]] Expected<void> commit();

 private:
  XyzPieceWriter(AtomicFile file, const Eigen::Vector3d& offset_m)
      : file_(std::move(file)), offset_m_(offset_m) {}

  AtomicFile file_;
  Eigen::Vector3d offset_m_;
};

}  // namespace hybridfusion
