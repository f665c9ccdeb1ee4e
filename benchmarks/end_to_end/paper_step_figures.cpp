#include "paper_step_figures.hpp"

#include "prepared_clouds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace hybridfusion::benchmark {
namespace {

std::optional<std::size_t> cell_at(const PatchGrid& grid, const Eigen::Vector3d& point) {
  const Eigen::Vector2d cell = (point.head<2>() - grid.origin) / grid.step_m;
  const int patch =
      grid.patch_at(static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y())));
  if (patch < 0) return std::nullopt;
  return static_cast<std::size_t>(patch);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Ranks and similarities, gathered patch by patch.
class Ranking {
 public:
  /// @param in_ring  Ascending.
  void add(const CentredSignature& lidar,
           const PatchSignatures& vision,
           std::size_t true_cell,
           const std::vector<std::size_t>& in_ring) {
    const double own = pearson_correlation(lidar, *vision[true_cell]);
    double better = 0.0;
    double better_in_ring = 0.0;
    for (std::size_t cell = 0; cell < vision.size(); ++cell) {
      if (cell == true_cell || !vision[cell]) continue;
      const double other = pearson_correlation(lidar, *vision[cell]);
      const double loses = other > own ? 1.0 : (other == own ? 0.5 : 0.0);
      better += loses;
      if (std::ranges::binary_search(in_ring, cell)) better_in_ring += loses;
      wins_ += 1.0 - loses;
      pairs_ += 1.0;
    }
    ranks_.push_back(1.0 + better);
    ring_ranks_.push_back(1.0 + better_in_ring);
  }

  void finish(StepFigures& figures) const {
    figures.num_ranked = ranks_.size();
    figures.rank_median = median(ranks_);
    figures.rank_ring_median = median(ring_ranks_);
    figures.auc = pairs_ > 0.0 ? wins_ / pairs_ : 0.0;
  }

 private:
  std::vector<double> ranks_ = {};
  std::vector<double> ring_ranks_ = {};
  double wins_ = 0.0;
  double pairs_ = 0.0;
};

bool holds(const std::vector<PatchCandidate>& candidates, std::size_t cell) {
  return std::ranges::find(candidates, cell, &PatchCandidate::vision_patch) != candidates.end();
}

/// The candidate steps of one LiDAR patch.
void follow(const PatchedCloud& lidar,
            const PatchedCloud& vision,
            std::size_t patch,
            std::size_t true_cell,
            const Eigen::Vector2d& origin,
            const PaperOptions& options,
            StepFigures& figures,
            Ranking& ranking) {
  const Eigen::Vector2d centroid = lidar.grid.patches[patch].centroid.head<2>();
  const auto in_ring = select_candidates(
      centroid,
      origin,
      vision.grid,
      vision.points,
      {.ring_ratio = options.ring_ratio, .max_bearing_rad = options.max_bearing_rad});
  ++figures.num_patches;
  figures.in_ring += in_ring.size();
  if (std::ranges::binary_search(in_ring, true_cell)) ++figures.true_in_ring;
  if (!lidar.signatures[patch]) return;
  const CentredSignature& signature = *lidar.signatures[patch];
  if (vision.signatures[true_cell]) ranking.add(signature, vision.signatures, true_cell, in_ring);
  const auto correlated =
      filter_by_correlation(signature, in_ring, vision.signatures, options.min_correlation);
  PatchMatch match;
  const auto kept = match_patch(patch, lidar, vision, origin, options, match);
  // With candidates by rank there is one step, which replaces both filters.
  const bool by_rank = changes_of(options).best_candidates > 0;
  figures.correlated += match.num_correlated;
  figures.similar += kept.size();
  if (by_rank ? holds(kept, true_cell) : holds(correlated, true_cell)) ++figures.true_correlated;
  if (holds(kept, true_cell)) ++figures.true_similar;
}

