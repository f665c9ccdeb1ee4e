#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/trajectory.hpp>

#include <filesystem>

namespace hybridfusion {

/// Reads "time[s] x y z qx qy qz qw" lines; '#' starts a comment. Times are read digit by digit
/// into nanoseconds.
/// @returns kNotFound; kParse naming the file and the line for a malformed line, a zero quaternion
/// or times that do not ascend.
[[nodiscard]] Expected<Trajectory> read_tum(const std::filesystem::path& path);

/// Writes one line per pose, time with nine decimals (exact), position to 1e-6 m.
[[nodiscard]] Expected<void> write_tum(const std::filesystem::path& path,
                                       const Trajectory& trajectory);

}  // namespace hybridfusion
