#include "baselines.hpp"

#include <hybridfusion/registration/ndt.hpp>

#include <algorithm>

namespace hybridfusion {

Expected<RegistrationResult> register_ndt(const PreparedClouds& clouds,
                                          const NdtOptions& options,
                                          const RunContext& ctx) {
  std::vector<Eigen::Vector3f> source;
  const std::size_t count =
      std::min(clouds.lidar.size(), static_cast<std::size_t>(options.samples));
  source.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    source.push_back(clouds.lidar[k * clouds.lidar.size() / count]);
  }
  Ndt3Result ndt{.target_from_source = height_aligned_initial(clouds)};
  for (const double cell_m : {options.start_cell_m, options.final_cell_m}) {
    const NdtPass pass{.cell_m = cell_m,
                       .min_cell_points = options.min_cell_points,
                       .outlier_ratio = options.outlier_ratio,
                       .max_iterations = options.iterations};
    auto aligned = align_ndt_3d(clouds.vision, source, ndt.target_from_source, pass, ctx);
    if (!aligned && aligned.error().code == ErrorCode::kInsufficient) {
      return fail(ErrorCode::kDegenerate, "NDT: " + aligned.error().message);
    }
    if (!aligned) return std::unexpected(aligned.error());
    ndt = *aligned;
  }
  RegistrationResult result =
      baseline_result(clouds, ndt.target_from_source, ndt.quality.converged);
  result.scores.push_back({"ndt_score", ndt.quality.score});
  result.scores.push_back({"ndt_iterations", static_cast<double>(ndt.quality.iterations)});
  return result;
}

PoseEvidence baseline_evidence(const PreparedClouds& clouds, const Rigid3& vision_from_leveled) {
  constexpr double kOverhang_m = 0.25;  // as the outline search finds it on ordinary roofs
  return judge_pose(clouds.maps, clouds.lidar_maps, vision_from_leveled, kOverhang_m);
}

RegistrationResult baseline_result(const PreparedClouds& clouds,
                                   const Rigid3& vision_from_leveled,
                                   bool converged) {
  RegistrationResult result;
  result.vision_from_lidar = from_leveled(vision_from_leveled, clouds);
  const Rigid3 inverse = result.vision_from_lidar.inverse();
  result.lidar_from_vision_similarity = {.rotation = inverse.rotation,
                                         .translation = inverse.translation};
  const PoseEvidence evidence = baseline_evidence(clouds, vision_from_leveled);
  result.scores = {{"converged", converged ? 1.0 : 0.0},
                   {"facade_share_on_edges", evidence.facade_share},
                   {"facade_share_on_ground", evidence.facade_on_ground},
                   {"ground_share_within_0.2_m", evidence.ground_share},
                   {"free_space_violations", evidence.free_violations}};
  // The baseline's own word, as its users have it; the confidence is what the evidence leaves of
  // it.
  result.status = converged ? RegistrationStatus::kOk : RegistrationStatus::kRefused;
  if (converged) {
    result.confidence = evidence.facade_share * evidence.ground_share;
  } else {
    result.reason = "stopped at the iteration limit without converging";
  }
  return result;
}

}  // namespace hybridfusion
