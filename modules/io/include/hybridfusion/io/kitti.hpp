#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/trajectory.hpp>

#include <filesystem>

namespace hybridfusion {

/// Reads the poses of the KITTI odometry benchmark: the upper 3 x 4 part of map_from_body, row by
/// row, on each line, and their times in seconds, one on each line of another file.
/// @returns kNotFound; kParse naming the file and the line for a malformed line, a matrix that is
/// no rotation, times that do not ascend or that are not as many as the poses.
[[nodiscard]] Expected<Trajectory> read_kitti(const std::filesystem::path& poses,
                                              const std::filesystem::path& times);

/// Writes the poses, translations to 1e-6 m.
[[nodiscard]] Expected<void> write_kitti(const std::filesystem::path& path,
                                         const Trajectory& trajectory);
/// Writes the times with nine decimals (exact).
[[nodiscard]] Expected<void> write_kitti_times(const std::filesystem::path& path,
                                               const Trajectory& trajectory);

}  // namespace hybridfusion
