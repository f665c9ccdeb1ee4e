#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

struct PipelineOptions;

/// The version that decides whether a stage's results are still good.
[[nodiscard]] std::string_view program_version();

struct StageCost {
  double wall_s = 0.0;
  double cpu_s = 0.0;
  double peak_memory_mib = 0.0;
};

/// The stages in the order in which a whole run takes them.
inline constexpr std::array<std::string_view, 4> kStages = {
    "reconstruct", "map", "register", "evaluate"};

/// What a stage has to say. `result_json` is one JSON object; `summary` the same for a person.
struct StageOutcome {
  std::string stage = {};
  bool up_to_date = false;  ///< Nothing had changed; the former result is repeated.
  bool refused = false;     ///< The stage ran but has no reliable result.
  StageCost cost = {};
  std::string result_json = "{}";
  std::vector<std::string> summary = {};
};

/// A workspace with the options of its stages (held by the caller). Every stage function below
/// leaves its files in the workspace under the names of `workspace_file` and its provenance in
/// run.json. A stage whose input contents, options, seed and program version equal those of its
/// last complete run is not run again unless it is forced.
struct Project {
  Workspace workspace;
  const PipelineOptions& options;
  std::vector<std::string> forced = {};  ///< Stages to run even when up to date.
};

struct PhotoInputs {
  std::filesystem::path images = {};  ///< Folder of photos.
  /// Folder of a COLMAP text model whose cameras and poses are taken as they are instead of being
  /// reconstructed.
  std::optional<std::filesystem::path> poses = {};
  /// Positions that replace those in the photos; absent: geo.txt among the photos, if there.
  std::optional<std::filesystem::path> geo_tags = {};
  /// Ground control points; absent: gcp_list.txt among the photos, if there.
  std::optional<std::filesystem::path> control = {};
};

/// Module A: photos -> COLMAP model, positions.csv, origin.json, dense.ply. Without positions and
/// control the outcome is refused: the files are there, in an arbitrary frame that frame.json
/// (instead of origin.json) tells of.
[[nodiscard]] Expected<StageOutcome> reconstruct_stage(Project& project,
                                                       const PhotoInputs& inputs,
                                                       const RunContext& ctx);

/// Module B: recording -> trajectory.tum, map.ply, quality.csv, gnss.json. An unreliable drive (too
/// long without a scan located by its points) is an outcome with `refused`; its files are written.
/// @param sensors  Absent: sensors.yaml beside the recording when it exists.
[[nodiscard]] Expected<StageOutcome> map_stage(Project& project,
                                               const std::filesystem::path& bag,
                                               const std::optional<std::filesystem::path>& sensors,
                                               const RunContext& ctx);

/// LiDAR-IMU extrinsic and time offset from the recording -> lidar/sensors.yaml, which map_stage
/// takes as `sensors`. Maps nothing. @returns kDegenerate when the motion shows neither.
[[nodiscard]] Expected<StageOutcome> calibrate_stage(
    Project& project,
    const std::filesystem::path& bag,
    const std::optional<std::filesystem::path>& sensors,
    const RunContext& ctx);

struct RegisterInputs {
  std::filesystem::path vision = {};
  std::filesystem::path lidar = {};
  std::optional<std::filesystem::path> initial = {};  ///< JSON with vision_from_lidar.
  /// Without `initial`: search around the identity within the options' limits instead of anywhere.
  bool near_identity = false;
};

/// Module C: two clouds -> registration.json, fused.ply, fused.las. A refusal is an outcome with
/// `refused`, not an error: registration.json then says why and there is no fused cloud.
[[nodiscard]] Expected<StageOutcome> register_stage(Project& project,
                                                    const RegisterInputs& inputs,
                                                    const RunContext& ctx);

/// Metrics of HybridFusion IV-A, baselines and, with truth, errors of whatever the workspace holds
/// -> metrics.json.
[[nodiscard]] Expected<StageOutcome> evaluate_stage(
    Project& project, const std::optional<std::filesystem::path>& truth, const RunContext& ctx);

/// The same metrics for two clouds outside any workspace. Nothing is written.
struct CloudPair {
  std::filesystem::path vision = {};
  std::filesystem::path lidar = {};
  std::optional<std::filesystem::path> transform = {};  ///< vision_from_lidar; absent: identity.
  std::optional<std::filesystem::path> truth = {};      ///< true vision_from_lidar.
};
[[nodiscard]] Expected<StageOutcome> evaluate_pair(const CloudPair& pair,
                                                   const PipelineOptions& options,
                                                   const RunContext& ctx);

/// Draws report/index.html, one self-contained page, from the files of the workspace, whichever
/// stages ran. A damaged file costs its figures, with a warning, not the report.
/// @returns kIo; kCancelled.
[[nodiscard]] Expected<void> write_report(const Project& project, const RunContext& ctx);

}  // namespace hybridfusion
