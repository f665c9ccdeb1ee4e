#pragma once

#include "scan_store.hpp"

#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// What in a located drive cannot be: an IMU that says something else than the points, and motion
/// that no vehicle makes. A sentence each, with the likely cause and a remedy.
[[nodiscard]] std::vector<std::string> contradictions_of(const OdometrySummary& summary,
                                                         std::span<const StoredScan> scans);

}  // namespace hybridfusion
