#include "pair_verification.hpp"

#include "cached_features.hpp"
#include "relative_pose.hpp"
#include "robust_statistics.hpp"
#include "triangulation.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <array>
#include <atomic>

namespace hybridfusion {
namespace {

struct NormalizedMatches {
  std::vector<Eigen::Vector2d> first;
  std::vector<Eigen::Vector2d> second;
};

NormalizedMatches normalize(std::span<const FeatureSet> features,
                            const CameraSetup& cameras,
                            const RawPair& pair) {
  const auto side = [&](std::uint32_t view, std::uint32_t Match::* index) {
    const CameraIntrinsics& camera = cameras.cameras[cameras.camera_of_photo[view]].intrinsics;
    std::vector<Eigen::Vector2d> result;
    result.reserve(pair.matches.size());
    for (const Match& match : pair.matches) {
      result.push_back(unproject(camera, features[view].pixels[match.*index].cast<double>()));
    }
    return result;
  };
  return {side(pair.views.first, &Match::first), side(pair.views.second, &Match::second)};
}

double median_angle(const RelativePose& pose, const NormalizedMatches& matches) {
  const Rigid3 first_from_second = pose.second_from_first.inverse();
  std::vector<double> angles;
  for (const std::uint32_t i : pose.inliers) {
    const std::array<WorldRay, 2> rays{
        WorldRay{.centre = Eigen::Vector3d::Zero(),
                 .direction = matches.first[i].homogeneous().normalized()},
        WorldRay{.centre = first_from_second.translation,
                 .direction =
                     first_from_second.rotation * matches.second[i].homogeneous().normalized()}};
    const auto point = intersect_rays(rays);
    angles.push_back(point ? largest_angle_rad(rays, *point) : 0.0);
  }
  return angles.empty() ? 0.0 : median(std::move(angles));
}

/// A pixel error of the reduced photos as an error of normalised coordinates.
double normalized_error(const CameraSetup& cameras, const RawPair& pair, double error_px) {
  const auto one = [&](std::uint32_t view) {
    const CameraPrior& camera = cameras.cameras[cameras.camera_of_photo[view]];
    return error_px * camera.pixel_scale / camera.intrinsics.focal_px;
  };
  return 0.5 * (one(pair.views.first) + one(pair.views.second));
}

std::uint64_t stream_index(const PhotoPair& views) {
  return (static_cast<std::uint64_t>(views.first) << 32U) | views.second;
}

}  // namespace

Expected<std::vector<RawPair>> match_pairs(std::span<const FeatureSet> features,
                                           std::span<const PhotoPair> pairs,
                                           const MatchingOptions& options,
                                           const RunContext& ctx,
                                           const PhotoCache* cache) {
  use_single_threaded_blas();
  std::vector<RawPair> result(pairs.size());
  std::atomic<std::int64_t> done = 0;
  parallel_for(ctx, pairs.size(), 1, [&](std::size_t k, std::size_t) {
    if (ctx.stopped()) return;
    const auto [first, second] = pairs[k];
    result[k] = {
        pairs[k],
        photo_matches(features[first], features[second], first, second, options.ratio, cache)};
    ctx.report({.stage = "vision/matching",
                .done = ++done,
                .total = static_cast<std::int64_t>(pairs.size())});
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
  return result;
}

std::optional<VerifiedPair> verify_pair(std::span<const FeatureSet> features,
                                        const CameraSetup& cameras,
                                        const RawPair& pair,
                                        const MatchingOptions& options,
                                        const RunContext& ctx) {
  const NormalizedMatches matches = normalize(features, cameras, pair);
  const double max_error = normalized_error(cameras, pair, options.max_error_px);
  const auto pose =
      estimate_relative_pose(matches.first,
                             matches.second,
                             {.max_error = max_error,
                              .max_iterations = options.max_iterations,
                              .min_inliers = options.min_inliers},
                             Random(ctx.seed, "vision/verify", stream_index(pair.views)));
  if (!pose || static_cast<double>(pose->inliers.size()) <
                   options.min_inlier_ratio * static_cast<double>(pair.matches.size())) {
    return std::nullopt;
  }
  VerifiedPair verified{.views = pair.views, .second_from_first = pose->second_from_first};
  NormalizedMatches agreeing;
  for (const std::uint32_t i : pose->inliers) {
    verified.matches.push_back(pair.matches[i]);
    agreeing.first.push_back(matches.first[i]);
    agreeing.second.push_back(matches.second[i]);
  }
  verified.median_angle_rad = median_angle(*pose, matches);
  verified.homography_share = homography_share(agreeing.first, agreeing.second, max_error);
  return verified;
}

Expected<std::vector<VerifiedPair>> verify_pairs(std::span<const FeatureSet> features,
                                                 const CameraSetup& cameras,
                                                 std::span<const RawPair> pairs,
                                                 const MatchingOptions& options,
                                                 const RunContext& ctx) {
  std::vector<std::optional<VerifiedPair>> verified(pairs.size());
  parallel_for(ctx, pairs.size(), 1, [&](std::size_t k, std::size_t) {
    if (!ctx.stopped()) verified[k] = verify_pair(features, cameras, pairs[k], options, ctx);
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
  std::vector<VerifiedPair> result;
  for (auto& pair : verified) {
    if (pair) result.push_back(std::move(*pair));
  }
  return result;
}

}  // namespace hybridfusion
