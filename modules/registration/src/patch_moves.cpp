#include "patch_moves.hpp"

#include "fine_alignment.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPlanePairs = 60;
/// Share of the information of a patch that holds it where it is, and its lever for the heading.
constexpr double kHold = 0.02;
constexpr double kHoldRadius_m = 5.0;

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

}  // namespace

PlanarPattern pattern_around(const PlanarPattern& pattern,
                             const PlanarPose& pose,
                             const Eigen::Vector2d& centre,
                             double half_side_m) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  PlanarPattern patch{.centre = centre};
  const auto place = [&](const Eigen::Vector2d& point) -> Eigen::Vector2d {
    return pose.position + turn * point - centre;
  };
  for (const PlanarPattern::Facade& f : pattern.facades) {
    const Eigen::Vector2d p = place(f.point);
    if (p.lpNorm<Eigen::Infinity>() > half_side_m) continue;
    patch.facades.push_back({p, turn * f.outward, f.weight});
    patch.reach_m = std::max(patch.reach_m, p.norm());
  }
  for (const Eigen::Vector2d& free_point : pattern.free_points) {
    const Eigen::Vector2d p = place(free_point);
    if (p.lpNorm<Eigen::Infinity>() <= half_side_m) patch.free_points.push_back(p);
  }
  return patch;
}

std::optional<PlanarPose> best_place_nearby(const VisionMaps& vision,
                                            const PlanarPattern& patch,
                                            const Eigen::Vector2d& centre,
                                            double overhang_m,
                                            const OutlineOptions& outline,
                                            const PatchVoteOptions& votes) {
  constexpr int kTurns = 2;       // to each side
  constexpr double kStay = 0.05;  // of the score at the rim of the window
  const int shifts =
      std::max(1, static_cast<int>(std::lround(votes.max_shift_m / vision.edge.grid.cell_m)));
  const auto pose_at = [&](int x, int y, int turn) {
    return PlanarPose{
        .position = centre + votes.max_shift_m / shifts * Eigen::Vector2d(x, y),
        .yaw_rad = votes.max_turn_rad / kTurns * turn,
        .overhang_m = overhang_m,
    };
  };
  PlanarPose best;
  for (int turn = -kTurns; turn <= kTurns; ++turn) {
    for (int y = -shifts; y <= shifts; ++y) {
      for (int x = -shifts; x <= shifts; ++x) {
        PlanarPose trial = pose_at(x, y, turn);
        const double way = std::hypot(x, y) / shifts + std::abs(static_cast<double>(turn)) / kTurns;
        trial.score = (1.0 - kStay * way) * score_of(vision, patch, trial, outline.free_penalty);
        if (trial.score > best.score) best = trial;
      }
    }
  }
  if (!(best.score > 0.0)) return std::nullopt;
  OutlineOptions fixed = outline;  // the overhang is that of the whole cloud
  fixed.min_overhang_m = fixed.max_overhang_m = overhang_m;
  return refine_pose(vision, patch, best, 0.5 * vision.edge.grid.cell_m, fixed);
}

void align_planes(FineInputs& inputs,
                  const Rigid3& pose,
                  const FineOptions& fine,
                  std::vector<VotingPatch>& patches,
                  const RunContext& ctx) {
  for (const double gate_m : {1.0, 0.7, 0.5, 0.35, 0.3}) {
    if (!ctx.stopped()) step_on_planes(inputs, pose, gate_m, fine, patches, ctx);
  }
}

}  // namespace hybridfusion
