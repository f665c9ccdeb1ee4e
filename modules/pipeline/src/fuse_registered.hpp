#pragma once

#include "companion_files.hpp"
#include "json_text.hpp"
#include "stage_runner.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

namespace hybridfusion {

/// Two clouds and the accepted pose between them.
struct RegisteredClouds {
  PointCloud vision;
  PointCloud lidar;
  const std::vector<Eigen::Vector3d>& sensor_positions;  ///< In the LiDAR map.
  const RegistrationResult& result;
};

/// Fuses the clouds and writes them; adds what it did to `json` and to the summary.
/// @param json  Holds "seconds" of the registration.
[[nodiscard]] Expected<StageResult> fuse_registered(const Project& project,
                                                    const Companions& companions,
                                                    RegisteredClouds clouds,
                                                    const RunContext& ctx,
                                                    Json& json);

}  // namespace hybridfusion
