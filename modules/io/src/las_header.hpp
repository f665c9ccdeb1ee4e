#pragma once

#include "input_file.hpp"
#include "las_attributes.hpp"
#include "las_crs.hpp"

#include <hybridfusion/io/las.hpp>

#include <array>
#include <cstdint>

namespace hybridfusion {

/// What the header and the variable length records of a LAS file say (LAS 1.4 R15), checked
/// against the size of the file.
struct LasHeader {
  std::uint8_t point_format = 0;
  std::uint16_t point_bytes = 0;
  std::uint64_t points = 0;
  std::uint64_t points_begin = 0;
  std::array<double, 3> scale = {};
  std::array<double, 3> offset = {};
  bool absolute_time = false;  ///< Adjusted standard GPS time, not seconds of a week.
  LasExtraFields extra = {};
  LasCrs crs = {};
};

/// Bytes of the point formats 0 to 10, and where time and colour lie (0: absent).
struct LasPointLayout {
  std::uint16_t bytes = 0;
  std::uint16_t time = 0;
  std::uint16_t color = 0;
};
inline constexpr std::array<LasPointLayout, 11> kLasLayouts = {{{20, 0, 0},
                                                                {28, 20, 0},
                                                                {26, 0, 20},
                                                                {34, 20, 28},
                                                                {57, 20, 0},
                                                                {63, 20, 28},
                                                                {30, 22, 0},
                                                                {36, 22, 30},
                                                                {38, 22, 30},
                                                                {59, 22, 0},
                                                                {67, 22, 30}}};

/// @returns kParse naming the file, the cause and the next step.
[[nodiscard]] Expected<LasHeader> read_las_header(InputFile& file);

}  // namespace hybridfusion
