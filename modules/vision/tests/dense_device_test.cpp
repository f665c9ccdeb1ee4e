#include "dense/cuda/sgm_steps.hpp"
#include "dense/device_matcher.hpp"
#include "dense/path_aggregation.hpp"
#include "dense/semi_global_matching.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

/// The lanes of a group one after the other.
struct HostLanes {
  template <class Body>
  void each(int count, const Body& body) const {
    for (int k = 0; k < count; ++k) body(k);
  }
  int smallest(int count, const std::int16_t* values) const {
    return *std::min_element(values, values + count);
  }
};

/// The threads of a device one after the other.
struct HostRunner {
  template <class Body>
  void items(std::size_t count, const Body& body) const {
    for (std::size_t i = 0; i < count; ++i) body(i);
  }
  void lines(const device::PathBody& body) const {
    std::vector<std::int16_t> before(device::kMaxCandidates);
    std::vector<std::int16_t> current(device::kMaxCandidates);
    for (std::size_t i = 0; i < body.num_lines(); ++i) {
      body(HostLanes{}, i, before.data(), current.data());
    }
  }
};

/// What the device computes, on the host.
ImagePlane<float> emulated(const RectifiedImages& images,
                           const DisparityRanges& ranges,
                           const StereoOptions& options) {
  const StepPenalties penalties =
      step_penalties(options.smoothness_small, options.smoothness_large);
  const std::size_t left = images.left.values.size();
  const std::size_t right = images.right.values.size();
  std::vector<std::uint64_t> begin(left);
  std::uint64_t entries = 0;
  for (std::size_t i = 0; i < left; ++i) {
    begin[i] = entries;
    entries += static_cast<std::uint64_t>(ranges.count.values[i]);
  }
  std::vector<std::uint64_t> left_codes(left);
  std::vector<std::uint64_t> right_codes(right);
  std::vector<std::uint8_t> costs(entries);
  std::vector<std::int16_t> sums(entries);
  std::vector<std::int16_t> right_disparity(right);
  ImagePlane<float> disparity(images.left.width, images.left.height);
  device::run_steps(HostRunner{},
                    {.in = sgm_problem(images, ranges, penalties, options),
                     .begin = begin.data(),
                     .left_codes = left_codes.data(),
                     .right_codes = right_codes.data(),
                     .costs = costs.data(),
                     .sums = sums.data(),
                     .right_disparity = right_disparity.data(),
                     .disparity = disparity.values.data()});
  return disparity;
}

/// Two surfaces with noise, holes in both masks.
RectifiedImages pair_of(int width, int height, int num_disparities, std::uint64_t seed) {
  Random random(seed, "device test");
  const int right_width = width + num_disparities - 1;
  RectifiedImages pair{.left = {width, height},
                       .right = {right_width, height},
                       .left_mask = {width, height, 255},
                       .right_mask = {right_width, height, 255},
                       .num_disparities = num_disparities};
  for (std::uint8_t& v : pair.right.values) v = static_cast<std::uint8_t>(random.index(256));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int k = std::min(num_disparities - 2, 2 + (x > width / 2 ? 3 : 0) + y / 8);
      const int noise = static_cast<int>(random.index(13)) - 6;
      pair.left.at(x, y) = static_cast<std::uint8_t>(
          std::clamp(pair.right.at(x - k + num_disparities - 1, y) + noise, 0, 255));
      if (random.index(20) == 0) pair.left_mask.at(x, y) = 0;
    }
    for (int x = 0; x < 3; ++x) {
      pair.right_mask.at(static_cast<int>(random.index(static_cast<std::uint32_t>(right_width))),
                         y) = 0;
    }
  }
  return pair;
}

/// Candidates as a coarser level leaves them: another few at each pixel, and jumps between.
DisparityRanges narrow_ranges(const RectifiedImages& images, std::uint64_t seed) {
  Random random(seed, "device ranges");
  DisparityRanges ranges = full_ranges(images);
  const auto total = static_cast<std::uint32_t>(images.num_disparities);
  for (std::size_t i = 0; i < ranges.count.values.size(); ++i) {
    if (ranges.count.values[i] == 0) continue;
    const std::uint32_t count = 1 + random.index(total);
    ranges.count.values[i] = static_cast<std::int16_t>(count);
    ranges.low.values[i] = static_cast<std::int16_t>(random.index(total - count + 1));
  }
  return ranges;
}

