#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>

#include <string>

namespace hybridfusion {

/// How well PROJ converts WGS84 to a system at a place with the grids that are installed.
/// @param crs  "EPSG:n" or "EPSG:n+m".
/// @returns "" when it promises 1 m or better, else a warning with the accuracy and the file that
/// would better it; kInvalidOptions beyond 5 m, which positions of plain GNSS have themselves,
/// unless `allow_ballpark`.
[[nodiscard]] Expected<std::string> judge_accuracy(const GeodeticOrigin& origin,
                                                   const std::string& crs,
                                                   bool allow_ballpark);

/// ": install FILE ..." for the grids that the best conversion lacks; empty: none is known.
[[nodiscard]] std::string missing_grids(const GeodeticOrigin& origin, const std::string& crs);

}  // namespace hybridfusion
