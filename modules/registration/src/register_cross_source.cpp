#include "baselines.hpp"
#include "hybrid.hpp"
#include "paper/paper_method.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

#include <algorithm>
#include <utility>

namespace hybridfusion {

std::string_view to_string(RegistrationStatus status) {
  return status == RegistrationStatus::kOk ? "ok" : "refused";
}

std::optional<double> RegistrationResult::score(std::string_view name) const {
  const auto found = std::ranges::find(scores, name, &RegistrationScore::name);
  if (found == scores.end()) return std::nullopt;
  return found->value;
}

Rigid3 rescaled_vision_from_lidar(const RegistrationResult& result) {
  if (!result.vision_scale_supported) return result.vision_from_lidar;
  // vision_scale * (s R p + t) with s = 1 / vision_scale.
  const Sim3 vision_from_lidar = result.lidar_from_vision_similarity.inverse();
  return {.rotation = vision_from_lidar.rotation,
          .translation = result.vision_scale * vision_from_lidar.translation};
}

Expected<RegistrationResult> register_cross_source(const PointCloud& vision,
                                                   const PointCloud& lidar,
                                                   const RegistrationInput& input,
                                                   const RegistrationOptions& options,
                                                   const RunContext& ctx) {
  if (const auto valid = validate(options, "registration"); !valid) {
    return std::unexpected(valid.error());
  }
  const auto run = [&]() -> Expected<RegistrationResult> {
    HF_TRY(const PreparedClouds clouds, prepare_clouds(vision, lidar, input, options, ctx));
    if (options.method == "gicp") return register_gicp(clouds, ctx);
    if (options.method == "ndt") return register_ndt(clouds, options.ndt, ctx);
    if (options.method == "paper") return register_paper(clouds, options, ctx);
    return register_hybrid(clouds, lidar, input, options, ctx);
  };
  Expected<RegistrationResult> result = run();
  if (!result && result.error().code == ErrorCode::kDegenerate) {
    // The clouds are sound but do not determine a pose: an answer, not a failure of the call.
    RegistrationResult refused;
    refused.reason = result.error().message;
    refused.vision_from_lidar = input.vision_from_lidar_initial.value_or(Rigid3{});
    result = std::move(refused);
  }
  if (result) result->method = options.method;
  return result;
}

}  // namespace hybridfusion
