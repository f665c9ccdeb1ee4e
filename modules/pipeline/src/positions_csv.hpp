#pragma once

#include <hybridfusion/core/error.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// One photo of vision/positions.csv; coordinates in the local ENU frame [m].
struct PositionRow {
  std::string name = {};
  std::optional<Eigen::Vector3d> position = {};  ///< Empty: not registered.
  std::optional<Eigen::Vector3d> gnss = {};
  std::string reason = {};
};

/// A text as a field of a table, quoted as in RFC 4180 where it must be.
[[nodiscard]] std::string csv_text(const std::string& text);

/// Fields of the record of a table (RFC 4180) that starts at `at`, which moves behind its end.
std::vector<std::string> next_csv_record(std::string_view text, std::size_t& at);

/// Columns: name,registered,x,y,z,gnss_x,gnss_y,gnss_z,residual_h,residual_v,reason. A comma, a
/// quote or a line break in a text is quoted as in RFC 4180.
[[nodiscard]] Expected<void> write_positions_csv(const std::filesystem::path& path,
                                                 const std::vector<PositionRow>& rows);
[[nodiscard]] Expected<std::vector<PositionRow>> read_positions_csv(
    const std::filesystem::path& path);

}  // namespace hybridfusion
