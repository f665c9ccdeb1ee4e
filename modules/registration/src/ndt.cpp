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

/// A source cloud against the cells of a target.
template <int Dim>
class NdtProblem {
 public:
  NdtProblem(std::span<const Eigen::Matrix<float, Dim, 1>> target,
             std::span<const Eigen::Matrix<float, Dim, 1>> source,
             const NdtPass& pass,
             const RunContext& ctx)
      : cells_(target, pass.cell_m, pass.min_cell_points),
        mixture_(make_mixture(pass.outlier_ratio, pass.cell_m, Dim)),
        ctx_(ctx) {
    points_.reserve(source.size());
    for (const auto& p : source) {
      if (p.allFinite()) points_.push_back(p.template cast<double>());
    }
    in_target_.resize(points_.size());
  }

  [[nodiscard]] bool has_target() const { return !cells_.empty(); }
  [[nodiscard]] double num_points() const { return static_cast<double>(points_.size()); }

  /// Where the last evaluation with derivatives took them about: the middle of the moved source.
  [[nodiscard]] const NdtVector<Dim>& centre() const { return centre_; }

  template <class Pose>
  NdtTerms<Dim> evaluate(const Pose& pose, bool with_derivatives) {
    NdtVector<Dim> mean = NdtVector<Dim>::Zero();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      in_target_[i] = apply(pose, points_[i]);
      mean += in_target_[i] / num_points();
    }
    if (with_derivatives) centre_ = mean;
    return ndt_terms<Dim>(cells_, mixture_, in_target_, centre_, with_derivatives, ctx_);
  }

  /// What a turn of one radian moves the source by, on average [m], and a metre more.
  [[nodiscard]] double radius_m() const {
    double radius_m = 1.0;
    for (const NdtVector<Dim>& p : in_target_) radius_m += (p - centre_).norm() / num_points();
    return radius_m;
  }

 private:
  NdtCells<Dim> cells_;
  NdtMixture mixture_;
  const RunContext& ctx_;
  std::vector<NdtVector<Dim>> points_ = {};
  std::vector<NdtVector<Dim>> in_target_ = {};
  NdtVector<Dim> centre_ = NdtVector<Dim>::Zero();
};

/// How far a step moves the source [m].
template <int Dim>
double step_length_m(const Eigen::Matrix<double, kNdtParams<Dim>, 1>& step, double radius_m) {
  return step.template head<Dim>().norm() +
         radius_m * step.template tail<kNdtParams<Dim> - Dim>().norm();
}

template <int Dim, class Pose, class Result>
Expected<Result> align(std::span<const Eigen::Matrix<float, Dim, 1>> target,
                       std::span<const Eigen::Matrix<float, Dim, 1>> source,
                       const Pose& start,
                       const NdtPass& pass,
                       const RunContext& ctx) {
  constexpr double kConverged_m = 1e-3;
  NdtProblem<Dim> problem(target, source, pass, ctx);
  if (!problem.has_target()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("no cell of {} m holds {} target points; use larger cells",
                            pass.cell_m,
                            pass.min_cell_points));
  }
  Result result{.target_from_source = start};
  NdtTerms<Dim> terms = problem.evaluate(start, true);
  const double radius_m = problem.radius_m();
  while (result.quality.iterations < pass.max_iterations && terms.matched > 0.0) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped in NDT");
    ++result.quality.iterations;
    auto step = newton_step<kNdtParams<Dim>>(terms.hessian, terms.gradient);
    // A step longer than a cell leaves the region that the derivatives describe.
    const double length_m = step_length_m<Dim>(step, radius_m);
    if (length_m > pass.cell_m) step *= pass.cell_m / length_m;
    Pose trial = moved(step, problem.centre(), result.target_from_source);
    for (int halving = 0; halving < 8 && problem.evaluate(trial, false).value >= terms.value;
         ++halving) {
      step *= 0.5;
      trial = moved(step, problem.centre(), result.target_from_source);
    }
    const NdtTerms<Dim> next = problem.evaluate(trial, true);
    result.quality.converged =
        next.value >= terms.value || step_length_m<Dim>(step, radius_m) < kConverged_m;
    if (next.value < terms.value) {
      result.target_from_source = trial;
      terms = next;
    }
    if (result.quality.converged) break;
  }
  if (terms.matched <= 0.0) {
    return fail(ErrorCode::kInsufficient, "no source point lies near a cell of the target");
  }
  result.quality.score = terms.density / problem.num_points();
  result.quality.matched_share = terms.matched / problem.num_points();
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
