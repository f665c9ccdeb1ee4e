#pragma once

#include "map_search.hpp"
#include "street_points.hpp"

#include <memory>

namespace hybridfusion::bench {

/// Libraries that a map could be made of, with the verbs of our own maps. They thin nothing; those
/// that cannot take or drop points are built anew.

/// nanoflann's static k-d tree.
class NanoflannMap {
 public:
  NanoflannMap();
  ~NanoflannMap();
  void insert(const Points& points);
  void erase_box(const MapBox& box);
  void nearest(const Eigen::Vector3f& query, int count, float radius_m, MapNeighbors& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// nanoflann's forest of static trees that are merged as points come in.
class NanoflannDynamicMap {
 public:
  NanoflannDynamicMap();
  ~NanoflannDynamicMap();
  void insert(const Points& points);
  void erase_box(const MapBox& box);
  void nearest(const Eigen::Vector3f& query, int count, float radius_m, MapNeighbors& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// pcl::KdTreeFLANN.
class PclKdTreeMap {
 public:
  PclKdTreeMap();
  ~PclKdTreeMap();
  void insert(const Points& points);
  void erase_box(const MapBox& box);
  void nearest(const Eigen::Vector3f& query, int count, float radius_m, MapNeighbors& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// pcl::octree::OctreePointCloudSearch with leaves of 1 m.
class PclOctreeMap {
 public:
  PclOctreeMap();
  ~PclOctreeMap();
  void insert(const Points& points);
  void erase_box(const MapBox& box);
  void nearest(const Eigen::Vector3f& query, int count, float radius_m, MapNeighbors& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hybridfusion::bench
