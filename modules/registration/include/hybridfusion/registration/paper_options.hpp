#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/geometry/boundary.hpp>

#include <numbers>
#include <string>

namespace hybridfusion {

/// Changes to the published chain that stay inside its structure; they act with
/// PaperOptions::variant "improved" only. On are those that help alone
/// (docs/reference/registration-benchmark.md).
struct PaperImprovements {
  bool half_step_patches = true;
  bool describe_spliced = false;
  double describe_above_m = 0.0;
  int best_candidates = 0;
  double min_overlap = 0.5;
};

template <>
struct OptionFields<PaperImprovements> {
  using T = PaperImprovements;
  static constexpr auto fields = std::tuple{
      Field{&T::half_step_patches,
            {.key = "half_step_patches",
             .doc = "LiDAR patches overlap: four grids, half a step apart.",
             .source = "ours"}},
      Field{&T::describe_spliced,
            {.key = "describe_spliced",
             .doc = "Descriptors of a patch with its 8 neighbours.",
             .source = "ours"}},
      Field{&T::describe_above_m,
            {.key = "describe_above_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "Descriptors of what stands higher above ground than this; 0: of everything.",
             .source = "ours"}},
      Field{&T::best_candidates,
            {.key = "best_candidates",
             .unit = "patches",
             .min = 0.0,
             .max = 1000.0,
             .doc = "Keep this many candidates by rank of the correlation, not those above "
                    "min_correlation and min_neighbour_score; 0: as published.",
             .source = "ours"}},
      Field{&T::min_overlap,
            {.key = "min_overlap",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Share of a patch's points above ground (higher than describe_above_m) that "
                    "must lie within 0.5 m of the candidate for its pose to count.",
             .source = "ours"}},
  };
};

/// The published chain (HybridFusion III-C and Algorithm 1). Where the paper states no value the
/// default is ours.
struct PaperOptions {
  std::string variant = "published";
  PaperImprovements improved = {};
  double isolation_cell_m = 0.6;
  int min_supporting_points = 8;  ///< In the 27 cells around a point; fewer: it is left out.
  double cut_share = 0.003;       ///< Of the points, off each side of a patch grid.
  int grid_divisions = 10;        ///< Patch step = scene size / this.
  int min_patch_points = 500;     ///< eta.
  double ring_ratio = 0.5;        ///< lambda.
  double max_bearing_rad = std::numbers::pi / 6.0;  ///< phi.
  int esf_samples = 20000;
  double min_correlation = 0.6;
  int min_neighbour_points = 100;
  double min_neighbour_score = 0.6;
  BoundaryOptions boundary = {};
  int min_boundary_points = 30;
  double ndt2_cell_m = 3.0;
  int ndt2_iterations = 50;
  double ndt3_max_shift_m = 1.5;
  double max_score_3d_m = 0.6;
  double cluster_radius_m = 1.0;                       ///< epsilon.
  double cluster_angle_rad = std::numbers::pi / 60.0;  ///< omega.
  int min_cluster_members = 3;
  double min_cluster_share = 0.15;
  double min_cluster_margin = 2.0;
};

template <>
struct OptionFields<PaperOptions> {
  using T = PaperOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::variant,
            {.key = "variant",
             .choices = "published|improved",
             .doc = "improved: with the changes of registration.paper.improved.",
             .source = "HybridFusion III-C; improved: ours"}},
      Field{&T::improved,
            {.key = "improved",
             .doc = "Changes to the chain, for variant improved.",
             .source = "ours"}},
      Field{&T::isolation_cell_m,
            {.key = "isolation_cell_m",
             .unit = "m",
             .min = 0.05,
             .max = 10.0,
             .doc = "Cell in which isolated points are looked for.",
             .source = "ours"}},
      Field{&T::min_supporting_points,
            {.key = "min_supporting_points",
             .unit = "points",
             .min = 0.0,
             .max = 1e6,
             .doc = "Points with fewer others in the 27 cells around them are left out; 0 keeps "
                    "all.",
             .source = "ours"}},
      Field{&T::cut_share,
            {.key = "cut_share",
             .unit = "1",
             .min = 0.0,
             .max = 0.1,
             .doc = "Share of the points cut off on each side before a patch grid is laid.",
             .source = "ours"}},
      Field{&T::grid_divisions,
            {.key = "grid_divisions",
             .unit = "1",
             .min = 2.0,
             .max = 100.0,
             .doc = "The patch step is the size of the vision scene divided by this.",
             .source = "HybridFusion III-C.1, one tenth"}},
      Field{&T::min_patch_points,
            {.key = "min_patch_points",
             .unit = "points",
             .min = 100.0,
             .max = 1e9,
             .doc = "LiDAR patches with fewer points are not registered (eta).",
             .source = "HybridFusion III-C.2a, eta; value ours"}},
      Field{&T::ring_ratio,
            {.key = "ring_ratio",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Half width of the candidate ring as a share of the distance from the origin "
                    "(lambda).",
             .source = "HybridFusion III-C.2a, R and r; value ours"}},
      Field{&T::max_bearing_rad,
            {.key = "max_bearing_rad",
             .unit = "rad",
             .min = 0.0,
             .max = std::numbers::pi,
             .doc = "Largest bearing difference of a candidate, seen from the origin (phi).",
             .source = "HybridFusion III-C.2a, phi; value ours"}},
      Field{&T::esf_samples,
            {.key = "esf_samples",
             .unit = "triples",
             .min = 100.0,
             .max = 1e7,
             .doc = "Point triples of a shape descriptor.",
             .source = "Wohlkinger and Vincze 2011; value of PCL"}},
      Field{&T::min_correlation,
            {.key = "min_correlation",
             .unit = "1",
             .min = -1.0,
             .max = 1.0,
             .doc = "Candidates whose descriptor correlates no better are dropped.",
             .source = "HybridFusion III-C.2b, 0.6"}},
      Field{&T::min_neighbour_points,
            {.key = "min_neighbour_points",
             .unit = "points",
             .min = 100.0,
             .max = 1e9,
             .doc = "Neighbour patches with fewer points are not compared.",
             .source = "HybridFusion III-C.3; value ours"}},
      Field{&T::min_neighbour_score,
            {.key = "min_neighbour_score",
             .unit = "1",
             .min = -1.0,
             .max = 1.0,
             .doc = "Candidates whose neighbourhood is less similar on average are dropped.",
             .source = "HybridFusion III-C.3; value ours"}},
      Field{&T::boundary,
            {.key = "boundary",
             .doc = "Boundary points of what stands higher than h.",
             .source = "HybridFusion III-C.4"}},
      Field{&T::min_boundary_points,
            {.key = "min_boundary_points",
             .unit = "points",
             .min = 3.0,
             .max = 1e6,
             .doc = "Patches with fewer boundary points (neighbours included) are not registered.",
             .source = "ours"}},
      Field{&T::ndt2_cell_m,
            {.key = "ndt2_cell_m",
             .unit = "m",
             .min = 0.2,
             .max = 50.0,
             .doc = "Cell of the 2D NDT; a second pass uses half of it.",
             .source = "HybridFusion III-C.4; value ours"}},
      Field{&T::ndt2_iterations,
            {.key = "ndt2_iterations",
             .unit = "1",
             .min = 1.0,
             .max = 1000.0,
             .doc = "Newton steps of each pass of the 2D NDT.",
             .source = "ours"}},
      Field{&T::ndt3_max_shift_m,
            {.key = "ndt3_max_shift_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "The 3D NDT of a patch adjusts height; one that moves it further horizontally "
                    "is rejected.",
             .source = "ours, for HybridFusion III-C.4 'adjusts pose in the z-axis direction'"}},
      Field{&T::max_score_3d_m,
            {.key = "max_score_3d_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "Largest median distance of a patch to its candidate after the 3D NDT.",
             .source = "Algorithm 1, NDT_3D_convergence; value ours"}},
      Field{&T::cluster_radius_m,
            {.key = "cluster_radius_m",
             .unit = "m",
             .min = 0.001,
             .max = 1000.0,
             .doc = "Largest translation gap inside a pose cluster (epsilon).",
             .source = "HybridFusion III-C.5, epsilon; value ours"}},
      Field{&T::cluster_angle_rad,
            {.key = "cluster_angle_rad",
             .unit = "rad",
             .min = 0.0001,
             .max = std::numbers::pi,
             .doc = "Largest rotation gap inside a pose cluster (omega).",
             .source = "HybridFusion III-C.5, omega; value ours"}},
      Field{&T::min_cluster_members,
            {.key = "min_cluster_members",
             .unit = "patches",
             .min = 1.0,
             .max = 1e6,
             .doc = "With fewer patches in the largest cluster the pose is refused.",
             .source = "ours"}},
      Field{&T::min_cluster_share,
            {.key = "min_cluster_share",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Share of the patch poses the largest cluster must hold, or the pose is "
                    "refused.",
             .source = "ours"}},
      Field{&T::min_cluster_margin,
            {.key = "min_cluster_margin",
             .unit = "1",
             .min = 1.0,
             .max = 1000.0,
             .doc = "The largest cluster must be this many times the next one elsewhere, or the "
                    "pose is refused.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
