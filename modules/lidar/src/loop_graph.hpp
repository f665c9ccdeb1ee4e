#pragma once

#include "loop_closure.hpp"
#include "loop_verification.hpp"
#include "pose_graph.hpp"
#include "segments.hpp"

namespace hybridfusion {

/// Odometry between neighbouring segments with the information that their common planes give, loops
/// and gravity. @returns kCancelled, kIo.
[[nodiscard]] Expected<PoseGraph> build_loop_graph(const ScanStore& store,
                                                   const std::vector<Segment>& segments,
                                                   const std::vector<Loop>& loops,
                                                   const RunContext& ctx);

/// Information of points of `second` about planes of `first` (both sorted by cell), for the motion
/// first_from_second; directions that no plane holds get none.
[[nodiscard]] PoseMatrix plane_information(std::span<const PlaneCluster> first,
                                           std::span<const PlaneCluster> second,
                                           const Rigid3& first_from_second);

/// Fixes as position priors of the segments, aligned to the map as a whole (yaw and offset free, so
/// that a biased receiver does no harm) and weak, as their errors last for minutes. Nothing happens
/// when the track cannot be aligned.
void add_gnss(const GnssTrack& gnss,
              const std::vector<Segment>& segments,
              std::span<const StoredScan> scans,
              PoseGraph& graph);

/// How far the poses are from what the odometry says: root of the sum of the edges' weighted
/// squared residuals, in standard deviations.
[[nodiscard]] double total_strain(std::span<const RelativePose> odometry,
                                  std::span<const Rigid3> map_from_segment);

}  // namespace hybridfusion
