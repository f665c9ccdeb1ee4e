#pragma once

#include "ray_tracer.hpp"
#include "vehicle_motion.hpp"
#include "world.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <filesystem>
#include <string>

namespace hybridfusion {

/// How the sensors sit on the vehicle. The body origin is the IMU's, its axes are the vehicle's.
struct VehicleSetup {
  Eigen::Quaterniond body_from_imu = Eigen::Quaterniond::Identity();
  Rigid3 imu_from_lidar = {};
  Eigen::Vector3d antenna_in_imu = Eigen::Vector3d::Zero();  ///< [m]

  [[nodiscard]] Rigid3 body_from_lidar() const {
    return Rigid3{.rotation = body_from_imu} * imu_from_lidar;
  }
  /// Motion of the IMU; @param body  Motion of the vehicle.
  [[nodiscard]] MotionState imu_motion(MotionState body) const;
};

[[nodiscard]] VehicleSetup make_vehicle(const LidarModelOptions& options, std::uint64_t seed);

/// What a recording holds.
struct DriveRecord {
  VehicleMotion motion;
  double start_s = 0.0;       ///< UNIX epoch of time 0 of the motion.
  double first_scan_s = 0.0;  ///< Since start_s.
  double path_m = 0.0;
  std::size_t scans = 0;
  std::size_t points = 0;
  std::size_t imu_samples = 0;
  std::size_t gnss_fixes = 0;
  std::size_t images = 0;
};

/// Drives around the blocks of drive number `index` and records the bag.
[[nodiscard]] Expected<DriveRecord> record_drive(const World& world,
                                                 const RayTracer& tracer,
                                                 const VehicleSetup& vehicle,
                                                 const SimulationOptions& options,
                                                 const GeodeticOrigin& origin,
                                                 int index,
                                                 const std::filesystem::path& bag,
                                                 const RunContext& ctx);

/// sensors.yaml beside the bag.
[[nodiscard]] std::string sensors_yaml(const VehicleSetup& vehicle,
                                       const SimulationOptions& options);

[[nodiscard]] std::string lidar_topic(const LidarModelOptions& options);

}  // namespace hybridfusion
