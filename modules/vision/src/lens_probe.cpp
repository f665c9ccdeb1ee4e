#include "pair_verification.hpp"
#include "relative_pose.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr std::size_t kPairs = 8;
constexpr std::size_t kMatches = 600;  // per pair
constexpr int kSamples = 60;
constexpr double kError_px = 1.0;  // tight: a wrong lens bends by a few pixels

constexpr double kMinK1 = -0.5;
constexpr double kStepK1 = 0.05;
constexpr std::size_t kNumK1 = 15;
constexpr double kMinFocal = 0.5;  // times the guess
constexpr double kFocalStep = 1.12;
constexpr std::size_t kNumFocals = 13;

/// The pairs with most matches in which both photos come from `camera`, thinned evenly.
std::vector<RawPair> strongest_pairs(const CameraSetup& cameras,
                                     std::span<const RawPair> pairs,
                                     std::uint32_t camera) {
  std::vector<const RawPair*> candidates;
  for (const RawPair& pair : pairs) {
    if (cameras.camera_of_photo[pair.views.first] == camera &&
        cameras.camera_of_photo[pair.views.second] == camera && pair.matches.size() >= 50) {
      candidates.push_back(&pair);
    }
  }
  std::ranges::stable_sort(
      candidates, std::greater<>{}, [](const RawPair* p) { return p->matches.size(); });
  std::vector<RawPair> chosen;
  for (std::size_t k = 0; k < std::min(kPairs, candidates.size()); ++k) {
    // Spread over the stronger half: the very strongest overlap so much that they have no parallax.
    const std::size_t stride = std::max<std::size_t>(1, candidates.size() / (2 * kPairs));
    const RawPair& pair = *candidates[k * stride];
    RawPair thinned{.views = pair.views, .matches = {}};
    const std::size_t step = std::max<std::size_t>(1, pair.matches.size() / kMatches);
    for (std::size_t i = 0; i < pair.matches.size(); i += step) {
      thinned.matches.push_back(pair.matches[i]);
    }
    chosen.push_back(std::move(thinned));
  }
  return chosen;
}

class Probe {
 public:
  Probe(const CameraSetup& cameras,
        std::span<const FeatureSet> features,
        std::vector<RawPair> pairs,
        std::uint32_t camera,
        const RunContext& ctx)
      : prior_(cameras.cameras[camera]), features_(features), pairs_(std::move(pairs)), ctx_(ctx) {}

  /// Matches within the tight limit over all probe pairs.
  [[nodiscard]] double agreeing(double focal_px, double k1) const {
    CameraIntrinsics camera = prior_.intrinsics;
    camera.focal_px = focal_px;
    camera.k1 = k1;
    return ordered_reduce(
        ctx_,
        pairs_.size(),
        1,
        0.0,
        [&](std::size_t k, std::size_t) { return agreeing_in(pairs_[k], camera); },
        std::plus<>{});
  }

 private:
  [[nodiscard]] double agreeing_in(const RawPair& pair, const CameraIntrinsics& camera) const {
    std::vector<Eigen::Vector2d> first;
    std::vector<Eigen::Vector2d> second;
    for (const Match& match : pair.matches) {
      first.push_back(
          unproject(camera, features_[pair.views.first].pixels[match.first].cast<double>()));
      second.push_back(
          unproject(camera, features_[pair.views.second].pixels[match.second].cast<double>()));
    }
    const auto pose =
        estimate_relative_pose(first,
                               second,
                               {.max_error = kError_px * prior_.pixel_scale / camera.focal_px,
                                .max_iterations = kSamples,
                                .min_inliers = 8},
                               Random(ctx_.seed, "vision/probe", pair.views.first));
    return pose ? static_cast<double>(pose->inliers.size()) : 0.0;
  }

  const CameraPrior& prior_;
  std::span<const FeatureSet> features_;
  std::vector<RawPair> pairs_;
  const RunContext& ctx_;
};

struct Peak {
  double index = 0.0;  // vertex of the parabola through the best sample and its neighbours
  double value = 0.0;  // of the best sample
};

template <std::size_t Size>
Peak peak_of(const std::array<double, Size>& values) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < Size; ++i) {
    if (values[i] > values[best]) best = i;
  }
  Peak peak{.index = static_cast<double>(best), .value = values[best]};
  if (best == 0 || best + 1 == Size) return peak;
  const double bend = values[best - 1] - 2.0 * values[best] + values[best + 1];
  if (bend < 0.0) peak.index += 0.5 * (values[best - 1] - values[best + 1]) / bend;
  return peak;
}

}  // namespace

void probe_lenses(CameraSetup& cameras,
                  std::span<const FeatureSet> features,
                  std::span<const RawPair> pairs,
                  const RunContext& ctx) {
  for (std::uint32_t camera = 0; camera < cameras.cameras.size(); ++camera) {
    CameraPrior& prior = cameras.cameras[camera];
    const Probe probe(cameras, features, strongest_pairs(cameras, pairs, camera), camera, ctx);
    if (prior.focal_guessed) {
      const double first = kMinFocal * prior.intrinsics.focal_px;
      std::array<double, kNumFocals> values{};
      for (std::size_t i = 0; i < kNumFocals; ++i) {
        values[i] = probe.agreeing(first * std::pow(kFocalStep, static_cast<double>(i)), 0.0);
      }
      const Peak peak = peak_of(values);
      if (peak.value > 0.0) prior.intrinsics.focal_px = first * std::pow(kFocalStep, peak.index);
    }
    std::array<double, kNumK1> values{};
    for (std::size_t i = 0; i < kNumK1; ++i) {
      values[i] =
          probe.agreeing(prior.intrinsics.focal_px, kMinK1 + kStepK1 * static_cast<double>(i));
    }
    const Peak peak = peak_of(values);
    const double without = probe.agreeing(prior.intrinsics.focal_px, 0.0);
    // Only a clear gain is a lens; the rest is chance.
    constexpr double kMinGain = 1.02;
    if (peak.value > kMinGain * without) prior.intrinsics.k1 = kMinK1 + kStepK1 * peak.index;
  }
}

}  // namespace hybridfusion
