#include "drive_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::benchmark {
namespace {

constexpr double kCm = 100.0;
// Of every drive: memory of the whole process, distances of L to the true surface.
constexpr double kMemoryGoal_mib = 100.0;
constexpr double kMapMedianGoal_m = 0.015;
constexpr double kMapP95Goal_m = 0.06;

/// "0.52" or, where a goal is missed, "0.72 (goal 0.60)".
std::string against(double value, double goal, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (goal > 0.0 && value > goal) text += fmt::format(" (goal {:.{}f})", goal, decimals);
  return text;
}

std::string line(const Row& row) {
  const Figures& f = row.figures;
  const Goals& goals = row.kind->goals;
  const double ate_goal_m = row.offline ? goals.offline_ate_m : goals.filter_ate_m;
  const bool has_map = f.map_median_m >= 0.0;
  // Of the reference's time with the hash and with the k-d tree; the offline pass has no limit.
  const double share = row.offline ? 0.0 : row.variant == "ikdtree" ? 0.9 : 0.5;
  return fmt::format(
      "| {} | {} | {} | {:.0f} | {} | {:.2f} | {:.2f} | {:.1f} | {} | {} | {} | {} | {} | {} | "
      "{}/{} |\n",
      row.kind->name,
      row.seed,
      row.variant,
      f.points_per_scan,
      against(kCm * f.ate_m, kCm * ate_goal_m, 2),
      kCm * f.ate_max_m,
      kCm * f.rpe_1_s_m,
      kCm * f.rpe_50_m_m,
      against(kCm * f.startup_m, kCm * goals.startup_m, 1),
      against(f.cpu_ms_median, share * row.kind->fast_lio.cpu_ms_median, 1),
      against(f.cpu_ms_p95, share * row.kind->fast_lio.cpu_ms_p95, 1),
      against(f.memory_mib, kMemoryGoal_mib, 0),
      has_map ? against(kCm * f.map_median_m, kCm * kMapMedianGoal_m, 2) : "-",
      has_map ? against(kCm * f.map_p95_m, kCm * kMapP95Goal_m, 2) : "-",
      f.num_flagged,
      f.num_scans);
}

std::string reference_line(const DriveKind& kind) {
  const Reference& r = kind.fast_lio;
  if (r.ate_m == 0.0) return "";
  return fmt::format(
      "| {} | | FAST_LIO, a like drive | | {:.2f} | | | | | {:.0f} | {:.0f} | {:.0f} | | | |\n",
      kind.name,
      kCm * r.ate_m,
      r.cpu_ms_median,
      r.cpu_ms_p95,
      r.memory_mib);
}

/// Memory of the process over the recording, of drives long enough to show whether it grows.
std::string memory_text(const std::vector<Row>& rows) {
  constexpr std::size_t kMinSamples = 5;
  std::string text;
  for (const Row& row : rows) {
    const Figures& f = row.figures;
    if (f.memory.size() < kMinSamples) continue;
    text += fmt::format("\nMiB of {} (seed {}, {}) after", row.kind->name, row.seed, row.variant);
    for (const MemorySample& sample : f.memory) {
      text += fmt::format("{} {:.0f} s: {:.0f}",
                          &sample == &f.memory.front() ? "" : ",",
                          sample.time_s,
                          sample.mib);
    }
    text +=
        row.offline ? fmt::format("; finishing raised the peak by {:.0f}\n", f.finish_mib) : "\n";
  }
  return text;
}

}  // namespace

std::string table(const std::vector<Row>& rows) {
  std::string text =
      "| drive | seed | run | points a scan | ATE cm | max cm | RPE 1 s cm | RPE 50 m cm | "
      "first 8 s cm | ms a scan | 95 % | MiB | L to surface cm | 95 % | flagged |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += line(rows[i]);
    const bool last_of_kind = i + 1 == rows.size() || rows[i + 1].kind != rows[i].kind;
    if (last_of_kind) text += reference_line(*rows[i].kind);
  }
  return text + memory_text(rows);
}

nlohmann::json table_json(const std::vector<Row>& rows) {
  nlohmann::json json = nlohmann::json::array();
  for (const Row& row : rows) {
    nlohmann::json entry = to_json(row.figures);
    entry["drive"] = row.kind->name;
    entry["seed"] = row.seed;
    entry["run"] = row.variant;
    entry["goal_ate_m"] =
        row.offline ? row.kind->goals.offline_ate_m : row.kind->goals.filter_ate_m;
    entry["goal_startup_m"] = row.kind->goals.startup_m;
    entry["fast_lio_ate_m"] = row.kind->fast_lio.ate_m;
    entry["fast_lio_cpu_ms_median"] = row.kind->fast_lio.cpu_ms_median;
    json.push_back(entry);
  }
  return json;
}

}  // namespace hybridfusion::benchmark
