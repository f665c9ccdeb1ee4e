#include "patch_voting.hpp"

#include <hybridfusion/registration/pose_clustering.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Size of the largest cluster of the poses that are not near `mean`: poses just outside the
/// winning cluster are no rival to it.
std::size_t count_runner_up(std::span<const Rigid3> poses,
                            const Rigid3& mean,
                            const PaperOptions& options) {
  std::vector<Rigid3> rest;
  for (const Rigid3& pose : poses) {
    const bool near =
        (pose.translation - mean.translation).norm() < 2.0 * options.cluster_radius_m &&
        rotation_distance_rad(pose.rotation, mean.rotation) < 2.0 * options.cluster_angle_rad;
    if (!near) rest.push_back(pose);
  }
  const auto cluster =
      largest_pose_cluster(rest, options.cluster_radius_m, options.cluster_angle_rad);
  return cluster ? cluster->members.size() : 0;
}

/// Whether the largest cluster may be believed.
bool is_clear_majority(const PaperResult& result, const PaperOptions& options) {
  const auto members = static_cast<double>(result.num_cluster_members);
  return members >= options.min_cluster_members &&
         members >= options.min_cluster_share * static_cast<double>(result.num_poses) &&
         members >= options.min_cluster_margin * static_cast<double>(result.num_runner_up);
}

}  // namespace

std::string_view to_string(PatchOutcome outcome) {
  switch (outcome) {
    case PatchOutcome::kNoCandidate:
      return "no_candidate";
    case PatchOutcome::kNoCorrelation:
      return "no_correlation";
    case PatchOutcome::kNoNeighbours:
      return "no_similar_neighbours";
    case PatchOutcome::kNoBoundary:
      return "no_boundary";
    case PatchOutcome::kRejected3d:
      return "rejected_3d";
    case PatchOutcome::kOutOfWindow:
      return "out_of_window";
    case PatchOutcome::kPose:
      return "outside_cluster";
    case PatchOutcome::kInCluster:
      return "in_cluster";
  }
  return "unknown";
}

void cluster_poses(const Eigen::Vector3d& lidar_centroid,
                   const PaperOptions& options,
                   PaperResult& result) {
  // Translations at the LiDAR centroid: elsewhere a small rotation looks like a long way.
  std::vector<Rigid3> poses;
  std::vector<std::size_t> patch_of;
  for (std::size_t i = 0; i < result.patches.size(); ++i) {
    const PatchMatch& match = result.patches[i];
    if (match.outcome != PatchOutcome::kPose) continue;
    poses.push_back({.rotation = match.vision_from_lidar.rotation,
                     .translation = match.vision_from_lidar * lidar_centroid});
    patch_of.push_back(i);
  }
  result.num_poses = poses.size();
  const auto cluster =
      largest_pose_cluster(poses, options.cluster_radius_m, options.cluster_angle_rad);
  if (!cluster) {
    result.reason = fmt::format("none of {} LiDAR patches gave a pose", result.patches.size());
    return;
  }
  result.num_cluster_members = cluster->members.size();
  for (const std::size_t member : cluster->members) {
    result.patches[patch_of[member]].outcome = PatchOutcome::kInCluster;
    const double gap_m = (poses[member].translation - cluster->mean.translation).norm();
    result.cluster_spread_m = std::max(result.cluster_spread_m, gap_m);
  }
  result.vision_from_lidar = cluster->mean;
  result.vision_from_lidar.translation -= cluster->mean.rotation * lidar_centroid;
  result.num_runner_up = count_runner_up(poses, cluster->mean, options);
  result.supported = is_clear_majority(result, options);
  if (!result.supported) {
    result.reason = fmt::format(
        "{} of {} patch poses agree and {} agree elsewhere; at least {}, a share of {:.2g} and "
        "{:.2g}"
        " times the next are needed",
        result.num_cluster_members,
        result.num_poses,
        result.num_runner_up,
        options.min_cluster_members,
        options.min_cluster_share,
        options.min_cluster_margin);
  }
}

}  // namespace hybridfusion
