#include "patch_votes.hpp"

#include "fine_alignment.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/registration/gridding.hpp>
#include <hybridfusion/registration/ndt.hpp>
#include <hybridfusion/registration/pose_clustering.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

namespace hybridfusion {
namespace {

constexpr double kCutShare = 0.003;
constexpr std::size_t kMinPlanePairs = 60;
/// Share of the information of a patch that holds it where it is, and its lever for the heading.
constexpr double kHold = 0.02;
constexpr double kHoldRadius_m = 5.0;

/// A patch of L with its move: point_after = move (point - centre) + centre, in vision.
struct VotingPatch {
  std::size_t match = 0;  ///< Into PatchVotes::patches.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Rigid3 move = {};
  std::vector<std::size_t> samples = {};
};

/// Boundary [m, x-y of vision] of what stands high, `points` being in vision.
std::vector<Eigen::Vector2f> boundary_of(std::span<const Eigen::Vector3f> points,
                                         std::span<const float> heights,
                                         const BoundaryOptions& options,
                                         const RunContext& ctx) {
  std::vector<Eigen::Vector2f> high;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<double>(heights[i]) > options.min_height_m) high.push_back(points[i].head<2>());
  }
  return boundary_points(high, options, ctx);
}

std::vector<Eigen::Vector2f> near(std::span<const Eigen::Vector2f> points,
                                  const Eigen::Vector2d& centre,
                                  double half_side_m) {
  std::vector<Eigen::Vector2f> kept;
  for (const Eigen::Vector2f& p : points) {
    if ((p.cast<double>() - centre).lpNorm<Eigen::Infinity>() > half_side_m) continue;
    kept.emplace_back((p.cast<double>() - centre).cast<float>());
  }
  return kept;
}

/// Share of the boundary points (relative to `centre`) over known vision cells.
double overlap_share(std::span<const Eigen::Vector2f> boundary,
                     const Eigen::Vector2d& centre,
                     const Raster& height) {
  const auto known = std::ranges::count_if(boundary, [&](const Eigen::Vector2f& p) {
    const Eigen::Vector2d at = centre + p.cast<double>();
    return !std::isnan(height.nearest(at.x(), at.y()));
  });
  return static_cast<double>(known) / static_cast<double>(boundary.size());
}

/// 2D NDT of the boundary of a patch to that of G around it, from where it is.
std::optional<Rigid2> align_boundary(std::span<const Eigen::Vector2f> vision,
                                     std::span<const Eigen::Vector2f> lidar,
                                     const PatchVoteOptions& options) {
  constexpr int kMinCellPoints = 4;
  const RunContext serial{.num_threads = 1};  // the patches run side by side
  Rigid2 move;
  for (const double cell_m : {options.ndt_cell_m, 0.5 * options.ndt_cell_m}) {
    const NdtPass pass{.cell_m = cell_m, .min_cell_points = kMinCellPoints};
    const auto step = align_ndt_2d(vision, lidar, move, pass, serial);
    if (!step) return std::nullopt;
    move = step->target_from_source;
  }
  const bool is_inside = move.translation.norm() <= options.max_shift_m &&
                         std::abs(move.yaw_rad) <= options.max_turn_rad;
  return is_inside ? std::optional(move) : std::nullopt;
}

bool is_inside_window(const Rigid3& move, const PatchVoteOptions& options) {
  return move.translation.norm() <= options.max_shift_m &&
         rotation_distance_rad(move.rotation, Eigen::Quaterniond::Identity()) <=
             options.max_turn_rad;
}

