#pragma once

#include "finding_list.hpp"

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// What a check writes into.
struct Diagnosis {
  FindingList findings = {};
  std::vector<std::string> facts = {};
};

/// What the recording says that other checks need.
struct RecordingEvidence {
  std::vector<GeodeticPosition> fixes = {};  ///< Usable ones, in order.
  std::uint64_t size_bytes = 0;
};

/// What the photos say that other checks need.
struct PhotoEvidence {
  std::size_t num_photos = 0;  ///< Usable files.
  /// Of the photos that have one; the altitude is NaN where it is not known.
  std::vector<GeodeticPosition> positions = {};
  /// Altitudes of the take-off, by the photos that know their height above it.
  std::vector<double> take_off_altitudes_m = {};
  /// What the run will say of scale and tilt where GNSS alone cannot tell them; empty: it can, or
  /// ground control does.
  std::string weak_georeference = {};
  int width_px = 0;  ///< Of the largest photo.
  int height_px = 0;
};

/// sensors.yaml, or the defaults with a finding.
[[nodiscard]] SensorConfig check_sensors(const std::optional<std::filesystem::path>& path,
                                         Diagnosis& diagnosis);

/// Topics and every message. @returns kCancelled only.
[[nodiscard]] Expected<RecordingEvidence> check_recording(const std::filesystem::path& bag,
                                                          const RecordingOptions& options,
                                                          Diagnosis& diagnosis,
                                                          const RunContext& ctx);

/// Files, metadata, positions, overlap and pixels of a folder, with geo.txt and ground control as
/// far as they are given or lie in it. @param ground_altitude_m  Height of the street where it is
/// known, for the size of the footprints. @returns kCancelled only.
[[nodiscard]] Expected<PhotoEvidence> check_photos(const PhotoInputs& given,
                                                   std::optional<double> ground_altitude_m,
                                                   const VisionStageOptions& options,
                                                   Diagnosis& diagnosis,
                                                   const RunContext& ctx);

/// Height in the metadata; none where it is exactly 0, which is written for want of one.
[[nodiscard]] std::optional<double> known_altitude_m(const PhotoMetadata& photo);

/// Cameras, focal lengths, sizes, times.
void check_cameras(std::span<const PhotoMetadata> photos, Diagnosis& diagnosis);
/// Presence, repetition and sign of the positions. @param num_control  Surveyed points that place
/// the model where photos have no position.
void check_positions(const std::filesystem::path& folder,
                     std::span<const PhotoMetadata> photos,
                     std::size_t num_control,
                     const GnssOptions& options,
                     Diagnosis& diagnosis);
/// Deviations of scale and tilt as the positions allow; what the run will say where they are too
/// large for a georeference, else empty.
[[nodiscard]] std::string weak_georeference(std::span<const PhotoMetadata> photos,
                                            const GnssOptions& options,
                                            Diagnosis& diagnosis);
/// geo.txt and ground control against the photos; the tags go into the photos of the folder.
/// @returns Number of surveyed points that can place the model.
std::size_t check_sources(const PhotoInputs& inputs,
                          const VisionStageOptions& options,
                          PhotoFolder& folder,
                          Diagnosis& diagnosis);
/// Footprints over the ground. @pre positions fit (no photos.no_positions, .same_position)
void check_overlap(std::span<const PhotoMetadata> photos,
                   std::optional<double> ground_altitude_m,
                   const GnssOptions& options,
                   Diagnosis& diagnosis);
/// Copies of one file.
[[nodiscard]] Expected<void> check_duplicates(const PhotoFolder& folder,
                                              Diagnosis& diagnosis,
                                              const RunContext& ctx);
/// Decodes an even sample: damage, sharpness, exposure. @returns kCancelled only.
[[nodiscard]] Expected<void> check_pixels(const PhotoFolder& folder,
                                          Diagnosis& diagnosis,
                                          const RunContext& ctx);

/// Photos and drive against each other.
void check_site(const PhotoEvidence& photos,
                const RecordingEvidence& recording,
                Diagnosis& diagnosis);

struct MachineState {
  std::optional<std::uint64_t> memory_bytes = {};  ///< Free for this process.
  std::optional<std::uint64_t> disk_bytes = {};    ///< Free at the output.
};
/// Of this machine; the disk is that of the nearest existing folder of `output`.
[[nodiscard]] MachineState machine_state(const std::optional<std::filesystem::path>& output);
void check_machine(const MachineState& machine,
                   const PhotoEvidence& photos,
                   const RecordingEvidence& recording,
                   Diagnosis& diagnosis);
void check_workspace(const std::filesystem::path& workspace, Diagnosis& diagnosis);

/// Ratio of the detail at a half to that at an eighth of the resolution: falls steeply with blur,
/// hardly depends on the scene, and is above the noise of single pixels.
[[nodiscard]] double sharpness_of(const Image8& image);

}  // namespace hybridfusion
