#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/normals.hpp>
#include <hybridfusion/registration/fuse_clouds.hpp>
#include <hybridfusion/registration/gap_interpolation.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

double sigma_of(const PointCloud& cloud, std::size_t i, double fallback_m) {
  return cloud.sigmas_m.empty() ? fallback_m : static_cast<double>(cloud.sigmas_m[i]);
}

/// How a point lies to the surface that the other cloud shows there.
struct SurfaceGap {
  double distance_m = 0.0;  ///< From the plane, or from the nearest point where there is no plane.
  double beside_m = 0.0;    ///< Along the plane from the foot to the nearest point; 0 without one.
  Eigen::Vector3f foot = Eigen::Vector3f::Zero();
};

SurfaceGap surface_gap(const Eigen::Vector3f& point,
                       const PointCloud& other,
                       const std::vector<Neighbor>& members) {
  Eigen::Vector3d mean;
  const Eigen::Matrix3d covariance = covariance_of(other.points, members, mean);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const bool is_plane = solver.eigenvalues()[0] < 0.06 * solver.eigenvalues().sum() &&
                        solver.eigenvalues()[1] > 0.1 * solver.eigenvalues()[2];
  const auto squared_m2 = static_cast<double>(members.front().squared_distance_m2);
  if (!is_plane) return {.distance_m = std::sqrt(squared_m2), .foot = point};
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const double height_m = normal.dot(point.cast<double>() - mean);
  const Eigen::Vector3d foot = point.cast<double>() - height_m * normal;
  const Eigen::Vector3d nearest = other.points[members.front().index].cast<double>();
  return {.distance_m = std::abs(height_m),
          .beside_m = (nearest - foot).norm(),
          .foot = foot.cast<float>()};
}

/// What becomes of the points of a cloud beside another.
struct Doubles {
  std::vector<char> is_kept = {};
  std::vector<std::vector<std::pair<std::size_t, Eigen::Vector3f>>> moved = {};
};

/// Not kept are the points of `cloud` whose surface `other` shows better, but for those that fill a
/// gap between its points: these move onto its surface.
Doubles find_doubles(const PointCloud& cloud,
                     double cloud_sigma_m,
                     const PointCloud& other,
                     double other_sigma_m,
                     const FuseOptions& options,
                     const RunContext& ctx) {
  constexpr std::size_t kGrain = 2048;
  const KdTree tree(other.points);
  const auto wanted = static_cast<std::size_t>(options.min_neighbors);
  const auto limit = static_cast<float>(options.search_m * options.search_m);
  Doubles doubles;
  doubles.is_kept.assign(cloud.size(), 1);
  doubles.moved.resize((cloud.size() + kGrain - 1) / kGrain);
  parallel_for(ctx, cloud.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> members;
    for (std::size_t i = begin; i < end && !ctx.stopped(); ++i) {
      tree.nearest(cloud.points[i], 2 * wanted, members);
      while (!members.empty() && members.back().squared_distance_m2 > limit) members.pop_back();
      if (members.size() < wanted) continue;
      const double mine = sigma_of(cloud, i, cloud_sigma_m);
      const double theirs = sigma_of(other, members.front().index, other_sigma_m);
      // Equal sigmas: the LiDAR's, which is `other` when its fallback is the smaller one.
      if (theirs > mine || (theirs == mine && other_sigma_m >= cloud_sigma_m)) continue;
      const double same_m =
          std::max(options.min_distance_m, options.sigma_factor * std::hypot(mine, theirs));
      const SurfaceGap gap = surface_gap(cloud.points[i], other, members);
      if (gap.distance_m >= same_m) continue;
      if (gap.beside_m > options.fill_gap_m) {
        doubles.moved[begin / kGrain].emplace_back(i, gap.foot);
      } else {
        doubles.is_kept[i] = 0;
      }
    }
  });
  return doubles;
}

/// @returns how many points were taken out.
std::size_t take_out(const Doubles& doubles, PointCloud& cloud) {
  for (const auto& part : doubles.moved) {
    for (const auto& [i, foot] : part) cloud.points[i] = foot;
  }
  const std::size_t before = cloud.size();
  keep_flagged(cloud, doubles.is_kept);
  return before - cloud.size();
}

/// LiDAR points take the colour of the nearest vision point: what the better positioned point shows
/// is what the photos saw there. Farther than `max_distance_m` from any they are mid-grey.
void borrow_colors(const PointCloud& vision,
                   PointCloud& lidar,
                   double max_distance_m,
                   const RunContext& ctx) {
  constexpr Rgb8 kGrey{128, 128, 128};
  if (vision.colors.empty() || !lidar.colors.empty()) return;
  lidar.colors.assign(lidar.size(), kGrey);
  const KdTree tree(vision.points);
  const double limit = max_distance_m * max_distance_m;
  parallel_for(ctx, lidar.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighbor nearest = tree.nearest(lidar.points[i]);
      if (nearest.squared_distance_m2 <= limit) lidar.colors[i] = vision.colors[nearest.index];
    }
  });
}

/// Channels that only one sensor has get a neutral value in the other's points, so that they
/// survive the merge.
void harmonise(PointCloud& vision, PointCloud& lidar, const FuseOptions& options) {
  if (!lidar.intensities.empty() && vision.intensities.empty()) {
    vision.intensities.assign(vision.size(), 0.0F);
  }
  if (vision.sigmas_m.empty()) {
    vision.sigmas_m.assign(vision.size(), static_cast<float>(options.default_vision_sigma_m));
  }
  if (lidar.sigmas_m.empty()) {
    lidar.sigmas_m.assign(lidar.size(), static_cast<float>(options.default_lidar_sigma_m));
  }
  vision.sources.assign(vision.size(), PointSource::kVision);
  lidar.sources.assign(lidar.size(), PointSource::kLidar);
}

}  // namespace

Expected<FuseResult> fuse_clouds(PointCloud vision,
                                 PointCloud lidar,
                                 const Rigid3& vision_from_lidar,
                                 const std::optional<Sim3>& vision_rescale,
                                 const FuseOptions& options,
                                 const RunContext& ctx) {
  for (const auto& valid : {validate(options, "fuse"), validate(vision), validate(lidar)}) {
    if (!valid) return std::unexpected(valid.error());
  }
  PointCloud a =
      vision_rescale ? transformed(*vision_rescale, std::move(vision)) : std::move(vision);
  PointCloud b = transformed(vision_from_lidar, std::move(lidar));
  remove_non_finite(a);
  remove_non_finite(b);
  borrow_colors(a, b, options.color_distance_m, ctx);
  FuseResult result;
  if (options.drop_duplicates && !a.empty() && !b.empty()) {
    const double sigma_a = options.default_vision_sigma_m;
    const double sigma_b = options.default_lidar_sigma_m;
    const Doubles doubles_a = find_doubles(a, sigma_a, b, sigma_b, options, ctx);
    const Doubles doubles_b = find_doubles(b, sigma_b, a, sigma_a, options, ctx);
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while merging the clouds");
    result.vision_dropped = take_out(doubles_a, a);
    result.lidar_dropped = take_out(doubles_b, b);
  }
  harmonise(a, b, options);
  result.cloud = concatenate(std::move(a), b);
  b = {};
  if (options.interpolation.enabled) {
    const PointCloud added = interpolate_gaps(result.cloud, options.interpolation, ctx);
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while filling gaps");
    result.interpolated = added.size();
    result.cloud = concatenate(std::move(result.cloud), added);
  }
  return result;
}

}  // namespace hybridfusion
