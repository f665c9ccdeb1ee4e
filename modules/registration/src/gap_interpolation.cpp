#include "gap_places.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/boundary.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/registration/gap_interpolation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hybridfusion {
namespace {

constexpr std::size_t kGrain = 4096;
constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;

/// An interpolated point; one is kept a cell, the best surrounded.
struct Filling {
  std::uint64_t cell = 0;
  float open_angle_rad = 0.0F;
  Eigen::Vector3f at = Eigen::Vector3f::Zero();
  float sigma_m = 0.0F;
  std::uint32_t nearest = 0;  ///< Measured point.
  Rgb8 color = {};
};

/// Widest sector around `foot` without a neighbour near the plane; a full turn for too few, and
/// where one lies above or below it: there the surface is rough, but it has no gap.
float open_angle_rad(const Measured& measured,
                     const Eigen::Vector3d& foot,
                     const LocalPlane& plane,
                     const std::vector<Neighbor>& members,
                     std::vector<float>& directions) {
  directions.clear();
  for (const Neighbor& member : members) {
    const Eigen::Vector3d d = measured.cloud.points[member.index].cast<double>() - foot;
    if (std::abs(plane.normal.dot(d)) > 3.0 * measured.options.max_roughness_m) continue;
    const Eigen::Vector2d beside(plane.along.dot(d), plane.across.dot(d));
    if (beside.squaredNorm() < 0.5 * static_cast<double>(measured.spacing_squared())) {
      return kFullTurn;
    }
    directions.push_back(static_cast<float>(std::atan2(beside.y(), beside.x())));
  }
  if (directions.size() < static_cast<std::size_t>(measured.options.min_neighbors)) {
    return kFullTurn;
  }
  return widest_gap_rad(directions);
}

/// Colour and sigma of the neighbours, near ones weighing more.
void take_means(const Measured& measured,
                const std::vector<Neighbor>& members,
                double roughness_m,
                Filling& filling) {
  const PointCloud& cloud = measured.cloud;
  double sum = 0.0;
  double variance = 0.0;
  Eigen::Vector3d color = Eigen::Vector3d::Zero();
  for (const Neighbor& member : members) {
    const double weight = weight_of(member, measured.options.radius_m);
    sum += weight;
    if (!cloud.sigmas_m.empty()) {
      const auto sigma_m = static_cast<double>(cloud.sigmas_m[member.index]);
      variance += weight * sigma_m * sigma_m;
    }
    if (cloud.colors.empty()) continue;
    const Rgb8& rgb = cloud.colors[member.index];
    color += weight * Eigen::Vector3d(rgb[0], rgb[1], rgb[2]);
  }
  filling.sigma_m = static_cast<float>(std::sqrt(variance / sum + roughness_m * roughness_m));
  for (std::size_t k = 0; k < 3; ++k) {
    filling.color[k] =
        static_cast<std::uint8_t>(std::lround(color[static_cast<Eigen::Index>(k)] / sum));
  }
}

/// The point on the neighbours' plane; none where they do not surround it or it is not free.
std::optional<Filling> filling_at(const Measured& measured,
                                  const Eigen::Vector3f& place,
                                  std::vector<Neighbor>& members,
                                  std::vector<float>& directions) {
  const InterpolationOptions& options = measured.options;
  if (!find_neighbors(measured, place, members)) return std::nullopt;
  if (members.front().squared_distance_m2 < measured.spacing_squared()) return std::nullopt;
  const auto plane = local_plane(measured, members);
  if (!plane) return std::nullopt;
  const double height_m = plane->normal.dot(place.cast<double>() - plane->mean);
  if (std::abs(height_m) > options.spacing_m) return std::nullopt;
  const Eigen::Vector3d foot = place.cast<double>() - height_m * plane->normal;
  const float open_rad = open_angle_rad(measured, foot, *plane, members, directions);
  if (static_cast<double>(open_rad) > options.max_open_angle_rad) return std::nullopt;
  const Eigen::Vector3f at = foot.cast<float>();
  if (measured.tree.nearest(at).squared_distance_m2 < measured.spacing_squared()) {
    return std::nullopt;
  }
  Filling filling{.cell = voxel_key(voxel_of(at, options.spacing_m)),
                  .open_angle_rad = open_rad,
                  .at = at,
                  .nearest = static_cast<std::uint32_t>(members.front().index)};
  take_means(measured, members, plane->roughness_m, filling);
  return filling;
}

std::vector<Filling> fillings_of(const Measured& measured,
                                 const std::vector<Place>& places,
                                 const RunContext& ctx) {
  std::vector<std::vector<Filling>> parts((places.size() + kGrain - 1) / kGrain);
  parallel_for(ctx, places.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> members;
    std::vector<float> directions;
    for (std::size_t i = begin; i < end && !ctx.stopped(); ++i) {
      if (auto filling = filling_at(measured, places[i].at, members, directions)) {
        parts[begin / kGrain].push_back(*filling);
      }
    }
  });
  return joined(std::move(parts));
}

/// Slice by slice along x, because there are several free places to a measured point.
std::vector<Filling> fillings(const Measured& measured, const RunContext& ctx) {
  constexpr std::size_t kSlice = 32 * kGrain;
  const std::vector<std::uint32_t> starts =
      one_in_each_cell(measured.cloud, measured.options.spacing_m);
  std::vector<std::vector<Filling>> slices;
  for (std::size_t begin = 0; begin < starts.size(); begin += kSlice) {
    const std::size_t count = std::min(kSlice, starts.size() - begin);
    slices.push_back(fillings_of(
        measured, free_places(measured, std::span(starts).subspan(begin, count), ctx), ctx));
  }
  std::vector<Filling> all = joined(std::move(slices));
  keep_best_in_cell(all, &Filling::open_angle_rad);
  return all;
}

}  // namespace

PointCloud interpolate_gaps(const PointCloud& cloud,
                            const InterpolationOptions& options,
                            const RunContext& ctx) {
  const KdTree tree(cloud.points);
  const Measured measured{.cloud = cloud, .tree = tree, .options = options};
  const std::vector<Filling> found = fillings(measured, ctx);
  std::vector<std::size_t> nearest;
  nearest.reserve(found.size());
  for (const Filling& filling : found) nearest.push_back(filling.nearest);
  PointCloud added = select(cloud, nearest);
  added.sources.assign(found.size(), PointSource::kInterpolated);
  added.sigmas_m.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    added.points[i] = found[i].at;
    added.sigmas_m[i] = found[i].sigma_m;
    if (!added.colors.empty()) added.colors[i] = found[i].color;
  }
  return added;
}

}  // namespace hybridfusion
