#include <hybridfusion/lidar/gnss_alignment.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinFixes = 5;
constexpr std::size_t kMaxSeeds = 40;
constexpr int kMaxPasses = 20;
// A track must be longer than its noise by this before its heading means anything.
constexpr double kMinExtentOverSigma = 5.0;
// Slow errors of a receiver (atmosphere, multipath) drift by this share of the stated deviation
// within a drive; neither the scatter nor its correlation shows them.
constexpr double kSlowDriftShare = 0.15;
constexpr double kMaxPlausible_m = 1e5;

struct Pair {
  Timestamp time{};
  Eigen::Vector3d antenna_in_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d fix_in_enu = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();
};

struct Fit {
  double yaw = 0.0;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

Eigen::Vector3d apply(const Fit& fit, const Eigen::Vector3d& p) {
  const double c = std::cos(fit.yaw);
  const double s = std::sin(fit.yaw);
  return fit.translation + Eigen::Vector3d(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::vector<Pair> pair_up(const Trajectory& trajectory,
                          std::span<const GnssFix> fixes,
                          const GeodeticOrigin& origin,
                          const Eigen::Vector3d& antenna_in_imu,
                          const GnssAlignmentOptions& options) {
  std::vector<Pair> pairs;
  for (const GnssFix& fix : fixes) {
    const GeodeticPosition& at = fix.position;
    if (!std::isfinite(at.latitude_deg) || !std::isfinite(at.longitude_deg) ||
        !std::isfinite(at.altitude_m) || std::abs(at.latitude_deg) > 90.0) {
      continue;
    }
    const auto pose = interpolate(trajectory, fix.time, options.max_time_gap_s);
    if (!pose) continue;
    Pair pair{.time = fix.time,
              .antenna_in_map = *pose * antenna_in_imu,
              .fix_in_enu = enu_from_geodetic(origin, at)};
    for (int i = 0; i < 3; ++i) {
      const double sigma = fix.sigma_enu_m[i];
      pair.sigma_m[i] = std::isfinite(sigma) && sigma > 0.0 ? sigma : options.default_sigma_m;
    }
    if (pair.fix_in_enu.allFinite() && pair.fix_in_enu.norm() < kMaxPlausible_m) {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

/// Weighted least squares in closed form: yaw from the centred horizontal tracks, then translation.
Fit solve(const std::vector<Pair>& pairs, const std::vector<double>& weights) {
  Eigen::Vector3d center_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d center_enu = Eigen::Vector3d::Zero();
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    center_map += weights[i] / total * pairs[i].antenna_in_map;
    center_enu += weights[i] / total * pairs[i].fix_in_enu;
  }
  double dot = 0.0;
  double cross = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Eigen::Vector3d a = pairs[i].antenna_in_map - center_map;
    const Eigen::Vector3d b = pairs[i].fix_in_enu - center_enu;
    dot += weights[i] * (a.x() * b.x() + a.y() * b.y());
    cross += weights[i] * (a.x() * b.y() - a.y() * b.x());
  }
  Fit fit{.yaw = std::atan2(cross, dot)};
  fit.translation = center_enu - apply(fit, center_map);
  return fit;
}

/// Least median of squares over pairs of distant fixes: right with up to half of them wrong.
Fit robust_start(const std::vector<Pair>& pairs, double extent_m) {
  std::vector<std::size_t> seeds;
  const std::size_t stride = (pairs.size() - 1) / kMaxSeeds + 1;
  for (std::size_t i = 0; i < pairs.size(); i += stride) seeds.push_back(i);
  Fit best;
  double best_median = std::numeric_limits<double>::infinity();
  std::vector<double> distances(pairs.size());
  for (std::size_t a = 0; a < seeds.size(); ++a) {
    for (std::size_t b = a + 1; b < seeds.size(); ++b) {
      const std::vector<Pair> two{pairs[seeds[a]], pairs[seeds[b]]};
      const double length = (two[1].antenna_in_map - two[0].antenna_in_map).head<2>().norm();
      if (length < 0.4 * extent_m) continue;
      const Fit fit = solve(two, {1.0, 1.0});
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        distances[i] = (pairs[i].fix_in_enu - apply(fit, pairs[i].antenna_in_map)).squaredNorm();
      }
      const double m = median(distances);
      if (m < best_median) {
        best_median = m;
        best = fit;
      }
    }
  }
  return best;
}

double extent_of(const std::vector<Pair>& pairs) {
  double extent2 = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t j = i + 1; j < pairs.size(); j += 1 + pairs.size() / 200) {
      extent2 = std::max(
          extent2, (pairs[i].antenna_in_map - pairs[j].antenna_in_map).head<2>().squaredNorm());
    }
  }
  return std::sqrt(extent2);
}

/// Number of successive residuals that one independent error spans (integrated autocorrelation).
double correlation_length(const std::vector<Eigen::Vector3d>& residuals) {
  double variance = 0.0;
  for (const auto& r : residuals) variance += r.head<2>().squaredNorm();
  double length = 1.0;
  for (std::size_t lag = 1; lag < residuals.size() / 2 && variance > 0.0; ++lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < residuals.size(); ++i) {
      sum += residuals[i].head<2>().dot(residuals[i - lag].head<2>());
    }
    if (sum / variance < 0.05) break;
    length += 2.0 * sum / variance;
  }
  return std::min(length, static_cast<double>(residuals.size()) / 2.0);
}

