#pragma once

#include "fine_alignment.hpp"
#include "prepared_clouds.hpp"

namespace hybridfusion {

/// A place of the outline search, leveled and refined.
struct OutlinePlace {
  PlanarPose planar = {};
  Rigid3 vision_from_leveled = {};
  double score = 0.0;
  PoseEvidence evidence = {};
  std::size_t ground_inliers = 0;  ///< Of the ground alignment; 0 when it failed.
};

struct OutlinePlaces {
  std::vector<OutlinePlace> places = {};  ///< Descending score.
  std::vector<YawScore> yaw_scores = {};  ///< Of the search, before any refinement.
  bool used_prior = false;                ///< The coarse pose changed the order of the places.
  bool is_vision_whole = true;  ///< The prepared vision cloud reaches about all of the places.
};

/// In descending score; of those that climbed to the same place the best.
[[nodiscard]] std::vector<OutlinePlace> distinct_places(std::vector<OutlinePlace> places,
                                                        const OutlineOptions& options);

/// Outline search, refinement of each peak, ground alignment and a second refinement with roll and
/// pitch known.
/// @param halvings  The exhaustive search runs on maps so many times coarser by two.
/// @returns kDegenerate when there is no facade or no peak (a reason to refuse), kCancelled.
[[nodiscard]] Expected<OutlinePlaces> find_places(const PreparedClouds& clouds,
                                                  const RegistrationInput& input,
                                                  const RegistrationOptions& options,
                                                  const RunContext& ctx,
                                                  int halvings = 0);

/// Where places score alike, those that the coarse pose excludes (beyond 5 sigma) step back.
void prefer_by_prior(const PreparedClouds& clouds,
                     const RegistrationInput& input,
                     double max_peak_ratio,
                     OutlinePlaces& found);

/// Largest score 3 m beside the best place over its own: 1 on a ridge, where one direction is free.
struct RidgeTest {
  double ratio = 0.0;
  double bearing_rad = 0.0;  ///< Of that direction, from x towards y.
};
[[nodiscard]] RidgeTest test_ridge(const PreparedClouds& clouds,
                                   const OutlinePlace& place,
                                   const OutlineOptions& options);

/// The drift of L about a pose.
struct DriftFinding {
  DriftCorrection correction = {};  ///< In the LiDAR frame.
  Rigid3 rigid = {};                ///< In the leveled frame: the pose becomes pose * rigid.
  bool scale_stands = true;         ///< False: what seemed a scale is a bend of the drive.
};
/// Whether a scale found with L taken as rigid is the photos', and not a bend of the drive around a
/// block, which resembles one: held-out pieces of the drive fit with it, need no bend beside it,
/// and are not explained better by a bend alone.
/// @param scaled, unscaled  Drift about the pose with and without the scale.
[[nodiscard]] bool scale_stands(const DriftCorrection& scaled,
                                const DriftCorrection& unscaled,
                                const DriftOptions& options);
/// Estimates the drift about `fine` along the times of `lidar`, or along the sensor positions where
/// it has none; a supported one is taken out of the samples.
/// @returns kInsufficient when the way of the LiDAR or the overlap says too little, kCancelled.
[[nodiscard]] Expected<DriftFinding> find_drift(FineInputs& inputs,
                                                const PreparedClouds& clouds,
                                                const PointCloud& lidar,
                                                const RegistrationInput& input,
                                                const FineResult& fine,
                                                const RegistrationOptions& options,
                                                const RunContext& ctx);

/// Fine alignment at the best of the places, votes and verdict on it against the others.
/// @param clouds  Its vision half must reach as far about the best place as L does.
[[nodiscard]] Expected<RegistrationResult> register_at_places(OutlinePlaces found,
                                                              const PreparedClouds& clouds,
                                                              const PointCloud& lidar,
                                                              const RegistrationInput& input,
                                                              const RegistrationOptions& options,
                                                              const RunContext& ctx);

/// find_places, prefer_by_prior, register_at_places.
[[nodiscard]] Expected<RegistrationResult> register_hybrid(const PreparedClouds& clouds,
                                                           const PointCloud& lidar,
                                                           const RegistrationInput& input,
                                                           const RegistrationOptions& options,
                                                           const RunContext& ctx);

}  // namespace hybridfusion
