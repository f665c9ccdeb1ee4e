#pragma once

#include "plane_adjustment.hpp"
#include "scan_store.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

/// Consecutive scans that move as one body; the frame is the IMU at the middle scan.
struct Segment {
  std::size_t first = 0;
  std::size_t last = 0;  ///< One behind.
  std::size_t anchor = 0;
};

[[nodiscard]] std::vector<Segment> cut_into_segments(const std::vector<StoredScan>& scans,
                                                     double duration_s);

/// map_from_imu of the middle scans.
[[nodiscard]] std::vector<Rigid3> anchor_poses(const std::vector<Segment>& segments,
                                               const std::vector<StoredScan>& scans);

/// Points of a segment by map cells of side `voxel_m`, in the segment's frame; cells with fewer
/// than three points are left out. @returns kIo.
[[nodiscard]] Expected<std::vector<PlaneCluster>> cluster_segment(const ScanStore& store,
                                                                  const Segment& segment,
                                                                  std::uint32_t index,
                                                                  double voxel_m);

/// The changes of velocity from segment to segment that the IMU measured along directions that the
/// planes of the middle segment do not hold (`held` as from held_directions, one per segment), with
/// gravity and accelerometer bias from fit_gravity; none without it, nor where IMU samples are
/// missing.
[[nodiscard]] std::vector<VelocityChange> velocity_changes(const std::vector<Segment>& segments,
                                                           const std::vector<StoredScan>& scans,
                                                           std::span<const Eigen::Matrix3d> held);

/// Whether part of the motion behind scan `first`, up to scan `last`, was not measured.
[[nodiscard]] bool is_bridged(const std::vector<StoredScan>& scans,
                              std::size_t first,
                              std::size_t last);

/// Projector (3 x 3, map axes) onto the directions that the planes of a segment hold.
[[nodiscard]] Eigen::Matrix3d held_directions(std::span<const PlaneCluster> clusters,
                                              const Rigid3& map_from_segment);

/// The normal of a cluster in its segment's frame; nothing when its points do not lie on a plane.
[[nodiscard]] std::optional<Eigen::Vector3d> normal_of(const PlaneCluster& cluster);

/// Range noise of the sensor from how faces scatter within one segment, each divided by the cosine
/// under which it is seen: their median.
class RangeNoise {
 public:
  /// @param lidar_in_segment  Where the segment's points were seen from, about [m].
  void add(std::span<const PlaneCluster> clusters, const Eigen::Vector3d& lidar_in_segment);
  /// [m]; nothing from too few faces.
  [[nodiscard]] std::optional<double> sigma_m() const;

 private:
  static constexpr double kBin_m = 5e-4;
  std::array<std::size_t, 256> counts_ = {};
  std::size_t total_ = 0;
};

/// Carries the moves of the segments over to all scans: between two anchors the correction is
/// interpolated in time, so that the trajectory stays smooth.
void move_scans(const std::vector<Segment>& segments,
                const std::vector<Rigid3>& map_from_segment,
                std::vector<StoredScan>& scans);

}  // namespace hybridfusion
