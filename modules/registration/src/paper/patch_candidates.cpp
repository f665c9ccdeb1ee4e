#include <hybridfusion/registration/patch_candidates.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

/// Smallest angle between two directions [rad], in [0, pi].
double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

}  // namespace

std::vector<std::size_t> select_candidates(const Eigen::Vector2d& centroid,
                                           const Eigen::Vector2d& origin,
                                           const PatchGrid& vision_grid,
                                           std::span<const Eigen::Vector3f> vision_points,
                                           const CandidateRing& ring) {
  const Eigen::Vector2d to_centroid = centroid - origin;
  const double distance = to_centroid.norm();  // E
  const bool near_origin = distance < vision_grid.step_m;
  const double inner = near_origin ? 0.0 : (1.0 - ring.ring_ratio) * distance;
  const double outer = (1.0 + ring.ring_ratio) * std::max(distance, vision_grid.step_m);
  const auto in_ring = [&](std::uint32_t i) {
    const double d = (vision_points[i].head<2>().cast<double>() - origin).norm();
    return d >= inner && d <= outer;
  };
  std::vector<std::size_t> candidates;
  for (std::size_t p = 0; p < vision_grid.patches.size(); ++p) {
    const Patch& patch = vision_grid.patches[p];
    const Eigen::Vector2d to_patch = patch.centroid.head<2>() - origin;
    if (!near_origin && angle_between(to_patch, to_centroid) > ring.max_bearing_rad) continue;
    if (std::ranges::any_of(patch.indices, in_ring)) candidates.push_back(p);
  }
  return candidates;
}

std::vector<PatchCandidate> filter_by_correlation(const CentredSignature& lidar,
                                                  std::span<const std::size_t> candidates,
                                                  const PatchSignatures& vision,
                                                  double min_correlation) {
  std::vector<PatchCandidate> kept;
  for (const std::size_t candidate : candidates) {
    if (!vision[candidate]) continue;
    const double correlation = pearson_correlation(lidar, *vision[candidate]);
    if (correlation > min_correlation) {
      kept.push_back({.vision_patch = candidate, .correlation = correlation});
    }
  }
  return kept;
}

std::vector<PatchCandidate> best_by_correlation(const CentredSignature& lidar,
                                                std::span<const std::size_t> candidates,
                                                const PatchSignatures& vision,
                                                std::size_t count) {
  constexpr double kAny = -2.0;
  std::vector<PatchCandidate> ranked = filter_by_correlation(lidar, candidates, vision, kAny);
  std::ranges::stable_sort(ranked, std::ranges::greater{}, &PatchCandidate::correlation);
  if (ranked.size() > count) ranked.resize(count);
  return ranked;
}

}  // namespace hybridfusion
