#include "deskew.hpp"

#include <hybridfusion/core/floor.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <utility>

namespace hybridfusion {

std::size_t clean_scan(double min_range_m, double max_range_m, std::vector<LidarPoint>& points) {
  const auto min2 = static_cast<float>(min_range_m * min_range_m);
  const auto max2 = static_cast<float>(max_range_m * max_range_m);
  const std::size_t before = points.size();
  std::erase_if(points, [&](const LidarPoint& point) {
    const float range2 = point.point_in_lidar.squaredNorm();
    return !(range2 > 0.0F && range2 >= min2 && range2 <= max2);  // false for NaN
  });
  const auto earlier = [](const LidarPoint& a, const LidarPoint& b) {
    return a.offset_ns < b.offset_ns;
  };
  if (!std::ranges::is_sorted(points, earlier)) std::ranges::stable_sort(points, earlier);
  return before - points.size();
}

void decimate(std::size_t max_points, std::vector<LidarPoint>& points) {
  if (points.size() <= max_points) return;
  const std::size_t stride = (points.size() - 1) / max_points + 1;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) points[kept++] = points[i];
  points.resize(kept);
}

void deskew(const std::vector<LidarPoint>& points,
            const std::vector<PathNode>& path,
            const NavState& end,
            std::int64_t end_ns,
            std::vector<LidarPoint>& out) {
  out = points;
  std::size_t node = 0;
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
  Eigen::Matrix3f end_from_lidar = end.imu_from_lidar.cast<float>();
  Eigen::Vector3f lidar_in_end = end.lidar_in_imu.cast<float>();
  for (LidarPoint& point : out) {
    // Spinning sensors fire many beams at one time: the pose is worked out once for them.
    if (point.offset_ns != last_ns && !path.empty()) {
      last_ns = point.offset_ns;
      const double time_s = 1e-9 * static_cast<double>(point.offset_ns - end_ns);
      while (node + 1 < path.size() && path[node + 1].time_s <= time_s) ++node;
      const PathNode& from = path[node];
      const double h = time_s - from.time_s;
      const Eigen::Matrix3d end_from_map = end.map_from_imu.transpose();
      const Eigen::Matrix3d end_from_imu =
          end_from_map * from.map_from_imu * so3_exp(h * from.angular_velocity_radps);
      const Eigen::Vector3d position =
          from.position_in_map + h * from.velocity_in_map + 0.5 * h * h * from.acceleration_in_map;
      const Eigen::Vector3d imu_in_end = end_from_map * (position - end.position_in_map);
      end_from_lidar = (end_from_imu * end.imu_from_lidar).cast<float>();
      lidar_in_end = (end_from_imu * end.lidar_in_imu + imu_in_end).cast<float>();
    }
    point.point_in_lidar = end_from_lidar * point.point_in_lidar + lidar_in_end;
  }
}

namespace {

/// The point nearest to the centre of each voxel, in an open-addressing table that grows with the
/// number of voxels: a scan has far fewer of them than points, and few fit into the cache.
class VoxelWinners {
 public:
  void offer(std::uint64_t key, std::uint32_t index, float distance2) {
    Slot& slot = slots_[slot_of(key)];
    const bool is_new = slot.distance2 < 0.0F;
    if (is_new || distance2 < slot.distance2) {
      slot = {.key = key, .index = index, .distance2 = distance2};
    }
    if (is_new && 2 * ++num_voxels_ > slots_.size()) grow();
  }
  [[nodiscard]] std::vector<std::size_t> indices() const {
    std::vector<std::size_t> kept;
    kept.reserve(num_voxels_);
    for (const Slot& slot : slots_) {
      if (slot.distance2 >= 0.0F) kept.push_back(slot.index);
    }
    std::ranges::sort(kept);
    return kept;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t index = 0;
    float distance2 = -1.0F;  // < 0: empty
  };

  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    // Fibonacci hashing: only the highest bits of the product depend on all bits of the key.
    std::size_t at = (key * 0x9E3779B97F4A7C15ULL) >> shift_;
    while (slots_[at].distance2 >= 0.0F && slots_[at].key != key) at = (at + 1) & mask;
    return at;
  }
  void grow() {
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(2 * slots_.size()));
    --shift_;
    for (const Slot& slot : old) {
      if (slot.distance2 >= 0.0F) slots_[slot_of(slot.key)] = slot;
    }
  }

  std::vector<Slot> slots_ = std::vector<Slot>(4096);
  unsigned shift_ = 64U - 12U;
  std::size_t num_voxels_ = 0;
};

}  // namespace

std::vector<std::size_t> thin(const std::vector<LidarPoint>& points, double voxel_m) {
  VoxelWinners winners;
  const auto inverse = static_cast<float>(1.0 / voxel_m);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3f scaled = points[i].point_in_lidar.array() * inverse;
    const Eigen::Array3f floor = scaled.unaryExpr([](float value) { return floor_of(value); });
    const std::uint64_t key = voxel_key(floor.cast<int>());
    winners.offer(
        key, static_cast<std::uint32_t>(i), (scaled - floor - 0.5F).matrix().squaredNorm());
  }
  return winners.indices();
}

}  // namespace hybridfusion
