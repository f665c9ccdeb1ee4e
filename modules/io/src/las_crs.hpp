#pragma once

#include "input_file.hpp"

#include <hybridfusion/io/placed_cloud.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// The records of a LAS file that say what its coordinates mean.
struct LasCrsRecords {
  bool wkt_rules = false;  ///< Bit 4 of the global encoding.
  std::string wkt = {};
  std::vector<std::byte> geo_keys = {};     ///< GeoKeyDirectoryTag.
  std::vector<std::byte> geo_doubles = {};  ///< GeoDoubleParamsTag.
  std::string geo_ascii = {};               ///< GeoAsciiParamsTag.
};

struct LasCrs {
  CrsDescription crs = {};                              ///< Of the coordinates in its own units.
  Eigen::Vector3d to_metres = Eigen::Vector3d::Ones();  ///< Of those of the file.
  std::vector<std::string> warnings = {};
};

/// @returns kParse for degrees, for heights that count downwards and for units that contradict each
/// other.
[[nodiscard]] Expected<LasCrs> las_crs(const InputFile& file, const LasCrsRecords& records);

}  // namespace hybridfusion