/// Reweighted least squares with a hard gate that shrinks to `outlier_sigmas`.
Fit reweighted(const std::vector<Pair>& pairs,
               double outlier_sigmas,
               Fit fit,
               std::vector<double>& weights) {
  weights.assign(pairs.size(), 1.0);
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    std::vector<double> scaled(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Eigen::Vector3d r = pairs[i].fix_in_enu - apply(fit, pairs[i].antenna_in_map);
      scaled[i] = r.cwiseQuotient(pairs[i].sigma_m).norm() / std::numbers::sqrt3;
    }
    // Receivers are often better or worse than they say: the gate follows the residuals.
    const double gate = outlier_sigmas * std::max(1.0, 1.3 * median(scaled));
    const std::vector<double> before = weights;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      weights[i] = scaled[i] > gate ? 0.0 : 1.0 / pairs[i].sigma_m.head<2>().squaredNorm();
    }
    fit = solve(pairs, weights);
    if (pass > 0 && weights == before) break;
  }
  return fit;
}

void fill_statistics(const std::vector<Pair>& pairs,
                     const std::vector<double>& weights,
                     const Fit& fit,
                     GnssAlignment& out) {
  std::vector<Eigen::Vector3d> used;
  Eigen::Vector3d mean_sigma = Eigen::Vector3d::Zero();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double sum_horizontal = 0.0;
  double sum_vertical = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Eigen::Vector3d r = pairs[i].fix_in_enu - apply(fit, pairs[i].antenna_in_map);
    out.residuals.push_back({.time = pairs[i].time, .enu_m = r, .used = weights[i] > 0.0});
    if (weights[i] <= 0.0) continue;
    used.push_back(r);
    mean_sigma += pairs[i].sigma_m;
    center += pairs[i].antenna_in_map;
    sum_horizontal += r.head<2>().squaredNorm();
    sum_vertical += r.z() * r.z();
  }
  const auto count = static_cast<double>(used.size());
  out.num_used = used.size();
  out.num_outliers = pairs.size() - used.size();
  if (used.empty()) return;
  mean_sigma /= count;
  center /= count;
  out.rms_horizontal_m = std::sqrt(sum_horizontal / count);
  out.rms_vertical_m = std::sqrt(sum_vertical / count);
  double lever2 = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (weights[i] > 0.0) {
      lever2 += (pairs[i].antenna_in_map - center).head<2>().squaredNorm();
    }
  }
  // Correlated errors: fewer independent fixes. The constant part of the error does not show in the
  // residuals, so the stated deviation is added to the translation as a whole.
  const double correlated = correlation_length(used);
  const double axis_variance = 0.5 * sum_horizontal / std::max(1.0, count - 2.0);
  const double drift_rad =
      kSlowDriftShare * mean_sigma.head<2>().mean() / std::max(out.track_extent_m, 1e-3);
  const double yaw_variance =
      axis_variance * correlated / std::max(lever2, 1e-9) + drift_rad * drift_rad;
  const double fit_variance = axis_variance * correlated / count;
  const Eigen::Vector3d center_in_enu = apply(fit, center) - fit.translation;
  // The translation is that of the map's origin: yaw moves it about the centre of the track.
  Eigen::Vector4d by_yaw(center_in_enu.y(), -center_in_enu.x(), 0.0, 1.0);
  out.covariance = yaw_variance * by_yaw * by_yaw.transpose();
  out.covariance(0, 0) += fit_variance + mean_sigma.x() * mean_sigma.x();
  out.covariance(1, 1) += fit_variance + mean_sigma.y() * mean_sigma.y();
  out.covariance(2, 2) += out.rms_vertical_m * out.rms_vertical_m * correlated / count +
                          mean_sigma.z() * mean_sigma.z();
}

