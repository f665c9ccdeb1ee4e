#pragma once

#include "paper/described_pair.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

#include <cstddef>

namespace hybridfusion::benchmark {

/// What the steps of the published chain (HybridFusion III-C) keep of the truth on one pair. The
/// true cell of a LiDAR patch is the vision patch in which its centroid truly lies.
struct StepFigures {
  std::size_t num_patches = 0;  ///< LiDAR patches with more than eta points and a true cell.
  std::size_t num_cells = 0;    ///< Vision patches.
  /// Candidates of those patches by step, summed: ring sector, descriptor, neighbours.
  std::size_t in_ring = 0;
  std::size_t correlated = 0;
  std::size_t similar = 0;
  /// Patches whose true cell is still among them.
  std::size_t true_in_ring = 0;
  std::size_t true_correlated = 0;
  std::size_t true_similar = 0;
  /// Of the patches with descriptors of their own and of the true cell:
  std::size_t num_ranked = 0;
  double rank_median = 0.0;       ///< Of the true cell among all cells by correlation; 1 is best.
  double rank_ring_median = 0.0;  ///< Among those in the ring sector.
  double auc = 0.0;               ///< Chance that the true cell correlates better than another one.
  /// Patches with a 2D and with a 3D pose, and those of them within 1 m and 2 degrees (2D: in plan
  /// and heading) at their centroid.
  std::size_t num_2d = 0;
  std::size_t chosen_true = 0;  ///< Of these, with the true cell as the best candidate.
  std::size_t right_2d = 0;
  std::size_t num_3d = 0;
  std::size_t right_3d = 0;
};

/// Both clouds described as register_cross_source does it for the paper method. Variants whose
/// descriptors are the same can share one.
struct DescribedScene {
  DescribedPair pair = {};
  Rigid3 coarse = {};  ///< With its height aligned; takes the leveled frame to vision.
  Rigid3 lidar_from_leveled = {};
};
[[nodiscard]] Expected<DescribedScene> describe_scene(const PointCloud& vision,
                                                      const PointCloud& lidar,
                                                      const RegistrationInput& input,
                                                      const RegistrationOptions& options,
                                                      const RunContext& ctx);

/// @param options  Of the chain with the variant that is looked at.
/// @param result   Of register_cross_source with these options, for its patches.
[[nodiscard]] StepFigures paper_step_figures(const DescribedScene& scene,
                                             const PaperOptions& options,
                                             const RegistrationResult& result,
                                             const Rigid3& true_vision_from_lidar);

}  // namespace hybridfusion::benchmark
