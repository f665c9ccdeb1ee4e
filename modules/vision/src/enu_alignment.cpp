#include "enu_alignment.hpp"

#include "flight_errors.hpp"
#include "gravity_cue.hpp"
#include "robust_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMinContradiction_rad = 1.0 * kDegree;  // between GNSS and a measured up direction
constexpr double kMaxTiltSigma_rad = 5.0 * kDegree;
constexpr double kMaxRatio = 3.0;  // residuals over stated sigmas
constexpr double kTightUp = 0.1;   // share of the cue's sigma when it alone decides
// An error of the tags is believed when it explains most of the residuals, is certain, and matters.
constexpr double kExplained = 0.6;
constexpr double kCertain = 4.0;
constexpr double kMinDrift_m = 2.0;
constexpr double kMinLag_s = 0.2;

std::vector<PositionPair> collect(const SfmModel& model, const GnssIngest& gnss) {
  const std::vector<Eigen::Vector3d> velocities = view_velocities(model, gnss);
  std::vector<PositionPair> pairs;
  for (const std::uint32_t view : model.registered()) {
    const PhotoFix& fix = gnss.fixes[view];
    if (!fix.position_in_enu) continue;
    PositionPair pair{.in_world = model.world_from_view[view]->translation,
                      .in_enu = *fix.position_in_enu,
                      .sigma_m = fix.sigma_m,
                      .velocity_in_world = velocities[view],
                      .flight = fix.flight,
                      .flight_time_s = fix.flight_time_s};
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

std::optional<UpPrior> prior_of(const std::optional<GravityCue>& cue) {
  if (!cue) return std::nullopt;
  return UpPrior{.up_in_world = cue->up_in_world, .sigma_rad = cue->sigma_rad};
}

/// Largest difference of the modelled height errors of two photos.
double drift_range_m(std::span<const PositionPair> pairs, const SimilarityFit& fit) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const PositionPair& pair : pairs) {
    const FlightErrors& flight = fit.flights[static_cast<std::size_t>(pair.flight)];
    const double error_m = flight.offset_m + flight.rate_mps * pair.flight_time_s;
    least = std::min(least, error_m);
    most = std::max(most, error_m);
  }
  return most - least;
}

/// Whether the drift of at least one flight is certain; so for the lag.
bool any_certain(const SimilarityFit& fit, double FlightErrors::* member, double least) {
  for (std::size_t f = 0; f < fit.flights.size(); ++f) {
    const double value = std::abs(fit.flights[f].*member);
    if (value > least && value > kCertain * fit.sigmas[f].*member) return true;
  }
  return false;
}

/// The simplest model of the tag errors that explains the residuals: from the richest one, each
/// error is dropped that the fit hardly needs. The two judge on different axes.
TagErrorModel choose_errors(std::span<const PositionPair> pairs,
                            const Sim3& start,
                            const std::optional<GravityCue>& cue) {
  // A guess could not tell a drift from a tilt.
  const auto up = cue && cue->measured ? prior_of(cue) : std::nullopt;
  const auto fit = [&](bool drift, bool lag) {
    return refine_similarity(pairs, start, up, {.drift = drift, .lag = lag});
  };
  const SimilarityFit both = fit(true, true);
  TagErrorModel model;
  model.lag = any_certain(both, &FlightErrors::lag_s, kMinLag_s) &&
              both.horizontal_spread < kExplained * fit(true, false).horizontal_spread;
  const SimilarityFit drifting = model.lag ? both : fit(true, false);
  const bool certain = any_certain(drifting, &FlightErrors::rate_mps, 0.0) ||
                       any_certain(drifting, &FlightErrors::offset_m, kMinDrift_m);
  model.drift = certain && drift_range_m(pairs, drifting) > kMinDrift_m &&
                drifting.vertical_spread < kExplained * fit(false, model.lag).vertical_spread;
  return model;
}

Expected<SimilarityFit> fit_by_cue(std::vector<PositionPair> pairs,
                                   const GravityCue& cue,
                                   const TagErrorModel& errors,
                                   const Random& random) {
  HF_TRY(const Sim3 start, least_median_upright_similarity(pairs, cue.up_in_world, random));
  for (PositionPair& pair : pairs) pair.sigma_m.z() = kUnknownSigma_m;
  const UpPrior up{.up_in_world = cue.up_in_world, .sigma_rad = kTightUp * cue.sigma_rad};
  return refine_similarity(pairs, start, up, {.lag = errors.lag});
}

EnuAlignment without_altitudes(const SimilarityFit& fit,
                               const GravityCue& cue,
                               const TagErrorModel& errors,
                               std::string_view why) {
  return {
      .enu_from_world = fit.enu_from_world,
      .altitude_trusted = false,
      .flights = fit.flights,
      .errors = {.lag = errors.lag},
      .up = prior_of(cue),
      .warnings = {fmt::format("GNSS altitudes are not used for the orientation of the model ({}); "
                               "up is taken from {}",
                               why,
                               cue.source)}};
}

/// Whether a cue from how photos are usually taken is believed more than a similarity that uses the
/// altitudes. Horizontal positions judge without altitudes: a wrong tilt foreshortens the flight.
bool guess_wins(const GravityCue& cue,
                const SimilarityFit& full,
                const SimilarityFit& by_cue,
                double tilt) {
  if (tilt < 3.0 * cue.sigma_rad) return false;
  if (by_cue.horizontal_ratio < 0.5 * full.horizontal_ratio) return true;
  const bool fits = full.vertical_ratio < kMaxRatio && full.horizontal_ratio < kMaxRatio;
  return !fits && by_cue.horizontal_ratio < 1.2 * full.horizontal_ratio;
}

