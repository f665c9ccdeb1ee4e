#include "fine_samples.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

LazyPlanes::Plane plane_at(std::span<const Eigen::Vector3f> points,
                           const KdTree& tree,
                           const Eigen::Vector3f& point,
                           int neighbors,
                           std::vector<Neighbor>& scratch) {
  tree.nearest(point, static_cast<std::size_t>(neighbors), scratch);
  LazyPlanes::Plane plane{.curvature = 1.0F};
  if (scratch.size() < 4) return plane;
  Eigen::Vector3d mean;
  const Eigen::Matrix3d covariance = covariance_of(points, scratch, mean);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const double sum = solver.eigenvalues().sum();
  // Twice the middle eigenvalue below the largest: a line, whose normal means nothing.
  if (sum <= 0.0 || solver.eigenvalues()[1] < 0.1 * solver.eigenvalues()[2]) return plane;
  plane.mean = mean.cast<float>();
  plane.normal = solver.eigenvectors().col(0).cast<float>();
  plane.curvature = static_cast<float>(std::max(0.0, solver.eigenvalues()[0]) / sum);
  return plane;
}

/// Every k-th index so that about `count` remain.
std::vector<std::size_t> thin(const std::vector<std::size_t>& indices, std::size_t count) {
  if (indices.size() <= count) return indices;
  std::vector<std::size_t> kept;
  kept.reserve(count);
  for (std::size_t k = 0; k < count; ++k) kept.push_back(indices[k * indices.size() / count]);
  return kept;
}

}  // namespace

LazyPlanes::LazyPlanes(std::span<const Eigen::Vector3f> points,
                       const FineOptions& options,
                       const RunContext& ctx)
    : points_(points), tree_(points), planes_(points.size()), neighbors_(options.neighbors) {
  std::vector<std::size_t> probe(points.size());
  for (std::size_t i = 0; i < probe.size(); ++i) probe[i] = i;
  probe = thin(probe, 2000);
  for (int doubling = 0;; ++doubling) {
    compute(probe, neighbors_, ctx);
    const auto planar = std::ranges::count_if(probe, [&](std::size_t i) {
      return static_cast<double>(planes_[i].curvature) < options.max_curvature;
    });
    if (doubling == 2 || 2 * static_cast<std::size_t>(planar) >= probe.size()) break;
    neighbors_ *= 2;
  }
}

void LazyPlanes::compute(std::span<const std::size_t> wanted,
                         int neighbors,
                         const RunContext& ctx) {
  parallel_for(ctx, wanted.size(), 512, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> scratch;
    for (std::size_t k = begin; k < end; ++k) {
      planes_[wanted[k]] = plane_at(points_, tree_, points_[wanted[k]], neighbors, scratch);
    }
  });
}

void LazyPlanes::prepare(std::vector<std::size_t> wanted, const RunContext& ctx) {
  std::erase_if(wanted, [&](std::size_t i) { return planes_[i].curvature >= 0.0F; });
  std::ranges::sort(wanted);
  const auto repeated = std::ranges::unique(wanted);
  wanted.erase(repeated.begin(), repeated.end());
  compute(wanted, neighbors_, ctx);
}

std::vector<FineSample> draw_samples(std::span<const Eigen::Vector3f> vision,
                                     std::span<const Eigen::Vector3f> lidar,
                                     const Rigid3& start,
                                     const FineOptions& options,
                                     const RunContext& ctx) {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F);
  Eigen::Vector3f high = -low;
  for (const Eigen::Vector3f& p : vision) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < lidar.size(); ++i) {
    const Eigen::Vector3f p = (start * lidar[i].cast<double>()).cast<float>();
    if (((p - low).array() > -1.0F).all() && ((high - p).array() > -1.0F).all()) {
      inside.push_back(i);
    }
  }
  const auto wanted = static_cast<std::size_t>(options.samples);
  inside = thin(inside, 4 * wanted);
  const KdTree tree(lidar);
  std::vector<LazyPlanes::Plane> planes(inside.size());
  parallel_for(ctx, inside.size(), 512, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> scratch;
    for (std::size_t k = begin; k < end; ++k) {
      planes[k] = plane_at(lidar, tree, lidar[inside[k]], options.neighbors, scratch);
    }
  });
  std::array<std::vector<std::size_t>, 2> classes;
  const Eigen::Vector3f up = (start.rotation.inverse() * Eigen::Vector3d::UnitZ()).cast<float>();
  for (std::size_t k = 0; k < inside.size(); ++k) {
    if (static_cast<double>(planes[k].curvature) > options.max_curvature) continue;
    const float rise = std::abs(planes[k].normal.dot(up));
    if (rise < 0.3F) classes[1].push_back(k);
    if (rise > 0.9F) classes[0].push_back(k);
  }
  classes[1] = thin(classes[1], wanted / 2);
  classes[0] = thin(classes[0], wanted - classes[1].size());
  std::vector<FineSample> samples;
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t k = 0; k < classes[c].size(); ++k) {
      const LazyPlanes::Plane& plane = planes[classes[c][k]];
      samples.push_back({.point = plane.mean.cast<double>(),
                         .normal = plane.normal.cast<double>(),
                         .is_vertical = c == 1,
                         .is_held_out = k % 5 == 4});
    }
  }
  return samples;
}

FineInputs make_fine_inputs(std::span<const Eigen::Vector3f> vision,
                            std::span<const Eigen::Vector3f> lidar,
                            const Rigid3& start,
                            const FineOptions& options,
                            const RunContext& ctx) {
  return {.planes = LazyPlanes(vision, options, ctx),
          .samples = draw_samples(vision, lidar, start, options, ctx)};
}

}  // namespace hybridfusion
