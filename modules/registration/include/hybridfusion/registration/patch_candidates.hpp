#pragma once

#include <hybridfusion/registration/esf_descriptor.hpp>
#include <hybridfusion/registration/gridding.hpp>

#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

/// A vision patch that may show the place of a LiDAR patch.
struct PatchCandidate {
  std::size_t vision_patch = 0;  ///< Index into the vision grid's patches.
  double correlation = 0.0;      ///< Pearson, of the two descriptors.
  double neighbour_score = 0.0;  ///< Mean best correlation among the neighbours.
};

/// Descriptors by patch; absent where a patch has too few points.
using PatchSignatures = std::vector<std::optional<CentredSignature>>;

struct CandidateRing {
  double ring_ratio = 0.0;       ///< lambda.
  double max_bearing_rad = 0.0;  ///< phi.
};

/// Vision patches with a point in the ring (1 -+ lambda) E about the GNSS origin and their centroid
/// within +-phi of the bearing of the LiDAR patch's centroid, E away (HybridFusion III-C.2a, R and
/// r). Where E is below one patch step neither ring nor bearing says anything: there every patch
/// with a point within (1 + lambda) steps of the origin is a candidate.
/// @param centroid  Of the LiDAR patch, in vision by the coarse alignment [m].
/// @param origin    GNSS_origin: the origin of the LiDAR frame in vision [m].
/// @returns         Ascending indices into vision_grid.patches.
[[nodiscard]] std::vector<std::size_t> select_candidates(
    const Eigen::Vector2d& centroid,
    const Eigen::Vector2d& origin,
    const PatchGrid& vision_grid,
    std::span<const Eigen::Vector3f> vision_points,
    const CandidateRing& ring);

/// Keeps the candidates whose descriptor correlates with `lidar` by more than `min_correlation`
/// (HybridFusion III-C.2b, 0.6). Candidates without a descriptor are dropped.
[[nodiscard]] std::vector<PatchCandidate> filter_by_correlation(
    const CentredSignature& lidar,
    std::span<const std::size_t> candidates,
    const PatchSignatures& vision,
    double min_correlation);

/// Keeps the `count` candidates whose descriptors correlate best with `lidar`, best first; equal
/// ones in ascending order of the patch.
[[nodiscard]] std::vector<PatchCandidate> best_by_correlation(
    const CentredSignature& lidar,
    std::span<const std::size_t> candidates,
    const PatchSignatures& vision,
    std::size_t count);

}  // namespace hybridfusion
