#include <hybridfusion/geometry/kd_tree.hpp>

#include <iterator>
#include <limits>

#include <nanoflann.hpp>

namespace hybridfusion {
namespace {

struct PointAdaptor {
  std::span<const Eigen::Vector3f> points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return points[index][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointAdaptor>,
                                                  PointAdaptor,
                                                  3,
                                                  std::size_t>;

/// Result set of nanoflann: the nearest points inside a sphere, sorted. `out` never grows beyond
/// `count`.
class NearestWithin {
 public:
  NearestWithin(std::size_t count, float squared_radius_m2, std::vector<Neighbor>& out)
      : count_(count), squared_radius_m2_(squared_radius_m2), out_(out) {}

  [[nodiscard]] std::size_t size() const { return out_.size(); }
  [[nodiscard]] bool full() const { return out_.size() == count_; }
  [[nodiscard]] float worstDist() const {  // NOLINT(readability-identifier-naming): nanoflann's
    return full() ? out_.back().squared_distance_m2 : squared_radius_m2_;
  }
  /// nanoflann asks for the worst distance once a leaf: since then it may have become smaller.
  bool addPoint(float distance, std::size_t index) {  // NOLINT(readability-identifier-naming)
    if (distance >= worstDist()) return true;
    if (full()) out_.pop_back();
    auto place = out_.end();
    while (place != out_.begin() && std::prev(place)->squared_distance_m2 > distance) --place;
    out_.insert(place, {index, distance});
    return true;
  }

 private:
  std::size_t count_;
  float squared_radius_m2_;
  std::vector<Neighbor>& out_;
};

}  // namespace

struct KdTree::Impl {
  PointAdaptor adaptor;
  Index index;
  explicit Impl(std::span<const Eigen::Vector3f> points)
      : adaptor{points}, index(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}
};

KdTree::KdTree(std::span<const Eigen::Vector3f> points) : impl_(std::make_unique<Impl>(points)) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

std::size_t KdTree::size() const {
  return impl_->adaptor.points.size();
}

void KdTree::nearest(const Eigen::Vector3f& query,
                     std::size_t count,
                     std::vector<Neighbor>& out) const {
  thread_local std::vector<std::size_t> indices;
  thread_local std::vector<float> distances;
  indices.resize(count);
  distances.resize(count);
  const std::size_t found =
      size() == 0 ? 0
                  : impl_->index.knnSearch(query.data(), count, indices.data(), distances.data());
  out.resize(found);
  for (std::size_t i = 0; i < found; ++i) out[i] = {indices[i], distances[i]};
}

void KdTree::nearest(const Eigen::Vector3f& query,
                     std::size_t count,
                     float radius_m,
                     std::vector<Neighbor>& out) const {
  out.clear();
  if (size() == 0 || count == 0) return;
  NearestWithin found(count, radius_m * radius_m, out);
  impl_->index.findNeighbors(found, query.data(), nanoflann::SearchParams());
}

void KdTree::within(const Eigen::Vector3f& query,
                    float radius_m,
                    std::vector<Neighbor>& out) const {
  out.clear();
  if (size() == 0) return;
  thread_local std::vector<std::pair<std::size_t, float>> found;
  found.clear();
  impl_->index.radiusSearch(
      query.data(), radius_m * radius_m, found, nanoflann::SearchParams(32, 0.0F, true));
  out.reserve(found.size());
  for (const auto& [index, squared_distance] : found) out.push_back({index, squared_distance});
}

Neighbor KdTree::nearest(const Eigen::Vector3f& query) const {
  Neighbor best{.index = size(), .squared_distance_m2 = std::numeric_limits<float>::infinity()};
  if (size() == 0) return best;
  impl_->index.knnSearch(query.data(), 1, &best.index, &best.squared_distance_m2);
  return best;
}

}  // namespace hybridfusion
