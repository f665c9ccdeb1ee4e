#include "gap_places.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::size_t kGrain = 4096;
constexpr int kDirections = 8;
/// Places are tried up to that many spacings beside a point.
constexpr int kSteps = 4;
/// Cells have 21 bits an axis: farther points are left alone.
constexpr int kMaxCell = (1 << 20) - 1;

bool has_cell(const Eigen::Vector3f& point, double spacing_m) {
  return static_cast<double>(point.cwiseAbs().maxCoeff()) < spacing_m * kMaxCell;
}

/// Free places around measured point `i`, in rings on its plane.
void add_places_around(const Measured& measured,
                       std::size_t i,
                       std::vector<Neighbor>& members,
                       std::vector<Place>& places) {
  const double spacing_m = measured.options.spacing_m;
  const std::vector<Eigen::Vector3f>& points = measured.cloud.points;
  const Eigen::Vector3f& centre = points[i];
  if (!find_neighbors(measured, centre, members)) return;
  const auto plane = local_plane(measured, members);
  if (!plane) return;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    const Eigen::Vector3f direction =
        (std::cos(angle) * plane->along + std::sin(angle) * plane->across).cast<float>();
    for (int step = 1; step <= kSteps; ++step) {
      const auto step_m = static_cast<float>(spacing_m * step);
      const Eigen::Vector3f at = centre + step_m * direction;
      const auto is_near = [&](const Neighbor& member) {
        return (points[member.index] - at).squaredNorm() < measured.spacing_squared();
      };
      if (std::ranges::any_of(members, is_near) || !has_cell(at, spacing_m)) continue;
      places.push_back({voxel_key(voxel_of(at, spacing_m)), step_m, at});
    }
  }
}

}  // namespace

std::vector<std::uint32_t> one_in_each_cell(const PointCloud& cloud, double spacing_m) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells;
  cells.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!has_cell(cloud.points[i], spacing_m)) continue;
    cells.emplace_back(voxel_key(voxel_of(cloud.points[i], 1.5 * spacing_m)),
                       static_cast<std::uint32_t>(i));
  }
  std::ranges::sort(cells);
  std::vector<std::uint32_t> chosen;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k == 0 || cells[k].first != cells[k - 1].first) chosen.push_back(cells[k].second);
  }
  return chosen;
}

std::vector<Place> free_places(const Measured& measured,
                               std::span<const std::uint32_t> starts,
                               const RunContext& ctx) {
  std::vector<std::vector<Place>> parts((starts.size() + kGrain - 1) / kGrain);
  parallel_for(ctx, starts.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> members;
    std::vector<Place>& places = parts[begin / kGrain];
    for (std::size_t i = begin; i < end && !ctx.stopped(); ++i) {
      add_places_around(measured, starts[i], members, places);
    }
    keep_best_in_cell(places, &Place::step_m);
    places.shrink_to_fit();
  });
  std::vector<Place> places = joined(std::move(parts));
  keep_best_in_cell(places, &Place::step_m);
  return places;
}

}  // namespace hybridfusion
