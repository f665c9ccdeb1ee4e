#pragma once

#include "truth_metrics.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>

#include <filesystem>
#include <optional>

namespace hybridfusion {

/// How the frames of a workspace lie over the truth, as far as it is known.
struct TruthAlignments {
  std::optional<Rigid3> truth_from_vision_absolute = {};  ///< By the georeference of the photos.
  std::optional<Rigid3> truth_from_map_absolute = {};     ///< By the GNSS of the drive.
  std::optional<Sim3> truth_from_vision = {};             ///< Cameras laid over the true ones.
  std::optional<Rigid3> truth_from_vision_rigid = {};     ///< The same without scale.
  std::optional<Rigid3> truth_from_map = {};              ///< Drive laid over the true one.
  std::optional<Sim3> fused_from_vision = {};             ///< Of an accepted registration.
};

/// Adds where the georeference puts the centre of the scene, against where it is.
void add_georeference_errors(const TruthAlignments& known,
                             const SceneTruth& truth,
                             TruthMetrics& metrics);

/// The same of the fused cloud, whose vertical may be gravity's.
void add_fused_georeference(const TruthAlignments& known,
                            const SceneTruth& truth,
                            TruthMetrics& metrics);

/// Adds accuracy and completeness of the vision, LiDAR and fused clouds under each alignment, as
/// far as mesh.ply and samples.ply exist.
[[nodiscard]] Expected<void> compare_clouds(const Workspace& workspace,
                                            const std::filesystem::path& truth_folder,
                                            const TruthAlignments& known,
                                            const EvaluationOptions& options,
                                            const RunContext& ctx,
                                            TruthMetrics& metrics);

}  // namespace hybridfusion
