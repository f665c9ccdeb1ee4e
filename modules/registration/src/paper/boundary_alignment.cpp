#include "boundary_alignment.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace hybridfusion {
namespace {

constexpr int kMinCellPoints = 4;  // a line of boundary points 0.2 m apart crosses a cell corner
constexpr double kHopeless = 2.0;

Eigen::Vector2d centroid_of(std::span<const Eigen::Vector2f> points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2f& p : points) sum += p.cast<double>();
  return sum / static_cast<double>(points.size());
}

std::vector<Eigen::Vector3f> flattened(std::span<const Eigen::Vector2f> points) {
  std::vector<Eigen::Vector3f> flat;
  flat.reserve(points.size());
  for (const Eigen::Vector2f& p : points) flat.emplace_back(p.x(), p.y(), 0.0F);
  return flat;
}

}  // namespace

std::vector<Eigen::Vector2f> splice_boundary(std::span<const Eigen::Vector3f> points,
                                             std::span<const float> heights,
                                             const PatchGrid& grid,
                                             std::size_t patch,
                                             const BoundaryOptions& options) {
  std::vector<Eigen::Vector2f> high;
  for (const std::uint32_t i : splice_neighbours(grid, patch)) {
    if (static_cast<double>(heights[i]) > options.min_height_m) {
      high.emplace_back(points[i].head<2>());
    }
  }
  return boundary_points(high, options, {.num_threads = 1});
}

BoundaryTarget::BoundaryTarget(std::vector<Eigen::Vector2f> boundary)
    : points_(std::move(boundary)),
      flat_(flattened(points_)),
      tree_(flat_),
      centroid_(centroid_of(points_)) {}

double BoundaryTarget::mean_distance_m(std::span<const Eigen::Vector2f> source,
                                       const Rigid2& target_from_source) const {
  const Eigen::Rotation2D<double> rotation(target_from_source.yaw_rad);
  double sum = 0.0;
  for (const Eigen::Vector2f& p : source) {
    const Eigen::Vector2d moved = rotation * p.cast<double>() + target_from_source.translation;
    const auto x = static_cast<float>(moved.x());
    const auto y = static_cast<float>(moved.y());
    sum += std::sqrt(static_cast<double>(tree_.nearest({x, y, 0.0F}).squared_distance_m2));
  }
  return sum / static_cast<double>(source.size());
}

std::optional<BoundaryMatch> align_boundaries_2d(std::span<const Eigen::Vector2f> lidar,
                                                 const BoundaryTarget& vision,
                                                 const PaperOptions& options) {
  const Eigen::Vector2d onto_centroid = vision.centroid() - centroid_of(lidar);
  const RunContext serial{.num_threads = 1};  // the patches run side by side
  NdtPass coarse{.cell_m = options.ndt2_cell_m,
                 .min_cell_points = kMinCellPoints,
                 .max_iterations = options.ndt2_iterations};
  NdtPass fine = coarse;
  fine.cell_m *= 0.5;
  std::optional<BoundaryMatch> best;
  for (const Eigen::Vector2d& shift : {Eigen::Vector2d(0.0, 0.0), onto_centroid}) {
    const auto near = align_ndt_2d(vision.points(), lidar, {.translation = shift}, coarse, serial);
    if (!near) continue;
    // The fine pass moves little: it cannot save a candidate that is far behind.
    const double near_m = vision.mean_distance_m(lidar, near->target_from_source);
    if (best && near_m > kHopeless * best->mean_distance_m) continue;
    const auto end = align_ndt_2d(vision.points(), lidar, near->target_from_source, fine, serial);
    if (!end || !end->quality.converged) continue;
    const double distance_m = vision.mean_distance_m(lidar, end->target_from_source);
    if (!best || distance_m < best->mean_distance_m) best = {end->target_from_source, distance_m};
  }
  return best;
}

}  // namespace hybridfusion
