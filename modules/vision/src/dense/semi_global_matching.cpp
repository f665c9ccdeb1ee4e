#include "semi_global_matching.hpp"

#include "census.hpp"
#include "disparity_selection.hpp"
#include "path_aggregation.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

namespace hybridfusion {
namespace {

constexpr std::uint8_t kNoDataCost = 31;  // half of the bits: as good as chance

/// Hamming distances of one row's candidates. `codes` and `data` (255 where there is data, else 0)
/// are the right row backwards, so that rising disparities read forwards.
__attribute__((target_clones("popcnt", "default"))) void hamming_row(const CandidateRow& row,
                                                                     const std::uint64_t* left,
                                                                     const std::uint64_t* codes,
                                                                     const std::uint8_t* data,
                                                                     std::uint8_t* costs) {
  for (int x = 0; x < row.width; ++x) {
    const int start = row.width - 1 - x + row.low[x];
    const int count = row.count[x];
    std::uint8_t* out = costs + static_cast<std::size_t>(row.block[x]) * kDisparityLanes;
    const std::uint64_t code = left[x];
    for (int k = 0; k < count; ++k) {
      out[k] = static_cast<std::uint8_t>(std::popcount(code ^ codes[start + k]));
    }
    for (int k = 0; k < count; ++k) {
      const std::uint8_t mask = data[start + k];
      out[k] = static_cast<std::uint8_t>((out[k] & mask) | (kNoDataCost & ~mask));
    }
  }
}

/// Directions of the paths that arrive from the row above (below, on the way back).
std::vector<int> row_directions(bool diagonal_paths) {
  return diagonal_paths ? std::vector<int>{0, 1, -1} : std::vector<int>{0};
}

/// Paths that cross from strip to strip: one state for each direction.
using PathStates = std::array<PathRow, 3>;

/// Matches the images in strips of rows. Only one strip's costs and sums are in memory; paths from
/// above are computed twice, first to know where each strip begins, so that the result does not
/// depend on the strips.
class Matcher {
 public:
  Matcher(const RectifiedImages& images,
          const DisparityRanges& ranges,
          const StereoOptions& options);
  [[nodiscard]] ImagePlane<float> match();

 private:
  struct Strip {
    int begin = 0;
    int end = 0;
  };
  void divide_into_strips();
  [[nodiscard]] CandidateRow row(int y);
  void load(const Strip& strip);
  void aggregate_down(const Strip& strip, PathStates& states);
  void advance(int y, int from_y, PathStates& states);

