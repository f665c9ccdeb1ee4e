#pragma once

// Included by CUDA sources too: plain C++17, no other header of the project.

#include <cstddef>
#include <cstdint>

namespace hybridfusion::device {

/// A rectified pair as semi_global_matching.hpp has it, in bare arrays, rows from the top.
struct SgmProblem {
  int width = 0;  ///< Of the left image; the right one is num_disparities - 1 wider.
  int height = 0;
  int num_disparities = 0;
  const std::uint8_t* left = nullptr;
  const std::uint8_t* right = nullptr;
  const std::uint8_t* right_mask = nullptr;
  const std::int16_t* low = nullptr;            ///< First candidate of each left pixel.
  const std::int16_t* count = nullptr;          ///< Candidates of each left pixel.
  const std::int16_t* large_penalty = nullptr;  ///< P2 by grey step, 256 entries.
  int small_penalty = 0;                        ///< P1
  bool diagonal_paths = false;
  double uniqueness = 0.0;
  double max_left_right_px = 0.0;
};

/// Why there is no usable device; nullptr: there is one.
[[nodiscard]] const char* device_problem();

/// Matches on the device. @param disparity  width * height; NaN where there is none.
/// @returns nullptr, or what CUDA found wrong (a constant text).
[[nodiscard]] const char* match_on_device(const SgmProblem& problem, float* disparity);

}  // namespace hybridfusion::device
