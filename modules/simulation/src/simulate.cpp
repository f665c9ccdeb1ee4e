#include "flight.hpp"
#include "output_file.hpp"
#include "street_drive.hpp"
#include "truth_files.hpp"
#include "world.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/simulation/simulate.hpp>

#include <system_error>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

/// Folder that is removed again unless it is kept.
class PartialFolder {
 public:
  explicit PartialFolder(fs::path path) : path_(std::move(path)) {}
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;
  ~PartialFolder() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }
  [[nodiscard]] Expected<void> rename_to(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    if (error) {
      return fail(
          ErrorCode::kIo,
          fmt::format(
              "cannot rename '{}' to '{}': {}", path_.string(), target.string(), error.message()));
    }
    kept_ = true;
    return {};
  }

 private:
  fs::path path_;
  bool kept_ = false;
};

/// @returns the folder to write into; kIo when something is in the way.
Expected<fs::path> make_partial_folder(const fs::path& output) {
  std::error_code error;
  if (fs::exists(output, error) && !(fs::is_directory(output, error) && fs::is_empty(output))) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("'{}' exists and is not an empty folder; it was left as it is, name "
                            "another output",
                            output.string()));
  }
  fs::path partial = output.has_filename() ? output : output.parent_path();
  partial += ".part";
  if (fs::exists(partial, error)) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("'{}' is left from an interrupted run or belongs to a running one; "
                            "remove it or name another output",
                            partial.string()));
  }
  if (!fs::create_directories(partial / "images", error) ||
      !fs::create_directories(partial / "truth", error)) {
    return fail(ErrorCode::kIo,
                fmt::format("cannot make the folder '{}': {}", partial.string(), error.message()));
  }
  return partial;
}

GeodeticOrigin make_origin(std::uint64_t seed) {
  Random random(seed, "world/origin");
  return {.latitude_deg = 48.10 + 0.1 * random.uniform(),
          .longitude_deg = 11.50 + 0.1 * random.uniform(),
          .altitude_m = 500.0 + 40.0 * random.uniform()};
}

std::string numbered(const std::string& stem, int drive, const std::string& extension) {
  return drive == 0 ? stem + extension : fmt::format("{}_{}{}", stem, drive + 1, extension);
}

/// Everything of one run; each step writes its files into the folder.
class Simulation {
 public:
  Simulation(fs::path folder, const SimulationOptions& options, const RunContext& ctx)
      : folder_(std::move(folder)),
        options_(options),
        ctx_(ctx),
        origin_(make_origin(ctx.seed)),
        camera_(make_true_camera(options.camera, ctx.seed)),
        vehicle_(make_vehicle(options.lidar, ctx.seed)) {}

  [[nodiscard]] Expected<SimulationSummary> run() {
    HF_TRY(const World world, build_world(options_.world, ctx_.seed, ctx_));
    const RayTracer tracer(world.scene);
    SimulationSummary summary{.triangles = world.scene.faces.size()};
    if (options_.flight.enabled) {
      shots_ = plan_flight(world.terrain, options_, ctx_.seed);
      if (Expected<void> flown = fly(
              world.scene, tracer, camera_, shots_, options_, origin_, folder_ / "images", ctx_);
          !flown) {
        return std::unexpected(flown.error());
      }
      summary.photos = shots_.size();
    }
    if (Expected<void> driven = make_drives(world, tracer, summary); !driven) {
      return std::unexpected(driven.error());
    }
    if (Expected<void> written = write_truth(world, tracer, summary); !written) {
      return std::unexpected(written.error());
    }
    return summary;
  }

 private:
  [[nodiscard]] Expected<void> make_drives(const World& world,
                                           const RayTracer& tracer,
                                           SimulationSummary& summary) {
    if (!options_.drive.enabled) return {};
    if (options_.world.variant == "other-site") {
      // It has the same origin, so that position alone does not give the difference away.
      constexpr std::uint64_t kElsewhere = 0x5bd1e995;
      HF_TRY(const World elsewhere, build_world(options_.world, ctx_.seed ^ kElsewhere, ctx_));
      return record_drives(elsewhere, RayTracer(elsewhere.scene), summary);
    }
    return record_drives(world, tracer, summary);
  }

