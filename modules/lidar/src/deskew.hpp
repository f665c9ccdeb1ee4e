#pragma once

#include "imu_propagation.hpp"

#include <hybridfusion/core/sensor_data.hpp>

#include <vector>

namespace hybridfusion {

/// Drops returns that are not finite, zero or out of [min_range_m, max_range_m] and sorts the rest
/// by time. @returns how many were dropped.
std::size_t clean_scan(double min_range_m, double max_range_m, std::vector<LidarPoint>& points);

/// Keeps every n-th point, so that at most `max_points` are left.
void decimate(std::size_t max_points, std::vector<LidarPoint>& points);

/// Moves points measured at different times to where they would have been seen at the end of the
/// path (FAST-LIO2, backward propagation).
/// @param points    In the LiDAR frame, offsets in ascending time.
/// @param path      Motion before `end`; points before its first node follow that node's motion.
/// @param end_ns    Offset of the end state on the clock of the points.
/// @param out       Points in the IMU frame at the end; other members are copied.
void deskew(const std::vector<LidarPoint>& points,
            const std::vector<PathNode>& path,
            const NavState& end,
            std::int64_t end_ns,
            std::vector<LidarPoint>& out);

/// Indices, ascending, of one point in each voxel: the nearest to the voxel's centre.
[[nodiscard]] std::vector<std::size_t> thin(const std::vector<LidarPoint>& points, double voxel_m);

}  // namespace hybridfusion
