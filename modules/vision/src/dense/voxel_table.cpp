#include "voxel_table.hpp"

#include <hybridfusion/core/error.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr unsigned kColorBits = 21;
constexpr std::int32_t kMostColors = 8192;
static_assert(255 * kMostColors < 1 << kColorBits);

}  // namespace

void VoxelSums::count_color(const Rgb8& color) {
  if (count < kMostColors) {
    for (unsigned c = 0; c < 3; ++c) colors += std::uint64_t{color[c]} << (c * kColorBits);
  }
  ++count;
}

Rgb8 VoxelSums::mean_color() const {
  constexpr std::uint64_t kMask = (1U << kColorBits) - 1;
  const auto counted = static_cast<float>(std::min(count, kMostColors));
  Rgb8 mean{};
  for (unsigned c = 0; c < 3; ++c) {
    const auto sum = static_cast<float>(colors >> (c * kColorBits) & kMask);
    mean[c] = static_cast<std::uint8_t>(std::lround(sum / counted));
  }
  return mean;
}

/// The key's slot or the first free one on its way.
std::size_t VoxelTable::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  // Fibonacci hashing of cubes of 4 x 4 x 4 voxels, whose slots lie together: what a photo shows
  // next to each other fits the cache. A key's fields are 21 bits wide; only the highest bits of
  // the product depend on all of them.
  constexpr std::uint64_t kWithin = (3ULL << 42U) | (3ULL << 21U) | 3ULL;
  const std::uint64_t product = (key & ~kWithin) * 0x9e3779b97f4a7c15ULL;
  const std::uint64_t cube = product >> static_cast<unsigned>(std::countl_zero(mask) + 6);
  const std::uint64_t within = (key >> 42U & 3U) << 4U | (key >> 21U & 3U) << 2U | (key & 3U);
  auto slot = static_cast<std::size_t>(cube << 6U | within) & mask;
  while (slots_[slot] != kEmpty && entry(slots_[slot]).key != key) slot = (slot + 1) & mask;
  return slot;
}

void VoxelTable::grow() {
  slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), kEmpty);
  for (std::size_t i = 0; i < size_; ++i) {
    slots_[slot_of(entry(i).key)] = static_cast<std::uint32_t>(i);
  }
}

void VoxelTable::close() {
  slots_ = {};
  is_closed_ = true;
}

VoxelSums& VoxelTable::operator[](std::uint64_t key) {
  HF_CHECK(!is_closed_);
  if (4 * size_ >= 3 * slots_.size()) grow();
  const std::size_t slot = slot_of(key);
  if (slots_[slot] == kEmpty) {
    if (size_ == blocks_.size() * kBlockSize) blocks_.emplace_back().reserve(kBlockSize);
    slots_[slot] = static_cast<std::uint32_t>(size_);
    blocks_.back().push_back({.key = key});
    ++size_;
  }
  return entry(slots_[slot]);
}

}  // namespace hybridfusion
