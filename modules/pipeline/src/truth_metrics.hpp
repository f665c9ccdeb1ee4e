#pragma once

#include "json_text.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/pipeline/evaluation_options.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// Errors against truth of whatever the workspace and the truth folder both hold.
struct TruthMetrics {
  Json json = Json::object();
  std::vector<std::string> summary = {};
  std::optional<Rigid3> true_vision_from_lidar = {};  ///< When cameras and drive have truth.
};

/// @returns kNotFound when the folder holds no truth at all; kParse; kCancelled.
[[nodiscard]] Expected<TruthMetrics> truth_metrics(const Workspace& workspace,
                                                   const std::filesystem::path& truth_folder,
                                                   const EvaluationOptions& options,
                                                   const RunContext& ctx);

/// {"at_centroid_m", "horizontal_m", "vertical_m", "rotation_deg", "success", "precise"}.
[[nodiscard]] Json registration_error_json(const Rigid3& truth,
                                           const Rigid3& estimate,
                                           const Eigen::Vector3d& centroid_in_lidar);

}  // namespace hybridfusion
