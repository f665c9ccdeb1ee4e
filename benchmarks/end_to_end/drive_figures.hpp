#pragma once

#include "drive_kinds.hpp"

#include <hybridfusion/core/error.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace hybridfusion::benchmark {

/// Resident memory of the process at a time of the recording.
struct MemorySample {
  double time_s = 0.0;  ///< Since the first message.
  double mib = 0.0;
};

/// One run over one recording, against its truth.
struct Figures {
  std::size_t num_scans = 0;
  std::size_t num_flagged = 0;
  double points_per_scan = 0.0;
  double ate_m = 0.0;
  double ate_max_m = 0.0;
  double rpe_1_s_m = 0.0;
  double rpe_50_m_m = 0.0;
  double startup_m = 0.0;      ///< Largest error of the first 8 s after the alignment of the whole.
  double cpu_ms_median = 0.0;  ///< One thread, reading not counted. Offline: mean in both.
  double cpu_ms_p95 = 0.0;
  double memory_mib = 0.0;  ///< Peak of the process before the comparison with the truth.
  double finish_mib = 0.0;  ///< By which all that follows the last message raised that peak.
  std::vector<MemorySample> memory = {};  ///< One for each half minute of the recording.
  double map_median_m = -1.0;  ///< Distance of L to the true surface; < 0: no L was made.
  double map_p95_m = -1.0;
};

[[nodiscard]] nlohmann::json to_json(const Figures& figures);
[[nodiscard]] Figures from_json(const nlohmann::json& json);

/// Runs a variant over a data set (street.bag, sensors.yaml, truth/) in this process and leaves its
/// trajectory, quality.csv and, offline, L in `details`. Without truth/mesh.ply L is not judged.
[[nodiscard]] Expected<Figures> run_variant(const Variant& variant,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& details);

}  // namespace hybridfusion::benchmark
