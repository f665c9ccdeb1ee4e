#include "prepared_clouds.hpp"

#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPoints = 1000;

/// LiDAR points near a sensor position (all, when none is given), turned by `leveled_from_lidar`.
PointCloud leveled_cloud(const PointCloud& lidar,
                         const RegistrationInput& input,
                         const Eigen::Quaterniond& leveled_from_lidar,
                         double max_range_m) {
  std::vector<Eigen::Vector3f> sensors;
  for (const Eigen::Vector3d& p : input.sensor_positions) {
    const Eigen::Vector3f planar(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    // A position every metre is enough for a range of tens of metres.
    if (sensors.empty() || (sensors.back() - planar).norm() > 1.0F) sensors.push_back(planar);
  }
  const KdTree tree(sensors);
  const auto limit = static_cast<float>(max_range_m * max_range_m);
  const Eigen::Matrix3f turn = leveled_from_lidar.toRotationMatrix().cast<float>();
  PointCloud kept;
  kept.points.reserve(lidar.size());
  for (const Eigen::Vector3f& p : lidar.points) {
    if (!p.allFinite()) continue;
    if (!sensors.empty() &&
        tree.nearest(Eigen::Vector3f(p.x(), p.y(), 0.0F)).squared_distance_m2 > limit) {
      continue;
    }
    kept.points.emplace_back(turn * p);
  }
  return kept;
}

/// @returns kInsufficient for inconsistent channels or too few finite points.
Expected<void> check_usable(const PointCloud& cloud, std::string_view name) {
  if (const auto valid = validate(cloud); !valid) {
    return std::unexpected(Error(valid.error()).with_context(fmt::format("{} cloud", name)));
  }
  const auto finite = static_cast<std::size_t>(
      std::ranges::count_if(cloud.points, [](const Eigen::Vector3f& p) { return p.allFinite(); }));
  if (finite < kMinPoints) {
    return fail(
        ErrorCode::kInsufficient,
        fmt::format(
            "the {} cloud has {} finite points, at least {} are needed", name, finite, kMinPoints));
  }
  return {};
}

/// Largest raster at OutlineOptions::refine_cell_m: 7.5 km2 at 0.5 m, about 0.6 GB.
constexpr double kMaxCells = 3e7;

/// @returns kInsufficient when the rasters of a cloud would not fit in memory.
Expected<void> check_extent(std::span<const Eigen::Vector3f> points,
                            const OutlineOptions& options,
                            std::string_view name) {
  const Box2 box = percentile_box(points, options.cut_share);
  const Eigen::Vector2d size = box.high - box.low;
  const double cell_m = std::min(options.refine_cell_m, options.lidar_cell_m);
  if (size.x() / cell_m * (size.y() / cell_m) <= kMaxCells) return {};
  return fail(ErrorCode::kInsufficient,
              fmt::format("the {} cloud covers {:.0f} x {:.0f} m, at most {:.1f} km2 can be "
                          "searched at once; give a coarse pose, cut the cloud, or raise "
                          "registration.outline.refine_cell_m",
                          name,
                          size.x(),
                          size.y(),
                          1e-6 * kMaxCells * cell_m * cell_m));
}

Expected<GroundModel> ground_of(std::span<const Eigen::Vector3f> points,
                                const GroundOptions& options,
                                std::string_view name) {
  auto ground = fit_ground(points, options);
  if (!ground && ground.error().code == ErrorCode::kInsufficient) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("the {} cloud shows no ground: {}", name, ground.error().message));
  }
  return ground;
}

}  // namespace

std::vector<Eigen::Vector3f> reachable_vision(const PointCloud& vision,
                                              const PreparedClouds& clouds,
                                              const RegistrationInput& input,
                                              double max_offset_m) {
  constexpr double kMargin_m = 20.0;
  if (!input.vision_from_lidar_initial) return vision.points;
  // L may turn about the middle of its facades, which lies anywhere inside its box.
  const double reach_m = 2.0 * clouds.lidar_diagonal_m + max_offset_m + kMargin_m;
  const Eigen::Vector2d middle =
      (clouds.vision_from_leveled_initial * clouds.lidar_centroid).head<2>();
  std::vector<Eigen::Vector3f> kept;
  for (const Eigen::Vector3f& p : vision.points) {
    if ((p.head<2>().cast<double>() - middle).squaredNorm() < reach_m * reach_m) kept.push_back(p);
  }
  return kept;
}

