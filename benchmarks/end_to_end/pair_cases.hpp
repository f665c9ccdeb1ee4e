#pragma once

#include "pair_scene.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion::benchmark {

/// Kinds of pairs that share a goal.
enum class PairKind : std::uint8_t {
  kClean,
  kCrop,       ///< LiDAR within 20 or 30 m.
  kShortCrop,  ///< Within 12 m.
  kThick,      ///< A noisy, thick vision cloud.
  kScaleDrift,
  kBent,
  kRefuse,
};

/// A group of pairs.
struct CaseGroup {
  std::string_view name;
  std::string_view text;
  PairKind kind = PairKind::kClean;
  double offset_m = 30.0;  ///< Horizontal error of the start.
  double yaw_deg = 180.0;  ///< Heading error of the start; 180: any heading.
  double crop_m = 0.0;     ///< LiDAR within this radius of one place of the drive; 0: all of it.
  bool nadir_only = false;
  double scale = 1.0;  ///< Of the vision cloud.
  double drift = 0.0;  ///< Of the LiDAR map, metres per metre driven.
  double noise = 1.0;
  int keep_every = 1;     ///< Thinning of the vision cloud.
  bool everyday = false;  ///< Vision bent and without dark ground, moving cars in the LiDAR.
  double wander_m = 0.0;  ///< Smooth bend of the LiDAR cloud along the drive.

  [[nodiscard]] bool must_refuse() const { return kind == PairKind::kRefuse; }
};

/// All groups, in the order of the table.
[[nodiscard]] const std::vector<CaseGroup>& case_groups();

/// Two clouds and what is true about them.
struct RegistrationPair {
  PointCloud vision = {};
  PointCloud lidar = {};
  RegistrationInput input = {};
  SceneTruth truth = {};  ///< Meaningless for pairs that must be refused.
  /// Some LiDAR points with the places in vision where they belong [m].
  std::vector<std::size_t> checked = {};
  std::vector<Eigen::Vector3d> places_in_vision = {};
};

/// A start that is off by the group's amounts at the middle of the LiDAR cloud, 1 to 3 m off in
/// height, and level.
[[nodiscard]] Rigid3 wrong_start(const Rigid3& world_from_lidar,
                                 const Eigen::Vector3d& centroid_in_lidar,
                                 const CaseGroup& group,
                                 Random& random);

/// The pair of a group on the scene of a seed; the LiDAR frame is turned, shifted and tilted by
/// random amounts, and so is the start.
[[nodiscard]] Expected<RegistrationPair> make_pair(const CaseGroup& group,
                                                   std::uint64_t seed,
                                                   SceneCache& scenes,
                                                   const RunContext& ctx);

}  // namespace hybridfusion::benchmark
