#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <cstddef>
#include <filesystem>

namespace hybridfusion {

/// What simulate() left on the disk.
struct SimulationSummary {
  std::size_t photos = 0;
  std::size_t drives = 0;
  std::size_t scans = 0;
  std::size_t lidar_points = 0;
  std::size_t imu_samples = 0;
  std::size_t gnss_fixes = 0;
  std::size_t street_images = 0;
  std::size_t triangles = 0;
  std::size_t truth_samples = 0;
  double path_m = 0.0;  ///< Driven by the vehicle(s).
};

/// Makes a complete data set with exact truth: one seed (`ctx.seed`) -> one town block -> one drone
/// flight (images/*.JPG with EXIF) and one street drive (street.bag, sensors.yaml), and truth/
/// (dataset.json, cameras.csv, trajectory_imu.tum, trajectory_lidar.tum, mesh.ply, samples.ply).
/// Coordinates of the truth are ENU metres at the origin named in dataset.json. Everything is
/// written to "<output>.part" and renamed at the end, so that `output` exists only when complete.
/// Every noise source has its own random stream: switching one sensor off does not change another.
/// The same options and seed give the same bytes at any number of threads.
/// @returns kInvalidOptions for an option out of range, a drive that is too short, or when `output`
/// (or "<output>.part") exists and is not an empty folder: it is left alone; kIo when it cannot be
/// written; kCancelled (nothing is left behind).
[[nodiscard]] Expected<SimulationSummary> simulate(const std::filesystem::path& output,
                                                   const SimulationOptions& options,
                                                   const RunContext& ctx = {});

}  // namespace hybridfusion
