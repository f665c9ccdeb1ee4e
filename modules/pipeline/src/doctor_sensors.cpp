#include "doctor_checks.hpp"

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxVehicle_m = 5.0;

}  // namespace

SensorConfig check_sensors(const std::optional<std::filesystem::path>& path, Diagnosis& diagnosis) {
  if (!path) {
    diagnosis.findings.add("sensors.no_extrinsic", "there is no sensors.yaml");
    return {};
  }
  auto config = read_sensors_yaml(*path);
  if (!config) {
    const std::string& message = config.error().message;
    const bool extrinsic = config.error().code == ErrorCode::kInvalidOptions &&
                           message.find(": imu_from_lidar: ") != std::string::npos;
    diagnosis.findings.add(extrinsic ? "sensors.extrinsic" : "sensors.unreadable", message);
    return {};
  }
  if (!config->imu_from_lidar) {
    diagnosis.findings.add("sensors.no_extrinsic",
                           fmt::format("{} has no imu_from_lidar", path->string()));
  }
  const double lidar_m = config->imu_from_lidar ? config->imu_from_lidar->translation.norm() : 0.0;
  const double antenna_m = config->gnss_antenna_in_imu ? config->gnss_antenna_in_imu->norm() : 0.0;
  if (lidar_m > kMaxVehicle_m || antenna_m > kMaxVehicle_m) {
    diagnosis.findings.add(
        "sensors.far",
        fmt::format("{}: LiDAR {:.1f} and antenna {:.1f} from the IMU, {:g} m is the limit",
                    path->string(),
                    lidar_m,
                    antenna_m,
                    kMaxVehicle_m));
  }
  return *std::move(config);
}

}  // namespace hybridfusion
