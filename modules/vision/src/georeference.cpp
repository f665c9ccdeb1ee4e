#include "georeference.hpp"

#include "gnss_adjustment.hpp"
#include "robust_statistics.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

void fill_residuals(const SfmModel& model, const GnssTerms& terms, ReconstructionQuality& out) {
  const std::vector<Eigen::Vector3d> residuals = gnss_residuals(model, terms);
  if (residuals.empty()) return;
  std::vector<double> horizontal;
  std::vector<double> vertical;
  const auto count = static_cast<double>(residuals.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    horizontal.insert(horizontal.end(), {residuals[i].x(), residuals[i].y()});
    out.gnss_horizontal_rms_m += residuals[i].head<2>().squaredNorm() / count;
    if (terms.observations[i].sigma_m.z() < kUnknownSigma_m) vertical.push_back(residuals[i].z());
  }
  for (const double v : vertical) {
    out.gnss_vertical_rms_m += v * v / static_cast<double>(vertical.size());
  }
  out.gnss_horizontal_rms_m = std::sqrt(out.gnss_horizontal_rms_m);
  out.gnss_vertical_rms_m = std::sqrt(out.gnss_vertical_rms_m);
  out.estimated_sigma_horizontal_m = robust_sigma_about_zero(std::move(horizontal));
  if (!vertical.empty()) {
    out.estimated_sigma_vertical_m = robust_sigma_about_zero(std::move(vertical));
  }
}

/// Deviations of scale and tilt, by a similarity that leaves the model where it is.
void fill_uncertainty(const SfmModel& model,
                      const GnssTerms& terms,
                      const Placement& placement,
                      ReconstructionQuality& out) {
  std::vector<PositionPair> pairs;
  for (const GnssObservation& o : terms.observations) {
    pairs.push_back({.in_world = *model.world_from_view[o.view] * terms.antenna_in_camera,
                     .in_enu = o.position,
                     .sigma_m = o.sigma_m,
                     .velocity_in_world = o.velocity_mps,
                     .flight = o.flight,
                     .flight_time_s = o.flight_time_s});
  }
  if (pairs.size() < 3) return;
  std::optional<UpPrior> up;
  if (placement.up_sigma_rad) up = UpPrior{.sigma_rad = *placement.up_sigma_rad};
  const SimilarityFit fit = refine_similarity(pairs, Sim3{}, up, placement.errors);
  out.scale_sigma = fit.scale_sigma;
  out.tilt_sigma_rad = fit.tilt_sigma_rad;
}

class Judge {
 public:
  explicit Judge(ReconstructionQuality& out) : out_(out) {}

  void find(GeoreferenceVerdict verdict, std::string reason) {
    out_.georeference = std::max(out_.georeference, verdict);
    out_.georeference_reasons.push_back(std::move(reason));
  }

  void limit(double value, double good, double usable, const std::string& reason) {
    if (value <= good) return;
    find(value <= usable ? GeoreferenceVerdict::kLimited : GeoreferenceVerdict::kUnusable, reason);
  }

 private:
  ReconstructionQuality& out_;
};

void judge_flights(const GnssTerms& terms, Judge& judge) {
  for (std::size_t f = 0; f < terms.flights.size(); ++f) {
    const FlightErrors& flight = terms.flights[f];
    if (terms.estimate_drift && (flight.offset_m != 0.0 || flight.rate_mps != 0.0)) {
      judge.find(GeoreferenceVerdict::kLimited,
                 fmt::format("the altitudes of flight {} drift ({:.1f} m a minute, taken out): "
                             "heights rest on its first photos",
                             f + 1,
                             60.0 * flight.rate_mps));
    }
    if (terms.estimate_lag && flight.lag_s != 0.0) {
      judge.find(
          GeoreferenceVerdict::kLimited,
          fmt::format("the positions of flight {} are {:.2f} s behind its photos (corrected)",
                      f + 1,
                      flight.lag_s));
    }
  }
}

