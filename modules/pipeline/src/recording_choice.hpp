#pragma once

#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>

namespace hybridfusion {

/// An option that is set wins over sensors.yaml, which wins over detection.
[[nodiscard]] RecordingOptions recording_options(const RecordingOptions& options,
                                                 const SensorConfig& sensors);

/// `given`, else sensors.yaml beside the recording when there is one.
[[nodiscard]] std::optional<std::filesystem::path> sensors_file(
    const std::filesystem::path& bag, const std::optional<std::filesystem::path>& given);

}  // namespace hybridfusion
