#include "drive_figures.hpp"

#include <hybridfusion/evaluation/surface_distance.hpp>
#include <hybridfusion/evaluation/trajectory_error.hpp>
#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/lidar/mapper.hpp>
#include <hybridfusion/lidar/odometry.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <time.h>

namespace hybridfusion::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr double kStartup_s = 8.0;
constexpr double kMiB = 1024.0 * 1024.0;

double thread_cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// "VmRSS:", or "VmHWM:" for the peak; ru_maxrss inherits that of the parent process.
double memory_mib(const std::string& what) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(what)) return std::stod(line.substr(what.size())) * 1024.0 / kMiB;
  }
  return 0.0;
}

/// Takes a sample of the resident memory each half minute of the recording.
class MemoryLog {
 public:
  void note(const SensorMessage& message) {
    const auto* scan = std::get_if<LidarScan>(&message);
    if (scan == nullptr) return;
    if (!start_) start_ = scan->stamp;
    constexpr double kInterval_s = 30.0;
    const double time_s = to_seconds(scan->stamp - *start_);
    if (time_s < kInterval_s * static_cast<double>(samples_.size() + 1)) return;
    samples_.push_back({.time_s = time_s, .mib = memory_mib("VmRSS:")});
  }
  [[nodiscard]] const std::vector<MemorySample>& samples() const { return samples_; }

