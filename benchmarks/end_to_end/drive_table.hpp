#pragma once

#include "drive_figures.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace hybridfusion::benchmark {

/// A finished run.
struct Row {
  const DriveKind* kind = nullptr;
  std::uint64_t seed = 0;
  std::string variant = {};
  bool offline = false;
  Figures figures = {};
};

/// Markdown: one line a run, the goals and the reference behind each kind; below, memory over time
/// where a recording is long.
[[nodiscard]] std::string table(const std::vector<Row>& rows);
[[nodiscard]] nlohmann::json table_json(const std::vector<Row>& rows);

}  // namespace hybridfusion::benchmark