void warn_of_errors(const SimilarityFit& fit, EnuAlignment& result) {
  for (std::size_t f = 0; f < fit.flights.size(); ++f) {
    const FlightErrors& flight = fit.flights[f];
    if (result.errors.drift && (flight.rate_mps != 0.0 || flight.offset_m != 0.0)) {
      result.warnings.push_back(fmt::format(
          "GNSS altitudes of flight {} drift by {:.1f} m a minute, {:.1f} m off at its first "
          "photo: the drift is taken out",
          f + 1,
          60.0 * flight.rate_mps,
          flight.offset_m));
    }
    if (result.errors.lag && flight.lag_s != 0.0) {
      result.warnings.push_back(
          fmt::format("GNSS positions of flight {} are {:.1f} s {} their photos: corrected",
                      f + 1,
                      std::abs(flight.lag_s),
                      flight.lag_s > 0.0 ? "behind" : "ahead of"));
    }
  }
}

/// Altitudes and cue together, or the cue alone where they contradict each other.
Expected<EnuAlignment> weigh(std::span<const PositionPair> pairs,
                             const Sim3& start,
                             const GravityCue& cue,
                             const Random& random) {
  const TagErrorModel errors = choose_errors(pairs, start, cue);
  // A guessed up direction only fills in where GNSS leaves the tilt open.
  const SimilarityFit gnss_alone = refine_similarity(pairs, start, std::nullopt, errors);
  const double tilt = tilt_rad(gnss_alone.enu_from_world, cue.up_in_world);
  const double tolerance = 3.0 * std::hypot(gnss_alone.tilt_sigma_rad, cue.sigma_rad);
  HF_TRY(const SimilarityFit by_cue, fit_by_cue({pairs.begin(), pairs.end()}, cue, errors, random));
  const bool contradicted = cue.measured ? tilt > std::max(tolerance, kMinContradiction_rad)
                                         : guess_wins(cue, gnss_alone, by_cue, tilt);
  if (contradicted) {
    return without_altitudes(
        by_cue,
        cue,
        errors,
        fmt::format("they would tilt it by {:.1f} degrees; vertical residuals are {:.1f} sigma",
                    tilt / kDegree,
                    gnss_alone.vertical_ratio));
  }
  const bool open = gnss_alone.tilt_sigma_rad > kMaxTiltSigma_rad && tilt < tolerance;
  EnuAlignment result{.errors = errors};
  if (cue.measured || open || errors.drift) result.up = prior_of(cue);
  const SimilarityFit fit = refine_similarity(pairs, gnss_alone.enu_from_world, result.up, errors);
  result.enu_from_world = fit.enu_from_world;
  result.flights = fit.flights;
  warn_of_errors(fit, result);
  return result;
}

}  // namespace

Expected<EnuAlignment> align_to_enu(const SfmModel& model,
                                    const GnssIngest& gnss,
                                    std::span<const PhotoMetadata> photos,
                                    Random random) {
  const std::vector<PositionPair> pairs = collect(model, gnss);
  const Expected<Sim3> start = least_median_similarity(pairs, random);
  if (!start && start.error().code == ErrorCode::kInsufficient) {
    return std::unexpected(start.error());
  }
  const std::optional<GravityCue> cue = find_cue(model, photos);
  if (!start) {
    if (!cue) return std::unexpected(start.error());
    HF_TRY(const SimilarityFit by_cue, fit_by_cue(pairs, *cue, {}, random));
    return without_altitudes(by_cue, *cue, {}, "the photos lie on one line");
  }
  const bool has_altitudes = std::ranges::any_of(
      pairs, [](const PositionPair& pair) { return pair.sigma_m.z() < kUnknownSigma_m; });
  if (cue && !has_altitudes) {
    HF_TRY(const SimilarityFit by_cue, fit_by_cue(pairs, *cue, {}, random));
    return without_altitudes(by_cue, *cue, {}, "the photos carry none");
  }
  if (cue) return weigh(pairs, *start, *cue, random);
  EnuAlignment result{.errors = choose_errors(pairs, *start, std::nullopt)};
  const SimilarityFit fit = refine_similarity(pairs, *start, std::nullopt, result.errors);
  result.enu_from_world = fit.enu_from_world;
  result.flights = fit.flights;
  warn_of_errors(fit, result);
  return result;
}

EnuAlignment align_to_nothing(const SfmModel& model, std::span<const PhotoMetadata> photos) {
  constexpr double kDepth = 50.0;
  EnuAlignment result{.altitude_trusted = false};
  Sim3& placed = result.enu_from_world;
  if (const std::optional<GravityCue> cue = find_cue(model, photos)) {
    placed.rotation =
        Eigen::Quaterniond::FromTwoVectors(cue->up_in_world, Eigen::Vector3d::UnitZ());
  }
  const std::vector<std::uint32_t> views = model.registered();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::uint32_t view : views) {
    middle += model.world_from_view[view]->translation / static_cast<double>(views.size());
  }
  std::vector<double> depths;
  for (std::size_t t = 0; t < model.tracks.size(); ++t) {
    if (!model.points[t]) continue;
    for (const TrackElement& e : model.tracks[t]) {
      if (!e.active) continue;
      depths.push_back((*model.points[t] - model.world_from_view[e.view]->translation).norm());
    }
  }
  if (!depths.empty()) placed.scale = kDepth / median(std::move(depths));
  placed.translation = -placed.scale * (placed.rotation * middle);
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
