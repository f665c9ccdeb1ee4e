#include "peer_maps.hpp"

#include <optional>

#include <nanoflann.hpp>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/octree/octree_search.h>

namespace hybridfusion::bench {
namespace {

struct Dataset {
  Points points = {};

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return points[index][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  [[nodiscard]] bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};
using Metric = nanoflann::L2_Simple_Adaptor<float, Dataset>;
using StaticIndex = nanoflann::KDTreeSingleIndexAdaptor<Metric, Dataset, 3, std::uint32_t>;
using DynamicIndex = nanoflann::KDTreeSingleIndexDynamicAdaptor<Metric, Dataset, 3, std::uint32_t>;
const nanoflann::KDTreeSingleIndexAdaptorParams kLeaves(16);

template <class Index>
void find(const Index& index,
          const Points& points,
          const Eigen::Vector3f& query,
          int count,
          float radius_m,
          MapNeighbors& out) {
  std::array<std::uint32_t, MapNeighbors::kCapacity> found{};
  nanoflann::KNNResultSet<float, std::uint32_t> result(static_cast<std::size_t>(count));
  result.init(found.data(), out.squared_distances_m2.data());
  index.findNeighbors(result, query.data(), nanoflann::SearchParams());
  out.count = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (out.squared_distances_m2[i] >= radius_m * radius_m) break;
    out.points[i] = points[found[i]];
    ++out.count;
  }
}

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

void append(const Points& points, Cloud& cloud) {
  for (const Eigen::Vector3f& p : points) cloud.push_back({p.x(), p.y(), p.z()});
}

void erase(const MapBox& box, Cloud& cloud) {
  std::erase_if(cloud.points, [&](const auto& p) { return box.contains(p.getVector3fMap()); });
  cloud.width = static_cast<std::uint32_t>(cloud.size());
}

template <class Search>
void find_in_cloud(Search& search,
                   const Cloud& cloud,
                   const Eigen::Vector3f& query,
                   int count,
                   float radius_m,
                   MapNeighbors& out) {
  thread_local pcl::Indices found;
  thread_local std::vector<float> distances;
  search.nearestKSearch(pcl::PointXYZ(query.x(), query.y(), query.z()), count, found, distances);
  out.count = 0;
  for (std::size_t i = 0; i < found.size() && distances[i] < radius_m * radius_m; ++i) {
    out.points[i] = cloud[static_cast<std::size_t>(found[i])].getVector3fMap();
    out.squared_distances_m2[i] = distances[i];
    ++out.count;
  }
}

}  // namespace

struct NanoflannMap::Impl {
  Dataset data = {};
  std::optional<StaticIndex> index = {};

  void build() { index.emplace(3, data, kLeaves); }
};
NanoflannMap::NanoflannMap() : impl_(std::make_unique<Impl>()) {}
NanoflannMap::~NanoflannMap() = default;
void NanoflannMap::insert(const Points& points) {
  impl_->data.points.insert(impl_->data.points.end(), points.begin(), points.end());
  impl_->build();
}
void NanoflannMap::erase_box(const MapBox& box) {
  std::erase_if(impl_->data.points, [&](const auto& p) { return box.contains(p); });
  impl_->build();
}
void NanoflannMap::nearest(const Eigen::Vector3f& query,
                           int count,
                           float radius_m,
                           MapNeighbors& out) const {
  find(*impl_->index, impl_->data.points, query, count, radius_m, out);
}

struct NanoflannDynamicMap::Impl {
  Dataset data = {};
  DynamicIndex index{3, data, kLeaves};
};
NanoflannDynamicMap::NanoflannDynamicMap() : impl_(std::make_unique<Impl>()) {}
NanoflannDynamicMap::~NanoflannDynamicMap() = default;
void NanoflannDynamicMap::insert(const Points& points) {
  const auto first = static_cast<std::uint32_t>(impl_->data.points.size());
  impl_->data.points.insert(impl_->data.points.end(), points.begin(), points.end());
  impl_->index.addPoints(first, static_cast<std::uint32_t>(impl_->data.points.size() - 1));
}
void NanoflannDynamicMap::erase_box(const MapBox& box) {
  for (std::size_t i = 0; i < impl_->data.points.size(); ++i) {
    if (box.contains(impl_->data.points[i])) impl_->index.removePoint(i);
  }
}
void NanoflannDynamicMap::nearest(const Eigen::Vector3f& query,
                                  int count,
                                  float radius_m,
                                  MapNeighbors& out) const {
  find(impl_->index, impl_->data.points, query, count, radius_m, out);
}

struct PclKdTreeMap::Impl {
  Cloud::Ptr cloud = std::make_shared<Cloud>();
  std::optional<pcl::KdTreeFLANN<pcl::PointXYZ>> index = {};

  void build() {
    index.emplace();
    index->setInputCloud(cloud);
  }
};
PclKdTreeMap::PclKdTreeMap() : impl_(std::make_unique<Impl>()) {}
PclKdTreeMap::~PclKdTreeMap() = default;
void PclKdTreeMap::insert(const Points& points) {
  append(points, *impl_->cloud);
  impl_->build();
}
void PclKdTreeMap::erase_box(const MapBox& box) {
  erase(box, *impl_->cloud);
  impl_->build();
}
void PclKdTreeMap::nearest(const Eigen::Vector3f& query,
                           int count,
                           float radius_m,
                           MapNeighbors& out) const {
  find_in_cloud(*impl_->index, *impl_->cloud, query, count, radius_m, out);
}

struct PclOctreeMap::Impl {
  Cloud::Ptr cloud = std::make_shared<Cloud>();
  std::optional<pcl::octree::OctreePointCloudSearch<pcl::PointXYZ>> index = {};

  void build() {
    index.emplace(1.0);
    index->setInputCloud(cloud);
    index->addPointsFromInputCloud();
  }
};
PclOctreeMap::PclOctreeMap() : impl_(std::make_unique<Impl>()) {}
PclOctreeMap::~PclOctreeMap() = default;
void PclOctreeMap::insert(const Points& points) {
  append(points, *impl_->cloud);
  impl_->build();
}
void PclOctreeMap::erase_box(const MapBox& box) {
  erase(box, *impl_->cloud);
  impl_->build();
}
void PclOctreeMap::nearest(const Eigen::Vector3f& query,
                           int count,
                           float radius_m,
                           MapNeighbors& out) const {
  find_in_cloud(*impl_->index, *impl_->cloud, query, count, radius_m, out);
}

}  // namespace hybridfusion::bench
