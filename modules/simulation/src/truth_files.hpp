#pragma once

#include "flight.hpp"
#include "street_drive.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// truth/cameras.csv
[[nodiscard]] std::string cameras_csv(const std::vector<Shot>& shots);

/// truth/trajectory_*.tum, 100 Hz. @param body_from_sensor  IMU or LiDAR in the vehicle.
[[nodiscard]] std::string trajectory_tum(const DriveRecord& drive, const Rigid3& body_from_sensor);

/// truth/dataset.json
[[nodiscard]] std::string dataset_json(const SimulationOptions& options,
                                       std::uint64_t seed,
                                       const GeodeticOrigin& origin,
                                       const PinholeCamera& camera,
                                       std::size_t photos,
                                       const VehicleSetup& vehicle,
                                       const std::vector<DriveRecord>& drives);

/// truth/mesh.ply
[[nodiscard]] Expected<void> write_truth_mesh(const std::filesystem::path& path,
                                              const Scene& scene);

/// One point of truth/samples.ply.
struct TruthSample {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
  std::uint8_t label = 0;
  std::uint8_t drone = 0;    ///< Photos that see it, up to 4.
  std::uint8_t vehicle = 0;  ///< 1: in the LiDAR's view from somewhere along a drive.
};

/// Random points of the built-up area's surface with what sees them. @returns kCancelled.
[[nodiscard]] Expected<std::vector<TruthSample>> sample_truth(
    const Scene& scene,
    const RayTracer& tracer,
    const SimulationOptions& options,
    const PinholeCamera& camera,
    const std::vector<Shot>& shots,
    const VehicleSetup& vehicle,
    const std::vector<DriveRecord>& drives,
    const RunContext& ctx);
[[nodiscard]] Expected<void> write_truth_samples(const std::filesystem::path& path,
                                                 const std::vector<TruthSample>& samples);

}  // namespace hybridfusion
