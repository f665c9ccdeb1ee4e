#include "bundle_adjustment.hpp"

#include "adjustment_costs.hpp"
#include "adjustment_gnss.hpp"
#include "schur_covariance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kDenseViews = 150;

/// Blocks must not move in memory while the problem lives.
struct Blocks {
  std::vector<std::array<double, kPoseSize>> poses;  // per view
  std::vector<IntrinsicsVector> intrinsics;          // per camera
  std::vector<Eigen::Vector3d> points;               // per requested track
  std::vector<Eigen::Vector3d> control;              // per control target
};

/// Lets the caller's stop token end the solver.
class StopCallback final : public ceres::IterationCallback {
 public:
  explicit StopCallback(const RunContext& ctx) : ctx_(ctx) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override {
    return ctx_.stopped() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const RunContext& ctx_;
};

class Adjuster {
 public:
  Adjuster(SfmModel& model, const AdjustmentRequest& request, const IntrinsicsOptions& intrinsics)
      : model_(model), request_(request), options_(intrinsics), problem_(problem_options()) {}

  Expected<AdjustmentSummary> run(const RunContext& ctx) {
    load();
    add_reprojections();
    if (problem_.NumResidualBlocks() == 0) {
      return fail(ErrorCode::kInsufficient, "no triangulated point is seen by the views to adjust");
    }
    add_control();
    add_intrinsics();
    if (request_.gnss != nullptr) add_gnss();
    hold_fixed();
    ceres::Solver::Summary summary;
    ceres::Solver::Options options = solver_options();
    StopCallback stop(ctx);
    options.callbacks.push_back(&stop);
    ceres::Solve(options, &problem_, &summary);
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    if (!summary.IsSolutionUsable()) {
      return fail(ErrorCode::kDegenerate, "bundle adjustment failed: " + summary.message);
    }
    store();
    if (request_.covariance) {
      if (auto stored = store_covariance(ctx); !stored) return std::unexpected(stored.error());
    }
    return AdjustmentSummary{.iterations = static_cast<int>(summary.iterations.size()),
                             .converged = summary.termination_type == ceres::CONVERGENCE,
                             .initial_cost = summary.initial_cost,
                             .final_cost = summary.final_cost};
  }

