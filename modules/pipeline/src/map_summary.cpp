#include "map_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

double path_length_m(const Trajectory& trajectory) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < trajectory.poses.size(); ++i) {
    length_m += (trajectory.poses[i].map_from_body.translation -
                 trajectory.poses[i - 1].map_from_body.translation)
                    .norm();
  }
  return length_m;
}

struct Residuals {
  std::ptrdiff_t num_flagged = 0;
  double mean_m = 0.0;
};

Residuals residuals_of(const std::vector<ScanQuality>& quality) {
  Residuals residuals{.num_flagged = std::ranges::count_if(
                          quality, [](const ScanQuality& scan) { return scan.flags != 0; })};
  for (const ScanQuality& scan : quality) residuals.mean_m += scan.mean_residual_m;
  residuals.mean_m /= std::max<double>(1.0, static_cast<double>(quality.size()));
  return residuals;
}

Json json_of(const MappingResult& mapping, const RecordingSummary& recording, const Json& gnss) {
  const Residuals residuals = residuals_of(mapping.quality);
  return {{"recording_format", recording.format},
          {"recording_truncated", recording.truncated},
          {"lidar_topic", recording.lidar_topic},
          {"imu_topic", recording.imu_topic},
          {"gnss_topic", recording.gnss_topic},
          {"point_time", recording.point_time},
          {"point_times_made_up", recording.point_times_made_up},
          {"imu_gravity_removed", recording.imu_dialect.gravity_removed},
          {"num_scans", mapping.trajectory.poses.size()},
          {"num_flagged_scans", residuals.num_flagged},
          {"num_unmatched_scans", mapping.odometry.num_unmatched_scans},
          {"num_degenerate_scans", mapping.odometry.num_degenerate_scans},
          {"used_imu", mapping.odometry.used_imu},
          {"num_scans_before_start", mapping.odometry.num_scans_before_start},
          {"contradictions", mapping.contradictions},
          {"num_imu_gaps", mapping.odometry.num_imu_gaps},
          {"num_lidar_gaps", mapping.odometry.num_lidar_gaps},
          {"longest_blind_s", mapping.longest_blind_s},
          {"num_damaged_messages", recording.num_damaged_messages},
          {"path_m", path_length_m(mapping.trajectory)},
          {"mean_residual_m", residuals.mean_m},
          {"num_map_points", mapping.num_map_points},
          {"num_loops", mapping.num_loops},
          {"loops_applied", mapping.loops_applied},
          {"max_loop_error_m", mapping.max_loop_error_m},
          {"refine_iterations", mapping.refine_iterations},
          {"refine_rms_before_m", mapping.refine_rms_before_m},
          {"refine_rms_after_m", mapping.refine_rms_after_m},
          {"gnss", gnss},
          {"warnings", mapping.warnings}};
}

/// Why the accelerations cannot be those of a vehicle on earth; empty when they can.
std::string unfit_accelerations(const ImuDialect& imu) {
  constexpr double kMax_mps2 = 1.5 * 9.80665;  // no drive has half of gravity added in the median
  if (imu.gravity_removed) {
    return fmt::format(
        "the driver of the IMU removed gravity ({:.2f} m/s^2 in the median); record the raw "
        "acceleration, 9.81 at rest",
        imu.force_median);
  }
  if (imu.force_median > kMax_mps2) {
    return fmt::format(
        "the accelerations are {:.1f} in the median where 9.81 m/s^2 is right: another unit",
        imu.force_median);
  }
  return {};
}

bool contradicts(const Json& gnss) {
  return gnss.value("contradicts", false);
}

/// Whatever keeps the map from being taken as it is.
void add_doubts(const MappingResult& mapping,
                const RecordingSummary& recording,
                const Json& gnss,
                std::vector<std::string>& summary) {
  if (!mapping.reliable && mapping.contradictions.empty()) {
    summary.push_back(fmt::format("not reliable: {:.1f} s without a scan located by its points",
                                  mapping.longest_blind_s));
  }
  for (const std::string& contradiction : mapping.contradictions) {
    summary.push_back("not reliable: " + contradiction);
  }
  if (!mapping.odometry.used_imu) {
    summary.emplace_back(
        mapping.level_sigma_rad > 0.0
            ? fmt::format("without an IMU: motion from the LiDAR alone, level by walls and ground "
                          "to {:.2f} deg",
                          180.0 / std::numbers::pi * mapping.level_sigma_rad)
            : std::string("without an IMU: motion from the LiDAR alone, level not known"));
  }
  if (contradicts(gnss)) {
    summary.push_back("not reliable: " + gnss["reason"].get<std::string>() +
                      "; either the map is wrong or the receiver is: without it, --set "
                      "lidar.recording.gnss_topic=none maps the drive by itself");
  }
  if (const std::string unfit = unfit_accelerations(recording.imu_dialect); !unfit.empty()) {
    summary.push_back("not reliable: " + unfit);
  }
  if (recording.point_times_made_up) {
    summary.push_back(
        "the times of the points are made up: motion within a scan is removed "
        "in part only");
  }
}

}  // namespace

StageResult map_summary(const MappingResult& mapping,
                        const RecordingSummary& recording,
                        const Json& gnss) {
  const Residuals residuals = residuals_of(mapping.quality);
  StageResult result{.refused = !mapping.reliable || contradicts(gnss) ||
                                !unfit_accelerations(recording.imu_dialect).empty(),
                     .json = to_text(json_of(mapping, recording, gnss))};
  result.summary = {fmt::format("{} scans located over {:.0f} m, {} flagged, residual {:.3f} m",
                                mapping.trajectory.poses.size(),
                                path_length_m(mapping.trajectory),
                                residuals.num_flagged,
                                residuals.mean_m),
                    fmt::format("{} map points", mapping.num_map_points)};
  if (!recording.point_time.empty()) {
    result.summary.push_back("point times: " + recording.point_time);
  }
  if (mapping.num_loops > 0) {
    result.summary.push_back(
        fmt::format("{} places passed twice agree; odometry alone left them open by up to {:.2f} m",
                    mapping.num_loops,
                    mapping.max_loop_error_m));
  }
  add_doubts(mapping, recording, gnss, result.summary);
  if (recording.truncated) {
    result.summary.push_back("the recording is cut off; what precedes the cut was used");
  }
  result.summary.push_back(
      gnss.contains("enu_from_map")
          ? fmt::format("GNSS residuals {:.2f} m horizontal, {:.2f} m vertical (rms), heading to "
                        "{:.2f} deg",
                        gnss["horizontal_rms_m"].get<double>(),
                        gnss["vertical_rms_m"].get<double>(),
                        gnss["heading_sigma_deg"].get<double>())
          : "no georeference: " + gnss.value("reason", "no GNSS"));
  return result;
}

}  // namespace hybridfusion
