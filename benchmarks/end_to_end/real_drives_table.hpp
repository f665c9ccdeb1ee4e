#pragma once

#include "drive_errors.hpp"
#include "program_run.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace hybridfusion::benchmark {

/// One program on one drive.
struct RealDriveRow {
  std::string drive = {};
  std::string program = {};
  std::size_t num_scans = 0;
  std::optional<ProgramRun> run = {};  // none: the trajectory was there before
  std::optional<DriveErrors> errors = {};
  double thickness_m = -1.0;
};

/// Markdown, one line a row.
[[nodiscard]] std::string table(const std::vector<RealDriveRow>& rows);
[[nodiscard]] nlohmann::json to_json(const RealDriveRow& row);

}  // namespace hybridfusion::benchmark
