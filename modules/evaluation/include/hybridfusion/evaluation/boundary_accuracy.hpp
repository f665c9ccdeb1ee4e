#pragma once

#include <hybridfusion/geometry/boundary.hpp>

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

struct BoundaryAccuracyOptions {
  BoundaryOptions boundary = {};
  GroundOptions ground = {};
  double partner_m = 1.0;
};

template <>
struct OptionFields<BoundaryAccuracyOptions> {
  using T = BoundaryAccuracyOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::boundary,
          {.key = "boundary", .doc = "What counts as a boundary.", .source = "HybridFusion IV-A"}},
      Field{&T::ground, {.key = "ground", .doc = "The ground to remove.", .source = "ours"}},
      Field{
          &T::partner_m,
          {.key = "partner_m",
           .unit = "m",
           .min = 0.01,
           .max = 100.0,
           .doc = "A LiDAR boundary point has a partner when a vision boundary point is this near.",
           .source = "ours"}},
  };
};

/// Accuracy of HybridFusion IV-A. The two clouds see different parts of the world, so the mean has
/// a floor well above zero at the true pose: a method is better when it is nearer to the value at
/// the true pose, not when it is under it. It is blind to height.
struct BoundaryAccuracy {
  std::size_t num_vision = 0;   ///< 2D boundary points of G.
  std::size_t num_lidar = 0;    ///< 2D boundary points of the registered L in the rectangle of G's.
  std::size_t num_outside = 0;  ///< Left out: the LiDAR reaches further than the photos.
  double mean_m = 0.0;  ///< From each L boundary point to the nearest one of G; NaN without any.
  double share_with_partner = 0.0;
  double trimmed_mean_m = 0.0;          ///< Over that share; NaN when nothing has a partner.
  std::vector<float> distances_m = {};  ///< Of every L boundary point, for a histogram.
};

/// 2D boundary of what stands higher than `boundary.min_height_m` above the cloud's own ground.
/// @returns kInsufficient when there is no ground or nothing stands on it.
[[nodiscard]] Expected<std::vector<Eigen::Vector2f>> standing_boundary(
    std::span<const Eigen::Vector3f> points,
    const BoundaryAccuracyOptions& options,
    const RunContext& ctx = {});

/// Points of L outside the rectangle of G's boundary (grown by `partner_m`) have nothing to meet
/// and are left out. @pre both boundaries are in the frame of G and not empty
[[nodiscard]] BoundaryAccuracy boundary_accuracy(std::span<const Eigen::Vector2f> vision_boundary,
                                                 std::span<const Eigen::Vector2f> lidar_boundary,
                                                 double partner_m);

}  // namespace hybridfusion
