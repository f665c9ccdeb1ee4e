#include "ground_candidates.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/ground.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

using Basis = Eigen::Matrix<double, 6, 1>;

/// Coordinates are scaled by 1/50 m inside the solves, so that one ridge fits all terms.
constexpr double kUnit_m = 50.0;

Basis basis_at(double x, double y) {
  const double u = x / kUnit_m;
  const double v = y / kUnit_m;
  return (Basis() << 1.0, u, v, u * u, u * v, v * v).finished();
}

/// Weighted least squares over the first `terms` of the basis with a slight ridge on the others.
Basis solve_surface(std::span<const Eigen::Vector3d> points,
                    std::span<const double> weights,
                    const Eigen::Vector2d& centre,
                    int terms) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Basis right = Basis::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    const Basis b = basis_at(points[i].x() - centre.x(), points[i].y() - centre.y());
    normal += weights[i] * b * b.transpose();
    right += weights[i] * points[i].z() * b;
  }
  const double total = normal(0, 0) + 1e-9;
  for (int k = 0; k < 6; ++k) {
    // Curvature is held weakly at zero: cells along one street do not determine it.
    if (k > 0) normal(k, k) += total * (k < 3 ? 1e-6 : 1e-3);
    if (k < terms) continue;
    normal.row(k).setZero();
    normal.col(k).setZero();
    normal(k, k) = 1.0;
    right[k] = 0.0;
  }
  return normal.ldlt().solve(right);
}

/// Cauchy weight that treats what lies above the surface (roofs, cars) harder than what lies below.
double asymmetric_weight(double residual_m, double scale) {
  const double width_m = scale * (residual_m > 0.0 ? 0.6 : 2.4);
  const double ratio = residual_m / width_m;
  return 1.0 / (1.0 + ratio * ratio);
}

double surface_at(const Basis& surface, const Eigen::Vector2d& offset) {
  return surface.dot(basis_at(offset.x(), offset.y()));
}

Basis start_plane(std::span<const Eigen::Vector3d> lowest, const Eigen::Vector2d& centre) {
  std::vector<double> weights(lowest.size(), 1.0);
  Basis plane = solve_surface(lowest, weights, centre, 3);
  // Graduated: wide kernels first, so that a slope of several metres is not taken for outliers.
  for (const double scale : {8.0, 8.0, 4.0, 4.0, 2.0, 2.0, 1.0, 1.0, 1.0, 1.0}) {
    for (std::size_t i = 0; i < lowest.size(); ++i) {
      const double residual = lowest[i].z() - surface_at(plane, lowest[i].head<2>() - centre);
      weights[i] = asymmetric_weight(residual, scale);
    }
    plane = solve_surface(lowest, weights, centre, 3);
  }
  return plane;
}

void refit_surface(GroundModel& model,
                   std::span<const Eigen::Vector3d> points,
                   const GroundOptions& options) {
  std::vector<double> weights(points.size());
  constexpr int kRounds = 8;
  for (int round = 0; round < kRounds; ++round) {
    const double gate = options.start_gate_m * std::pow(options.final_gate_m / options.start_gate_m,
                                                        round / (kRounds - 1.0));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double residual =
          points[i].z() - surface_at(model.surface, points[i].head<2>() - model.centre);
      weights[i] = std::abs(residual) < gate ? asymmetric_weight(residual, gate) : 0.0;
    }
    model.surface = solve_surface(points, weights, model.centre, round < 3 ? 3 : 6);
  }
}

std::size_t node_at(const GroundModel& model, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(model.tiles_x) +
         static_cast<std::size_t>(x);
}

/// Local planes about grid nodes on what the surface leaves, held at zero where cells are few.
void fit_tiles(GroundModel& model,
               std::span<const Eigen::Vector3d> points,
               const GroundOptions& options) {
  model.tile_m = options.tile_m;
  model.tiles_x = static_cast<int>((model.box_max.x() - model.box_min.x()) / model.tile_m) + 2;
  model.tiles_y = static_cast<int>((model.box_max.y() - model.box_min.y()) / model.tile_m) + 2;
  model.tiles.assign(
      static_cast<std::size_t>(model.tiles_x) * static_cast<std::size_t>(model.tiles_y),
      Eigen::Vector3d::Zero());
  for (const double gate : {2.0 * options.start_gate_m,
                            options.start_gate_m,
                            options.final_gate_m,
                            options.final_gate_m}) {
    std::vector<Eigen::Matrix3d> normals(model.tiles.size(), Eigen::Matrix3d::Zero());
    std::vector<Eigen::Vector3d> rights(model.tiles.size(), Eigen::Vector3d::Zero());
    for (const Eigen::Vector3d& p : points) {
      const double residual = p.z() - model.height_at(p.x(), p.y());
      if (std::abs(residual) > gate) continue;
      const double left = p.z() - surface_at(model.surface, p.head<2>() - model.centre);
      const Eigen::Vector2d grid = (p.head<2>() - model.box_min) / model.tile_m;
      const int x0 = std::clamp(static_cast<int>(grid.x()), 0, model.tiles_x - 2);
      const int y0 = std::clamp(static_cast<int>(grid.y()), 0, model.tiles_y - 2);
      for (const auto& [x, y] : {std::pair{x0, y0}, {x0 + 1, y0}, {x0, y0 + 1}, {x0 + 1, y0 + 1}}) {
        const Eigen::Vector3d b(1.0, grid.x() - x, grid.y() - y);
        const double hat = (1.0 - std::abs(b.y())) * (1.0 - std::abs(b.z()));
        if (hat <= 0.0) continue;
        const double weight = hat * asymmetric_weight(residual, gate);
        const std::size_t node = node_at(model, x, y);
        normals[node] += weight * b * b.transpose();
        rights[node] += weight * left * b;
      }
    }
    for (std::size_t node = 0; node < model.tiles.size(); ++node) {
      normals[node].diagonal() += Eigen::Vector3d(2.0, 5.0, 5.0);
      model.tiles[node] = normals[node].ldlt().solve(rights[node]);
    }
  }
}

}  // namespace

