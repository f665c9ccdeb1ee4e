#include "pair_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace hybridfusion::benchmark {
namespace {

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(at));
  return values[at];
}

/// "-" where there is nothing to take a quantile of.
std::string figure(const std::vector<double>& values, double share, int digits) {
  return values.empty() ? "-" : fmt::format("{:.{}f}", quantile(values, share), digits);
}

/// The outcomes of one group by one method.
struct GroupFigures {
  std::size_t pairs = 0;
  std::size_t right = 0;
  std::size_t refused = 0;
  std::size_t wrong = 0;
  std::vector<double> error_m = {};
  std::vector<double> angle_deg = {};
  std::vector<double> height_m = {};
  std::vector<double> scale_percent = {};
  std::vector<double> floor_m = {};
  std::vector<double> places_m = {};
  std::vector<double> cpu_s = {};

  void add(const Outcome& o) {
    ++pairs;
    cpu_s.push_back(o.cpu_s);
    if (!o.ok) {
      ++refused;
    } else if (!o.right) {
      ++wrong;
    } else {
      ++right;
      error_m.push_back(o.errors.at_centroid_m);
      angle_deg.push_back(o.errors.rotation_deg);
      height_m.push_back(std::abs(o.errors.vertical_m));
      scale_percent.push_back(100.0 * std::abs(o.scale_error));
      floor_m.push_back(o.floor_m);
      places_m.push_back(o.places_m);
    }
  }
};

}  // namespace

void print_table(const std::vector<Outcome>& outcomes, const std::vector<std::string>& methods) {
  for (const std::string& method : methods) {
    fmt::print(
        "\n### {}\n\n"
        "| pairs | n | right | refused | wrong | error median / 95 % [m] | rotation 95 % [deg] "
        "| height 95 % [m] | scale 95 % [%] | LiDAR points to their places, rigid floor / ours [m] "
        "| CPU s |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n",
        method);
    std::size_t total = 0;
    std::size_t wrong_total = 0;
    for (const CaseGroup& group : case_groups()) {
      GroupFigures f;
      for (const Outcome& o : outcomes) {
        if (o.method == method && o.group == group.name) f.add(o);
      }
      if (f.pairs == 0) continue;
      total += f.pairs;
      wrong_total += f.wrong;
      fmt::print("| {}{} | {} | {} | {} | {} | {} / {} | {} | {} | {} | {} / {} | {} |\n",
                 group.text,
                 group.must_refuse ? " (to be refused)" : "",
                 f.pairs,
                 f.right,
                 f.refused,
                 f.wrong,
                 figure(f.error_m, 0.5, 3),
                 figure(f.error_m, 0.95, 3),
                 figure(f.angle_deg, 0.95, 3),
                 figure(f.height_m, 0.95, 3),
                 figure(f.scale_percent, 0.95, 2),
                 figure(f.floor_m, 0.5, 3),
                 figure(f.places_m, 0.5, 3),
                 figure(f.cpu_s, 0.5, 1));
    }
    fmt::print("\n{} pairs, {} wrong answers given as right\n", total, wrong_total);
  }
  fmt::print("\npeak memory {:.0f} MB, simulation included\n", peak_memory_mb());
}

void write_json(const std::vector<Outcome>& outcomes, const std::string& path) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Outcome& o : outcomes) {
    nlohmann::ordered_json scores;
    for (const RegistrationScore& score : o.scores) scores[score.name] = score.value;
    rows.push_back({{"group", o.group},
                    {"seed", o.seed},
                    {"method", o.method},
                    {"ok", o.ok},
                    {"right", o.right},
                    {"at_centroid_m", o.errors.at_centroid_m},
                    {"horizontal_m", o.errors.horizontal_m},
                    {"vertical_m", o.errors.vertical_m},
                    {"rotation_deg", o.errors.rotation_deg},
                    {"floor_m", o.floor_m},
                    {"places_m", o.places_m},
                    {"scale_error", o.scale_error},
                    {"confidence", o.confidence},
                    {"cpu_s", o.cpu_s},
                    {"reason", o.reason},
                    {"scores", scores}});
  }
  std::ofstream(path) << rows.dump(1) << '\n';
}

}  // namespace hybridfusion::benchmark
