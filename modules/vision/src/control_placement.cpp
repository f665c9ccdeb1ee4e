#include "control_placement.hpp"

#include "robust_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct Tie {
  std::size_t point = 0;
  Eigen::Vector3d in_world = Eigen::Vector3d::Zero();
  Eigen::Vector3d in_enu = Eigen::Vector3d::Zero();
};

std::vector<Tie> ties_of(const SfmModel& model,
                         std::span<const ControlPoint> points,
                         const GeodeticOrigin& origin) {
  std::vector<Tie> ties;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].check) continue;
    const auto seen = triangulate_marks(model, points[k]);
    if (!seen) continue;
    ties.push_back(
        {.point = k, .in_world = *seen, .in_enu = enu_from_geodetic(origin, points[k].position)});
  }
  return ties;
}

/// @param left_out  Index of a tie; ties.size(): none.
Expected<Sim3> fit(std::span<const Tie> ties, std::size_t left_out) {
  std::vector<Eigen::Vector3d> target;
  std::vector<Eigen::Vector3d> source;
  for (std::size_t k = 0; k < ties.size(); ++k) {
    if (k == left_out) continue;
    target.push_back(ties[k].in_enu);
    source.push_back(ties[k].in_world);
  }
  return fit_sim3(target, source);
}

}  // namespace

std::optional<Eigen::Vector3d> triangulate_marks(const SfmModel& model, const ControlPoint& point) {
  // The point nearest to all rays.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  std::size_t rays = 0;
  for (const ControlPoint::Mark& mark : point.marks) {
    if (mark.photo >= model.world_from_view.size() || !model.world_from_view[mark.photo]) continue;
    const auto view = static_cast<std::uint32_t>(mark.photo);
    const Eigen::Vector2d at = unproject(model.camera_of(view), mark.pixel);
    const Rigid3& pose = *model.world_from_view[view];
    const Eigen::Vector3d ray = (pose.rotation * at.homogeneous()).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ray * ray.transpose();
    normal += across;
    right += across * pose.translation;
    ++rays;
  }
  if (rays < 2) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal);
  constexpr double kParallel = 1e-4;  // 1 - cos of the angle between the rays
  if (solver.eigenvalues()[0] < kParallel) return std::nullopt;
  return Eigen::Vector3d(normal.ldlt().solve(right));
}

GeodeticOrigin origin_of_control(std::span<const ControlPoint> points) {
  GeodeticOrigin origin;
  for (const ControlPoint& point : points) {
    const auto count = static_cast<double>(points.size());
    origin.latitude_deg += point.position.latitude_deg / count;
    origin.longitude_deg += point.position.longitude_deg / count;
    origin.altitude_m += point.position.altitude_m / count;
  }
  return origin;
}

Expected<Sim3> place_by_control(const SfmModel& model,
                                std::span<const ControlPoint> points,
                                const GeodeticOrigin& origin) {
  const std::vector<Tie> ties = ties_of(model, points, origin);
  constexpr std::size_t kLeast = 3;
  if (ties.size() < kLeast) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} of {} ground control points are marked in two or more registered "
                            "photos, {} are needed; mark more of them",
                            ties.size(),
                            points.size(),
                            kLeast));
  }
  HF_TRY(const Sim3 all, fit(ties, ties.size()));
  // A blunder shows when the others fit each other far better without it.
  const auto rms = [&](const Sim3& sim, std::size_t left_out) {
    double sum = 0.0;
    for (std::size_t k = 0; k < ties.size(); ++k) {
      if (k != left_out) sum += (sim * ties[k].in_world - ties[k].in_enu).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(ties.size()));
  };
  constexpr double kGross_m = 1.0;
  constexpr double kShare = 0.1;
  constexpr std::size_t kRedundant = 5;
  const double together_m = rms(all, ties.size());
  if (ties.size() < kRedundant || together_m < kGross_m) return all;
  for (std::size_t k = 0; k < ties.size(); ++k) {
    const auto without = fit(ties, k);
    if (!without || rms(*without, k) > kShare * together_m) continue;
    return fail(ErrorCode::kDegenerate,
                fmt::format("ground control point {} contradicts the others by {:.1f} m; check its "
                            "coordinates and marks",
                            points[ties[k].point].name,
                            (*without * ties[k].in_world - ties[k].in_enu).norm()));
  }
  return all;
}

std::vector<ControlTarget> control_targets(const SfmModel& model,
                                           std::span<const ControlPoint> points,
                                           const GeodeticOrigin& origin) {
  std::vector<ControlTarget> targets;
  for (const Tie& tie : ties_of(model, points, origin)) {
    const ControlPoint& point = points[tie.point];
    ControlTarget target{.position = tie.in_enu, .sigma_m = point.sigma_m};
    for (const ControlPoint::Mark& mark : point.marks) {
      target.marks.push_back({.view = static_cast<std::uint32_t>(mark.photo), .pixel = mark.pixel});
    }
    std::erase_if(target.marks, [&](const auto& mark) {
      return mark.view >= model.world_from_view.size() || !model.world_from_view[mark.view];
    });
    targets.push_back(std::move(target));
  }
  return targets;
}

std::vector<ControlResidual> control_residuals(const SfmModel& model,
                                               std::span<const ControlPoint> points,
                                               const GeodeticOrigin& origin) {
  const Eigen::Vector3d unknown =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const std::vector<Tie> ties = ties_of(model, points, origin);
  std::vector<ControlResidual> residuals;
  for (std::size_t k = 0; k < points.size(); ++k) {
    ControlResidual residual{.name = points[k].name, .residual_m = unknown, .held_out_m = unknown};
    for (const ControlPoint::Mark& mark : points[k].marks) {
      const bool shown =
          mark.photo < model.world_from_view.size() && model.world_from_view[mark.photo];
      residual.num_marks += shown ? 1 : 0;
    }
    if (const auto seen = triangulate_marks(model, points[k])) {
      residual.residual_m = *seen - enu_from_geodetic(origin, points[k].position);
    }
    const auto tie = std::ranges::find(ties, k, &Tie::point);
    residual.used = tie != ties.end();
    if (residual.used) {
      const auto without = fit(ties, static_cast<std::size_t>(tie - ties.begin()));
      if (without) residual.held_out_m = *without * tie->in_world - tie->in_enu;
    } else {
      residual.held_out_m = residual.residual_m;
    }
    residuals.push_back(std::move(residual));
  }
  return residuals;
}

}  // namespace hybridfusion
