#pragma once

#include "map_search.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace hybridfusion::testing {

inline bool before(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

/// Points whose order does not matter.
inline std::vector<Eigen::Vector3f> sorted(std::vector<Eigen::Vector3f> points) {
  std::ranges::sort(points, &before);
  return points;
}

/// What a thinning map makes of the points of one voxel, one after the other.
enum class Thinning {
  kMean,             // of the first 100 points
  kNearestToCenter,  // of the means that the calls of insert() brought
};

/// Slow twin of the maps: one entry a voxel, every query looks at all of them.
class SlowMap {
 public:
  SlowMap(float voxel_m, Thinning thinning) : inverse_(1.0F / voxel_m), thinning_(thinning) {}

  void insert(const std::vector<Eigen::Vector3f>& points) {
    for (const Eigen::Vector3f& point :
         thinning_ == Thinning::kMean ? points : means_of_voxels(points)) {
      auto& [kept, count] = voxels_[key_of(point)];
      ++count;
      if (thinning_ == Thinning::kMean) {
        if (count <= 100) kept += (point - kept) / static_cast<float>(count);
      } else if (count == 1 || off_center(point) < off_center(kept)) {
        kept = point;
      }
    }
  }
  template <class Predicate>
  void erase_if(const Predicate& goes) {
    std::erase_if(voxels_, [&](const auto& entry) { return goes(entry.second.kept); });
  }
  [[nodiscard]] std::vector<Eigen::Vector3f> points() const {
    std::vector<Eigen::Vector3f> out;
    for (const auto& [key, voxel] : voxels_) out.push_back(voxel.kept);
    return sorted(out);
  }
  template <class Predicate>
  [[nodiscard]] std::vector<Eigen::Vector3f> points_if(const Predicate& wanted) const {
    std::vector<Eigen::Vector3f> out = points();
    std::erase_if(out, [&](const Eigen::Vector3f& point) { return !wanted(point); });
    return out;
  }
  /// Squared distances of the nearest points, ascending.
  [[nodiscard]] std::vector<float> nearest(const Eigen::Vector3f& query,
                                           std::size_t count,
                                           float radius_m) const {
    std::vector<float> distances;
    for (const auto& [key, voxel] : voxels_) {
      const float d = (voxel.kept - query).squaredNorm();
      if (d < radius_m * radius_m) distances.push_back(d);
    }
    std::ranges::sort(distances);
    if (distances.size() > count) distances.resize(count);
    return distances;
  }

 private:
  [[nodiscard]] std::uint64_t key_of(const Eigen::Vector3f& point) const {
    return voxel_key((point.array() * inverse_).floor().cast<int>());
  }
  [[nodiscard]] std::vector<Eigen::Vector3f> means_of_voxels(
      const std::vector<Eigen::Vector3f>& points) const {
    std::map<std::uint64_t, std::vector<Eigen::Vector3f>> groups;
    for (const Eigen::Vector3f& point : points) groups[key_of(point)].push_back(point);
    std::vector<Eigen::Vector3f> means;
    for (const auto& [key, group] : groups) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (const Eigen::Vector3f& point : sorted(group)) sum += point;
      const Eigen::Vector3f mean = sum / static_cast<float>(group.size());
      means.push_back(key_of(mean) == key ? mean : sorted(group).front());
    }
    return means;
  }
  [[nodiscard]] float off_center(const Eigen::Vector3f& point) const {
    const Eigen::Array3f scaled = point.array() * inverse_;
    return (scaled - scaled.floor() - 0.5F).matrix().squaredNorm();
  }

  struct Voxel {
    Eigen::Vector3f kept = Eigen::Vector3f::Zero();
    int count = 0;
  };

  float inverse_;
  Thinning thinning_;
  std::map<std::uint64_t, Voxel> voxels_ = {};
};

}  // namespace hybridfusion::testing
