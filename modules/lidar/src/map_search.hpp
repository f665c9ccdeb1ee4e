#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// Neighbours of a query, nearest first.
struct MapNeighbors {
  static constexpr int kCapacity = 8;
  std::array<Eigen::Vector3f, kCapacity> points = {};
  std::array<float, kCapacity> squared_distances_m2 = {};
  int count = 0;
};

/// Half-open box [min, max) in the map frame [m].
struct MapBox {
  Eigen::Vector3f min = Eigen::Vector3f::Zero();
  Eigen::Vector3f max = Eigen::Vector3f::Zero();

  [[nodiscard]] bool contains(const Eigen::Vector3f& point) const {
    return (point.array() >= min.array()).all() && (point.array() < max.array()).all();
  }
};

/// The `count` nearest of the points offered that are strictly nearer than a radius.
class NearestPoints {
 public:
  /// @pre 0 < count <= MapNeighbors::kCapacity
  NearestPoints(int count, float radius_m, MapNeighbors& best)
      : count_(count), limit_(radius_m * radius_m), best_(best) {
    best_.count = 0;
  }
  /// A point must have a smaller squared distance to be kept.
  [[nodiscard]] float limit() const { return limit_; }
  void offer(const Eigen::Vector3f& point, float distance) {
    if (!(distance < limit_)) return;
    int at = best_.count < count_ ? best_.count++ : count_ - 1;
    for (; at > 0 && best_.squared_distances_m2[at - 1] > distance; --at) {
      best_.squared_distances_m2[at] = best_.squared_distances_m2[at - 1];
      best_.points[at] = best_.points[at - 1];
    }
    best_.squared_distances_m2[at] = distance;
    best_.points[at] = point;
    if (best_.count == count_) limit_ = best_.squared_distances_m2[count_ - 1];
  }

 private:
  int count_;
  float limit_;
  MapNeighbors& best_;
};

}  // namespace hybridfusion
