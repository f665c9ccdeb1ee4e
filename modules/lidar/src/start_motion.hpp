#pragma once

#include "scan_filter.hpp"

#include <optional>
#include <span>

namespace hybridfusion {

/// Why a start stays open.
enum class StartProblem : std::uint8_t {
  kFewScans,   ///< Fewer than two scans with points.
  kUnmatched,  ///< The scans do not fit each other under any motion tried.
  kAmbiguous,  ///< Different motions fit equally well.
};

/// How the vehicle moved when the first scan began, in the IMU frame of that moment.
struct StartMotion {
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rate_radps = Eigen::Vector3d::Zero();
  /// Mean distance of points to the surfaces that earlier scans left, bounded for those that found
  /// none [m].
  double misfit_m = 0.0;
  /// Of the points, that lie in the last scan where they lay in the first one.
  double share_in_place = 0.0;
  std::optional<StartProblem> problem = {};  ///< The motion is a guess, one of several.
};

/// Motion over the first scans from nothing but their points: hypotheses of velocity up to
/// `kMaxStartSpeed_mps` in all level directions are followed through the scans with constant
/// velocity and turn, and the one after which they fit each other best is kept. No rest, no gravity
/// and no IMU is assumed.
/// @param up_in_imu  About vertical; a few ten degrees do not matter.
/// @param turn_rate  A guess, as from a gyro [rad/s].
[[nodiscard]] StartMotion find_start_motion(const OdometryOptions& options,
                                            const LidarRig& rig,
                                            std::span<const PreparedScan> scans,
                                            const Eigen::Vector3d& up_in_imu,
                                            const Eigen::Vector3d& turn_rate_radps);

/// State for a filter of constant velocity that starts in `motion`; the map frame is the IMU's.
[[nodiscard]] StateEstimate coasting_state(const LidarRig& rig,
                                           const StartMotion& motion,
                                           double velocity_sigma_mps,
                                           double turn_rate_sigma_radps);

}  // namespace hybridfusion
