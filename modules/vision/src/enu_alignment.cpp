#include "enu_alignment.hpp"

#include "gravity_cue.hpp"
#include "similarity_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMaxTilt_rad = 5.0 * kDegree;  // between GNSS and a measured up direction
constexpr double kMaxTiltSigma_rad = 5.0 * kDegree;
constexpr double kMaxRatio = 3.0;          // residuals over stated sigmas
constexpr double kUnknownSigma_m = 1.0e3;  // of an altitude that must not turn the model
constexpr double kTightUp = 0.1;           // share of the cue's sigma when it alone decides

std::vector<PositionPair> collect(const SfmModel& model, const GnssIngest& gnss) {
  std::vector<PositionPair> pairs;
  for (const std::uint32_t view : model.registered()) {
    const PhotoFix& fix = gnss.fixes[view];
    if (!fix.position_in_enu) continue;
    PositionPair pair{.in_world = model.world_from_view[view]->translation,
                      .in_enu = *fix.position_in_enu,
                      .sigma_m = fix.sigma_m};
    if (!fix.has_altitude) pair.sigma_m.z() = kUnknownSigma_m;
    pairs.push_back(pair);
  }
  return pairs;
}

double tilt_rad(const Sim3& enu_from_world, const Eigen::Vector3d& up_in_world) {
  return std::acos(std::clamp((enu_from_world.rotation * up_in_world).z(), -1.0, 1.0));
}

std::optional<GravityCue> find_cue(const SfmModel& model, std::span<const PhotoMetadata> photos) {
  if (auto cue = gravity_from_gimbals(model, photos)) return cue;
  if (auto cue = gravity_from_level_rows(model)) return cue;
  return gravity_from_common_axis(model);
}

Expected<SimilarityFit> fit_by_cue(std::vector<PositionPair> pairs,
                                   const GravityCue& cue,
                                   const Random& random) {
  HF_TRY(const Sim3 start, least_median_upright_similarity(pairs, cue.up_in_world, random));
  for (PositionPair& pair : pairs) pair.sigma_m.z() = kUnknownSigma_m;
  const UpPrior up{.up_in_world = cue.up_in_world, .sigma_rad = kTightUp * cue.sigma_rad};
  return refine_similarity(pairs, start, up);
}

EnuAlignment without_altitudes(const SimilarityFit& fit,
                               const GravityCue& cue,
                               std::string_view why) {
  return {
      .enu_from_world = fit.enu_from_world,
      .altitude_trusted = false,
      .warning = fmt::format("GNSS altitudes are not used for the orientation of the model ({}); "
                             "up is taken from {}",
                             why,
                             cue.source)};
}

/// Whether `cue` is believed more than a similarity that uses the altitudes. Horizontal positions
/// judge without altitudes: a wrong tilt foreshortens the flight.
bool cue_wins(const GravityCue& cue,
              const SimilarityFit& full,
              const SimilarityFit& by_cue,
              double tilt) {
  if (cue.measured) return tilt > kMaxTilt_rad;
  if (tilt < 3.0 * cue.sigma_rad) return false;
  if (by_cue.horizontal_ratio < 0.5 * full.horizontal_ratio) return true;
  const bool fits = full.vertical_ratio < kMaxRatio && full.horizontal_ratio < kMaxRatio;
  return !fits && by_cue.horizontal_ratio < 1.2 * full.horizontal_ratio;
}

}  // namespace

Expected<EnuAlignment> align_to_enu(const SfmModel& model,
                                    const GnssIngest& gnss,
                                    std::span<const PhotoMetadata> photos,
                                    Random random) {
  const std::vector<PositionPair> pairs = collect(model, gnss);
  const Expected<Sim3> full = least_median_similarity(pairs, random);
  if (!full && full.error().code == ErrorCode::kInsufficient) return std::unexpected(full.error());
  const std::optional<GravityCue> cue = find_cue(model, photos);
  if (!full) {
    if (!cue) return std::unexpected(full.error());
    HF_TRY(const SimilarityFit by_cue, fit_by_cue(pairs, *cue, random));
    return without_altitudes(by_cue, *cue, "the photos lie on one line");
  }
  std::optional<UpPrior> prior;
  if (cue && cue->measured) {
    prior = UpPrior{.up_in_world = cue->up_in_world, .sigma_rad = cue->sigma_rad};
  }
  const SimilarityFit fit = refine_similarity(pairs, *full, prior);
  EnuAlignment result{.enu_from_world = fit.enu_from_world};
  if (!cue) return result;
  const double tilt = tilt_rad(fit.enu_from_world, cue->up_in_world);
  HF_TRY(const SimilarityFit by_cue, fit_by_cue(pairs, *cue, random));
  if (cue_wins(*cue, fit, by_cue, tilt)) {
    return without_altitudes(
        by_cue,
        *cue,
        fmt::format("they would tilt it by {:.1f} degrees; vertical residuals are {:.1f} sigma",
                    tilt / kDegree,
                    fit.vertical_ratio));
  }
  const bool agrees = tilt < 3.0 * std::hypot(fit.tilt_sigma_rad, cue->sigma_rad);
  if (!cue->measured && fit.tilt_sigma_rad > kMaxTiltSigma_rad && agrees) {
    // GNSS leaves the tilt open: the guess fills in, but does not overrule it.
    prior = UpPrior{.up_in_world = cue->up_in_world, .sigma_rad = cue->sigma_rad};
    result.enu_from_world = refine_similarity(pairs, fit.enu_from_world, prior).enu_from_world;
  }
  return result;
}

void transform_model(SfmModel& model, const Sim3& target_from_world) {
  for (auto& pose : model.world_from_view) {
    if (pose) pose = target_from_world.map_pose(*pose);
  }
  for (auto& point : model.points) {
    if (point) point = target_from_world * *point;
  }
}

}  // namespace hybridfusion
