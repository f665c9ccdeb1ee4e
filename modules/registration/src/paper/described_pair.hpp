#pragma once

#include "patch_registration.hpp"

#include <vector>

namespace hybridfusion {

/// A cloud of its own without isolated points, in vision.
struct CleanCloud {
  std::vector<Eigen::Vector3f> points = {};
  std::vector<float> heights = {};
};

/// Both clouds cut into described patches. `vision` and `lidar` look into the clean clouds.
struct DescribedPair {
  CleanCloud clean_vision = {};
  CleanCloud clean_lidar = {};
  PatchedCloud vision = {};
  std::vector<PatchedCloud> lidar =
      {};  ///< One for each grid; more than one where patches overlap.
};

/// Isolated points out, grids of one tenth of the scene, descriptors (HybridFusion III-C.1, 2b).
/// @returns kInvalidOptions, kDegenerate for a vision cloud without extent, kCancelled.
[[nodiscard]] Expected<DescribedPair> describe_pair(const GroundedCloud& vision,
                                                    const GroundedCloud& lidar,
                                                    const Rigid3& vision_from_lidar_coarse,
                                                    const PaperOptions& options,
                                                    const RunContext& ctx);

}  // namespace hybridfusion
