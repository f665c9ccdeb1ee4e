#pragma once

#include "coordinate_system.hpp"
#include "coordinate_table.hpp"

#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

[[nodiscard]] bool on_earth(const GeodeticPosition& position);

/// The system that the line names; kParse with file and line otherwise.
[[nodiscard]] Expected<CoordinateSystem> system_of_line(const CoordinateTable& table,
                                                        const std::string& line);

/// What coordinates that do not fit their system look like, for behind its refusal: "; these look
/// like ..."; empty when they look like nothing known.
[[nodiscard]] std::string hint_of(const Eigen::Vector3d& written, const CoordinateSystem& system);

/// Whether the rows together can be coordinates of their system: refuses degrees under a projected
/// one and swapped axes; notes a unit of heights that is no metre and places outside the area that
/// the system is made for.
[[nodiscard]] Expected<void> check_written(const CoordinateTable& table,
                                           const CoordinateSystem& system,
                                           std::span<const Eigen::Vector3d> written,
                                           std::span<const GeodeticPosition> positions,
                                           std::vector<std::string>& notes);

}  // namespace hybridfusion
