#include <hybridfusion/registration/neighbour_filter.hpp>

#include <algorithm>

namespace hybridfusion {

double neighbour_similarity(std::span<const std::size_t> lidar_neighbours,
                            const PatchSignatures& lidar,
                            std::span<const std::size_t> vision_neighbours,
                            const PatchSignatures& vision) {
  const auto described = [&](std::size_t v) { return vision[v].has_value(); };
  if (std::ranges::none_of(vision_neighbours, described)) return 0.0;
  double sum = 0.0;
  int count = 0;
  for (const std::size_t l : lidar_neighbours) {
    if (!lidar[l]) continue;
    double best = -1.0;
    for (const std::size_t v : vision_neighbours) {
      if (vision[v]) best = std::max(best, pearson_correlation(*lidar[l], *vision[v]));
    }
    sum += best;
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

std::vector<PatchCandidate> filter_by_neighbours(std::size_t lidar_patch,
                                                 std::span<const PatchCandidate> candidates,
                                                 const PatchGrid& lidar_grid,
                                                 const PatchSignatures& lidar,
                                                 const PatchGrid& vision_grid,
                                                 const PatchSignatures& vision,
                                                 std::size_t min_points,
                                                 double min_score) {
  const auto lidar_neighbours = neighbours_of(lidar_grid, lidar_patch, min_points);
  std::vector<PatchCandidate> kept;
  for (PatchCandidate candidate : candidates) {
    const auto vision_neighbours = neighbours_of(vision_grid, candidate.vision_patch, min_points);
    candidate.neighbour_score =
        neighbour_similarity(lidar_neighbours, lidar, vision_neighbours, vision);
    if (candidate.neighbour_score >= min_score) kept.push_back(candidate);
  }
  return kept;
}

}  // namespace hybridfusion