/// One Gauss-Newton step of a patch: shift and heading, held softly where its planes leave a
/// direction free.
void step_patch(const FineInputs& inputs,
                const Rigid3& pose,
                double gate_m,
                const FineOptions& fine,
                std::span<const Neighbor> nearest,
                VotingPatch& patch) {
  const auto limit = static_cast<float>(gate_m * gate_m);
  Matrix7d normal = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
  std::size_t count = 0;
  for (std::size_t j = 0; j < patch.samples.size(); ++j) {
    if (!(nearest[j].squared_distance_m2 < limit)) continue;
    const LazyPlanes::Plane& plane = inputs.planes.at(nearest[j].index);
    const FineSample& sample = inputs.samples[patch.samples[j]];
    const Eigen::Vector3d on_plane = plane.normal.cast<double>();
    const Eigen::Vector3d direction = patch.move.rotation * (pose.rotation * sample.normal);
    if (static_cast<double>(plane.curvature) > fine.max_curvature ||
        std::abs(on_plane.dot(direction)) < fine.min_normal_cosine) {
      continue;
    }
    // About the centre of the patch, where its moves are taken.
    const Eigen::Vector3d moved = patch.move * (pose * sample.point - patch.centre);
    Vector7d jacobian;
    const double residual = plane_residual(moved,
                                           plane.mean.cast<double>() - patch.centre,
                                           on_plane,
                                           Eigen::Vector3d::Zero(),
                                           jacobian);
    if (std::abs(residual) >= gate_m) continue;
    const double ratio = residual / gate_m;
    const double weight = (1.0 - ratio * ratio) * (1.0 - ratio * ratio);  // Tukey
    normal += weight * jacobian * jacobian.transpose();
    right -= weight * residual * jacobian;
    ++count;
  }
  if (count < kMinPlanePairs) return;
  for (const Eigen::Index held : {3, 4, 6}) {  // roll, pitch, scale
    normal.row(held).setZero();
    normal.col(held).setZero();
    normal(held, held) = 1.0;
    right[held] = 0.0;
  }
  const double hold = kHold * static_cast<double>(count);
  normal.topLeftCorner<3, 3>() += hold * Eigen::Matrix3d::Identity();
  normal(5, 5) += kHoldRadius_m * kHoldRadius_m * hold;
  const Vector7d update = normal.ldlt().solve(right);
  if (!update.allFinite()) return;
  const Sim3 after =
      apply_update(update,
                   Eigen::Vector3d::Zero(),
                   {.rotation = patch.move.rotation, .translation = patch.move.translation});
  patch.move = {.rotation = after.rotation, .translation = after.translation};
}

/// One Gauss-Newton step of every patch on the planes of G.
void step_on_planes(FineInputs& inputs,
                    const Rigid3& pose,
                    double gate_m,
                    const FineOptions& fine,
                    std::vector<VotingPatch>& patches,
                    const RunContext& ctx) {
  const auto moved = [&](const VotingPatch& patch, std::size_t i) -> Eigen::Vector3d {
    return patch.move * (pose * inputs.samples[i].point - patch.centre) + patch.centre;
  };
  std::vector<std::vector<Neighbor>> nearest(patches.size());
  parallel_for(ctx, patches.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      for (const std::size_t i : patches[k].samples) {
        nearest[k].push_back(inputs.planes.tree().nearest(moved(patches[k], i).cast<float>()));
      }
    }
  });
  const auto limit = static_cast<float>(gate_m * gate_m);
  std::vector<std::size_t> wanted;
  for (const auto& some : nearest) {
    for (const Neighbor& n : some) {
      if (n.squared_distance_m2 < limit) wanted.push_back(n.index);
    }
  }
  inputs.planes.prepare(std::move(wanted), ctx);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    step_patch(inputs, pose, gate_m, fine, nearest[k], patches[k]);
  }
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

/// L in vision and both boundaries.
struct VoteClouds {
  std::vector<Eigen::Vector3f> lidar = {};
  std::vector<Eigen::Vector2f> lidar_boundary = {};
  std::vector<Eigen::Vector2f> vision_boundary = {};
};

VoteClouds vote_clouds(const PreparedClouds& clouds,
                       const Rigid3& vision_from_leveled,
                       const BoundaryOptions& options,
                       const RunContext& ctx) {
  VoteClouds result{.lidar = clouds.lidar};
  for (Eigen::Vector3f& p : result.lidar) {
    p = (vision_from_leveled * p.cast<double>()).cast<float>();
  }
  const auto heights = [&](const GroundModel& ground, std::span<const Eigen::Vector3f> points) {
    return heights_above(ground, points, ctx);
  };
  result.lidar_boundary =
      boundary_of(result.lidar, heights(clouds.lidar_ground, clouds.lidar), options, ctx);
  result.vision_boundary =
      boundary_of(clouds.vision, heights(clouds.vision_ground, clouds.vision), options, ctx);
  return result;
}

