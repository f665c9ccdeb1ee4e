#include <hybridfusion/registration/pose_clustering.hpp>

#include <algorithm>
#include <utility>

namespace hybridfusion {
namespace {

bool close(const Rigid3& a, const Rigid3& b, double radius_m, double angle_rad) {
  return (a.translation - b.translation).norm() < radius_m &&
         rotation_distance_rad(a.rotation, b.rotation) < angle_rad;
}

/// Mean of n rotations as n-1 slerps with weights 1/2, 1/3, ...: exact for two, order-dependent to
/// second order.
Rigid3 sequential_mean(std::span<const Rigid3> poses, std::span<const std::size_t> members) {
  Rigid3 mean = poses[members.front()];
  for (std::size_t k = 1; k < members.size(); ++k) {
    const double weight = 1.0 / static_cast<double>(k + 1);
    const Rigid3& next = poses[members[k]];
    mean.rotation = mean.rotation.slerp(weight, next.rotation);
    mean.translation += weight * (next.translation - mean.translation);
  }
  return mean;
}

}  // namespace

Expected<PoseCluster> largest_pose_cluster(std::span<const Rigid3> poses,
                                           double radius_m,
                                           double angle_rad) {
  HF_CHECK(radius_m > 0.0 && angle_rad > 0.0);
  if (poses.empty()) return fail(ErrorCode::kInsufficient, "no patch produced a pose");

  PoseCluster best;
  for (std::size_t seed = 0; seed < poses.size(); ++seed) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto agrees = [&](std::size_t j) {
        return close(poses[i], poses[j], radius_m, angle_rad);
      };
      if (close(poses[i], poses[seed], radius_m, angle_rad) &&
          std::ranges::all_of(members, agrees)) {
        members.push_back(i);
      }
    }
    if (members.size() > best.members.size()) best.members = std::move(members);
  }
  if (best.members.empty()) return fail(ErrorCode::kDegenerate, "no patch pose is finite");
  best.mean = sequential_mean(poses, best.members);
  return best;
}

}  // namespace hybridfusion
