#include "truth_alignments.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace hybridfusion {

void add_georeference_errors(const TruthAlignments& known,
                             const SceneTruth& truth,
                             TruthMetrics& metrics) {
  const auto add = [&](std::string_view name, const Eigen::Vector3d& error) {
    metrics.json["georeference"][std::string(name)] = {{"horizontal_m", error.head<2>().norm()},
                                                       {"vertical_m", error.z()}};
  };
  const Eigen::Vector3d at_vision = truth.vision_from_lidar * truth.centroid_in_lidar;
  if (known.truth_from_vision_absolute) {
    add("vision",
        *known.truth_from_vision_absolute * at_vision - *known.truth_from_vision * at_vision);
  }
  if (known.truth_from_map_absolute) {
    add("lidar",
        *known.truth_from_map_absolute * truth.centroid_in_lidar -
            *known.truth_from_map * truth.centroid_in_lidar);
  }
}

void add_fused_georeference(const TruthAlignments& known,
                            const SceneTruth& truth,
                            TruthMetrics& metrics) {
  if (!known.truth_from_vision_absolute) return;
  const Eigen::Vector3d in_vision = truth.vision_from_lidar * truth.centroid_in_lidar;
  const Eigen::Vector3d error =
      *known.truth_from_vision_absolute * (*known.fused_from_vision * in_vision) -
      *known.truth_from_vision * in_vision;
  const Sim3 truth_from_fused = *known.truth_from_vision * known.fused_from_vision->inverse();
  const Eigen::Vector3d up = truth_from_fused.rotation.conjugate() *
                             known.truth_from_vision_absolute->rotation * Eigen::Vector3d::UnitZ();
  const double tilt_deg = 180.0 / std::numbers::pi * std::atan2(up.head<2>().norm(), up.z());
  metrics.json["georeference"]["fused"] = {
      {"horizontal_m", error.head<2>().norm()}, {"vertical_m", error.z()}, {"tilt_deg", tilt_deg}};
  metrics.summary.push_back(
      fmt::format("fused cloud: {:.2f} m horizontal and {:+.2f} m vertical from its true place, "
                  "tilted by {:.3f} deg",
                  error.head<2>().norm(),
                  error.z(),
                  tilt_deg));
}

}  // namespace hybridfusion
