#include "paper_method.hpp"

#include "baselines.hpp"
#include "verdict.hpp"

#include <hybridfusion/registration/paper_registration.hpp>

#include <utility>

namespace hybridfusion {
namespace {

/// The paper refuses nothing; patches that agree by accident stand in each other's walls.
void refuse_against_surfaces(const PreparedClouds& clouds,
                             const Rigid3& vision_from_leveled,
                             const RegistrationOptions& options,
                             RegistrationResult& result) {
  const SurfaceVerdict verdict =
      judge_surfaces(baseline_evidence(clouds, vision_from_leveled), options.verdict);
  result.confidence = verdict.confidence;
  if (verdict.reason.empty()) return;
  result.status = RegistrationStatus::kRefused;
  result.reason = verdict.reason;
}

}  // namespace

Expected<RegistrationResult> register_paper(const PreparedClouds& clouds,
                                            const RegistrationOptions& options,
                                            const RunContext& ctx) {
  const std::vector<float> vision_heights = heights_above(clouds.vision_ground, clouds.vision, ctx);
  const std::vector<float> lidar_heights = heights_above(clouds.lidar_ground, clouds.lidar, ctx);
  HF_TRY(PaperResult chain,
         register_by_patches({clouds.vision, vision_heights},
                             {clouds.lidar, lidar_heights},
                             height_aligned_initial(clouds),
                             options.paper,
                             options.ndt,
                             ctx));
  RegistrationResult result = baseline_result(clouds, chain.vision_from_lidar, chain.supported);
  result.reason = chain.reason;
  if (chain.supported) refuse_against_surfaces(clouds, chain.vision_from_lidar, options, result);
  result.scores.push_back({"patches", static_cast<double>(chain.patches.size())});
  result.scores.push_back({"patch_poses", static_cast<double>(chain.num_poses)});
  result.scores.push_back({"cluster_members", static_cast<double>(chain.num_cluster_members)});
  result.scores.push_back({"runner_up_members", static_cast<double>(chain.num_runner_up)});
  result.scores.push_back({"cluster_spread_m", chain.cluster_spread_m});
  result.scores.push_back({"final_ndt_taken", chain.adjusted ? 1.0 : 0.0});
  result.patches = std::move(chain.patches);
  for (PatchMatch& match : result.patches) {
    match.vision_from_lidar = from_leveled(match.vision_from_lidar, clouds);
    match.vision_from_lidar_2d = from_leveled(match.vision_from_lidar_2d, clouds);
  }
  return result;
}

}  // namespace hybridfusion
