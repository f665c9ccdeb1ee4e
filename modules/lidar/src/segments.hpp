#pragma once

#include "plane_adjustment.hpp"
#include "scan_store.hpp"

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

/// Carries the moves of the segments over to all scans: between two anchors the correction is
/// interpolated in time, so that the trajectory stays smooth.
void move_scans(const std::vector<Segment>& segments,
                const std::vector<Rigid3>& map_from_segment,
                std::vector<StoredScan>& scans);

}  // namespace hybridfusion
