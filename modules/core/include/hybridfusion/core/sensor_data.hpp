#pragma once

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/time.hpp>

#include <cstdint>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

struct ImuSample {
  Timestamp time{};
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_mps2 = Eigen::Vector3d::Zero();  ///< +g along up at rest.
};

struct GnssFix {
  Timestamp time{};
  GeodeticPosition position = {};
  Eigen::Vector3d sigma_enu_m = Eigen::Vector3d::Zero();  ///< 0 when the message does not say.
};

struct LidarPoint {
  Eigen::Vector3f point_in_lidar = Eigen::Vector3f::Zero();  ///< [m]
  float intensity = 0.0F;
  std::int32_t offset_ns = 0;  ///< Since LidarScan::stamp; may be negative.
  std::uint16_t ring = 0;
};

/// Points as the driver sent them: unsorted, NaN and zero returns included.
struct LidarScan {
  Timestamp stamp{};
  std::vector<LidarPoint> points = {};
};

using SensorMessage = std::variant<ImuSample, LidarScan, GnssFix>;

}  // namespace hybridfusion
