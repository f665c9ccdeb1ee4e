#pragma once

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/core/trajectory.hpp>
#include <hybridfusion/lidar/odometry.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hybridfusion {

/// A mapped drive. The map frame: origin at the first IMU position, z up, heading of the first
/// IMU x axis.
struct MappingResult {
  Trajectory trajectory = {};  ///< map_from_imu at the end of each scan.
  PointCloud map = {};         ///< L: points, intensities, times_s in the map frame.
  std::size_t num_map_points = 0;
  std::vector<ScanQuality> quality = {};  ///< One for each pose.
  /// One for each pose, before refinement: [translation in map; rotation in the IMU frame].
  std::vector<Eigen::Matrix<double, 6, 6>> covariances = {};
  std::vector<GnssFix> gnss_fixes = {};  ///< As received, for align_gnss.
  OdometrySummary odometry = {};
  std::size_t num_loop_candidates = 0;  ///< Pairs of places that may be the same.
  std::size_t num_loops = 0;            ///< Places that were passed twice and verified.
  double max_loop_error_m = 0.0;        ///< By which odometry alone left them open.
  bool loops_applied = false;           ///< False when they were closed already.
  int refine_iterations = 0;            ///< 0 when refinement is off or had nothing to do.
  std::size_t num_refine_planes = 0;
  double refine_rms_before_m = 0.0;  ///< Of points about common planes.
  double refine_rms_after_m = 0.0;
  double level_correction_rad = 0.0;  ///< Turn that made the first level estimate final.
  double level_sigma_rad = 0.0;       ///< Formal deviation of the map's vertical; 0: not known.
  /// Longest time without a scan that was located by its points: the IMU alone went on.
  double longest_blind_s = 0.0;
  /// What in the drive contradicts itself, a sentence each with the likely cause and a remedy.
  std::vector<std::string> contradictions = {};
  /// Nothing contradicts, and `longest_blind_s` is within OdometryOptions::max_blind_s: else what
  /// follows hangs on a guess.
  bool reliable = true;
  std::vector<std::string> warnings = {};  ///< What a user should know, in full sentences.
};

/// Takes a piece of the map (points, intensities, times_s); an error ends the mapping with it.
using MapSink = std::function<Expected<void>(const PointCloud& piece)>;

/// "time,points,matched,mean_residual_m,min_information,flags", and a row of it.
[[nodiscard]] std::string quality_csv_header();
[[nodiscard]] std::string quality_csv_row(const ScanQuality& quality);

/// HybridFusion III-B from messages to map: odometry while messages come in, loop closure,
/// refinement and dense map at the end.
class LidarMapper {
 public:
  /// @param scratch_folder  Holds the points of all scans (12 bytes each) until finish(), in a file
  /// without a name; empty: they stay in memory.
  /// @returns kInvalidOptions; kIo when nothing can be written to `scratch_folder`.
  [[nodiscard]] static Expected<LidarMapper> create(
      const OdometryOptions& options,
      const LidarRig& rig,
      const std::filesystem::path& scratch_folder = {});
  LidarMapper(LidarMapper&&) noexcept;
  LidarMapper& operator=(LidarMapper&&) noexcept;
  ~LidarMapper();

  /// Messages in the order of recording.
  void add(SensorMessage message);
  [[nodiscard]] std::size_t num_located_scans() const;
  /// @returns kInsufficient without IMU samples, scans or a single point in the map; kCancelled;
  /// kIo when the scratch folder fills up.
  [[nodiscard]] Expected<MappingResult> finish(const RunContext& ctx);
  /// The same with the map handed to `sink` piece by piece, `map` staying empty: however long the
  /// drive, only one piece of at most 26 x 26 m (at the default voxel) is in memory.
  [[nodiscard]] Expected<MappingResult> finish(const RunContext& ctx, const MapSink& sink);

 private:
  struct Impl;
  explicit LidarMapper(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hybridfusion
