#include "hybrid.hpp"

#include "fine_alignment.hpp"
#include "patch_votes.hpp"
#include "place_support.hpp"
#include "verdict.hpp"

#include <numbers>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::int64_t kSteps = 4;  // of the progress

/// What the outlines alone are worth (measured: 0.1-0.3 m and 0.3 deg on scenes of 90 m).
PoseCovariance outline_covariance() {
  Eigen::Matrix<double, 6, 1> sigma;
  sigma << 0.3, 0.3, 0.05, 0.003, 0.003, 0.01;
  return sigma.array().square().matrix().asDiagonal();
}

/// The fine pose must stay at the place that the outlines found.
bool agrees(const Rigid3& fine, const Rigid3& outline, const Eigen::Vector3d& centroid) {
  return are_near(fine, outline, centroid, 1.0, 2.0 * std::numbers::pi / 180.0);
}

void take_fine(const FineResult& fine, const PreparedClouds& clouds, RegistrationResult& result) {
  result.vision_from_lidar = from_leveled(fine.vision_from_lidar, clouds);
  PoseCovariance covariance = fine.covariance;
  if (!fine.horizontal_updated) {
    for (const Eigen::Index k : {0, 1, 5}) covariance.row(k).setZero(), covariance.col(k).setZero();
    covariance += outline_covariance();
  }
  result.covariance = from_leveled(covariance, clouds);
  if (fine.scale_supported) {
    const Sim3 leveled{.rotation = clouds.leveled_from_lidar};
    result.lidar_from_vision_similarity = (fine.similarity * leveled).inverse();
    result.vision_scale = result.lidar_from_vision_similarity.scale;
    result.vision_scale_supported = true;
  }
  result.vision_scale_sigma = fine.scale_sigma;
}

Sim3 as_similarity(const Rigid3& pose) {
  return {.rotation = pose.rotation, .translation = pose.translation, .scale = 1.0};
}

/// Fine alignment; where the drive shows a drift, once more with L straightened.
Expected<FineResult> align_finely(FineInputs& inputs,
                                  const PreparedClouds& clouds,
                                  const PointCloud& lidar,
                                  const RegistrationInput& input,
                                  const OutlinePlace& place,
                                  const RegistrationOptions& options,
                                  const RunContext& ctx,
                                  DriftCorrection& drift) {
  const Eigen::Vector3d& centroid = clouds.lidar_centroid;
  HF_TRY(FineResult fine,
         align_fine(inputs, place.vision_from_leveled, centroid, options.fine, ctx));
  const bool is_found = fine.horizontal_updated &&
                        agrees(fine.vision_from_lidar, place.vision_from_leveled, centroid);
  if (!options.drift.enabled || !is_found) return fine;
  const auto finding = find_drift(inputs, clouds, lidar, input, fine, options, ctx);
  if (!finding) {
    if (finding.error().code == ErrorCode::kCancelled) return std::unexpected(finding.error());
    return fine;  // too little of the drive is known or seen: no drift to speak of
  }
  drift = finding->correction;
  if (!drift.supported && finding->scale_stands) return fine;
  FineOptions again = options.fine;
  again.estimate_scale = again.estimate_scale && finding->scale_stands;
  const Rigid3 start =
      drift.supported ? fine.vision_from_lidar * finding->rigid : fine.vision_from_lidar;
  return align_fine(inputs, start, centroid, again, ctx);
}

/// The pose of `best` and all places; takes the scores of the headings.
RegistrationResult result_of_outlines(OutlinePlaces& found,
                                      const OutlinePlace& best,
                                      const PreparedClouds& clouds) {
  RegistrationResult result{.yaw_scores = std::move(found.yaw_scores)};
  for (const OutlinePlace& place : found.places) {
    result.candidates.push_back({from_leveled(place.vision_from_leveled, clouds), place.score});
  }
  result.vision_from_lidar = from_leveled(best.vision_from_leveled, clouds);
  result.covariance = from_leveled(outline_covariance(), clouds);
  result.lidar_from_vision_similarity = as_similarity(result.vision_from_lidar).inverse();
  return result;
}

/// What place `k` shows before the fine alignment, against the best of the others.
Evidence outline_evidence(const std::vector<OutlinePlace>& places,
                          std::size_t k,
                          const PreparedClouds& clouds,
                          const OutlineOptions& options) {
  const OutlinePlace& best = places[k];
  Evidence evidence;
  evidence.best = best.evidence;
  evidence.best_score = best.score;
  if (places.size() > 1) {
    const OutlinePlace& second = places[k == 0 ? 1 : 0];
    evidence.second_score = second.score;
    evidence.second_offset = second.planar.position - best.planar.position;
    evidence.second_turn_rad = second.planar.yaw_rad - best.planar.yaw_rad;
  }
  evidence.ground_inliers = best.ground_inliers;
  evidence.linear_share = clouds.lidar_maps.linear_share;
  evidence.ridge = test_ridge(clouds, best, options);
  return evidence;
}

