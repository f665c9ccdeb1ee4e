#pragma once

#include "cloud_builder.hpp"
#include "pcd_header.hpp"

#include <functional>

namespace hybridfusion {

/// The scalars of a row: arrays are left out, a packed colour becomes red, green and blue.
[[nodiscard]] std::vector<CloudColumn> pcd_columns(const PcdHeader& header);

struct PcdSink {
  std::function<void(std::uint64_t)> reserve = {};  ///< Called once, with the number of points.
  /// As pcd_columns; NaN is kept. An error ends the reading.
  std::function<Expected<void>(std::span<const double>)> row = {};
};

/// Reads the points behind the header. @returns kParse naming the file and the cause.
[[nodiscard]] Expected<void> read_pcd_rows(InputFile& file,
                                           const PcdHeader& header,
                                           const PcdSink& sink);

}  // namespace hybridfusion
