#pragma once

#include "map_search.hpp"

namespace hybridfusion {

/// Regions tell of a box of points whether it lies in them wholly or not at all.
struct Everything {
  [[nodiscard]] static bool covers(const Eigen::Vector3f&, const Eigen::Vector3f&) { return true; }
  [[nodiscard]] static bool misses(const Eigen::Vector3f&, const Eigen::Vector3f&) { return false; }
  [[nodiscard]] static bool contains(const Eigen::Vector3f&) { return true; }
};

struct InBox {
  MapBox box;

  [[nodiscard]] bool covers(const Eigen::Vector3f& min, const Eigen::Vector3f& max) const {
    return box.contains(min) && box.contains(max);
  }
  [[nodiscard]] bool misses(const Eigen::Vector3f& min, const Eigen::Vector3f& max) const {
    return (max.array() < box.min.array()).any() || (min.array() >= box.max.array()).any();
  }
  [[nodiscard]] bool contains(const Eigen::Vector3f& point) const { return box.contains(point); }
};

struct OutsideCube {
  Eigen::Vector3f center;
  float half_side_m;

  [[nodiscard]] bool covers(const Eigen::Vector3f& min, const Eigen::Vector3f& max) const {
    return (min - center).maxCoeff() > half_side_m || (center - max).maxCoeff() > half_side_m;
  }
  [[nodiscard]] bool misses(const Eigen::Vector3f& min, const Eigen::Vector3f& max) const {
    return !contains(min) && !contains(max);
  }
  [[nodiscard]] bool contains(const Eigen::Vector3f& point) const {
    return (point - center).cwiseAbs().maxCoeff() > half_side_m;
  }
};

/// From a point to a box of points.
inline float squared_gap(const Eigen::Vector3f& min,
                         const Eigen::Vector3f& max,
                         const Eigen::Vector3f& point) {
  return (min - point).cwiseMax(point - max).cwiseMax(0.0F).squaredNorm();
}

struct InBall {
  Eigen::Vector3f center;
  float squared_radius_m2;

  [[nodiscard]] bool covers(const Eigen::Vector3f& min, const Eigen::Vector3f& max) const {
    return (center - min).cwiseAbs().cwiseMax((max - center).cwiseAbs()).squaredNorm() <
           squared_radius_m2;
  }
  [[nodiscard]] bool misses(const Eigen::Vector3f& min, const Eigen::Vector3f& max) const {
    return squared_gap(min, max, center) >= squared_radius_m2;
  }
  [[nodiscard]] bool contains(const Eigen::Vector3f& point) const {
    return (point - center).squaredNorm() < squared_radius_m2;
  }
};

}  // namespace hybridfusion
