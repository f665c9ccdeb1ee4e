#pragma once

#include "json_text.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// Two clouds and what is known of their relation.
struct RegisteredPair {
  const PointCloud& vision;
  const PointCloud& lidar;
  Rigid3 vision_from_lidar = {};
  std::optional<Rigid3> truth = {};    ///< True vision_from_lidar.
  std::optional<Rigid3> initial = {};  ///< Coarse pose the baselines start from.
  std::string method = {};
  double seconds = 0.0;  ///< Of our registration; 0: unknown.
};

struct PairMetrics {
  Json json = Json::object();
  std::vector<std::string> summary = {};
};

/// Supplement degree, boundary accuracy (with its floor at the true pose) and baselines
/// (HybridFusion IV-A and Table I). What cannot be measured on these clouds is left out with a
/// warning. @returns kCancelled.
[[nodiscard]] Expected<PairMetrics> pair_metrics(const RegisteredPair& pair,
                                                 const PipelineOptions& options,
                                                 const RunContext& ctx);

}  // namespace hybridfusion