 private:
  static ceres::Problem::Options problem_options() {
    ceres::Problem::Options options;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  void load() {
    blocks_.poses.resize(model_.world_from_view.size());
    in_problem_.assign(model_.world_from_view.size(), false);
    for (const auto& views : {request_.free_views, request_.fixed_views}) {
      for (const std::uint32_t view : views) {
        const Rigid3& pose = *model_.world_from_view[view];
        Eigen::Map<Eigen::Vector4d>{blocks_.poses[view].data()} = pose.rotation.coeffs();
        Eigen::Map<Eigen::Vector3d>{blocks_.poses[view].data() + 4} = pose.translation;
        in_problem_[view] = true;
      }
    }
    for (const CameraIntrinsics& camera : model_.cameras) {
      blocks_.intrinsics.push_back(to_vector(camera));
    }
    for (const std::uint32_t track : request_.tracks) {
      blocks_.points.push_back(model_.points[track].value_or(Eigen::Vector3d::Zero()));
    }
  }

  void add_reprojections() {
    loss_ = std::make_unique<ceres::SoftLOneLoss>(request_.loss_width_px / request_.sigma_px);
    for (std::size_t t = 0; t < request_.tracks.size(); ++t) {
      const std::uint32_t track = request_.tracks[t];
      if (!model_.points[track]) continue;
      for (const TrackElement& element : model_.tracks[track]) {
        if (!element.active || !in_problem_[element.view]) continue;
        // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
        auto* cost = new ReprojectionCost(element.pixel,
                                          request_.sigma_px * model_.pixel_scale(element.view));
        problem_.AddResidualBlock(cost,
                                  loss_.get(),
                                  blocks_.poses[element.view].data(),
                                  blocks_.points[t].data(),
                                  intrinsics_of(element.view));
      }
    }
  }

  /// Marked points are measured by eye, and held where they were surveyed.
  void add_control() {
    constexpr double kMarkSigma_px = 1.0;
    for (const ControlTarget& target : request_.control) blocks_.control.push_back(target.position);
    for (std::size_t k = 0; k < blocks_.control.size(); ++k) {
      const ControlTarget& target = request_.control[k];
      double* point = blocks_.control[k].data();
      for (const ControlTarget::Mark& mark : target.marks) {
        if (!in_problem_[mark.view]) continue;
        const double sigma_px = kMarkSigma_px * model_.pixel_scale(mark.view);
        // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
        problem_.AddResidualBlock(new ReprojectionCost(mark.pixel, sigma_px),
                                  loss_.get(),
                                  blocks_.poses[mark.view].data(),
                                  point,
                                  intrinsics_of(mark.view));
      }
      if (!problem_.HasParameterBlock(point)) continue;
      // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
      auto* surveyed = new NormalPriorCost<3>(target.position, target.sigma_m);
      problem_.AddResidualBlock(surveyed, nullptr, point);
    }
  }

  void add_intrinsics() {
    for (std::uint32_t camera = 0; camera < model_.cameras.size(); ++camera) {
      double* block = blocks_.intrinsics[camera].data();
      if (!problem_.HasParameterBlock(block)) continue;
      if (request_.calibration == CalibrationLevel::kFixed) {
        problem_.SetParameterBlockConstant(block);
        continue;
      }
      const CameraPrior& prior = model_.priors[camera];
      const double longest = std::max(prior.intrinsics.width_px, prior.intrinsics.height_px);
      const double principal = options_.principal_point_sigma * longest;
      IntrinsicsVector sigma;
      sigma << prior.focal_sigma * prior.intrinsics.focal_px, principal, principal,
          options_.radial_sigma, options_.radial_sigma, 0.5 * options_.radial_sigma,
          options_.tangential_sigma, options_.tangential_sigma;
      // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the problem owns its costs
      problem_.AddResidualBlock(
          new NormalPriorCost<kNumIntrinsics>(to_vector(prior.intrinsics), sigma), nullptr, block);
      if (request_.calibration == CalibrationLevel::kRadial) {
        problem_.SetManifold(block, &radial_only_);
      }
    }
  }

  void add_gnss() {
    gnss_ = std::make_unique<GnssBlocks>(*request_.gnss);
    gnss_->add_to(problem_, blocks_.poses, in_problem_);
  }

  void hold_fixed() {
    for (const std::uint32_t view : request_.free_views) {
      double* pose = blocks_.poses[view].data();
      if (problem_.HasParameterBlock(pose)) problem_.SetManifold(pose, &pose_manifold_);
    }
    for (const std::uint32_t view : request_.fixed_views) hold(view);
    const bool floating =
        request_.fixed_views.empty() && request_.gnss == nullptr && request_.control.empty();
    if (floating && !request_.free_views.empty()) hold(request_.free_views.front());
  }

  void hold(std::uint32_t view) {
    double* pose = blocks_.poses[view].data();
    if (problem_.HasParameterBlock(pose)) problem_.SetParameterBlockConstant(pose);
  }

  ceres::Solver::Options solver_options() {
    ceres::Solver::Options options;
    options.linear_solver_type =
        request_.free_views.size() <= kDenseViews ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
    options.max_num_iterations = request_.max_iterations;
    options.function_tolerance = 1e-6;
    options.num_threads = 1;  // threaded Schur elimination adds in any order
    options.logging_type = ceres::SILENT;
    auto* ordering = new ceres::ParameterBlockOrdering;  // NOLINT: owned by the options
    // Within a group Ceres sorts by address: one group per array, or the order (and the rounding)
    // would depend on where the arrays lie in memory.
    const auto add = [&](double* block, int group) {
      if (problem_.HasParameterBlock(block)) ordering->AddElementToGroup(block, group);
    };
    for (Eigen::Vector3d& point : blocks_.points) add(point.data(), 0);
    for (Eigen::Vector3d& point : blocks_.control) add(point.data(), 4);
    for (auto& pose : blocks_.poses) add(pose.data(), 1);
    for (IntrinsicsVector& intrinsics : blocks_.intrinsics) add(intrinsics.data(), 2);
    if (gnss_) {
      for (Eigen::Vector3d& errors : gnss_->flights()) add(errors.data(), 3);
    }
    options.linear_solver_ordering.reset(ordering);
    return options;
  }

  void store() {
    for (const std::uint32_t view : request_.free_views) {
      Rigid3& pose = *model_.world_from_view[view];
      pose.rotation = Eigen::Map<const Eigen::Quaterniond>(blocks_.poses[view].data()).normalized();
      pose.translation = Eigen::Map<const Eigen::Vector3d>(blocks_.poses[view].data() + 4);
    }
    for (std::size_t camera = 0; camera < model_.cameras.size(); ++camera) {
      from_vector(blocks_.intrinsics[camera], model_.cameras[camera]);
    }
    for (std::size_t t = 0; t < request_.tracks.size(); ++t) {
      if (model_.points[request_.tracks[t]]) model_.points[request_.tracks[t]] = blocks_.points[t];
    }
    if (gnss_) gnss_->store();
  }

  Expected<void> store_covariance(const RunContext& ctx) {
    model_.pose_covariance.assign(model_.world_from_view.size(), std::nullopt);
    CovarianceBlocks blocks;
    for (Eigen::Vector3d& point : blocks_.points) blocks.points.push_back(point.data());
    for (Eigen::Vector3d& point : blocks_.control) blocks.points.push_back(point.data());
    for (const std::uint32_t view : request_.free_views) {
      blocks.poses.push_back(blocks_.poses[view].data());
    }
    for (IntrinsicsVector& camera : blocks_.intrinsics) blocks.others.push_back(camera.data());
    if (gnss_) {
      for (Eigen::Vector3d& errors : gnss_->flights()) blocks.others.push_back(errors.data());
    }
    HF_TRY(const auto covariances, pose_covariances(problem_, blocks, ctx));
    for (std::size_t k = 0; k < covariances.size(); ++k) {
      model_.pose_covariance[request_.free_views[k]] = covariances[k];
    }
    return {};
  }

  double* intrinsics_of(std::uint32_t view) {
    return blocks_.intrinsics[model_.camera_of_view[view]].data();
  }

  SfmModel& model_;
  const AdjustmentRequest& request_;
  const IntrinsicsOptions& options_;
  Blocks blocks_;
  std::vector<bool> in_problem_;  // per view
  PoseManifold pose_manifold_;
  ceres::SubsetManifold radial_only_{kNumIntrinsics, {1, 2, 5, 6, 7}};
  std::unique_ptr<ceres::LossFunction> loss_;
  std::unique_ptr<GnssBlocks> gnss_;
  ceres::Problem problem_;  // last: destroyed before what it points to
};

}  // namespace

Expected<AdjustmentSummary> adjust(SfmModel& model,
                                   const AdjustmentRequest& request,
                                   const IntrinsicsOptions& intrinsics,
                                   const RunContext& ctx) {
  for (const auto& views : {request.free_views, request.fixed_views}) {
    for (const std::uint32_t view : views) HF_CHECK(model.world_from_view[view].has_value());
  }
  return Adjuster(model, request, intrinsics).run(ctx);
}

}  // namespace hybridfusion
