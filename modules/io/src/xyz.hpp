#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <filesystem>

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

}  // namespace hybridfusion
