#pragma once

#include "input_file.hpp"
#include "scalar_type.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hybridfusion {

struct PcdField {
  std::string name = {};   ///< In lower case.
  std::string label = {};  ///< As written.
  ScalarType type = ScalarType::kFloat32;
  std::size_t count = 1;
  bool packed_color = false;  ///< "rgb" or "rgba": 0xAARRGGBB, perhaps in the bits of a float.
};

/// What the text header of a PCD file announces.
struct PcdHeader {
  std::vector<PcdField> fields = {};
  std::uint64_t points = 0;
  Viewpoint viewpoint = kNoViewpoint;
  std::string data = {};  ///< "ascii", "binary", "binary_compressed"

  [[nodiscard]] std::size_t point_bytes() const {
    std::size_t bytes = 0;
    for (const PcdField& field : fields) bytes += size_of(field.type) * field.count;
    return bytes;
  }
};

/// Reads up to and including the DATA line. @returns kParse naming the file and the cause.
[[nodiscard]] Expected<PcdHeader> read_pcd_header(InputFile& file);

}  // namespace hybridfusion