double GroundModel::height_at(double x, double y) const {
  const Eigen::Vector2d point(x, y);
  const Eigen::Vector2d inside = point.cwiseMax(box_min).cwiseMin(box_max);
  double z =
      surface_at(surface, inside - centre) + surface.segment<2>(1).dot(point - inside) / kUnit_m;
  if (tiles_x == 0) return z;
  const Eigen::Vector2d grid = (inside - box_min) / tile_m;
  const int x0 = std::clamp(static_cast<int>(grid.x()), 0, tiles_x - 2);
  const int y0 = std::clamp(static_cast<int>(grid.y()), 0, tiles_y - 2);
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const Eigen::Vector3d b(1.0, grid.x() - (x0 + dx), grid.y() - (y0 + dy));
      const double hat = (1.0 - std::abs(b.y())) * (1.0 - std::abs(b.z()));
      z += hat * b.dot(tiles[node_at(*this, x0 + dx, y0 + dy)]);
    }
  }
  return z;
}

Expected<GroundModel> fit_ground(std::span<const Eigen::Vector3f> points,
                                 const GroundOptions& options) {
  if (const auto valid = validate(options, "ground"); !valid) {
    return std::unexpected(valid.error());
  }
  const std::vector<GroundCandidate> candidates = ground_candidates(points, options);
  if (candidates.size() < static_cast<std::size_t>(options.min_cells)) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} cells of {} m hold {} points or more, at least {} are needed to "
                            "find the ground; give a denser or larger cloud",
                            candidates.size(),
                            options.cell_m,
                            options.min_points,
                            options.min_cells));
  }
  std::vector<Eigen::Vector3d> cells;
  cells.reserve(candidates.size());
  GroundModel model;
  for (const GroundCandidate& c : candidates) {
    cells.push_back(c.point);
    model.centre += c.point.head<2>() / static_cast<double>(candidates.size());
  }
  model.num_cells = cells.size();
  // Until the inliers are known the surface is a plane or is used where cells are.
  model.box_min = Eigen::Vector2d::Constant(-1e9);
  model.box_max = Eigen::Vector2d::Constant(1e9);
  model.surface = start_plane(block_minima(candidates, options.block_m), model.centre);
  refit_surface(model, cells, options);

  model.box_min = Eigen::Vector2d::Constant(1e9);
  model.box_max = Eigen::Vector2d::Constant(-1e9);
  for (const Eigen::Vector3d& p : cells) {
    const double residual = p.z() - surface_at(model.surface, p.head<2>() - model.centre);
    if (std::abs(residual) > 2.0 * options.start_gate_m) continue;
    model.box_min = model.box_min.cwiseMin(p.head<2>());
    model.box_max = model.box_max.cwiseMax(p.head<2>());
  }
  if ((model.box_max - model.box_min).minCoeff() >= 0.0) fit_tiles(model, cells, options);
  double sum = 0.0;
  for (const Eigen::Vector3d& p : cells) {
    const double residual = p.z() - model.height_at(p.x(), p.y());
    if (std::abs(residual) > options.final_gate_m) continue;
    ++model.num_inliers;
    sum += residual * residual;
  }
  if (model.num_inliers < static_cast<std::size_t>(options.min_cells)) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("only {} of {} cells lie within {} m of one ground surface, at least "
                            "{} are needed",
                            model.num_inliers,
                            model.num_cells,
                            options.final_gate_m,
                            options.min_cells));
  }
  model.rms_m = std::sqrt(sum / static_cast<double>(model.num_inliers));
  return model;
}

std::vector<float> heights_above(const GroundModel& ground,
                                 std::span<const Eigen::Vector3f> points,
                                 const RunContext& ctx) {
  std::vector<float> heights(points.size());
  parallel_for(ctx, points.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d p = points[i].cast<double>();
      heights[i] = static_cast<float>(p.z() - ground.height_at(p.x(), p.y()));
    }
  });
  return heights;
}

}  // namespace hybridfusion