/// The fine pose as evidence; one that left the outlines' pose within their peak is asked for the
/// support of its facades. @returns whether the pose may be taken.
bool weigh_fine(FineInputs& inputs,
                const PreparedClouds& clouds,
                const FineResult& fine,
                const OutlinePlace& place,
                const RegistrationOptions& options,
                const RunContext& ctx,
                Evidence& evidence) {
  const Rigid3& outline = place.vision_from_leveled;
  const Eigen::Vector3d& centroid = clouds.lidar_centroid;
  evidence.has_fine = true;
  evidence.fine = fine;
  evidence.fine_agrees = agrees(fine.vision_from_lidar, outline, centroid);
  if (evidence.fine_agrees) return true;
  if (!are_near(fine.vision_from_lidar,
                outline,
                centroid,
                options.outline.peak_distance_m,
                options.outline.peak_angle_rad)) {
    return false;
  }
  evidence.facade_support =
      facade_support(inputs, clouds, fine.vision_from_lidar, options.fine, ctx);
  evidence.fine_stays = evidence.facade_support > options.verdict.min_facade_support;
  return evidence.fine_stays;
}

/// Votes of the patches on `vision_from_leveled`, into the evidence and the result.
Expected<void> take_votes(FineInputs& inputs,
                          const PreparedClouds& clouds,
                          const Rigid3& vision_from_leveled,
                          double overhang_m,
                          const RegistrationOptions& options,
                          const RunContext& ctx,
                          Evidence& evidence,
                          RegistrationResult& result) {
  if (!options.votes.enabled) return {};
  HF_TRY(PatchVotes votes,
         vote_by_patches(inputs, clouds, vision_from_leveled, overhang_m, options, ctx));
  for (PatchMatch& match : votes.patches) {
    match.vision_from_lidar = from_leveled(match.vision_from_lidar, clouds);
  }
  result.patches = std::move(votes.patches);
  evidence.patches_tried = votes.num_tried;
  evidence.patch_share = votes.share();
  evidence.patch_spread_m = votes.spread_m;
  return {};
}

}  // namespace

Expected<RegistrationResult> register_at_places(OutlinePlaces found,
                                                const PreparedClouds& clouds,
                                                const PointCloud& lidar,
                                                const RegistrationInput& input,
                                                const RegistrationOptions& options,
                                                const RunContext& ctx) {
  const std::vector<OutlinePlace>& places = found.places;
  ctx.report({.stage = "registration/fine", .done = 1, .total = kSteps});
  FineInputs inputs = make_fine_inputs(
      clouds.vision, clouds.lidar, places.front().vision_from_leveled, options.fine, ctx);
  HF_TRY(const SurfaceChoice choice, choose_by_surfaces(inputs, clouds, found, options, ctx));
  const OutlinePlace& best = places[choice.place];
  if (choice.place > 0) {
    inputs.samples =
        draw_samples(clouds.vision, clouds.lidar, best.vision_from_leveled, options.fine, ctx);
  }
  Evidence evidence = outline_evidence(places, choice.place, clouds, options.outline);
  evidence.used_prior = found.used_prior;
  evidence.surfaces_compared = choice.is_compared;
  evidence.facade_support = choice.support;
  evidence.rival_support = choice.rival_support;

  RegistrationResult result = result_of_outlines(found, best, clouds);
  Rigid3 final_pose = best.vision_from_leveled;
  const auto fine = align_finely(inputs, clouds, lidar, input, best, options, ctx, result.drift);
  if (!fine && fine.error().code == ErrorCode::kCancelled) return std::unexpected(fine.error());
  if (fine && weigh_fine(inputs, clouds, *fine, best, options, ctx, evidence)) {
    take_fine(*fine, clouds, result);
    final_pose = fine->vision_from_lidar;
    evidence.best = judge_pose(clouds.maps, clouds.lidar_maps, final_pose, best.planar.overhang_m);
    if (!fine->scale_supported) {
      result.lidar_from_vision_similarity = as_similarity(result.vision_from_lidar).inverse();
    }
  } else {
    result.drift.supported = false;  // it was measured about a pose that is not taken
  }
  ctx.report({.stage = "registration/patches", .done = 2, .total = kSteps});
  if (const auto voted = take_votes(
          inputs, clouds, final_pose, best.planar.overhang_m, options, ctx, evidence, result);
      !voted) {
    return std::unexpected(voted.error());
  }
  ctx.report({.stage = "registration/verdict", .done = 3, .total = kSteps});
  pronounce(evidence, options.verdict, result);
  ctx.report({.stage = "registration/verdict", .done = kSteps, .total = kSteps});
  return result;
}

Expected<RegistrationResult> register_hybrid(const PreparedClouds& clouds,
                                             const PointCloud& lidar,
                                             const RegistrationInput& input,
                                             const RegistrationOptions& options,
                                             const RunContext& ctx) {
  ctx.report({.stage = "registration/outlines", .done = 0, .total = kSteps});
  HF_TRY(OutlinePlaces found, find_places(clouds, input, options, ctx));
  prefer_by_prior(clouds, input, options.verdict.max_peak_ratio, found);
  return register_at_places(std::move(found), clouds, lidar, input, options, ctx);
}

}  // namespace hybridfusion
