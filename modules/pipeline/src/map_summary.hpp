#pragma once

#include "json_text.hpp"
#include "stage_runner.hpp"

#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/lidar/mapper.hpp>

namespace hybridfusion {

/// What `map` answers: its lines and JSON, refused when the drive, its GNSS or its IMU contradict
/// each other.
/// @param gnss  gnss.json without residuals, or {"reason", "contradicts"}.
[[nodiscard]] StageResult map_summary(const MappingResult& mapping,
                                      const RecordingSummary& recording,
                                      const Json& gnss);

}  // namespace hybridfusion
