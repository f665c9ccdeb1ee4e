#include <hybridfusion/core/trajectory.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {

Expected<Rigid3> interpolate(const Trajectory& trajectory,
                             Timestamp time,
                             double max_extrapolation_s) {
  const auto& poses = trajectory.poses;
  if (poses.empty()) return fail(ErrorCode::kInsufficient, "the trajectory has no pose");
  const auto outside_s =
      std::max(to_seconds(poses.front().time - time), to_seconds(time - poses.back().time));
  if (outside_s > max_extrapolation_s) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("time is {:.3f} s outside the trajectory", outside_s));
  }
  const auto next = std::ranges::lower_bound(poses, time, {}, &StampedPose::time);
  if (next == poses.begin()) return poses.front().map_from_body;
  if (next == poses.end()) return poses.back().map_from_body;
  const auto previous = std::prev(next);
  const double share = to_seconds(time - previous->time) / to_seconds(next->time - previous->time);
  const Rigid3& a = previous->map_from_body;
  const Rigid3& b = next->map_from_body;
  return Rigid3{.rotation = a.rotation.slerp(share, b.rotation),
                .translation = a.translation + share * (b.translation - a.translation)};
}

}  // namespace hybridfusion