 private:
  std::optional<Timestamp> start_ = {};
  std::vector<MemorySample> samples_ = {};
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

LidarRig read_rig(const SensorConfig& sensors) {
  LidarRig rig;
  rig.imu_from_lidar = sensors.imu_from_lidar.value_or(rig.imu_from_lidar);
  ImuNoise& noise = rig.imu_noise;
  noise.gyro_noise_density = sensors.gyro_noise_density.value_or(noise.gyro_noise_density);
  noise.accel_noise_density = sensors.accel_noise_density.value_or(noise.accel_noise_density);
  noise.gyro_bias_walk = sensors.gyro_bias_walk.value_or(noise.gyro_bias_walk);
  noise.accel_bias_walk = sensors.accel_bias_walk.value_or(noise.accel_bias_walk);
  return rig;
}

struct Run {
  Trajectory trajectory = {};
  std::vector<ScanQuality> quality = {};
  fs::path map = {};  // empty: none was made
};

void count(const std::vector<ScanQuality>& scans, Figures& figures) {
  figures.num_scans = scans.size();
  for (const ScanQuality& quality : scans) {
    if (quality.flags != 0) ++figures.num_flagged;
    figures.points_per_scan += quality.num_points / static_cast<double>(scans.size());
  }
}

/// What a person looks at when the figures surprise.
Expected<void> write_details(const fs::path& folder, const std::string& name, const Run& run) {
  if (auto written = write_tum(folder / (name + ".tum"), run.trajectory); !written) return written;
  std::string csv = quality_csv_header() + "\n";
  for (const ScanQuality& quality : run.quality) csv += quality_csv_row(quality) + "\n";
  return write_file_atomically(folder / (name + ".csv"), csv);
}

Expected<Run> run_filter(const OdometryOptions& options,
                         const LidarRig& rig,
                         ScanSource& source,
                         Figures& figures) {
  HF_TRY(LidarOdometry odometry, LidarOdometry::create(options, rig));
  Run run;
  MemoryLog memory;
  std::vector<double> scan_ms;
  double spent_ms = 0.0;
  const auto collect = [&] {
    const std::vector<ScanEstimate> scans = odometry.take();
    for (const ScanEstimate& scan : scans) {
      run.trajectory.poses.push_back({.time = scan.time, .map_from_body = scan.map_from_imu});
      run.quality.push_back(scan.quality);
      scan_ms.push_back(spent_ms / static_cast<double>(scans.size()));
    }
    if (!scans.empty()) spent_ms = 0.0;
  };
  while (true) {
    HF_TRY(std::optional<SensorMessage> message, source.next());
    if (!message) break;
    memory.note(*message);
    const double before_ms = thread_cpu_ms();
    if (const auto* imu = std::get_if<ImuSample>(&*message)) odometry.add_imu(*imu);
    if (auto* scan = std::get_if<LidarScan>(&*message)) odometry.add_scan(std::move(*scan));
    spent_ms += thread_cpu_ms() - before_ms;
    collect();
  }
  if (auto finished = odometry.finish(); !finished) return std::unexpected(finished.error());
  collect();
  figures.memory = memory.samples();
  figures.cpu_ms_median = quantile(scan_ms, 0.5);
  figures.cpu_ms_p95 = quantile(scan_ms, 0.95);
  return run;
}

/// As `hybridfusion map`: scans wait in a file, L goes out piece by piece.
Expected<Run> run_offline(const OdometryOptions& options,
                          const LidarRig& rig,
                          const fs::path& details,
                          ScanSource& source,
                          Figures& figures) {
  HF_TRY(LidarMapper mapper, LidarMapper::create(options, rig, details));
  MemoryLog memory;
  double spent_ms = 0.0;
  while (true) {
    HF_TRY(std::optional<SensorMessage> message, source.next());
    if (!message) break;
    memory.note(*message);
    const double before_ms = thread_cpu_ms();
    mapper.add(*std::move(message));
    spent_ms += thread_cpu_ms() - before_ms;
  }
  figures.memory = memory.samples();
  const double read_mib = memory_mib("VmHWM:");
  const double before_ms = thread_cpu_ms();
  Run run{.map = details / "offline.ply"};
  HF_TRY(PlyPieceWriter map, PlyPieceWriter::create(run.map));
  HF_TRY(MappingResult mapping,
         mapper.finish({.num_threads = 1}, [&map](const PointCloud& piece) -> Expected<void> {
           map.add(piece);
           return {};
         }));
  if (auto written = map.commit(); !written) return std::unexpected(written.error());
  spent_ms += thread_cpu_ms() - before_ms;
  figures.finish_mib = memory_mib("VmHWM:") - read_mib;
  figures.cpu_ms_median = spent_ms / std::max(1.0, static_cast<double>(mapping.quality.size()));
  figures.cpu_ms_p95 = figures.cpu_ms_median;
  run.trajectory = std::move(mapping.trajectory);
  run.quality = std::move(mapping.quality);
  return run;
}

double startup_error_m(const Trajectory& truth,
                       const Trajectory& estimate,
                       const Rigid3& truth_from_map) {
  double largest_m = 0.0;
  for (const StampedPose& pose : estimate.poses) {
    if (to_seconds(pose.time - estimate.poses.front().time) > kStartup_s) break;
    const auto expected = interpolate(truth, pose.time, 0.0);
    if (!expected) continue;
    const Eigen::Vector3d gap =
        truth_from_map * pose.map_from_body.translation - expected->translation;
    largest_m = std::max(largest_m, gap.norm());
  }
  return largest_m;
}

Expected<void> judge_map(const PointCloud& map,
                         const Rigid3& truth_from_map,
                         const fs::path& mesh_path,
                         Figures& figures) {
  constexpr std::size_t kMaxPoints = 200'000;
  HF_TRY(const TriangleMesh mesh, read_ply_mesh(mesh_path));
  HF_TRY(const SurfaceDistance surface, SurfaceDistance::build(mesh.vertices, mesh.triangles));
  std::vector<double> distances_m;
  const std::size_t stride = map.points.size() / kMaxPoints + 1;
  for (std::size_t i = 0; i < map.points.size(); i += stride) {
    const Eigen::Vector3d point = truth_from_map * map.points[i].cast<double>();
    distances_m.push_back(static_cast<double>(surface.nearest(point.cast<float>()).distance_m));
  }
  figures.map_median_m = quantile(distances_m, 0.5);
  figures.map_p95_m = quantile(distances_m, 0.95);
  return {};
}

}  // namespace

