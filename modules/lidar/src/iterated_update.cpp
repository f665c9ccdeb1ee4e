#include "iterated_update.hpp"

#include <hybridfusion/lidar/odometry.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr double kMaxSpeed_mps = 100.0;
constexpr double kConverged_m = 1e-3;
constexpr double kConverged_rad = 1e-4;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}

using PoseColumns = Eigen::Matrix<double, err::kSize, kMatchSize>;

/// Columns (or, transposed, rows) of the error state that residuals touch.
PoseColumns match_columns(const ErrorMatrix& p) {
  PoseColumns columns;
  columns.leftCols<kPoseSize>() = p.middleCols<kPoseSize>(err::kPosition);
  columns.rightCols<kPoseSize>() = p.middleCols<kPoseSize>(err::kExtrinsicPosition);
  return columns;
}

MatchVector match_rows(const ErrorVector& e) {
  MatchVector rows;
  rows << e.segment<kPoseSize>(err::kPosition), e.segment<kPoseSize>(err::kExtrinsicPosition);
  return rows;
}

MatchMatrix match_block(const PoseColumns& columns) {
  MatchMatrix block;
  block.topRows<kPoseSize>() = columns.middleRows<kPoseSize>(err::kPosition);
  block.bottomRows<kPoseSize>() = columns.middleRows<kPoseSize>(err::kExtrinsicPosition);
  return block;
}

/// Information about the block at `a` with the block at `b` marginalised.
Eigen::Matrix3d marginal(const MatchMatrix& h, int a, int b, double regularization) {
  const Eigen::Matrix3d hbb = h.block<3, 3>(b, b) + regularization * Eigen::Matrix3d::Identity();
  return h.block<3, 3>(a, a) - h.block<3, 3>(a, b) * hbb.ldlt().solve(h.block<3, 3>(b, a));
}

/// One Gauss-Newton step of prior and measurements about `x` (a deviation d from the prior).
struct Step {
  ErrorVector error;       // to add to x
  ErrorMatrix covariance;  // about x
};

Step solve_step(const ObservedInformation& observed,
                const StateEstimate& prior,
                const NavState& x) {
  const ErrorVector deviation = minus(x, prior.state);
  const ErrorMatrix j = transport(prior.state, deviation);
  const ErrorMatrix p = j * prior.covariance * j.transpose();
  const ErrorVector mean = -(j * deviation);
  // (P^-1 + E A E^T)^-1 = P - P E (I + A E^T P E)^-1 A E^T P: no inverse of P, which may be
  // singular.
  const PoseColumns columns = match_columns(p);
  const Eigen::PartialPivLU<MatchMatrix> lu(MatchMatrix::Identity() +
                                            observed.information * match_block(columns));
  Step step;
  step.error =
      mean + columns * lu.solve(observed.gradient - observed.information * match_rows(mean));
  const ErrorMatrix reduced = p - columns * lu.solve(observed.information) * columns.transpose();
  step.covariance = 0.5 * (reduced + reduced.transpose());
  return step;
}

bool is_plausible(const LidarFilterOptions& options,
                  const StateEstimate& prior,
                  const StateEstimate& posterior) {
  const ErrorVector change = minus(posterior.state, prior.state);
  if (!change.allFinite() || !posterior.covariance.allFinite()) return false;
  const double sigma_m = std::sqrt(prior.covariance.topLeftCorner<3, 3>().trace());
  const double limit_m = std::max(options.max_correction_m, 3.0 * sigma_m);
  return change.segment<3>(err::kPosition).norm() <= limit_m &&
         posterior.state.velocity_in_map.norm() <= kMaxSpeed_mps;
}

/// d^T S^-1 d / 3 of a block of the correction.
double normalized_innovation(const ErrorMatrix& prior, const ErrorVector& change, int at) {
  const Eigen::Matrix3d variance = prior.block<3, 3>(at, at);
  const Eigen::Vector3d d = change.segment<3>(at);
  const double value = d.dot(variance.ldlt().solve(d)) / 3.0;
  return std::isfinite(value) ? std::max(0.0, value) : 0.0;
}

