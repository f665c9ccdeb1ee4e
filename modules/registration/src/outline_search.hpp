#pragma once

#include "outline_maps.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <optional>
#include <vector>

namespace hybridfusion {

/// A planar pose: a point p of the LiDAR cloud, given from `centre`, goes to position + R(yaw) p.
struct PlanarPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< Of the LiDAR centre in vision [m].
  double yaw_rad = 0.0;
  double overhang_m = 0.0;  ///< Outward shift of facades onto rims.
  double score = 0.0;       ///< Facade weight on rims less the penalty for ground in buildings.
};

/// Where to look. An absent disc means everywhere the clouds can overlap.
struct SearchWindow {
  double yaw_rad = 0.0;      ///< Middle of the headings.
  double max_yaw_rad = 0.0;  ///< Half range; pi or more: all headings.
  std::optional<Eigen::Vector2d> position = {};
  double max_offset_m = 0.0;
};

/// Facades and free ground as weighted planar points about `centre`.
struct PlanarPattern {
  struct Facade {
    Eigen::Vector2d point;
    Eigen::Vector2d outward;
    double weight;
  };
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< In the LiDAR frame [m].
  std::vector<Facade> facades = {};
  std::vector<Eigen::Vector2d> free_points = {};  ///< Every third free cell; weight 3 each.
  double reach_m = 0.0;                           ///< Farthest point.
};
inline constexpr double kFreeWeight = 3.0;

/// @param tilt  Roll and pitch of the LiDAR frame, applied before the projection to x-y.
[[nodiscard]] PlanarPattern make_pattern(const LidarMaps& maps, const Eigen::Matrix3d& tilt);

struct OutlineSearch {
  std::vector<PlanarPose> peaks = {};     ///< In descending score, at most `num_peaks`.
  std::vector<YawScore> yaw_scores = {};  ///< One for each heading tried.
};

/// Exhaustive search: for each heading, facade weight on rims less ground in buildings for every
/// shift by FFT.
/// @returns kInsufficient when there is nothing to correlate, kCancelled when stopped.
[[nodiscard]] Expected<OutlineSearch> search_outlines(const VisionMaps& vision,
                                                      const PlanarPattern& pattern,
                                                      const SearchWindow& window,
                                                      const OutlineOptions& options,
                                                      const RunContext& ctx);

/// True when two poses belong to one peak of the search.
[[nodiscard]] bool same_peak(const PlanarPose& a,
                             const PlanarPose& b,
                             const OutlineOptions& options);

/// The score at one pose, by bilinear look-up.
[[nodiscard]] double score_of(const VisionMaps& vision,
                              const PlanarPattern& pattern,
                              const PlanarPose& pose,
                              double free_penalty);

/// Climbs from `start` in position, heading and overhang. @param step_m first step
[[nodiscard]] PlanarPose refine_pose(const VisionMaps& vision,
                                     const PlanarPattern& pattern,
                                     const PlanarPose& start,
                                     double step_m,
                                     const OutlineOptions& options);

}  // namespace hybridfusion