void expect_the_same_bits(const ImagePlane<float>& actual, const ImagePlane<float>& expected) {
  ASSERT_EQ(actual.values.size(), expected.values.size());
  std::size_t different = 0;
  std::size_t valid = 0;
  for (std::size_t i = 0; i < actual.values.size(); ++i) {
    const bool both_none = std::isnan(actual.values[i]) && std::isnan(expected.values[i]);
    const bool same = std::bit_cast<std::uint32_t>(actual.values[i]) ==
                      std::bit_cast<std::uint32_t>(expected.values[i]);
    different += !both_none && !same ? 1U : 0U;
    valid += std::isnan(expected.values[i]) ? 0U : 1U;
  }
  EXPECT_EQ(different, 0U);
  EXPECT_GT(valid, actual.values.size() / 10);
}

struct Case {
  int width;
  int height;
  int num_disparities;
  bool diagonal_paths;
  bool narrow;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> kCases = {{57, 31, 13, false, false},
                                           {57, 31, 13, true, false},
                                           {40, 50, 37, true, false},
                                           {64, 33, 70, false, true},
                                           {33, 64, 21, true, true}};
  return kCases;
}

TEST(DeviceMatching, BodiesOfTheDeviceOnTheHostGiveTheDisparitiesOfTheCpuBitForBit) {
  for (const Case& c : cases()) {
    const RectifiedImages images = pair_of(c.width, c.height, c.num_disparities, 7);
    DisparityRanges ranges = full_ranges(images);
    if (c.narrow) ranges = narrow_ranges(images, 9);
    StereoOptions options;
    options.diagonal_paths = c.diagonal_paths;
    if (c.narrow) options.uniqueness = 0.0;  // random ranges leave little that is unique
    SCOPED_TRACE(c.num_disparities);
    const ImagePlane<float> expected = match_semi_globally(images, ranges, options);
    const ImagePlane<float> actual = emulated(images, ranges, options);
    if (!c.narrow) {
      expect_the_same_bits(actual, expected);
      continue;
    }
    for (std::size_t i = 0; i < actual.values.size(); ++i) {
      const bool both_none = std::isnan(actual.values[i]) && std::isnan(expected.values[i]);
      EXPECT_TRUE(both_none || actual.values[i] == expected.values[i]) << i;
    }
  }
}

TEST(DeviceMatching, TheDeviceGivesTheDisparitiesOfTheCpuBitForBit) {
  StereoOptions options;
  options.backend = "cuda";
  std::string log;
  RunContext ctx;
  ctx.log = [&](LogLevel, std::string_view text) { log += text; };
  const auto device = DeviceMatcher::open(options, ctx);
  if (!device) GTEST_SKIP() << "no comparison with a CUDA device: " << log;
  for (const Case& c : cases()) {
    const RectifiedImages images = pair_of(c.width, c.height, c.num_disparities, 7);
    const DisparityRanges ranges = c.narrow ? narrow_ranges(images, 9) : full_ranges(images);
    options.diagonal_paths = c.diagonal_paths;
    const auto actual = device->match(images, ranges, options);
    ASSERT_TRUE(actual) << log;
    const ImagePlane<float> expected = match_semi_globally(images, ranges, options);
    for (std::size_t i = 0; i < expected.values.size(); ++i) {
      const bool both_none = std::isnan(actual->values[i]) && std::isnan(expected.values[i]);
      EXPECT_TRUE(both_none || actual->values[i] == expected.values[i]) << i;
    }
  }
}

TEST(DeviceMatching, WithoutADeviceTheCpuMatchesAndOnlyAWishForOneIsAnswered) {
  for (const char* backend : {"auto", "cpu", "cuda"}) {
    StereoOptions options;
    options.backend = backend;
    std::string warnings;
    RunContext ctx;
    ctx.log = [&](LogLevel level, std::string_view text) {
      if (level == LogLevel::kWarning) warnings += text;
    };
    const auto device = DeviceMatcher::open(options, ctx);
    if (device) GTEST_SKIP() << "there is a CUDA device";
    if (std::string(backend) == "cuda") {
      EXPECT_THAT(warnings, HasSubstr("on the CPU"));
    } else {
      EXPECT_EQ(warnings, "");
    }
  }
}

}  // namespace
}  // namespace hybridfusion
