#pragma once

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

struct RelativePose {
  Rigid3 second_from_first = {};  ///< Translation of unit length: the scale is free.
  std::vector<std::uint32_t> inliers = {};
};

struct RelativePoseOptions {
  double max_error = 0.001;  ///< Sampson error of an inlier, normalised image coordinates.
  int max_iterations = 1000;
  int min_inliers = 20;
};

/// Calibrated relative pose by locally optimised RANSAC (Chum et al. 2003) over five-point samples
/// with truncated squared Sampson errors as the score.
/// @param first, second  Matched undistorted normalised coordinates.
/// @returns nullopt below options.min_inliers.
[[nodiscard]] std::optional<RelativePose> estimate_relative_pose(
    std::span<const Eigen::Vector2d> first,
    std::span<const Eigen::Vector2d> second,
    const RelativePoseOptions& options,
    Random random);

/// [t]x R of a pose.
[[nodiscard]] Eigen::Matrix3d essential_of(const Rigid3& second_from_first);

/// Share of the matches that one homography explains to `max_error` (a plane, or no baseline).
[[nodiscard]] double homography_share(std::span<const Eigen::Vector2d> first,
                                      std::span<const Eigen::Vector2d> second,
                                      double max_error);

}  // namespace hybridfusion
