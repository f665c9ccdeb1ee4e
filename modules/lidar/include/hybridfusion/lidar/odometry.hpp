#pragma once

#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/core/trajectory.hpp>
#include <hybridfusion/lidar/lidar_rig.hpp>
#include <hybridfusion/lidar/odometry_options.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// What was unusual about a scan; a bit each, so that they add up.
enum class ScanFlag : std::uint32_t {
  kImuGap = 1U << 0U,        ///< No IMU samples for part of the motion: bridged.
  kLidarGap = 1U << 1U,      ///< The scan before is missing.
  kFewPoints = 1U << 2U,     ///< Empty, or too few valid points to match.
  kUnmatched = 1U << 3U,     ///< Too few points found their plane: the prediction was kept.
  kDegenerate = 1U << 4U,    ///< A direction was not seen and is held to the prediction.
  kDiverged = 1U << 5U,      ///< The update was refused as implausible.
  kSaturated = 1U << 6U,     ///< The IMU stood at its limit.
  kClockStep = 1U << 7U,     ///< A sensor clock jumped; the stamps were shifted to go on.
  kNoPointTimes = 1U << 8U,  ///< All points carry one time: motion within the scan is not removed.
  kBadPoints = 1U << 9U,     ///< More than half of the returns were NaN, infinite or out of range.
  /// Loop closure corrected the motion here: odometry had drifted.
  kLoopCorrected = 1U << 16U,
};

/// "imu_gap|degenerate"; "" for 0.
[[nodiscard]] std::string flags_text(std::uint32_t flags);

/// How well one scan was located.
struct ScanQuality {
  Timestamp time{};              ///< Scan end.
  int num_points = 0;            ///< Valid points.
  int num_thinned = 0;           ///< Points after thinning: what is matched.
  int num_matched = 0;           ///< Thinned points that found a plane.
  double mean_residual_m = 0.0;  ///< Mean absolute point-to-plane distance.
  double min_information = 0.0;  ///< Smallest eigenvalue for the position [1/m^2].
  /// Squared correction of the predicted turn and place over its variance: about 1 when the
  /// prediction is as good as it says.
  double turn_innovation = 0.0;
  double shift_innovation = 0.0;
  std::uint32_t flags = 0;  ///< ScanFlag bits.
};

/// Motion that the IMU alone measured between two times, without gravity and initial velocity, in
/// the IMU frame at the first (Forster et al., "On-manifold preintegration", T-RO 2017).
struct ImuIncrement {
  double duration_s = 0.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d velocity_by_accel_bias = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d position_by_accel_bias = Eigen::Matrix3d::Zero();
  bool bridged = false;  ///< Part of it is not measured.
};

/// A scan in the map. The time of a pose is the time of the scan's last point.
struct ScanEstimate {
  Timestamp start{};  ///< Time that `deskewed` offsets count from.
  Timestamp time{};   ///< Scan end.
  Rigid3 map_from_imu = {};
  Eigen::Vector3d velocity_in_map = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d gyro_bias_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d accel_bias_mps2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity_in_map = Eigen::Vector3d::Zero();  ///< [m/s^2]
  double gravity_sigma_rad = 0.0;  ///< Of its direction; 0: no IMU measured it.
  ImuIncrement since_last = {};    ///< From the end of the scan before; accelerometer bias left in.
  Rigid3 imu_from_lidar = {};
  /// Of [translation in map; rotation in the IMU frame].
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  ScanQuality quality = {};
  std::vector<LidarPoint> deskewed = {};  ///< Points as seen from the IMU frame at scan end.
};

/// Counts over a recording.
struct OdometrySummary {
  std::size_t num_scans = 0;          ///< Located.
  std::size_t num_scans_dropped = 0;  ///< Duplicates and stamps that went back.
  std::size_t num_imu_samples = 0;
  std::size_t num_imu_dropped = 0;  ///< Duplicates, stamps that went back, not finite.
  std::size_t num_imu_gaps = 0;
  std::size_t num_lidar_gaps = 0;
  std::size_t num_points_dropped = 0;  ///< NaN, infinite, zero or out of range.
  std::size_t num_unmatched_scans = 0;
  std::size_t num_degenerate_scans = 0;
  std::size_t num_scans_before_start = 0;  ///< Left out: no motion explained them.
  bool started_at_standstill = false;
  bool used_imu = false;  ///< By the end; false when there is none or it is not believed.
  /// What speaks against the IMU; the motion then comes from the LiDAR alone.
  std::vector<std::string> imu_doubts = {};
  bool imu_ended = false;          ///< Scans after the last IMU sample were located.
  bool imu_in_g = false;           ///< Specific force came in units of g.
  std::size_t num_map_points = 0;  ///< In the local map at the end.
  std::vector<std::string> warnings = {};
};

/// Tightly coupled LiDAR-inertial odometry: an iterated error-state Kalman filter that matches raw
/// points to planes of its own map (Xu et al., "FAST-LIO2", T-RO 2022), written from the equations.
/// The map frame has its origin at the first IMU position, z against gravity and x along the first
/// heading of the IMU. Scans wait until the IMU covers their end; the first ones also until the
/// start is known.
class LidarOdometry {
 public:
  /// @returns kInvalidOptions.
  [[nodiscard]] static Expected<LidarOdometry> create(const OdometryOptions& options,
                                                      const LidarRig& rig);
  LidarOdometry(LidarOdometry&&) noexcept;
  LidarOdometry& operator=(LidarOdometry&&) noexcept;
  ~LidarOdometry();

  void add_imu(const ImuSample& sample);
  void add_scan(LidarScan scan);
  /// Scans located since the last call, in ascending time.
  [[nodiscard]] std::vector<ScanEstimate> take();
  /// No more data will come: locates the scans that still wait. @returns kInsufficient when there
  /// was no IMU sample or no scan at all.
  [[nodiscard]] Expected<void> finish();
  [[nodiscard]] const OdometrySummary& summary() const;

 private:
  struct Impl;
  explicit LidarOdometry(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hybridfusion
