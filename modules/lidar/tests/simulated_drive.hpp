#pragma once

#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/core/trajectory.hpp>
#include <hybridfusion/lidar/lidar_rig.hpp>

#include <functional>
#include <vector>

namespace hybridfusion::testing {

/// A drive through a street of boxes on level ground, with exact truth: the IMU is differentiated
/// from the same functions that place the LiDAR. Still for 2 s, then up to 6 m/s round an ellipse.
struct SimulatedDrive {
  LidarRig rig = {};
  std::vector<ImuSample> imu = {};    ///< 200 Hz, noise and bias of a good MEMS unit.
  std::vector<LidarScan> scans = {};  ///< 16 rings, 10 Hz, 2 cm range noise.
};

struct Box {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();
};

/// A box that drives straight on.
struct MovingBox {
  Box at_zero = {};  ///< At the start of the drive.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
};

/// Boxes on level ground and the way of the IMU among them.
struct DriveWorld {
  std::vector<Box> boxes = {};
  std::vector<MovingBox> moving = {};
  std::function<Rigid3(double)> pose = {};  ///< world_from_imu by seconds since the start.
  double max_range_m = 80.0;
  double accel_bias_walk = 0.0;  ///< [m/s^3/sqrt(Hz)]
};

inline constexpr double kDriveStart_s = 1000.0;
inline constexpr double kStandstill_s = 2.0;

[[nodiscard]] Rigid3 true_world_from_imu(Timestamp time);
[[nodiscard]] SimulatedDrive simulate_drive(double duration_s, std::uint64_t seed);
[[nodiscard]] SimulatedDrive simulate_drive(const DriveWorld& world,
                                            double duration_s,
                                            std::uint64_t seed);
/// Made once: 12 s, seed 1.
[[nodiscard]] const SimulatedDrive& standard_drive();

/// Both streams in the order in which a driver would publish them.
[[nodiscard]] std::vector<SensorMessage> messages_of(const SimulatedDrive& drive);
/// Root mean square position error [m] after the best rigid alignment.
[[nodiscard]] double trajectory_error_m(const Trajectory& trajectory);
[[nodiscard]] double trajectory_error_m(const Trajectory& trajectory,
                                        const std::function<Rigid3(Timestamp)>& world_from_imu);
/// Distance from a point in the world to the nearest surface [m].
[[nodiscard]] double distance_to_world_m(const Eigen::Vector3d& point_in_world);
/// The same among other boxes on the ground.
[[nodiscard]] double distance_to_boxes_m(const std::vector<Box>& boxes,
                                         const Eigen::Vector3d& point_in_world);

}  // namespace hybridfusion::testing
