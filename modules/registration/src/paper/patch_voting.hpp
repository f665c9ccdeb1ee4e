#pragma once

#include <hybridfusion/registration/paper_registration.hpp>

namespace hybridfusion {

/// Mean of the largest cluster of the patch poses (HybridFusion III-C.5), or the coarse pose that
/// `result` holds; says in `result` what it rests on and whether it may be believed, and marks the
/// members among its patches. @param lidar_centroid  In the LiDAR frame [m].
void cluster_poses(const Eigen::Vector3d& lidar_centroid,
                   const PaperOptions& options,
                   PaperResult& result);

}  // namespace hybridfusion