void count_poses(const RegistrationResult& result,
                 const PatchGrid& vision_grid,
                 const Rigid3& truth,
                 const Rigid3& true_from_coarse,
                 StepFigures& figures) {
  constexpr double kMaxGap_m = 1.0;
  constexpr double kMaxTurn_rad = 2.0 * std::numbers::pi / 180.0;
  const Rigid3 lidar_from_vision = truth.inverse();
  for (const PatchMatch& match : result.patches) {
    const bool has_3d =
        match.outcome == PatchOutcome::kPose || match.outcome == PatchOutcome::kInCluster;
    if (!has_3d && match.outcome != PatchOutcome::kRejected3d) continue;
    // Any point of the patch does: its centroid by the truth, near where the patch was put.
    const Eigen::Vector3d in_lidar = lidar_from_vision * match.centroid_in_vision;
    const Eigen::Vector3d place = truth * in_lidar;
    const Eigen::Vector3d gap_2d = match.vision_from_lidar_2d * in_lidar - place;
    const Eigen::Vector3d forward =
        truth.rotation.conjugate() *
        (match.vision_from_lidar_2d.rotation * Eigen::Vector3d::UnitX());
    ++figures.num_2d;
    const auto true_cell = cell_at(vision_grid, true_from_coarse * match.centroid_in_vision);
    if (true_cell && vision_grid.patches[*true_cell].cell == match.vision_cell) {
      ++figures.chosen_true;
    }
    if (gap_2d.head<2>().norm() < kMaxGap_m &&
        std::abs(std::atan2(forward.y(), forward.x())) < kMaxTurn_rad) {
      ++figures.right_2d;
    }
    if (!has_3d) continue;
    ++figures.num_3d;
    if ((match.vision_from_lidar * in_lidar - place).norm() < kMaxGap_m &&
        rotation_distance_rad(match.vision_from_lidar.rotation, truth.rotation) < kMaxTurn_rad) {
      ++figures.right_3d;
    }
  }
}

}  // namespace

Expected<DescribedScene> describe_scene(const PointCloud& vision,
                                        const PointCloud& lidar,
                                        const RegistrationInput& input,
                                        const RegistrationOptions& options,
                                        const RunContext& ctx) {
  HF_TRY(const PreparedClouds clouds, prepare_clouds(vision, lidar, input, options, ctx));
  const std::vector<float> vision_heights = heights_above(clouds.vision_ground, clouds.vision, ctx);
  const std::vector<float> lidar_heights = heights_above(clouds.lidar_ground, clouds.lidar, ctx);
  DescribedScene scene;
  scene.coarse = height_aligned_initial(clouds);
  scene.lidar_from_leveled.rotation = clouds.leveled_from_lidar.conjugate();
  HF_TRY(scene.pair,
         describe_pair({clouds.vision, vision_heights},
                       {clouds.lidar, lidar_heights},
                       scene.coarse,
                       options.paper,
                       ctx));
  return scene;
}

StepFigures paper_step_figures(const DescribedScene& scene,
                               const PaperOptions& options,
                               const RegistrationResult& result,
                               const Rigid3& true_vision_from_lidar) {
  const DescribedPair& pair = scene.pair;
  const Rigid3 true_from_coarse =
      true_vision_from_lidar * scene.lidar_from_leveled * scene.coarse.inverse();
  StepFigures figures{.num_cells = pair.vision.grid.patches.size()};
  Ranking ranking;
  for (const PatchedCloud& grid : pair.lidar) {
    for (std::size_t p = 0; p < grid.grid.patches.size(); ++p) {
      const Patch& patch = grid.grid.patches[p];
      if (std::cmp_less_equal(patch.indices.size(), options.min_patch_points)) continue;
      const auto true_cell = cell_at(pair.vision.grid, true_from_coarse * patch.centroid);
      if (!true_cell) continue;
      follow(grid,
             pair.vision,
             p,
             *true_cell,
             scene.coarse.translation.head<2>(),
             options,
             figures,
             ranking);
    }
  }
  ranking.finish(figures);
  count_poses(result, pair.vision.grid, true_vision_from_lidar, true_from_coarse, figures);
  return figures;
}

}  // namespace hybridfusion::benchmark
