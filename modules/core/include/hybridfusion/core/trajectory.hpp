#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/time.hpp>

#include <vector>

namespace hybridfusion {

struct StampedPose {
  Timestamp time{};
  Rigid3 map_from_body = {};
};

/// Poses in strictly ascending time.
struct Trajectory {
  std::vector<StampedPose> poses = {};
};

/// Position linear, rotation slerp between the two neighbours.
/// @returns kInsufficient for an empty trajectory or a time outside its span by more than
/// `max_extrapolation_s` (the end pose is held within it).
[[nodiscard]] Expected<Rigid3> interpolate(const Trajectory& trajectory,
                                           Timestamp time,
                                           double max_extrapolation_s);

}  // namespace hybridfusion
