#include "json_text.hpp"
#include "recording_setup.hpp"
#include "stage_runner.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/lidar/calibration.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <memory>
#include <numbers>
#include <system_error>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

Expected<RigCalibration> calibrate_recording(const LidarStageOptions& options,
                                             const std::filesystem::path& bag,
                                             const RecordingSetup& setup,
                                             const RunContext& ctx) {
  HF_TRY(const std::unique_ptr<ScanSource> source, open_recording(bag, setup.recording, ctx));
  HF_TRY(RigCalibrator calibrator,
         RigCalibrator::create(options.calibration, setup.odometry, setup.rig));
  while (true) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while reading the recording");
    HF_TRY(std::optional<SensorMessage> message, source->next());
    if (!message) break;
    calibrator.add(*std::move(message));
  }
  for (const std::string& warning : source->summary().warnings) {
    ctx.warn(fmt::format("{}: {}", bag.string(), warning));
  }
  return calibrator.finish(ctx);
}

Json value_json(const CalibratedValue& value) {
  return {{"sigma", value.sigma}, {"found", value.found}};
}

StageResult describe(const RigCalibration& calibration, const RecordingSetup& setup) {
  const Rigid3& given = setup.rig.imu_from_lidar;
  const Rigid3& found = calibration.imu_from_lidar;
  const char* const axes = "xyz";
  Json rotation = Json::array();
  Json translation = Json::array();
  StageResult result;
  result.summary.push_back(
      fmt::format("imu_from_lidar turned by {:.2f} deg and moved by {:.3f} m from what was given",
                  kDegPerRad * rotation_distance_rad(found.rotation, given.rotation),
                  (found.translation - given.translation).norm()));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const CalibratedValue& turn = calibration.rotation[i];
    const CalibratedValue& arm = calibration.translation[i];
    rotation.push_back(value_json(turn));
    translation.push_back(value_json(arm));
    result.summary.push_back(fmt::format(
        "  about {0}: {1} | along {0}: {2}",
        axes[i],
        turn.found
            ? fmt::format("+-{:.3f} deg", kDegPerRad * turn.sigma)
            : fmt::format("not shown by the motion (+-{:.1f} deg), kept", kDegPerRad * turn.sigma),
        arm.found ? fmt::format("{:.3f} +-{:.3f} m", found.translation[at], arm.sigma)
                  : fmt::format("not shown by the motion (+-{:.2f} m), kept", arm.sigma)));
  }
  result.summary.push_back(
      calibration.time_offset.found
          ? fmt::format("imu_time_offset_s {:.4f} +-{:.4f} s",
                        calibration.imu_time_offset_s,
                        calibration.time_offset.sigma)
          : fmt::format("imu_time_offset_s not shown by the motion (+-{:.3f} s), kept",
                        calibration.time_offset.sigma));
  result.json = to_text(Json{{"imu_from_lidar", matrix_json(found)},
                             {"imu_time_offset_s", calibration.imu_time_offset_s},
                             {"time_offset", value_json(calibration.time_offset)},
                             {"rotation_rad", rotation},
                             {"translation_m", translation},
                             {"num_scans", calibration.num_scans},
                             {"passes", calibration.passes},
                             {"rms_rotation_rad", calibration.rms_rotation_rad},
                             {"rms_velocity_mps", calibration.rms_velocity_mps},
                             {"sensors", workspace_file::kCalibratedSensors}});
  return result;
}

}  // namespace

Expected<StageOutcome> calibrate_stage(Project& project,
                                       const std::filesystem::path& bag,
                                       const std::optional<std::filesystem::path>& sensors,
                                       const RunContext& ctx) {
  HF_TRY(const RecordingSetup setup, recording_setup(project, bag, sensors));
  StagePlan plan{.stage = "calibrate",
                 .option_groups = {"lidar"},
                 .inputs = {},
                 .outputs = {workspace_file::kCalibratedSensors}};
  HF_TRY(plan.inputs, recording_files(bag));
  const Workspace& workspace = project.workspace;
  const std::filesystem::path output = workspace.path(workspace_file::kCalibratedSensors);
  if (setup.sensors_path) {
    std::error_code code;
    // Outputs of an earlier run are deleted first; this one is the user's input now.
    if (std::filesystem::equivalent(*setup.sensors_path, output, code)) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("{} is what --calibrate writes; copy it elsewhere to start from it",
                              setup.sensors_path->string()));
    }
    plan.inputs.push_back(*setup.sensors_path);
  }
  return run_stage(project, plan, ctx, [&]() -> Expected<StageResult> {
    HF_TRY(const RigCalibration calibration,
           calibrate_recording(project.options.lidar, bag, setup, ctx));
    SensorConfig calibrated = setup.sensors;
    calibrated.imu_from_lidar = calibration.imu_from_lidar;
    calibrated.imu_time_offset_s = calibration.imu_time_offset_s;
    if (auto made = workspace.make_folder("lidar"); !made) return std::unexpected(made.error());
    if (auto written = write_file_atomically(output, to_yaml(calibrated)); !written) {
      return std::unexpected(written.error());
    }
    StageResult result = describe(calibration, setup);
    result.summary.push_back(fmt::format("use it with --sensors {}", output.string()));
    return result;
  });
}

}  // namespace hybridfusion
