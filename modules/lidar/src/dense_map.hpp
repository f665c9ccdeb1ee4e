#pragma once

#include "scan_store.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/lidar/dense_map_options.hpp>
#include <hybridfusion/lidar/mapper.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace hybridfusion {

/// Voxel indices low <= index < high in x and y.
struct PlanBox {
  Eigen::Vector2i low = Eigen::Vector2i::Constant(std::numeric_limits<int>::min());
  Eigen::Vector2i high = Eigen::Vector2i::Constant(std::numeric_limits<int>::max());
};

/// Hits as many voxels away support a voxel.
inline constexpr int kSupportReach = 3;

/// Thins a stream of points to one (the mean) in each voxel and remembers how many scans hit it.
/// 48 bytes a voxel.
class DenseMap {
 public:
  explicit DenseMap(const DenseMapOptions& options);

  /// @pre scans come in order; `scan` counts them.
  void add(std::uint32_t scan, const Eigen::Vector3f& point_in_map, float intensity, float time_s);
  /// Supported voxels that were hit for at most `max_brief_s` and stand at least 0.3 m above the
  /// lowest hit near them: what moved is among them.
  [[nodiscard]] std::vector<std::uint32_t> brief_voxels() const;
  [[nodiscard]] const Eigen::Vector3f& mean(std::uint32_t voxel) const {
    return voxels_[voxel].mean;
  }
  void drop(std::uint32_t voxel) { voxels_[voxel].dropped = true; }
  /// Voxels in the box that, with those within kSupportReach, were hit in min_scans scans, in order
  /// of their first hit. @param time_origin  Added to the times given to add().
  [[nodiscard]] PointCloud extract(Timestamp time_origin, const PlanBox& box = {}) const;
  [[nodiscard]] std::size_t size() const { return voxels_.size(); }

 private:
  struct Voxel {
    std::uint64_t key = 0;
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    float intensity = 0.0F;
    float time_s = 0.0F;
    float last_time_s = 0.0F;
    std::uint32_t last_scan = 0;
    std::uint16_t num_points = 0;
    std::uint16_t num_scans = 0;
    bool dropped = false;
  };
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
  /// Scans that hit the voxel or one at most `reach` voxels away; stops at min_scans.
  [[nodiscard]] int scans_near(const Voxel& voxel, int reach) const;
  [[nodiscard]] bool is_supported(const Voxel& voxel) const;
  void grow();

  DenseMapOptions options_;
  std::vector<std::uint32_t> slots_;
  std::vector<Voxel> voxels_ = {};
};

/// The dense map of all scans, tile by tile: what the memory holds does not grow with the drive.
/// @returns kCancelled, kIo and what `sink` returns.
[[nodiscard]] Expected<void> build_dense_map(const DenseMapOptions& options,
                                             const RunContext& ctx,
                                             const ScanStore& store,
                                             const MapSink& sink);

}  // namespace hybridfusion
