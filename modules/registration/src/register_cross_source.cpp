#include "baselines.hpp"
#include "hybrid.hpp"
#include "paper/paper_method.hpp"
#include "tiled_search.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {

namespace {

/// Trees alone fix no position, whatever the photos show: no search is worth its time.
Expected<void> check_walls(const LidarMaps& maps, const VerdictOptions& options) {
  if (maps.facades.empty() || maps.linear_share >= options.min_linear_share) return {};
  return fail(ErrorCode::kDegenerate,
              fmt::format("{:.2f} of the LiDAR columns lie on straight walls (limit {:.2f}): trees "
                          "alone do not fix a position",
                          maps.linear_share,
                          options.min_linear_share));
}

/// At once, or by tiles where the vision cloud within reach is large.
Expected<RegistrationResult> run_hybrid(const PointCloud& vision,
                                        const PointCloud& lidar,
                                        const RegistrationInput& input,
                                        const RegistrationOptions& options,
                                        const RunContext& ctx) {
  HF_TRY(PreparedClouds clouds, prepare_lidar_of_pair(vision, lidar, input, options, ctx));
  if (auto fixed = check_walls(clouds.lidar_maps, options.verdict); !fixed) {
    return std::unexpected(fixed.error());
  }
  std::vector<Eigen::Vector3f> kept;
  std::span<const Eigen::Vector3f> within_reach = vision.points;
  if (input.vision_from_lidar_initial) {
    kept = reachable_vision(vision, clouds, input, options.max_offset_m);
    within_reach = kept;
  }
  if (needs_tiles(within_reach, options.outline)) {
    return register_in_tiles(within_reach, std::move(clouds), lidar, input, options, ctx);
  }
  if (kept.empty()) kept.assign(within_reach.begin(), within_reach.end());
  if (auto prepared = prepare_vision(std::move(kept), options, ctx, clouds); !prepared) {
    return std::unexpected(prepared.error());
  }
  return register_hybrid(clouds, lidar, input, options, ctx);
}

}  // namespace

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
    if (options.method == "hybrid") return run_hybrid(vision, lidar, input, options, ctx);
    HF_TRY(const PreparedClouds clouds, prepare_clouds(vision, lidar, input, options, ctx));
    if (options.method == "gicp") return register_gicp(clouds, ctx);
    if (options.method == "ndt") return register_ndt(clouds, options.ndt, ctx);
    return register_paper(clouds, options, ctx);
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
