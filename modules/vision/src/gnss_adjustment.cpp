#include "gnss_adjustment.hpp"

#include "flight_errors.hpp"
#include "incremental_mapper.hpp"
#include "robust_statistics.hpp"
#include "triangulation.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMinSigma_px = 0.15;
constexpr double kMinError_px = 1.0;  // filters never cut below this
constexpr double kFilterSigmas = 5.0;

/// Robust deviation of one pixel coordinate.
double pixel_sigma(const SfmModel& model) {
  std::vector<double> errors;
  for (std::size_t t = 0; t < model.tracks.size(); ++t) {
    if (!model.points[t]) continue;
    for (const TrackElement& element : model.tracks[t]) {
      if (element.active) errors.push_back(model.error_px(element, *model.points[t]));
    }
  }
  // The length of a normal 2-vector has its median at 1.1774 sigma.
  return errors.empty() ? 1.0 : std::max(kMinSigma_px, median(std::move(errors)) / 1.1774);
}

/// Variance components: where the residuals are larger than stated, the stated sigmas were too
/// optimistic; they are scaled by this share of the excess, per axis group.
void scale_sigmas(const SfmModel& model, const GnssTerms& stated, double share, GnssTerms& used) {
  const std::vector<Eigen::Vector3d> residuals = gnss_residuals(model, used);
  std::vector<double> horizontal;
  std::vector<double> vertical;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Eigen::Vector3d ratio = residuals[i].cwiseQuotient(stated.observations[i].sigma_m);
    horizontal.insert(horizontal.end(), {ratio.x(), ratio.y()});
    if (stated.observations[i].sigma_m.z() < kUnknownSigma_m) vertical.push_back(ratio.z());
  }
  if (residuals.size() < 5) return;
  const auto scale = [&](std::vector<double> ratios) {
    if (ratios.empty()) return 1.0;
    return std::max(1.0, share * robust_sigma_about_zero(std::move(ratios)));
  };
  const double horizontal_scale = scale(std::move(horizontal));
  const double vertical_scale = scale(std::move(vertical));
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    used.observations[i].sigma_m = stated.observations[i].sigma_m.cwiseProduct(
        Eigen::Vector3d(horizontal_scale, horizontal_scale, vertical_scale));
  }
}

/// Eq. (3) sees displacements only: the place comes from the median of the positions.
void restore_place(SfmModel& model, const GnssTerms& terms) {
  const std::vector<Eigen::Vector3d> residuals = gnss_residuals(model, terms);
  if (residuals.empty()) return;
  Eigen::Vector3d shift;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& r : residuals) values.push_back(r[axis]);
    shift[axis] = median(std::move(values));
  }
  for (auto& pose : model.world_from_view) {
    if (pose) pose->translation -= shift;
  }
  for (auto& point : model.points) {
    if (point) *point -= shift;
  }
}

/// Velocities of the cameras that carry the tags, where a lag turns them into distances.
void update_velocities(const SfmModel& model, GnssTerms& terms) {
  if (!terms.estimate_lag) return;
  std::vector<TimedPosition> track;
  for (const GnssObservation& o : terms.observations) {
    track.push_back({.position = model.world_from_view[o.view]->translation,
                     .flight = o.flight,
                     .time_s = o.flight_time_s});
  }
  const std::vector<Eigen::Vector3d> velocities = track_velocities(track);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    terms.observations[i].velocity_mps = velocities[i];
  }
}

}  // namespace