/// What remains when no placing makes fixes and trajectory agree. Receivers in streets are off by
/// some metres more than they state, and now and then by far more: neither is a contradiction.
std::string contradiction_of(const std::vector<Pair>& pairs, const Fit& fit, double extent_m) {
  constexpr double kSigmas = 5.0;
  constexpr double kMultipath_m = 5.0;
  constexpr double kShareOfTrack = 0.05;
  std::vector<double> off_m;
  std::vector<double> sigmas_m;
  std::size_t num_off = 0;
  for (const Pair& pair : pairs) {
    const double sigma_m = pair.sigma_m.head<2>().norm();
    sigmas_m.push_back(sigma_m);
    off_m.push_back((pair.fix_in_enu - apply(fit, pair.antenna_in_map)).head<2>().norm());
    const double limit_m = std::max({kSigmas * sigma_m, kMultipath_m, kShareOfTrack * extent_m});
    if (off_m.back() > limit_m) ++num_off;
  }
  if (5 * num_off < 2 * pairs.size()) return "";
  std::ranges::sort(off_m);
  return fmt::format(
      "{} of {} GNSS fixes contradict the trajectory: nine in ten lie within {:.1f} "
      "m of it, the receiver states {:.1f} m",
      num_off,
      pairs.size(),
      off_m[off_m.size() * 9 / 10],
      median(sigmas_m));
}

}  // namespace

Expected<GnssAlignment> align_gnss(const Trajectory& trajectory,
                                   std::span<const GnssFix> fixes,
                                   const GeodeticOrigin& origin,
                                   const Eigen::Vector3d& antenna_in_imu,
                                   const GnssAlignmentOptions& options) {
  const std::vector<Pair> pairs = pair_up(trajectory, fixes, origin, antenna_in_imu, options);
  if (pairs.size() < kMinFixes) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} of {} GNSS fixes are usable within the trajectory, {} are needed",
                            pairs.size(),
                            fixes.size(),
                            kMinFixes));
  }
  GnssAlignment out;
  out.track_extent_m = extent_of(pairs);
  std::vector<double> sigmas;
  for (const Pair& pair : pairs) sigmas.push_back(pair.sigma_m.head<2>().maxCoeff());
  const auto too_short = [&](double sigma_m) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("the drive covers {:.1f} m; with a GNSS noise of {:.2f} m a heading "
                            "needs at least {:.1f} m: drive farther or give the heading",
                            out.track_extent_m,
                            sigma_m,
                            kMinExtentOverSigma * sigma_m));
  };
  // A receiver that claims metres may scatter by centimetres: what the fixes show decides below.
  constexpr double kShortestTrack_m = 1.0;
  if (out.track_extent_m < kShortestTrack_m) return too_short(median(sigmas));
  std::vector<double> weights;
  const Fit fit =
      reweighted(pairs, options.outlier_sigmas, robust_start(pairs, out.track_extent_m), weights);
  out.contradiction = contradiction_of(pairs, fit, out.track_extent_m);
  if (!out.contradiction.empty()) return out;
  fill_statistics(pairs, weights, fit, out);
  if (out.num_used < kMinFixes) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("only {} of {} GNSS fixes agree with the trajectory, {} are needed",
                            out.num_used,
                            pairs.size(),
                            kMinFixes));
  }
  const double noise_m = out.rms_horizontal_m / std::numbers::sqrt2;
  if (out.track_extent_m < kMinExtentOverSigma * noise_m) return too_short(noise_m);
  const double yaw_sigma = std::sqrt(out.covariance(3, 3));
  if (!(yaw_sigma <= options.max_yaw_sigma_rad)) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("the GNSS track gives the heading to {:.3f} rad only, the limit is "
                            "{:.3f} rad: drive farther or give the heading",
                            yaw_sigma,
                            options.max_yaw_sigma_rad));
  }
  out.yaw_rad = fit.yaw;
  out.enu_from_map = {
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(fit.yaw, Eigen::Vector3d::UnitZ())),
      .translation = fit.translation};
  return out;
}

}  // namespace hybridfusion
