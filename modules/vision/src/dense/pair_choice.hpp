#pragma once

#include <hybridfusion/vision/densify_options.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <cstdint>
#include <vector>

namespace hybridfusion {

/// A photo to match another with, and what the sparse points they share say of the pair.
struct StereoPartner {
  std::uint32_t view = 0;
  std::vector<std::uint32_t> shared_points = {};  ///< Into Reconstruction::points.
  double median_angle_rad = 0.0;                  ///< Intersection angle at those points.
};

/// Partners of `reference`, best first: many shared points, an intersection angle near the
/// preferred one, and baselines in different directions (along and across the track).
[[nodiscard]] std::vector<StereoPartner> choose_partners(const Reconstruction& reconstruction,
                                                         std::uint32_t reference,
                                                         const DensifyOptions& options);

/// Views that see what `reference` sees: those sharing most points, at most `max_count`.
[[nodiscard]] std::vector<std::uint32_t> overlapping_views(const Reconstruction& reconstruction,
                                                           std::uint32_t reference,
                                                           std::size_t max_count);

}  // namespace hybridfusion