GnssTerms gnss_terms(const SfmModel& model,
                     const GnssIngest& gnss,
                     const GnssOptions& options,
                     const Placement& placement) {
  GnssTerms terms;
  terms.form = options.form == "displacement" ? GnssForm::kDisplacement : GnssForm::kAbsolute;
  terms.loss_width = options.loss_width;
  terms.estimate_drift = placement.errors.drift;
  terms.estimate_lag = placement.errors.lag;
  terms.flights = placement.flights;
  terms.ups = placement.ups;
  terms.antenna_in_camera = {
      options.antenna_right_m, options.antenna_down_m, options.antenna_forward_m};
  for (const std::size_t view : gnss.by_time) {
    const PhotoFix& fix = gnss.fixes[view];
    if (!fix.position_in_enu || !model.world_from_view[view]) continue;
    GnssObservation o{.view = static_cast<std::uint32_t>(view),
                      .position = *fix.position_in_enu,
                      .sigma_m = fix.sigma_m,
                      .flight = fix.flight,
                      .flight_time_s = fix.flight_time_s};
    if (!fix.has_altitude || !placement.altitude_trusted) o.sigma_m.z() = kUnknownSigma_m;
    terms.observations.push_back(o);
  }
  update_velocities(model, terms);
  return terms;
}

std::vector<Eigen::Vector3d> gnss_residuals(const SfmModel& model, const GnssTerms& terms) {
  std::vector<Eigen::Vector3d> residuals;
  for (const GnssObservation& o : terms.observations) {
    const Eigen::Vector3d antenna = *model.world_from_view[o.view] * terms.antenna_in_camera;
    const auto flight = static_cast<std::size_t>(o.flight);
    const FlightErrors errors =
        flight < terms.flights.size() ? terms.flights[flight] : FlightErrors{};
    residuals.push_back(antenna + tag_error(errors, o.flight_time_s, o.velocity_mps) - o.position);
  }
  return residuals;
}

Expected<void> adjust_with_gnss(SfmModel& model,
                                GnssTerms& terms,
                                std::span<const ControlTarget> control,
                                const ReconstructionOptions& options,
                                const RunContext& ctx) {
  const GnssTerms stated = terms;
  // Tags that are far worse than stated would bend the first adjustment.
  constexpr double kFirstShare = 0.1;
  scale_sigmas(model, stated, kFirstShare, terms);
  std::vector<std::uint32_t> all(model.tracks.size());
  std::iota(all.begin(), all.end(), 0);
  for (int round = 0; round < options.adjustment.rounds; ++round) {
    ctx.report({.stage = "vision/adjustment", .done = round, .total = options.adjustment.rounds});
    const double sigma_px = pixel_sigma(model);
    AdjustmentRequest request;
    request.free_views = model.registered();
    request.tracks = select_tracks(model, 0);
    request.calibration =
        model.num_registered() >=
                static_cast<std::size_t>(options.intrinsics.principal_point_min_views)
            ? CalibrationLevel::kFull
            : CalibrationLevel::kRadial;
    request.sigma_px = std::max(sigma_px, options.adjustment.sigma_px);
    request.loss_width_px = options.adjustment.loss_width_px;
    request.max_iterations = options.adjustment.max_iterations;
    if (!terms.observations.empty()) request.gnss = &terms;
    request.control = control;
    const bool held = request.gnss != nullptr || !control.empty();
    request.covariance = held && round + 1 == options.adjustment.rounds;
    HF_TRY(const AdjustmentSummary summary, adjust(model, request, options.intrinsics, ctx));
    if (terms.form == GnssForm::kDisplacement) restore_place(model, terms);
    update_velocities(model, terms);
    ctx.info(fmt::format("adjustment {}: {} iterations, cost {:.0f} -> {:.0f}, pixel sigma {:.3f}",
                         round + 1,
                         summary.iterations,
                         summary.initial_cost,
                         summary.final_cost,
                         sigma_px));
    const double limit_px =
        std::clamp(kFilterSigmas * pixel_sigma(model), kMinError_px, options.mapping.max_error_px);
    MappingOptions mapping = options.mapping;
    mapping.max_error_px = limit_px;
    triangulate_tracks(model, all, mapping, ctx);
    scale_sigmas(model, stated, 1.0, terms);
  }
  ctx.report({.stage = "vision/adjustment",
              .done = options.adjustment.rounds,
              .total = options.adjustment.rounds});
  return {};
}

}  // namespace hybridfusion
