#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/sim3.hpp>

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Which sensor saw a point of a fused cloud; interpolated ones neither did.
enum class PointSource : std::uint8_t { kVision = 0, kLidar = 1, kInterpolated = 2 };

/// Points in one local metric frame [m] (never UTM or ECEF: float spacing is 0.03 m at 5e5 m).
/// Every channel but `points` is optional: empty, or of the same length as `points`.
struct PointCloud {
  std::vector<Eigen::Vector3f> points = {};   ///< [m]
  std::vector<Eigen::Vector3f> normals = {};  ///< Unit length, towards the sensor.
  std::vector<Rgb8> colors = {};
  std::vector<float> intensities = {};  ///< Sensor units.
  std::vector<double> times_s = {};     ///< Seconds since the UNIX epoch.
  std::vector<float> sigmas_m = {};     ///< One standard deviation of the position along the ray.
  std::vector<float> confidences = {};  ///< Number of photos that agree, or 0..1; larger is better.
  std::vector<PointSource> sources = {};

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] bool empty() const { return points.empty(); }
};

/// kInsufficient when an optional channel is neither empty nor as long as `points`.
[[nodiscard]] Expected<void> validate(const PointCloud& cloud);

/// The points at `indices` (in that order) with every channel that `cloud` has.
[[nodiscard]] PointCloud select(const PointCloud& cloud, const std::vector<std::size_t>& indices);

/// Leaves the points whose flag is not 0, in their order: select without a second cloud's memory.
/// @pre is_kept.size() == cloud.size()
void keep_flagged(PointCloud& cloud, const std::vector<char>& is_kept);

/// `b` behind `a`. A channel survives only when both have it (or one of them is empty).
[[nodiscard]] PointCloud concatenate(PointCloud a, const PointCloud& b);

/// Points and normals mapped into the target frame; sigmas are scaled by a similarity.
[[nodiscard]] PointCloud transformed(const Rigid3& target_from_source, PointCloud cloud);
[[nodiscard]] PointCloud transformed(const Sim3& target_from_source, PointCloud cloud);

/// Drops points with a NaN or infinite coordinate.
/// @returns how many were dropped.
std::size_t remove_non_finite(PointCloud& cloud);

}  // namespace hybridfusion