Expected<PreparedClouds> prepare_lidar(const PointCloud& lidar,
                                       const RegistrationInput& input,
                                       const RegistrationOptions& options,
                                       const RunContext& ctx) {
  if (const auto usable = check_usable(lidar, "LiDAR"); !usable) {
    return std::unexpected(usable.error());
  }
  PreparedClouds clouds;
  const Rigid3 initial = input.vision_from_lidar_initial.value_or(Rigid3{});
  const auto [yaw_rad, tilt] = split_heading(initial.rotation);
  clouds.leveled_from_lidar = Eigen::Quaterniond(tilt).normalized();
  clouds.vision_from_leveled_initial.rotation =
      Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  clouds.vision_from_leveled_initial.translation = initial.translation;
  const PointCloud leveled =
      leveled_cloud(lidar, input, clouds.leveled_from_lidar, options.max_range_m);
  if (leveled.size() < kMinPoints) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} LiDAR points lie within {} m of a sensor position, at least {} are "
                            "needed; the positions must be in the frame of the LiDAR cloud",
                            leveled.size(),
                            options.max_range_m,
                            kMinPoints));
  }
  for (const Eigen::Vector3f& p : leveled.points) clouds.lidar_centroid += p.cast<double>();
  clouds.lidar_centroid /= static_cast<double>(leveled.size());
  const Box2 box = percentile_box(leveled.points, 0.003);
  clouds.lidar_diagonal_m = (box.high - box.low).norm();
  clouds.lidar = voxel_mean(leveled, options.voxel_m).points;
  if (auto fits = check_extent(clouds.lidar, options.outline, "LiDAR"); !fits) {
    return std::unexpected(fits.error());
  }
  HF_TRY(clouds.lidar_ground, ground_of(clouds.lidar, options.ground, "LiDAR"));
  const std::vector<float> heights = heights_above(clouds.lidar_ground, clouds.lidar, ctx);
  clouds.lidar_maps = make_lidar_maps(clouds.lidar, heights, options.outline);
  return clouds;
}

Expected<void> prepare_vision(std::vector<Eigen::Vector3f> points,
                              const RegistrationOptions& options,
                              const RunContext& ctx,
                              PreparedClouds& clouds) {
  clouds.vision = voxel_mean({.points = std::move(points)}, options.voxel_m).points;
  if (clouds.vision.size() < kMinPoints) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("{} vision points lie within reach of the coarse pose: it is wrong by "
                            "more than max_offset_m = {} m, or the clouds do not overlap",
                            clouds.vision.size(),
                            options.max_offset_m));
  }
  if (auto fits = check_extent(clouds.vision, options.outline, "vision"); !fits) return fits;
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while thinning the clouds");
  HF_TRY(clouds.vision_ground, ground_of(clouds.vision, options.ground, "vision"));
  const std::vector<float> heights = heights_above(clouds.vision_ground, clouds.vision, ctx);
  const OutlineOptions& outline = options.outline;
  clouds.search_maps = make_vision_maps(
      clouds.vision, heights, outline.search_cell_m, outline.search_blur_m, outline);
  clouds.maps = make_vision_maps(
      clouds.vision, heights, outline.refine_cell_m, outline.refine_blur_m, outline);
  return {};
}

Expected<PreparedClouds> prepare_lidar_of_pair(const PointCloud& vision,
                                               const PointCloud& lidar,
                                               const RegistrationInput& input,
                                               const RegistrationOptions& options,
                                               const RunContext& ctx) {
  if (const auto usable = check_usable(vision, "vision"); !usable) {
    return std::unexpected(usable.error());
  }
  return prepare_lidar(lidar, input, options, ctx);
}

Expected<PreparedClouds> prepare_clouds(const PointCloud& vision,
                                        const PointCloud& lidar,
                                        const RegistrationInput& input,
                                        const RegistrationOptions& options,
                                        const RunContext& ctx) {
  HF_TRY(PreparedClouds clouds, prepare_lidar_of_pair(vision, lidar, input, options, ctx));
  auto within_reach = reachable_vision(vision, clouds, input, options.max_offset_m);
  if (auto prepared = prepare_vision(std::move(within_reach), options, ctx, clouds); !prepared) {
    return std::unexpected(prepared.error());
  }
  return clouds;
}

Rigid3 height_aligned_initial(const PreparedClouds& clouds) {
  Rigid3 pose = clouds.vision_from_leveled_initial;
  std::vector<double> gaps;
  for (const Eigen::Vector3d& cell : clouds.lidar_maps.free_cells) {
    const Eigen::Vector3d p = pose * cell;
    if (std::isnan(clouds.maps.height.nearest(p.x(), p.y()))) continue;
    gaps.push_back(clouds.vision_ground.height_at(p.x(), p.y()) - p.z());
  }
  if (gaps.empty()) return pose;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  pose.translation.z() += *middle;
  return pose;
}

Rigid3 from_leveled(const Rigid3& vision_from_leveled, const PreparedClouds& clouds) {
  return vision_from_leveled * Rigid3{.rotation = clouds.leveled_from_lidar};
}

PoseCovariance from_leveled(const PoseCovariance& covariance, const PreparedClouds& clouds) {
  // T exp(xi) = (V exp(Q xi)) Q for a pure rotation Q: both halves of the tangent turn by Q.
  PoseCovariance turn = PoseCovariance::Zero();
  turn.topLeftCorner<3, 3>() = clouds.leveled_from_lidar.toRotationMatrix().transpose();
  turn.bottomRightCorner<3, 3>() = turn.topLeftCorner<3, 3>();
  return turn * covariance * turn.transpose();
}

}  // namespace hybridfusion
