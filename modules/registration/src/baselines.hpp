#pragma once

#include "prepared_clouds.hpp"

namespace hybridfusion {

/// Generalised ICP (Segal 2009) with PCL's default parameters, as the paper's comparison ran it,
/// from the height-aligned coarse pose. Reports what PCL reports: its "converged" is no verdict.
[[nodiscard]] Expected<RegistrationResult> register_gicp(const PreparedClouds& clouds,
                                                         const RunContext& ctx);

/// 3D NDT from the height-aligned coarse pose, large cells first.
[[nodiscard]] Expected<RegistrationResult> register_ndt(const PreparedClouds& clouds,
                                                        const NdtOptions& options,
                                                        const RunContext& ctx);

/// Facades and ground at a pose that was found without the outlines.
[[nodiscard]] PoseEvidence baseline_evidence(const PreparedClouds& clouds,
                                             const Rigid3& vision_from_leveled);

/// A baseline's pose in the common result record: pose, its similarity, the evidence at it.
[[nodiscard]] RegistrationResult baseline_result(const PreparedClouds& clouds,
                                                 const Rigid3& vision_from_leveled,
                                                 bool converged);

}  // namespace hybridfusion
