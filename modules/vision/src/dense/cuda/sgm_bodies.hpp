#pragma once

// The steps of semi-global matching as bodies of device threads. Each is compiled for the device
// and for the host, where a loop over threads runs the same code: what the device computes can be
// tested without one. Plain C++17.

#include "sgm_problem.hpp"

#include <cstddef>
#include <cstdint>

#ifdef __CUDACC__
#define HF_DEVICE __host__ __device__
#else
#define HF_DEVICE
#endif

namespace hybridfusion::device {

inline constexpr int kHalfWidth = 4;  // census window of 9 x 7
inline constexpr int kHalfHeight = 3;
inline constexpr int kNoData = 31;  // half of the bits: as good as chance
inline constexpr std::int16_t kNever = 0x7fff;
inline constexpr int kMaxCandidates = 1024;  // of a pixel

/// The problem with its arrays where the bodies run, and what they compute.
struct SgmVolume {
  SgmProblem in = {};
  const std::uint64_t* begin = nullptr;  ///< First entry of each left pixel in costs and sums.
  std::uint64_t* left_codes = nullptr;
  std::uint64_t* right_codes = nullptr;
  std::uint8_t* costs = nullptr;
  std::int16_t* sums = nullptr;
  std::int16_t* right_disparity = nullptr;  ///< Of each right pixel.
  float* disparity = nullptr;

  [[nodiscard]] HF_DEVICE int right_width() const { return in.width + in.num_disparities - 1; }
};

HF_DEVICE inline int clamped(int value, int low, int high) {
  return value < low ? low : value > high ? high : value;
}

HF_DEVICE inline int bits_of(std::uint64_t word) {
#ifdef __CUDA_ARCH__
  return __popcll(word);
#else
  return __builtin_popcountll(word);
#endif
}

/// Census code of a pixel: as census.hpp, bit for bit.
HF_DEVICE inline std::uint64_t census_code(
    const std::uint8_t* grey, int width, int height, int x, int y) {
  const std::uint8_t centre = grey[static_cast<std::size_t>(y) * width + x];
  std::uint64_t code = 0;
  for (int v = y - kHalfHeight; v <= y + kHalfHeight; ++v) {
    const std::uint8_t* row = grey + static_cast<std::size_t>(clamped(v, 0, height - 1)) * width;
    for (int u = x - kHalfWidth; u <= x + kHalfWidth; ++u) {
      if (u == x && v == y) continue;
      code = (code << 1U) | (row[clamped(u, 0, width - 1)] < centre ? 1U : 0U);
    }
  }
  return code;
}

/// One thread a pixel of the right image, which covers those of the left one.
struct CensusBody {
  SgmVolume volume;
  HF_DEVICE void operator()(std::size_t item) const {
    const int width = volume.right_width();
    const int x = static_cast<int>(item % static_cast<std::size_t>(width));
    const int y = static_cast<int>(item / static_cast<std::size_t>(width));
    const SgmProblem& in = volume.in;
    volume.right_codes[item] = census_code(in.right, width, in.height, x, y);
    if (x >= in.width) return;
    volume.left_codes[static_cast<std::size_t>(y) * in.width + x] =
        census_code(in.left, in.width, in.height, x, y);
  }
};

/// Hamming distances of a left pixel's candidates; clears its sums.
struct CostBody {
  SgmVolume volume;
  HF_DEVICE void operator()(std::size_t item) const {
    const SgmProblem& in = volume.in;
    const int x = static_cast<int>(item % static_cast<std::size_t>(in.width));
    const std::size_t row = item / static_cast<std::size_t>(in.width);
    const std::uint64_t code = volume.left_codes[item];
    for (int k = 0; k < in.count[item]; ++k) {
      const std::size_t right =
          row * volume.right_width() +
          static_cast<std::size_t>(x - (in.low[item] + k) + in.num_disparities - 1);
      const int bits = bits_of(code ^ volume.right_codes[right]);
      volume.costs[volume.begin[item] + k] =
          static_cast<std::uint8_t>(in.right_mask[right] != 0 ? bits : kNoData);
      volume.sums[volume.begin[item] + k] = 0;
    }
  }
};

/// One path across the image in direction (dx, dy), worked by a group of lanes.
/// @tparam Lanes  `each(count, f)` calls f(k) for k in [0, count) and waits for all lanes;
///                `smallest(count, values)` is the minimum, known to every lane.
struct PathBody {
  SgmVolume volume;
  int dx = 1;
  int dy = 0;

  /// Lines begin at the border pixels that have no predecessor.
  [[nodiscard]] HF_DEVICE std::size_t num_lines() const {
    const std::size_t across = dy != 0 ? static_cast<std::size_t>(volume.in.width) : 0U;
    const std::size_t down = dx != 0 ? static_cast<std::size_t>(volume.in.height) : 0U;
    return across + down - (across > 0 && down > 0 ? 1U : 0U);
  }

  HF_DEVICE void start_of(std::size_t line, int& x, int& y) const {
    const int index = static_cast<int>(line);
    const int first_x = dx >= 0 ? 0 : volume.in.width - 1;
    const int first_y = dy >= 0 ? 0 : volume.in.height - 1;
    if (dy == 0) {
      x = first_x;
      y = index;
    } else if (index < volume.in.width) {
      x = index;
      y = first_y;
    } else {
      x = first_x;
      y = first_y + dy * (index - volume.in.width + 1);
    }
  }

  /// @param before, current  Room for kMaxCandidates each.
  template <class Lanes>
  HF_DEVICE void operator()(const Lanes& lanes,
                            std::size_t line,
                            std::int16_t* before,
                            std::int16_t* current) const {
    const SgmProblem& in = volume.in;
    int x = 0;
    int y = 0;
    start_of(line, x, y);
    int from_count = 0;
    int from_low = 0;
    int from_min = 0;
    int from_grey = 0;
    for (; x >= 0 && y >= 0 && x < in.width && y < in.height; x += dx, y += dy) {
      const std::size_t pixel = static_cast<std::size_t>(y) * in.width + x;
      const int count = in.count[pixel];
      const int low = in.low[pixel];
      const int grey = in.left[pixel];
      const int step = grey < from_grey ? from_grey - grey : grey - from_grey;
      const int jump = from_min + in.large_penalty[from_count == 0 ? 0 : step];
      const std::uint64_t begin = volume.begin[pixel];
      lanes.each(count, [&](int k) {
        // L(p, d) of Hirschmueller 2008, Eq. 13, as advance_path() has it.
        int least = 0;
        if (from_count > 0) {
          least = jump;
          const int at = low + k - from_low;
          const auto offer = [&](int index, int penalty) {
            if (index < 0 || index >= from_count) return;
            const int cost = before[index] + penalty;
            least = cost < least ? cost : least;
          };
          offer(at, 0);
          offer(at - 1, in.small_penalty);
          offer(at + 1, in.small_penalty);
        }
        const auto value = static_cast<std::int16_t>(volume.costs[begin + k] + least - from_min);
        current[k] = value;
        volume.sums[begin + k] = static_cast<std::int16_t>(volume.sums[begin + k] + value);
      });
      from_min = count > 0 ? lanes.smallest(count, current) : 0;
      from_count = count;
      from_low = low;
      from_grey = grey;
      std::int16_t* const former = before;
      before = current;
      current = former;
    }
  }
};

}  // namespace hybridfusion::device
