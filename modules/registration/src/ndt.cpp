#include "ndt_objective.hpp"

#include <hybridfusion/registration/ndt.hpp>

#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Eigen::Vector2d apply(const Rigid2& pose, const Eigen::Vector2d& p) {
  return Eigen::Rotation2D<double>(pose.yaw_rad) * p + pose.translation;
}
Eigen::Vector3d apply(const Rigid3& pose, const Eigen::Vector3d& p) {
  return pose * p;
}

/// The motion of `step` about `centre`, after `pose`.
Rigid2 moved(const Eigen::Vector3d& step, const Eigen::Vector2d& centre, const Rigid2& pose) {
  const Eigen::Rotation2D<double> turn(step[2]);
  return {.yaw_rad = std::remainder(pose.yaw_rad + step[2], 2.0 * std::numbers::pi),
          .translation = turn * (pose.translation - centre) + centre + step.head<2>()};
}
Rigid3 moved(const Eigen::Matrix<double, 6, 1>& step,
             const Eigen::Vector3d& centre,
             const Rigid3& pose) {
  Rigid3 change;
  const Eigen::Vector3d turn = step.tail<3>();
  if (turn.norm() > 0.0) {
    change.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
  }
  change.translation = centre + step.head<3>() - change.rotation * centre;
  return change * pose;
}

/// Newton direction; the Hessian is shifted until it is positive definite, so that it descends.
template <int Params>
Eigen::Matrix<double, Params, 1> newton_step(const Eigen::Matrix<double, Params, Params>& hessian,
                                             const Eigen::Matrix<double, Params, 1>& gradient) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Params, Params>> solver(hessian);
  const double floor = 1e-3 * std::max(1e-12, solver.eigenvalues().cwiseAbs().maxCoeff());
  const Eigen::Matrix<double, Params, 1> values = solver.eigenvalues().cwiseAbs().cwiseMax(floor);
  return -(solver.eigenvectors() *
           (solver.eigenvectors().transpose() * gradient).cwiseQuotient(values));
}

template <int Dim, class Pose, class Result>
Expected<Result> align(std::span<const Eigen::Matrix<float, Dim, 1>> target,
                       std::span<const Eigen::Matrix<float, Dim, 1>> source,
                       const Pose& start,
                       const NdtPass& pass,
                       const RunContext& ctx) {
  constexpr double kConverged_m = 1e-3;
  const NdtCells<Dim> cells(target, pass.cell_m, pass.min_cell_points);
  if (cells.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("no cell of {} m holds {} target points; use larger cells",
                            pass.cell_m,
                            pass.min_cell_points));
  }
  const NdtMixture mixture = make_mixture(pass.outlier_ratio, pass.cell_m, Dim);
  std::vector<NdtVector<Dim>> points;
  points.reserve(source.size());
  for (const auto& p : source) {
    if (p.allFinite()) points.push_back(p.template cast<double>());
  }
  std::vector<NdtVector<Dim>> in_target(points.size());
  NdtVector<Dim> centre = NdtVector<Dim>::Zero();
  const auto evaluate = [&](const Pose& pose, bool with_derivatives) {
    NdtVector<Dim> mean = NdtVector<Dim>::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      in_target[i] = apply(pose, points[i]);
      mean += in_target[i] / static_cast<double>(points.size());
    }
    if (with_derivatives) centre = mean;
    return ndt_terms<Dim>(cells, mixture, in_target, centre, with_derivatives, ctx);
  };
  Result result{.target_from_source = start};
  NdtTerms<Dim> terms = evaluate(start, true);
  double radius_m = 1.0;
  for (const NdtVector<Dim>& p : in_target) {
    radius_m += (p - centre).norm() / static_cast<double>(points.size());
  }
  while (result.quality.iterations < pass.max_iterations && terms.matched > 0.0) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped in NDT");
    ++result.quality.iterations;
    auto step = newton_step<kNdtParams<Dim>>(terms.hessian, terms.gradient);
    const auto length = [&] {
      return step.template head<Dim>().norm() +
             radius_m * step.template tail<kNdtParams<Dim> - Dim>().norm();
    };
    // A step longer than a cell leaves the region that the derivatives describe.
    if (length() > pass.cell_m) step *= pass.cell_m / length();
    Pose trial = moved(step, centre, result.target_from_source);
    for (int halving = 0; halving < 8 && evaluate(trial, false).value >= terms.value; ++halving) {
      step *= 0.5;
      trial = moved(step, centre, result.target_from_source);
    }
    const NdtTerms<Dim> next = evaluate(trial, true);
    if (next.value >= terms.value) {
      result.quality.converged = true;
      break;
    }
    result.target_from_source = trial;
    terms = next;
    if (length() < kConverged_m) {
      result.quality.converged = true;
      break;
    }
  }
  if (terms.matched <= 0.0) {
    return fail(ErrorCode::kInsufficient, "no source point lies near a cell of the target");
  }
  result.quality.score = terms.density / static_cast<double>(points.size());
  result.quality.matched_share = terms.matched / static_cast<double>(points.size());
  result.quality.mean_distance_m = terms.distance / terms.matched;
  return result;
}

}  // namespace

Expected<Ndt2Result> align_ndt_2d(std::span<const Eigen::Vector2f> target,
                                  std::span<const Eigen::Vector2f> source,
                                  const Rigid2& start,
                                  const NdtPass& pass,
                                  const RunContext& ctx) {
  return align<2, Rigid2, Ndt2Result>(target, source, start, pass, ctx);
}

Expected<Ndt3Result> align_ndt_3d(std::span<const Eigen::Vector3f> target,
                                  std::span<const Eigen::Vector3f> source,
                                  const Rigid3& start,
                                  const NdtPass& pass,
                                  const RunContext& ctx) {
  return align<3, Rigid3, Ndt3Result>(target, source, start, pass, ctx);
}

}  // namespace hybridfusion
