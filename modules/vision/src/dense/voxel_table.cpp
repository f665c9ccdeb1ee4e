#include "voxel_table.hpp"

#include <algorithm>

namespace hybridfusion {

/// The key's slot or the first free one on its way.
std::size_t VoxelTable::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  // Fibonacci hashing: neighbouring voxels differ in low bits of three fields.
  auto slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 20U) & mask;
  while (slots_[slot] != kEmpty && entry(slots_[slot]).key != key) slot = (slot + 1) & mask;
  return slot;
}

void VoxelTable::grow() {
  slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), kEmpty);
  for (std::size_t i = 0; i < size_; ++i) {
    slots_[slot_of(entry(i).key)] = static_cast<std::uint32_t>(i);
  }
}

VoxelSums& VoxelTable::operator[](std::uint64_t key) {
  if (2 * size_ >= slots_.size()) grow();
  const std::size_t slot = slot_of(key);
  if (slots_[slot] == kEmpty) {
    if (size_ == blocks_.size() * kBlockSize) blocks_.push_back(std::make_unique<Block>());
    slots_[slot] = static_cast<std::uint32_t>(size_);
    entry(size_).key = key;
    ++size_;
  }
  return entry(slots_[slot]);
}

}  // namespace hybridfusion
