#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/registration/drift.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace hybridfusion {
namespace {

/// Metres driven at each position, and the positions in plan.
struct Path {
  std::vector<Eigen::Vector3f> planar = {};
  std::vector<double> length_m = {};
};

Path path_of(std::span<const Eigen::Vector3d> positions) {
  constexpr double kStep_m = 1.0;  // standing still adds no way
  Path path;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : positions) {
    if (!p.allFinite()) continue;
    const double step_m = path.planar.empty() ? 0.0 : (p - last).norm();
    if (!path.planar.empty() && step_m < kStep_m) continue;
    path.length_m.push_back(path.length_m.empty() ? 0.0 : path.length_m.back() + step_m);
    path.planar.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    last = p;
  }
  return path;
}

}  // namespace

Eigen::Vector3d corrected(const DriftCorrection& correction,
                          const Eigen::Vector3d& point,
                          double at) {
  const std::vector<DriftKnot>& knots = correction.knots;
  HF_CHECK(!knots.empty());
  const auto move = [&](const DriftKnot& knot) -> Eigen::Vector3d {
    return knot.shift_m + knot.turn_rad.cross(point - knot.pivot);
  };
  const auto after = std::ranges::upper_bound(knots, at, {}, &DriftKnot::at);
  if (after == knots.begin()) return point + move(knots.front());
  if (after == knots.end()) return point + move(knots.back());
  const DriftKnot& a = *(after - 1);
  const double share = (at - a.at) / (after->at - a.at);
  return point + (1.0 - share) * move(a) + share * move(*after);
}

Expected<std::vector<double>> drift_parameters(const PointCloud& lidar,
                                               DriftAxis axis,
                                               std::span<const Eigen::Vector3d> sensor_positions,
                                               const RunContext& ctx) {
  if (axis == DriftAxis::kTime) {
    if (lidar.times_s.empty() || lidar.times_s.size() != lidar.size()) {
      return fail(ErrorCode::kInsufficient, "the LiDAR points carry no times");
    }
    return lidar.times_s;
  }
  const Path path = path_of(sensor_positions);
  if (path.planar.size() < 2) {
    return fail(ErrorCode::kInsufficient,
                "fewer than two different sensor positions: the way of the LiDAR is unknown");
  }
  const KdTree tree(path.planar);
  std::vector<double> at(lidar.size());
  parallel_for(ctx, at.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f& p = lidar.points[i];
      at[i] = p.allFinite() ? path.length_m[tree.nearest(Eigen::Vector3f(p.x(), p.y(), 0.0F)).index]
                            : 0.0;
    }
  });
  return at;
}

Expected<PointCloud> without_drift(PointCloud lidar,
                                   const DriftCorrection& correction,
                                   std::span<const Eigen::Vector3d> sensor_positions,
                                   const RunContext& ctx) {
  if (!correction.supported || correction.knots.empty()) return lidar;
  HF_TRY(const std::vector<double> at,
         drift_parameters(lidar, correction.axis, sensor_positions, ctx));
  parallel_for(ctx, lidar.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      lidar.points[i] = corrected(correction, lidar.points[i].cast<double>(), at[i]).cast<float>();
    }
  });
  return lidar;
}

}  // namespace hybridfusion
