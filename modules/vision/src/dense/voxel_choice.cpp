#include "voxel_choice.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hybridfusion {
namespace {

using Entry = std::pair<std::uint64_t, const VoxelSums*>;

/// The 26 neighbours of voxels that are visited in ascending order: a column of three neighbours
/// moves forward with the visits, so that the table is read in order and not searched.
class Neighborhood {
 public:
  explicit Neighborhood(const std::vector<Entry>& entries) : entries_(entries) {}

  /// Calls `visit(step, sums)` for each occupied neighbour until that returns false.
  template <class Visit>
  bool all_of(std::uint64_t key, Visit&& visit) {
    const VoxelIndex at = voxel_of_key(key);
    for (std::size_t column = 0; column < next_.size(); ++column) {
      const VoxelIndex step(static_cast<int>(column / 3) - 1, static_cast<int>(column % 3) - 1, 0);
      const std::uint64_t first = voxel_key(at + step - VoxelIndex::UnitZ());
      std::size_t& next = next_[column];
      while (next < entries_.size() && entries_[next].first < first) ++next;
      for (std::size_t i = next; i < entries_.size() && entries_[i].first <= first + 2; ++i) {
        const int dz = static_cast<int>(entries_[i].first - first) - 1;
        if (entries_[i].first == key) continue;
        if (!visit(VoxelIndex(step.x(), step.y(), dz), *entries_[i].second)) return false;
      }
    }
    return true;
  }

 private:
  const std::vector<Entry>& entries_;
  std::array<std::size_t, 9> next_{};
};

bool thinly_sampled(Neighborhood& neighborhood, const VoxelSums& sums, int min_count) {
  constexpr float kAlongRay = 0.7F;  // cosine of the turn between a face and an edge of a voxel
  const Eigen::Vector3f ray = sums.towards_photo.stableNormalized();
  int count = sums.count;
  const bool foremost =
      neighborhood.all_of(sums.key, [&](const VoxelIndex& step, const VoxelSums& other) {
        if (std::abs(ray.dot(step.cast<float>().normalized())) < kAlongRay) {
          count += other.count;
          return true;
        }
        return other.weight < sums.weight || (other.weight == sums.weight && other.key > sums.key);
      });
  return foremost && count >= min_count;
}

}  // namespace

std::vector<const VoxelSums*> choose_voxels(const VoxelTable& voxels, int min_count) {
  std::vector<Entry> entries;
  entries.reserve(voxels.size());
  voxels.for_each([&](const VoxelSums& sums) { entries.emplace_back(sums.key, &sums); });
  std::ranges::sort(entries, {}, &Entry::first);
  Neighborhood neighborhood(entries);
  std::vector<const VoxelSums*> chosen;
  for (const auto& [key, sums] : entries) {
    if (sums->count >= min_count || thinly_sampled(neighborhood, *sums, min_count)) {
      chosen.push_back(sums);
    }
  }
  return chosen;
}

}  // namespace hybridfusion
