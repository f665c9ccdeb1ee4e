#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

struct Neighbor {
  std::size_t index = 0;          ///< Into the points given to the tree.
  float squared_distance_m2 = 0;  ///< [m^2]
};

/// Static k-d tree over points that must outlive it (nanoflann behind it). Queries are thread-safe.
class KdTree {
 public:
  explicit KdTree(std::span<const Eigen::Vector3f> points);
  ~KdTree();
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;

  /// The `count` nearest points, nearest first; fewer when the tree is smaller. Reuses `out`.
  void nearest(const Eigen::Vector3f& query, std::size_t count, std::vector<Neighbor>& out) const;
  /// The `count` nearest of the points strictly nearer than `radius_m`, nearest first.
  void nearest(const Eigen::Vector3f& query,
               std::size_t count,
               float radius_m,
               std::vector<Neighbor>& out) const;
  /// All points strictly nearer than `radius_m`, nearest first.
  void within(const Eigen::Vector3f& query, float radius_m, std::vector<Neighbor>& out) const;
  /// The nearest point; index == size() and infinite distance for an empty tree.
  [[nodiscard]] Neighbor nearest(const Eigen::Vector3f& query) const;
  [[nodiscard]] std::size_t size() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hybridfusion
