#include "submap_alignment.hpp"

#include "manifold.hpp"
#include "pose_equations.hpp"

#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

// Scales of the Cauchy weight [m], from coarse to fine: one or two iterations each.
constexpr std::array<double, 12> kScales_m{
    0.6, 0.6, 0.4, 0.4, 0.2, 0.2, 0.1, 0.1, 0.05, 0.05, 0.05, 0.05};
constexpr float kNearby_m = 1.5F;
constexpr std::size_t kNeighbors = 4;
constexpr float kMinNormalCosine = 0.9F;
constexpr double kInlier_m = 0.12;
constexpr std::size_t kMinPairs = 30;
constexpr std::size_t kMinSharedGround = 30;
// Of the information in the best held direction: what is held less stays as guessed.
constexpr double kDamping = 1e-3;

struct Pair {
  Eigen::Vector3d point_in_source = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of the target, in the target
  double residual_m = 0.0;
};

struct Pairing {
  std::vector<Pair> pairs = {};
  std::size_t num_nearby = 0;
};

Pairing pair_up(const Submap& target,
                const KdTree& tree,
                const Submap& source,
                const Rigid3& target_from_source) {
  const Eigen::Matrix3f rotation = target_from_source.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f translation = target_from_source.translation.cast<float>();
  Pairing out;
  std::vector<Neighbor> neighbors;
  for (const Surfel& surfel : source.surfels) {
    const Eigen::Vector3f p = rotation * surfel.mean + translation;
    const Eigen::Vector3f n = rotation * surfel.normal;
    tree.nearest(p, kNeighbors, neighbors);
    if (neighbors.empty() || neighbors.front().squared_distance_m2 > kNearby_m * kNearby_m)
      continue;
    ++out.num_nearby;
    const Surfel* best = nullptr;
    float best_distance = kNearby_m;
    for (const Neighbor& neighbor : neighbors) {
      const Surfel& candidate = target.surfels[neighbor.index];
      if (neighbor.squared_distance_m2 > kNearby_m * kNearby_m) break;
      const float distance = std::abs(candidate.normal.dot(p - candidate.mean));
      if (std::abs(candidate.normal.dot(n)) < kMinNormalCosine || distance >= best_distance)
        continue;
      best = &candidate;
      best_distance = distance;
    }
    if (best == nullptr) continue;
    out.pairs.push_back({.point_in_source = surfel.mean.cast<double>(),
                         .normal = best->normal.cast<double>(),
                         .residual_m = best->normal.dot(p - best->mean)});
  }
  return out;
}

PoseMatrix information(const std::vector<Pair>& pairs,
                       const Rigid3& target_from_source,
                       double scale_m,
                       PoseVector& right) {
  PoseMatrix h = PoseMatrix::Zero();
  right.setZero();
  for (const Pair& pair : pairs) {
    PoseVector row;
    row << pair.normal,
        pair.point_in_source.cross(target_from_source.rotation.conjugate() * pair.normal);
    const double scaled = pair.residual_m / scale_m;
    const double weight = 1.0 / (1.0 + scaled * scaled);
    h += weight * row * row.transpose();
    right -= weight * pair.residual_m * row;
  }
  return h;
}

SubmapAlignment judge(const Pairing& pairing, const Submap& source, const Rigid3& pose) {
  SubmapAlignment out{.target_from_source = pose};
  std::vector<Pair> inliers;
  double sum_squares = 0.0;
  for (const Pair& pair : pairing.pairs) {
    if (std::abs(pair.residual_m) > kInlier_m) continue;
    inliers.push_back(pair);
    sum_squares += pair.residual_m * pair.residual_m;
  }
  const auto count = static_cast<double>(inliers.size());
  out.num_inliers = inliers.size();
  out.overlap =
      static_cast<double>(pairing.num_nearby) / static_cast<double>(source.surfels.size());
  out.inlier_share = count / std::max(1.0, static_cast<double>(pairing.num_nearby));
  out.rms_m = std::sqrt(sum_squares / std::max(1.0, count));
  if (inliers.size() < kMinPairs) return out;
  PoseVector right;
  const PoseMatrix h = information(inliers, pose, 1.0, right);
  const Eigen::Matrix3d turns =
      h.bottomRightCorner<3, 3>() + 1e-6 * h.trace() * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d marginal =
      h.topLeftCorner<3, 3>() -
      h.topRightCorner<3, 3>() * turns.ldlt().solve(Eigen::Matrix3d(h.bottomLeftCorner<3, 3>()));
  out.min_cosine2 =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(marginal).eigenvalues()[0] / count;
  return out;
}

}  // namespace

std::optional<double> ground_offset(const Submap& target,
                                    const Submap& source,
                                    const Rigid3& target_from_source) {
  const auto key_of = [](const Eigen::Vector3f& p) {
    return voxel_key(voxel_of({p.x(), p.y(), 0.0F}, kPlanCell_m));
  };
  std::unordered_map<std::uint64_t, float> heights;
  for (const Eigen::Vector3f& p : target.ground) heights.emplace(key_of(p), p.z());
  std::vector<double> offsets;
  for (const Eigen::Vector3f& p : source.ground) {
    const Eigen::Vector3f moved = (target_from_source * p.cast<double>()).cast<float>();
    const auto found = heights.find(key_of(moved));
    if (found != heights.end()) offsets.push_back(found->second - moved.z());
  }
  if (offsets.size() < kMinSharedGround) return std::nullopt;
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::ranges::nth_element(offsets, middle);
  return *middle;
}

std::optional<SubmapAlignment> align_submaps(const Submap& target,
                                             const Submap& source,
                                             const Rigid3& guess) {
  if (target.surfels.empty() || source.surfels.empty()) return std::nullopt;
  std::vector<Eigen::Vector3f> means;
  for (const Surfel& surfel : target.surfels) means.push_back(surfel.mean);
  const KdTree tree(means);
  Rigid3 pose = guess;
  for (const double scale_m : kScales_m) {
    const Pairing pairing = pair_up(target, tree, source, pose);
    if (pairing.pairs.size() < kMinPairs) return std::nullopt;
    PoseVector right;
    PoseMatrix h = information(pairing.pairs, pose, scale_m, right);
    h.diagonal().head<3>().array() += kDamping * h.topLeftCorner<3, 3>().trace();
    h.diagonal().tail<3>().array() += kDamping * h.bottomRightCorner<3, 3>().trace();
    const PoseVector step = h.ldlt().solve(right);
    if (!step.allFinite()) return std::nullopt;
    pose.translation += step.head<3>();
    pose.rotation = (pose.rotation * Eigen::Quaterniond(so3_exp(step.tail<3>()))).normalized();
  }
  return judge(pair_up(target, tree, source, pose), source, pose);
}

}  // namespace hybridfusion