/// What the matches say, without false information along directions that few of them face.
MatchInformation linearize_soundly(const ScanMatcher& matcher, const NavState& state) {
  // Normals of planes through five noisy points are off by a few degrees: a mean squared cosine
  // below this may be nothing else.
  constexpr double kWeakRatio = 0.03;
  const MatchInformation matches = matcher.linearize(state);
  const double tiny = 1e-6 * matches.information.block<3, 3>(3, 3).trace() / 2.0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      marginal(matches.information, 0, 3, tiny));
  WeakDirections weak;
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] >= kWeakRatio * matches.sum_weights) continue;
    weak.directions[weak.count++] = solver.eigenvectors().col(i);
  }
  return weak.count == 0 ? matches : matcher.linearize(state, weak);
}

}  // namespace

ObservedInformation hold_unobserved(const MatchInformation& matches, double min_ratio) {
  ObservedInformation out;
  out.information = matches.information;
  out.gradient = matches.gradient;
  const double tiny = 1e-6 * matches.sum_weights;
  // Rotation is weighed by the mean square lever arm, so that its ratio has no unit either.
  const double lever2 = matches.information.block<3, 3>(3, 3).trace() / 2.0;
  for (const int at : {0, 3}) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        marginal(matches.information, at, 3 - at, at == 0 ? 1e-6 * lever2 : tiny));
    if (at == 0) out.min_position_information = std::max(0.0, solver.eigenvalues()[0]);
    const double total = at == 0 ? matches.sum_weights : lever2;
    for (int i = 0; i < 3; ++i) {
      if (solver.eigenvalues()[i] >= min_ratio * total) continue;
      MatchVector direction = MatchVector::Zero();
      direction.segment<3>(at) = solver.eigenvectors().col(i);
      const MatchMatrix keep = MatchMatrix::Identity() - direction * direction.transpose();
      out.information = keep * out.information * keep;
      out.gradient = keep * out.gradient;
      ++out.num_held;
    }
  }
  return out;
}

UpdateReport iterated_update(
    const LidarFilterOptions& options,
    const std::function<void(const NavState&, ScanMatcher&)>& repeat_deskew,
    ScanMatcher& matcher,
    StateEstimate& estimate) {
  UpdateReport report;
  StateEstimate posterior = estimate;
  double moved_m = 0.0;
  matcher.match(posterior.state);
  for (int pass = 0; pass < options.max_iterations; ++pass) {
    if (moved_m > options.rematch_distance_m) {
      matcher.match(posterior.state);
      moved_m = 0.0;
    }
    const MatchInformation matches = linearize_soundly(matcher, posterior.state);
    report.num_matched = matches.num_matched;
    report.mean_residual_m = matches.sum_abs_residual_m / std::max(1, matches.num_matched);
    if (matches.num_matched < options.min_matches) {
      report.flags = bit(ScanFlag::kUnmatched);
      return report;
    }
    const ObservedInformation observed = hold_unobserved(matches, options.min_information_ratio);
    report.min_information = observed.min_position_information;
    report.flags = observed.num_held > 0 ? bit(ScanFlag::kDegenerate) : 0U;
    const Step step = solve_step(observed, estimate, posterior.state);
    const ErrorMatrix j = transport(posterior.state, step.error);
    posterior.state = plus(posterior.state, step.error);
    posterior.covariance = j * step.covariance * j.transpose();
    const double shift_m = step.error.segment<3>(err::kPosition).norm();
    const double turn_rad = step.error.segment<3>(err::kRotation).norm();
    moved_m += shift_m + turn_rad * matcher.reach_m();
    // Where points are seen from the IMU depends on the extrinsic: then every pass needs it anew.
    if (pass == 0 || options.estimate_extrinsic) repeat_deskew(posterior.state, matcher);
    if (pass > 0 && shift_m < kConverged_m && turn_rad < kConverged_rad) break;
  }
  if (!is_plausible(options, estimate, posterior)) {
    report.flags |= bit(ScanFlag::kDiverged);
    return report;
  }
  const ErrorVector change = minus(posterior.state, estimate.state);
  report.turn_innovation = normalized_innovation(estimate.covariance, change, err::kRotation);
  report.shift_innovation = normalized_innovation(estimate.covariance, change, err::kPosition);
  estimate = posterior;
  return report;
}

}  // namespace hybridfusion