/// The 2D step of every patch: notes in `votes` who was tried, returns those inside the window.
std::vector<VotingPatch> align_boundaries(const VoteClouds& cloud,
                                          const PatchGrid& grid,
                                          const Raster& vision_height,
                                          const PatchVoteOptions& options,
                                          const RunContext& ctx,
                                          PatchVotes& votes) {
  std::vector<std::optional<Rigid2>> moves(grid.patches.size());
  parallel_for(ctx, grid.patches.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last && !ctx.stopped(); ++p) {
      const Eigen::Vector2d centre = grid.patches[p].centroid.head<2>();
      const auto mine = near(cloud.lidar_boundary, centre, 1.5 * grid.step_m);
      if (std::cmp_less(mine.size(), options.min_boundary_points) ||
          overlap_share(mine, centre, vision_height) < options.min_overlap_share) {
        continue;
      }
      const auto theirs =
          near(cloud.vision_boundary, centre, 1.5 * grid.step_m + options.max_shift_m);
      if (std::cmp_less(theirs.size(), options.min_boundary_points)) continue;
      votes.patches[p].outcome = PatchOutcome::kOutOfWindow;
      moves[p] = align_boundary(theirs, mine, options);
    }
  });
  std::vector<VotingPatch> voting;
  for (std::size_t p = 0; p < grid.patches.size(); ++p) {
    if (votes.patches[p].outcome == PatchOutcome::kOutOfWindow) ++votes.num_tried;
    if (!moves[p]) continue;
    VotingPatch entry{.match = p, .centre = grid.patches[p].centroid};
    entry.move.rotation = Eigen::AngleAxisd(moves[p]->yaw_rad, Eigen::Vector3d::UnitZ());
    entry.move.translation.head<2>() = moves[p]->translation;
    voting.push_back(std::move(entry));
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
                                     const FineOptions& fine,
                                     const PatchVoteOptions& options,
                                     const RunContext& ctx) {
  PatchVotes votes;
  const double step_m = scene_size_m(clouds.vision, kCutShare) / options.grid_divisions;
  if (!(step_m > 0.0)) return votes;
  const VoteClouds cloud = vote_clouds(clouds, vision_from_leveled, options.boundary, ctx);
  HF_TRY(const PatchGrid grid, grid_into_patches(cloud.lidar, step_m, kCutShare));
  for (const Patch& patch : grid.patches) {
    votes.patches.push_back({.lidar_cell = patch.cell,
                             .centroid_in_vision = patch.centroid,
                             .num_points = patch.indices.size(),
                             .outcome = PatchOutcome::kNoBoundary,
                             .vision_from_lidar = vision_from_leveled});
  }
  std::vector<VotingPatch> voting =
      align_boundaries(cloud, grid, clouds.maps.height, options, ctx, votes);
  hand_out_samples(inputs, vision_from_leveled, grid, voting);
  for (const double gate_m : {1.0, 0.7, 0.5, 0.35, 0.3}) {
    if (!ctx.stopped()) step_on_planes(inputs, vision_from_leveled, gate_m, fine, voting, ctx);
  }
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while patches vote");
  std::erase_if(voting, [&](const VotingPatch& v) { return !is_inside_window(v.move, options); });
  for (const VotingPatch& v : voting) {
    PatchMatch& match = votes.patches[v.match];
    match.outcome = PatchOutcome::kPose;
    match.vision_from_lidar = Rigid3{.translation = v.centre} * v.move *
                              Rigid3{.translation = -v.centre} * vision_from_leveled;
  }
  votes.num_poses = voting.size();
  cluster_moves(voting, options, votes);
  return votes;
}

}  // namespace hybridfusion
