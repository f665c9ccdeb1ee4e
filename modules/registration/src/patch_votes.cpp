#include "patch_votes.hpp"

#include "ground_alignment.hpp"
#include "patch_moves.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/registration/gridding.hpp>
#include <hybridfusion/registration/pose_clustering.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

namespace hybridfusion {
namespace {

constexpr double kCutShare = 0.003;

bool is_inside_window(const Rigid3& move, const PatchVoteOptions& options) {
  return move.translation.norm() <= options.max_shift_m &&
         rotation_distance_rad(move.rotation, Eigen::Quaterniond::Identity()) <=
             options.max_turn_rad;
}

/// Largest cluster of the moves (III-C.5); the members count when the cluster is about no move.
void cluster_moves(std::span<const VotingPatch> patches,
                   const PatchVoteOptions& options,
                   PatchVotes& votes) {
  std::vector<Rigid3> moves;
  for (const VotingPatch& patch : patches) moves.push_back(patch.move);
  const auto cluster =
      largest_pose_cluster(moves, options.cluster_radius_m, options.cluster_angle_rad);
  if (!cluster || cluster->mean.translation.norm() > options.cluster_radius_m) return;
  double squares = 0.0;
  for (const std::size_t member : cluster->members) {
    votes.patches[patches[member].match].outcome = PatchOutcome::kInCluster;
    squares += moves[member].translation.head<2>().squaredNorm();
  }
  votes.num_members = cluster->members.size();
  votes.spread_m = std::sqrt(squares / static_cast<double>(votes.num_members));
}

double facade_weight(const PlanarPattern& pattern) {
  double weight = 0.0;
  for (const PlanarPattern::Facade& f : pattern.facades) weight += f.weight;
  return weight;
}

/// Share of the facades (relative to `centre`) over known vision cells.
double overlap_share(const PlanarPattern& patch,
                     const Eigen::Vector2d& centre,
                     const Raster& height) {
  const auto known = std::ranges::count_if(patch.facades, [&](const PlanarPattern::Facade& f) {
    const Eigen::Vector2d at = centre + f.point;
    return !std::isnan(height.nearest(at.x(), at.y()));
  });
  return static_cast<double>(known) / static_cast<double>(patch.facades.size());
}

/// L with its outlines, in vision.
struct VoteClouds {
  std::vector<Eigen::Vector3f> points = {};
  PlanarPattern pattern = {};
  PlanarPose pose = {};  ///< Of the pattern.
};

VoteClouds vote_clouds(const PreparedClouds& clouds,
                       const Rigid3& vision_from_leveled,
                       double overhang_m) {
  const HeadingTilt heading = split_heading(vision_from_leveled.rotation);
  VoteClouds lidar{.points = clouds.lidar,
                   .pattern = make_pattern(clouds.lidar_maps, heading.tilt)};
  for (Eigen::Vector3f& p : lidar.points) {
    p = (vision_from_leveled * p.cast<double>()).cast<float>();
  }
  lidar.pose = planar_of(vision_from_leveled, lidar.pattern, overhang_m);
  return lidar;
}

/// The 2D step of every patch: notes in `votes` who was tried, returns those inside the window.
std::vector<VotingPatch> align_outlines(const VoteClouds& lidar,
                                        const PatchGrid& grid,
                                        const VisionMaps& vision,
                                        const OutlineOptions& outline,
                                        const PatchVoteOptions& options,
                                        const RunContext& ctx,
                                        PatchVotes& votes) {
  std::vector<std::optional<Rigid3>> moves(grid.patches.size());
  parallel_for(ctx, grid.patches.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last && !ctx.stopped(); ++p) {
      const Eigen::Vector2d centre = grid.patches[p].centroid.head<2>();
      const PlanarPattern patch =
          pattern_around(lidar.pattern, lidar.pose, centre, 1.5 * grid.step_m);
      if (facade_weight(patch) < options.min_facade_weight ||
          overlap_share(patch, centre, vision.height) < options.min_overlap_share) {
        continue;
      }
      votes.patches[p].outcome = PatchOutcome::kOutOfWindow;
      const auto place =
          best_place_nearby(vision, patch, centre, lidar.pose.overhang_m, outline, options);
      if (!place) continue;
      Rigid3 move{.rotation = Eigen::Quaterniond(
                      Eigen::AngleAxisd(place->yaw_rad, Eigen::Vector3d::UnitZ()))};
      move.translation.head<2>() = place->position - centre;
      if (is_inside_window(move, options)) moves[p] = move;
    }
  });
  std::vector<VotingPatch> voting;
  for (std::size_t p = 0; p < grid.patches.size(); ++p) {
    if (votes.patches[p].outcome == PatchOutcome::kOutOfWindow) ++votes.num_tried;
    if (moves[p]) {
      voting.push_back({.match = p, .centre = grid.patches[p].centroid, .move = *moves[p]});
    }
  }
  return voting;
}