/// Deviations that the adjustment had to raise above what the tags state.
void judge_excess(const GnssTerms& terms, const GnssIngest& stated, Judge& judge) {
  Eigen::Vector3d excess = Eigen::Vector3d::Ones();
  for (const GnssObservation& o : terms.observations) {
    Eigen::Vector3d ratio = o.sigma_m.cwiseQuotient(stated.fixes[o.view].sigma_m);
    if (!(o.sigma_m.z() < kUnknownSigma_m)) ratio.z() = 1.0;
    excess = excess.cwiseMax(ratio);
  }
  constexpr double kMaxExcess = 3.0;
  if (excess.maxCoeff() <= kMaxExcess) return;
  judge.find(GeoreferenceVerdict::kLimited,
             fmt::format("GNSS residuals are {:.1f} (horizontal) and {:.1f} (vertical) times the "
                         "stated deviations",
                         excess.head<2>().maxCoeff(),
                         excess.z()));
}

}  // namespace

void assess_georeference(const SfmModel& model,
                         const GnssTerms& terms,
                         const GnssIngest& gnss,
                         const Placement& placement,
                         ReconstructionQuality& out) {
  fill_residuals(model, terms, out);
  fill_uncertainty(model, terms, placement, out);
  out.flights = terms.flights;
  Judge judge(out);
  judge.limit(out.scale_sigma,
              0.005,
              0.01,
              fmt::format("the scale is known to {:.1f} % only", 100.0 * out.scale_sigma));
  judge.limit(
      out.tilt_sigma_rad,
      0.5 * kDegree,
      1.0 * kDegree,
      fmt::format("the tilt is known to {:.1f} degrees only", out.tilt_sigma_rad / kDegree));
  const bool has_altitudes = std::ranges::any_of(
      terms.observations, [&](const auto& o) { return gnss.fixes[o.view].has_altitude; });
  if (!has_altitudes) {
    judge.find(GeoreferenceVerdict::kLimited,
               "the photos carry no usable altitude: heights count from the flight");
  } else if (!placement.altitude_trusted) {
    judge.find(GeoreferenceVerdict::kLimited,
               "the altitudes contradict the direction of gravity: heights are uncertain");
  }
  constexpr double kDeadSea_m = -50.0;
  if (has_altitudes && gnss.origin.altitude_m < kDeadSea_m) {
    judge.find(
        GeoreferenceVerdict::kLimited,
        "the photos lie below sea level: GPSAltitudeRef may be wrong, and the height with it");
  }
  judge_flights(terms, judge);
  judge_excess(terms, gnss, judge);
}

double dome_between(std::span<const Eigen::Vector3d> before,
                    std::span<const Eigen::Vector3d> after) {
  constexpr std::size_t kLeast = 8;
  if (before.size() < kLeast) return 0.0;
  const auto after_from_before = fit_sim3(after, before);
  if (!after_from_before) return 0.0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& c : after) middle += c / static_cast<double>(after.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  double edge2 = 0.0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Eigen::Vector2d at = (after[i] - middle).head<2>();
    const double rise = (after[i] - *after_from_before * before[i]).z();
    const Eigen::Vector4d row(1.0, at.x(), at.y(), at.squaredNorm());
    normal += row * row.transpose();
    right += rise * row;
    edge2 = std::max(edge2, at.squaredNorm());
  }
  const Eigen::Vector4d solution = normal.ldlt().solve(right);
  return solution.allFinite() ? solution[3] * edge2 : 0.0;
}

void judge_control(std::span<const ControlTarget> targets, Reconstruction& result) {
  std::vector<double> gaps_m;
  for (const ControlResidual& residual : result.control) {
    if (residual.held_out_m.allFinite()) gaps_m.push_back(residual.held_out_m.norm());
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ControlTarget& target : targets) {
    mean += target.position / static_cast<double>(targets.size());
  }
  double spread2 = 0.0;
  for (const ControlTarget& target : targets) {
    spread2 += (target.position - mean).squaredNorm();
  }
  if (gaps_m.empty() || !(spread2 > 0.0)) return;
  const double gap_m = median(std::move(gaps_m));
  result.quality.scale_sigma = gap_m / std::sqrt(spread2);
  result.quality.tilt_sigma_rad = result.quality.scale_sigma;
  Judge judge(result.quality);
  judge.limit(result.quality.scale_sigma,
              0.005,
              0.01,
              fmt::format("ground control points leave {:.2f} m when they are held out", gap_m));
}

}  // namespace hybridfusion