nlohmann::json to_json(const Figures& f) {
  nlohmann::json memory = nlohmann::json::array();
  for (const MemorySample& sample : f.memory) memory.push_back({sample.time_s, sample.mib});
  return {{"num_scans", f.num_scans},
          {"num_flagged", f.num_flagged},
          {"points_per_scan", f.points_per_scan},
          {"ate_m", f.ate_m},
          {"ate_max_m", f.ate_max_m},
          {"rpe_1_s_m", f.rpe_1_s_m},
          {"rpe_50_m_m", f.rpe_50_m_m},
          {"startup_m", f.startup_m},
          {"cpu_ms_median", f.cpu_ms_median},
          {"cpu_ms_p95", f.cpu_ms_p95},
          {"memory_mib", f.memory_mib},
          {"finish_mib", f.finish_mib},
          {"memory", memory},
          {"map_median_m", f.map_median_m},
          {"map_p95_m", f.map_p95_m}};
}

Figures from_json(const nlohmann::json& json) {
  const auto number = [&](const char* key) { return json.at(key).get<double>(); };
  Figures figures{.num_scans = json.at("num_scans").get<std::size_t>(),
                  .num_flagged = json.at("num_flagged").get<std::size_t>(),
                  .points_per_scan = number("points_per_scan"),
                  .ate_m = number("ate_m"),
                  .ate_max_m = number("ate_max_m"),
                  .rpe_1_s_m = number("rpe_1_s_m"),
                  .rpe_50_m_m = number("rpe_50_m_m"),
                  .startup_m = number("startup_m"),
                  .cpu_ms_median = number("cpu_ms_median"),
                  .cpu_ms_p95 = number("cpu_ms_p95"),
                  .memory_mib = number("memory_mib"),
                  .finish_mib = number("finish_mib"),
                  .map_median_m = number("map_median_m"),
                  .map_p95_m = number("map_p95_m")};
  for (const nlohmann::json& sample : json.at("memory")) {
    figures.memory.push_back(
        {.time_s = sample.at(0).get<double>(), .mib = sample.at(1).get<double>()});
  }
  return figures;
}

Expected<Figures> run_variant(const Variant& variant,
                              const fs::path& folder,
                              const fs::path& details) {
  HF_TRY(const SensorConfig sensors, read_sensors_yaml(folder / "sensors.yaml"));
  const LidarRig rig = read_rig(sensors);
  Figures figures;
  Run run;
  {
    HF_TRY(const std::unique_ptr<ScanSource> source, open_recording(folder / "street.bag"));
    HF_TRY(run,
           variant.offline ? run_offline(variant.options, rig, details, *source, figures)
                           : run_filter(variant.options, rig, *source, figures));
  }
  figures.memory_mib = memory_mib("VmHWM:");
  count(run.quality, figures);
  if (auto written = write_details(details, variant.name, run); !written) {
    return std::unexpected(written.error());
  }
  HF_TRY(const Trajectory truth, read_tum(folder / "truth" / "trajectory_imu.tum"));
  HF_TRY(const TrajectoryErrors errors, trajectory_errors(truth, run.trajectory));
  figures.ate_m = errors.ate_rmse_m;
  figures.ate_max_m = errors.ate_max_m;
  figures.rpe_1_s_m = errors.over_1_s.translation_rmse_m;
  figures.rpe_50_m_m = errors.over_50_m.translation_rmse_m;
  figures.startup_m = startup_error_m(truth, run.trajectory, errors.truth_from_map);
  const fs::path mesh = folder / "truth" / "mesh.ply";
  if (!run.map.empty() && fs::exists(mesh)) {
    HF_TRY(const PointCloud map, read_ply(run.map));
    if (auto judged = judge_map(map, errors.truth_from_map, mesh, figures); !judged) {
      return std::unexpected(judged.error());
    }
  }
  return figures;
}

}  // namespace hybridfusion::benchmark
