#include "triangulation.hpp"

#include "projection.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxHypotheses = 12;
constexpr int kRefinements = 6;

struct Seen {
  std::vector<std::uint32_t> elements;  // of registered views
  std::vector<WorldRay> rays;           // parallel to elements
};

Seen registered_part(const SfmModel& model, const Track& track) {
  Seen seen;
  for (std::uint32_t e = 0; e < track.size(); ++e) {
    const auto& pose = model.world_from_view[track[e].view];
    if (!pose) continue;
    const Eigen::Vector2d n = unproject(model.camera_of(track[e].view), track[e].pixel);
    seen.elements.push_back(e);
    seen.rays.push_back(
        {.centre = pose->translation, .direction = pose->rotation * n.homogeneous().normalized()});
  }
  return seen;
}

struct Hypothesis {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::vector<std::size_t> members;  // into Seen
  double cost = std::numeric_limits<double>::infinity();
};

Hypothesis judge(const SfmModel& model,
                 const Track& track,
                 const Seen& seen,
                 const Eigen::Vector3d& point,
                 double max_error_px) {
  Hypothesis result{.point = point, .members = {}, .cost = 0.0};
  for (std::size_t k = 0; k < seen.elements.size(); ++k) {
    const double error = model.error_px(track[seen.elements[k]], point);
    if (error <= max_error_px) result.members.push_back(k);
    result.cost += std::min(error, max_error_px) * std::min(error, max_error_px);
  }
  return result;
}

/// Gauss-Newton on the reprojection errors of the members.
Eigen::Vector3d refine(const SfmModel& model,
                       const Track& track,
                       const Seen& seen,
                       const Hypothesis& start) {
  Eigen::Vector3d point = start.point;
  for (int iteration = 0; iteration < kRefinements; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (const std::size_t k : start.members) {
      const TrackElement& element = track[seen.elements[k]];
      const Rigid3& pose = *model.world_from_view[element.view];
      const Eigen::Matrix3d camera_from_world = pose.rotation.conjugate().toRotationMatrix();
      const Eigen::Vector3d in_camera = camera_from_world * (point - pose.translation);
      if (in_camera.z() <= 1e-9) return start.point;
      const Projection p =
          project_with_jacobian(to_vector(model.camera_of(element.view)), in_camera);
      const double scale = 1.0 / model.pixel_scale(element.view);
      const Eigen::Matrix<double, 2, 3> jacobian = scale * p.by_point * camera_from_world;
      normal += jacobian.transpose() * jacobian;
      gradient += jacobian.transpose() * (scale * (p.pixel - element.pixel));
    }
    const Eigen::Vector3d step = -normal.ldlt().solve(gradient);
    if (!step.allFinite()) return start.point;
    point += step;
    if (step.norm() < 1e-9 * (point - seen.rays.front().centre).norm()) break;
  }
  return point;
}

Hypothesis best_hypothesis(const SfmModel& model,
                           const Track& track,
                           const Seen& seen,
                           const MappingOptions& options) {
  Hypothesis best;
  const std::size_t n = seen.rays.size();
  const std::size_t num_pairs = n * (n - 1) / 2;
  // Long tracks are sampled evenly over their pairs instead of exhaustively.
  const std::size_t stride = std::max<std::size_t>(1, num_pairs / kMaxHypotheses);
  std::size_t index = 0;
  for (std::size_t gap = n - 1; gap >= 1; --gap) {
    for (std::size_t i = 0; i + gap < n; ++i) {
      if (index++ % stride != 0) continue;
      const std::array<WorldRay, 2> rays{seen.rays[i], seen.rays[i + gap]};
      const auto point = intersect_rays(rays);
      if (!point) continue;
      Hypothesis candidate = judge(model, track, seen, *point, options.max_error_px);
      if (candidate.cost < best.cost) best = std::move(candidate);
    }
    if (best.members.size() == n) break;
  }
  return best;
}

std::optional<Hypothesis> solve(const SfmModel& model,
                                const Track& track,
                                const Seen& seen,
                                const MappingOptions& options) {
  if (seen.rays.size() < 2) return std::nullopt;
  Hypothesis best = best_hypothesis(model, track, seen, options);
  if (best.members.size() < 2) return std::nullopt;
  const Eigen::Vector3d refined = refine(model, track, seen, best);
  Hypothesis polished = judge(model, track, seen, refined, options.max_error_px);
  if (polished.cost <= best.cost) best = std::move(polished);
  if (best.members.size() < 2) return std::nullopt;
  std::vector<WorldRay> rays;
  for (const std::size_t k : best.members) rays.push_back(seen.rays[k]);
  const double min_angle_rad = options.min_angle_deg * std::numbers::pi / 180.0;
  if (largest_angle_rad(rays, best.point) < min_angle_rad) return std::nullopt;
  return best;
}

}  // namespace

std::optional<Eigen::Vector3d> intersect_rays(std::span<const WorldRay> rays) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const WorldRay& ray : rays) {
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    normal += across;
    right += across * ray.centre;
  }
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(normal);
  // The smallest pivot is about the squared sine of the angle between the rays.
  if (ldlt.info() != Eigen::Success || ldlt.vectorD().minCoeff() < 1e-8) return std::nullopt;
  return ldlt.solve(right);
}

double largest_angle_rad(std::span<const WorldRay> rays, const Eigen::Vector3d& point) {
  double smallest_cosine = 1.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Eigen::Vector3d a = (point - rays[i].centre).normalized();
    for (std::size_t j = i + 1; j < rays.size(); ++j) {
      smallest_cosine = std::min(smallest_cosine, a.dot((point - rays[j].centre).normalized()));
    }
  }
  return std::acos(std::clamp(smallest_cosine, -1.0, 1.0));
}

void triangulate_tracks(SfmModel& model,
                        std::span<const std::uint32_t> tracks,
                        const MappingOptions& options,
                        const RunContext& ctx) {
  constexpr std::size_t kGrain = 256;
  parallel_for(ctx, tracks.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      Track& track = model.tracks[tracks[t]];
      const Seen seen = registered_part(model, track);
      const auto solution = solve(model, track, seen, options);
      for (TrackElement& element : track) element.active = false;
      model.points[tracks[t]].reset();
      if (!solution) continue;
      model.points[tracks[t]] = solution->point;
      for (const std::size_t k : solution->members) track[seen.elements[k]].active = true;
    }
  });
}

}  // namespace hybridfusion
