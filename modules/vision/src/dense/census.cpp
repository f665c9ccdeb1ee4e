#include "census.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace hybridfusion {
namespace {

constexpr int kWindowWidth = 2 * kCensusHalfWidth + 1;
constexpr int kWindowHeight = 2 * kCensusHalfHeight + 1;
constexpr std::size_t kComparisons = kWindowWidth * kWindowHeight - 1;
constexpr std::size_t kBytes = 8;

/// The image with its border repeated, so that windows need no bounds checks.
ImagePlane<std::uint8_t> padded(const ImagePlane<std::uint8_t>& grey) {
  ImagePlane<std::uint8_t> result(grey.width + 2 * kCensusHalfWidth,
                                  grey.height + 2 * kCensusHalfHeight);
  for (int y = 0; y < result.height; ++y) {
    const std::uint8_t* source = grey.row(std::clamp(y - kCensusHalfHeight, 0, grey.height - 1));
    std::uint8_t* target = result.row(y);
    std::fill_n(target, kCensusHalfWidth, source[0]);
    std::copy_n(source, grey.width, target + kCensusHalfWidth);
    std::fill_n(target + kCensusHalfWidth + grey.width, kCensusHalfWidth, source[grey.width - 1]);
  }
  return result;
}

/// One byte of the code of every pixel of a row from eight comparisons: byte lanes carry eight
/// times as many pixels as the words themselves would.
__attribute__((target_clones("avx2", "default"))) void compare_eight(
    const std::uint8_t* const* neighbors,
    const std::uint8_t* centre,
    std::uint8_t* out,
    int count) {
  const std::uint8_t* const n[8] = {neighbors[0],
                                    neighbors[1],
                                    neighbors[2],
                                    neighbors[3],
                                    neighbors[4],
                                    neighbors[5],
                                    neighbors[6],
                                    neighbors[7]};
  for (int x = 0; x < count; ++x) {
    unsigned bits = 0;
    for (int i = 0; i < 8; ++i) bits = (bits << 1U) | (n[i][x] < centre[x] ? 1U : 0U);
    out[x] = static_cast<std::uint8_t>(bits);
  }
}

__attribute__((target_clones("avx2", "default"))) void join_bytes(const std::uint8_t* bytes,
                                                                  std::size_t stride,
                                                                  std::uint64_t* codes,
                                                                  int count) {
  for (int x = 0; x < count; ++x) {
    std::uint64_t code = 0;
    for (std::size_t i = 0; i < kBytes; ++i) code = (code << 8U) | bytes[i * stride + x];
    codes[x] = code;
  }
}

}  // namespace

ImagePlane<std::uint64_t> census_transform(const ImagePlane<std::uint8_t>& grey) {
  const ImagePlane<std::uint8_t> source = padded(grey);
  ImagePlane<std::uint64_t> codes(grey.width, grey.height);
  const auto width = static_cast<std::size_t>(grey.width);
  std::vector<std::uint8_t> bytes(kBytes * width);
  for (int y = 0; y < grey.height; ++y) {
    const std::uint8_t* centre = source.row(y + kCensusHalfHeight) + kCensusHalfWidth;
    // Leading bits that nothing is compared for: the centre is not darker than itself.
    std::array<const std::uint8_t*, 8 * kBytes> neighbors{};
    neighbors.fill(centre);
    std::size_t next = neighbors.size() - kComparisons;
    for (int i = 0; i < kWindowWidth * kWindowHeight; ++i) {
      const std::uint8_t* neighbor = source.row(y + i / kWindowWidth) + i % kWindowWidth;
      if (neighbor != centre) neighbors[next++] = neighbor;
    }
    for (std::size_t i = 0; i < kBytes; ++i) {
      compare_eight(neighbors.data() + 8 * i, centre, bytes.data() + i * width, grey.width);
    }
    join_bytes(bytes.data(), width, codes.row(y), grey.width);
  }
  return codes;
}

}  // namespace hybridfusion
