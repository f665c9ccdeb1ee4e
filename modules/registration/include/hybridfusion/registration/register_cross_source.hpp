#pragma once

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/drift.hpp>
#include <hybridfusion/registration/patch_match.hpp>
#include <hybridfusion/registration/registration_options.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// What is known before the clouds are compared. Everything is optional.
struct RegistrationInput {
  /// Coarse pose, e.g. from GNSS. Its height is corrected from the ground, its horizontal part and
  /// heading are searched within `max_offset_m` and `max_yaw_rad`. Absent: identity heading, any
  /// offset.
  std::optional<Rigid3> vision_from_lidar_initial = {};
  /// Of the coarse pose, in the tangent order of Rigid3 (translation [m], rotation [rad]). It
  /// decides between places that look alike.
  std::optional<PoseCovariance> initial_covariance = {};
  /// Where the LiDAR was, in the LiDAR frame [m].
  std::vector<Eigen::Vector3d> sensor_positions = {};
};

enum class RegistrationStatus : std::uint8_t { kOk, kRefused };
[[nodiscard]] std::string_view to_string(RegistrationStatus status);

/// Evidence by name, in the order it was found.
struct RegistrationScore {
  std::string name = {};
  double value = 0.0;
};

/// A place the outline search considered.
struct PoseCandidate {
  Rigid3 vision_from_lidar = {};
  double score = 0.0;  ///< Facade columns on rims less ground columns inside buildings.
};

/// The best score of the outline search at one heading.
struct YawScore {
  double yaw_rad = 0.0;  ///< Of the LiDAR frame in the vision frame, -pi..pi.
  double score = 0.0;    ///< 0 when no shift brings a facade onto a rim.
};

struct RegistrationResult {
  RegistrationStatus status = RegistrationStatus::kRefused;
  std::string reason = {};  ///< Why it was refused, or what lowers the confidence.
  std::string method = {};
  /// Best rigid pose: LiDAR coordinates to vision coordinates. When a scale is supported it is the
  /// rigid motion nearest to the similarity at the centroid of the LiDAR cloud. Meaningful for a
  /// refused result only as "the best that was found".
  Rigid3 vision_from_lidar = {};
  PoseCovariance covariance = PoseCovariance::Zero();  ///< Tangent order and side of Rigid3.
  /// What the evidence leaves, in [0, 1]; below min_confidence, or 0, when refused.
  double confidence = 0.0;
  /// Metres of LiDAR per metre of vision: multiply vision coordinates by it to get their true size.
  /// 1 when the scale is not supported.
  double vision_scale = 1.0;
  double vision_scale_sigma = 0.0;  ///< 0 when no scale was estimated.
  bool vision_scale_supported = false;
  /// Vision coordinates to LiDAR coordinates with scale = vision_scale; the inverse of
  /// vision_from_lidar when no scale is supported.
  Sim3 lidar_from_vision_similarity = {};
  std::vector<RegistrationScore> scores = {};
  std::vector<PoseCandidate> candidates = {};  ///< Descending score.
  std::vector<YawScore> yaw_scores = {};       ///< Of the outline search, in its order.
  std::vector<PatchMatch> patches = {};  ///< Of the published chain, or of the vote on the pose.
  /// Bend of the LiDAR cloud along the drive, in its own frame; without_drift takes it out.
  DriftCorrection drift = {};

  /// The value of a score, if present.
  [[nodiscard]] std::optional<double> score(std::string_view name) const;
};

/// The pose for a vision cloud whose coordinates were multiplied by `vision_scale` (about its
/// origin): what a caller needs who rescales the vision cloud and its cameras.
[[nodiscard]] Rigid3 rescaled_vision_from_lidar(const RegistrationResult& result);

/// Registers a street LiDAR cloud to a cloud from aerial photos (HybridFusion III-C). Both clouds
/// are level to a few degrees (z up). A pose that the evidence does not support is returned with
/// status kRefused and a reason, never as an answer.
/// @returns kInvalidOptions for options out of range; kInsufficient when a cloud is empty, has
/// inconsistent channels or fewer than 1000 finite points; kCancelled when stopped.
[[nodiscard]] Expected<RegistrationResult> register_cross_source(
    const PointCloud& vision,
    const PointCloud& lidar,
    const RegistrationInput& input = {},
    const RegistrationOptions& options = {},
    const RunContext& ctx = {});

}  // namespace hybridfusion