void hand_out_samples(const FineInputs& inputs,
                      const Rigid3& vision_from_leveled,
                      const PatchGrid& grid,
                      std::vector<VotingPatch>& voting) {
  std::vector<VotingPatch*> of_patch(grid.patches.size(), nullptr);
  for (VotingPatch& patch : voting) of_patch[patch.match] = &patch;
  for (std::size_t i = 0; i < inputs.samples.size(); ++i) {
    const Eigen::Vector3d at = vision_from_leveled * inputs.samples[i].point;
    const Eigen::Vector2d cell = ((at.head<2>() - grid.origin) / grid.step_m).array().floor();
    const int patch = grid.patch_at(static_cast<int>(cell.x()), static_cast<int>(cell.y()));
    if (patch < 0 || of_patch[static_cast<std::size_t>(patch)] == nullptr) continue;
    of_patch[static_cast<std::size_t>(patch)]->samples.push_back(i);
  }
}

}  // namespace

Expected<PatchVotes> vote_by_patches(FineInputs& inputs,
                                     const PreparedClouds& clouds,
                                     const Rigid3& vision_from_leveled,
                                     double overhang_m,
                                     const RegistrationOptions& options,
                                     const RunContext& ctx) {
  PatchVotes votes;
  const double step_m = scene_size_m(clouds.vision, kCutShare) / options.votes.grid_divisions;
  if (!(step_m > 0.0)) return votes;
  const VoteClouds lidar = vote_clouds(clouds, vision_from_leveled, overhang_m);
  HF_TRY(const PatchGrid grid, grid_into_patches(lidar.points, step_m, kCutShare));
  for (const Patch& patch : grid.patches) {
    votes.patches.push_back({.lidar_cell = patch.cell,
                             .centroid_in_vision = patch.centroid,
                             .num_points = patch.indices.size(),
                             .outcome = PatchOutcome::kNoBoundary,
                             .vision_from_lidar = vision_from_leveled});
  }
  std::vector<VotingPatch> voting =
      align_outlines(lidar, grid, clouds.maps, options.outline, options.votes, ctx, votes);
  hand_out_samples(inputs, vision_from_leveled, grid, voting);
  align_planes(inputs, vision_from_leveled, options.fine, voting, ctx);
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while patches vote");
  std::erase_if(voting,
                [&](const VotingPatch& v) { return !is_inside_window(v.move, options.votes); });
  for (const VotingPatch& v : voting) {
    PatchMatch& match = votes.patches[v.match];
    match.outcome = PatchOutcome::kPose;
    match.vision_from_lidar = Rigid3{.translation = v.centre} * v.move *
                              Rigid3{.translation = -v.centre} * vision_from_leveled;
  }
  votes.num_poses = voting.size();
  cluster_moves(voting, options.votes, votes);
  return votes;
}

}  // namespace hybridfusion