  const RectifiedImages& images_;
  const DisparityRanges& ranges_;
  const StereoOptions& options_;
  const StepPenalties penalties_;
  const std::vector<int> directions_;
  const ImagePlane<std::uint64_t> left_codes_;
  const ImagePlane<std::uint64_t> right_codes_;
  std::vector<std::uint32_t> blocks_;   // width + 1 a row: first block of each pixel
  std::vector<std::size_t> row_begin_;  // first block of each row among those of its strip
  std::vector<Strip> strips_;
  std::vector<std::uint8_t> costs_;
  std::vector<std::int16_t> sums_;
  PathRow scratch_;
};

Matcher::Matcher(const RectifiedImages& images,
                 const DisparityRanges& ranges,
                 const StereoOptions& options)
    : images_(images),
      ranges_(ranges),
      options_(options),
      penalties_(step_penalties(options.smoothness_small, options.smoothness_large)),
      directions_(row_directions(options.diagonal_paths)),
      left_codes_(census_transform(images.left)),
      right_codes_(census_transform(images.right)) {
  divide_into_strips();
}

void Matcher::divide_into_strips() {
  constexpr std::size_t kBytesPerBlock =
      kDisparityLanes * (sizeof(std::uint8_t) + sizeof(std::int16_t));
  const std::size_t max_blocks =
      (static_cast<std::size_t>(options_.max_volume_mib) << 20U) / kBytesPerBlock;
  const auto width = static_cast<std::size_t>(images_.left.width);
  blocks_.reserve((width + 1) * static_cast<std::size_t>(images_.left.height));
  std::size_t in_strip = 0;
  for (int y = 0; y < images_.left.height; ++y) {
    const std::int16_t* count = ranges_.count.row(y);
    std::uint32_t block = 0;
    for (std::size_t x = 0; x < width; ++x) {
      blocks_.push_back(block);
      block += static_cast<std::uint32_t>((count[x] + kDisparityLanes - 1) / kDisparityLanes);
    }
    blocks_.push_back(block);
    if (strips_.empty() || in_strip + block > max_blocks) {
      strips_.push_back({.begin = y, .end = y});
      in_strip = 0;
    }
    strips_.back().end = y + 1;
    row_begin_.push_back(in_strip);
    in_strip += block;
  }
}

CandidateRow Matcher::row(int y) {
  const std::size_t first = row_begin_[static_cast<std::size_t>(y)] * kDisparityLanes;
  return {.width = images_.left.width,
          .low = ranges_.low.row(y),
          .count = ranges_.count.row(y),
          .block = blocks_.data() +
                   static_cast<std::size_t>(y) * (static_cast<std::size_t>(images_.left.width) + 1),
          .costs = costs_.data() + first,
          .sums = sums_.data() + first,
          .grey = images_.left.row(y)};
}

/// Matching costs of the strip; path costs summed up so far are dropped.
void Matcher::load(const Strip& strip) {
  const CandidateRow last = row(strip.end - 1);
  const std::size_t size =
      (row_begin_[static_cast<std::size_t>(strip.end - 1)] + last.block[last.width]) *
      kDisparityLanes;
  costs_.resize(std::max(costs_.size(), size));
  sums_.assign(std::max(sums_.size(), size), 0);
  std::vector<std::uint64_t> codes(static_cast<std::size_t>(images_.right.width));
  std::vector<std::uint8_t> data(codes.size());
  for (int y = strip.begin; y < strip.end; ++y) {
    const std::uint64_t* right = right_codes_.row(y);
    std::reverse_copy(right, right + codes.size(), codes.begin());
    const std::uint8_t* mask = images_.right_mask.row(y);
    std::transform(mask, mask + data.size(), data.rbegin(), [](std::uint8_t m) {
      return static_cast<std::uint8_t>(m != 0 ? 255 : 0);
    });
    const std::size_t first = row_begin_[static_cast<std::size_t>(y)] * kDisparityLanes;
    hamming_row(row(y), left_codes_.row(y), codes.data(), data.data(), costs_.data() + first);
  }
}

void Matcher::advance(int y, int from_y, PathStates& states) {
  const CandidateRow to = row(y);
  const bool first = from_y < 0 || from_y >= images_.left.height;
  const CandidateRow from = row(first ? y : from_y);
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    aggregate_from(to, from, directions_[i], penalties_, states[i], scratch_);
  }
}

void Matcher::aggregate_down(const Strip& strip, PathStates& states) {
  for (int y = strip.begin; y < strip.end; ++y) advance(y, y - 1, states);
}

ImagePlane<float> Matcher::match() {
  ImagePlane<float> result(
      images_.left.width, images_.left.height, std::numeric_limits<float>::quiet_NaN());
  std::vector<PathStates> at_begin(strips_.size());
  for (std::size_t i = 0; i + 1 < strips_.size(); ++i) {
    at_begin[i + 1] = at_begin[i];
    load(strips_[i]);
    aggregate_down(strips_[i], at_begin[i + 1]);
  }
  DisparitySelection selection(images_, options_);
  PathStates from_below;
  for (std::size_t i = strips_.size(); i-- > 0;) {
    load(strips_[i]);
    aggregate_down(strips_[i], at_begin[i]);
    for (int y = strips_[i].end - 1; y >= strips_[i].begin; --y) {
      aggregate_along(row(y), penalties_);
      advance(y, y + 1, from_below);
      selection.select(row(y), y, result.row(y));
    }
  }
  return result;
}

}  // namespace

DisparityRanges full_ranges(const RectifiedImages& images) {
  DisparityRanges ranges{.low = {images.left.width, images.left.height, 0},
                         .count = {images.left.width, images.left.height, 0}};
  for (std::size_t i = 0; i < ranges.count.values.size(); ++i) {
    if (images.left_mask.values[i] != 0) {
      ranges.count.values[i] = static_cast<std::int16_t>(images.num_disparities);
    }
  }
  return ranges;
}

ImagePlane<float> match_semi_globally(const RectifiedImages& images,
                                      const DisparityRanges& ranges,
                                      const StereoOptions& options) {
  return Matcher(images, ranges, options).match();
}

}  // namespace hybridfusion