  [[nodiscard]] Expected<void> record_drives(const World& world,
                                             const RayTracer& tracer,
                                             SimulationSummary& summary) {
    for (int drive = 0; drive < options_.drive.drives; ++drive) {
      HF_TRY(DriveRecord record,
             record_drive(world,
                          tracer,
                          vehicle_,
                          options_,
                          origin_,
                          drive,
                          folder_ / numbered("street", drive, ".bag"),
                          ctx_));
      ++summary.drives;
      summary.scans += record.scans;
      summary.lidar_points += record.points;
      summary.imu_samples += record.imu_samples;
      summary.gnss_fixes += record.gnss_fixes;
      summary.street_images += record.images;
      summary.path_m += record.path_m;
      drives_.push_back(std::move(record));
    }
    return write_whole_file(folder_ / "sensors.yaml", sensors_yaml(vehicle_, options_));
  }

  [[nodiscard]] Expected<void> write_truth(const World& world,
                                           const RayTracer& tracer,
                                           SimulationSummary& summary) {
    const fs::path truth = folder_ / "truth";
    std::vector<std::pair<std::string, std::string>> files = {
        {"dataset.json",
         dataset_json(options_, ctx_.seed, origin_, camera_, shots_.size(), vehicle_, drives_)},
        {"cameras.csv", cameras_csv(shots_)}};
    const Rigid3 body_from_imu{.rotation = vehicle_.body_from_imu};
    for (int drive = 0; drive < static_cast<int>(drives_.size()); ++drive) {
      const DriveRecord& record = drives_[static_cast<std::size_t>(drive)];
      files.emplace_back(numbered("trajectory_imu", drive, ".tum"),
                         trajectory_tum(record, body_from_imu));
      files.emplace_back(numbered("trajectory_lidar", drive, ".tum"),
                         trajectory_tum(record, vehicle_.body_from_lidar()));
    }
    for (const auto& [name, content] : files) {
      if (Expected<void> written = write_whole_file(truth / name, content); !written) {
        return written;
      }
    }
    if (Expected<void> written = write_truth_mesh(truth / "mesh.ply", world.scene); !written) {
      return written;
    }
    // A drive at another site sees nothing of this world.
    const bool elsewhere = options_.world.variant == "other-site";
    HF_TRY(const std::vector<TruthSample> samples,
           sample_truth(world.scene,
                        tracer,
                        options_,
                        camera_,
                        shots_,
                        vehicle_,
                        elsewhere ? std::vector<DriveRecord>{} : drives_,
                        ctx_));
    summary.truth_samples = samples.size();
    return write_truth_samples(truth / "samples.ply", samples);
  }

  fs::path folder_;
  const SimulationOptions& options_;
  const RunContext& ctx_;
  GeodeticOrigin origin_;
  PinholeCamera camera_;
  VehicleSetup vehicle_;
  std::vector<Shot> shots_ = {};
  std::vector<DriveRecord> drives_ = {};
};

}  // namespace

Expected<SimulationSummary> simulate(const fs::path& output,
                                     const SimulationOptions& options,
                                     const RunContext& ctx) {
  if (Expected<void> valid = validate(options, "simulation"); !valid) {
    return std::unexpected(valid.error());
  }
  if (!options.flight.enabled && !options.drive.enabled) {
    return fail(ErrorCode::kInvalidOptions,
                "simulation.flight.enabled and simulation.drive.enabled are both false: there is "
                "nothing to simulate");
  }
  HF_TRY(const fs::path partial, make_partial_folder(output));
  PartialFolder folder(partial);
  HF_TRY(const SimulationSummary summary, Simulation(partial, options, ctx).run());
  const fs::path target = output.has_filename() ? output : output.parent_path();
  if (Expected<void> renamed = folder.rename_to(target); !renamed) {
    return std::unexpected(renamed.error());
  }
  return summary;
}

}  // namespace hybridfusion
