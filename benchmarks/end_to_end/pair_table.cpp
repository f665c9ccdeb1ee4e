#include "pair_table.hpp"

#include "quantile.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::benchmark {
namespace {

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
  std::vector<double> memory_mb = {};

  void add(const Outcome& o) {
    ++pairs;
    cpu_s.push_back(o.cpu_s);
    if (o.memory_mb > 0.0) memory_mb.push_back(o.memory_mb);
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
    GroupFigures all;
    for (const CaseGroup& group : case_groups()) {
      GroupFigures f;
      for (const Outcome& o : outcomes) {
        if (o.method != method || o.group != group.name) continue;
        f.add(o);
        all.add(o);
      }
      if (f.pairs == 0) continue;
      fmt::print("| {}{} | {} | {} | {} | {} | {} / {} | {} | {} | {} | {} / {} | {} |\n",
                 group.text,
                 group.must_refuse() ? " (to be refused)" : "",
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
    fmt::print(
        "\n{} pairs, {} wrong answers given as right; CPU s median {}, 95 % {}, most {}; "
        "memory of a registration [MB] median {}, 95 % {}, most {}\n",
        all.pairs,
        all.wrong,
        figure(all.cpu_s, 0.5, 1),
        figure(all.cpu_s, 0.95, 1),
        figure(all.cpu_s, 1.0, 1),
        figure(all.memory_mb, 0.5, 0),
        figure(all.memory_mb, 0.95, 0),
        figure(all.memory_mb, 1.0, 0));
  }
}

Expected<std::vector<Outcome>> read_json(const std::string& path) {
  std::ifstream file(path);
  if (!file) return fail(ErrorCode::kNotFound, fmt::format("{}: cannot be read", path));
  std::vector<Outcome> outcomes;
  try {
    for (const auto& row : nlohmann::json::parse(file)) {
      Outcome o{.group = row.at("group"), .seed = row.at("seed"), .method = row.at("method")};
      o.ok = row.at("ok");
      o.right = row.at("right");
      o.errors = {.at_centroid_m = row.at("at_centroid_m"),
                  .horizontal_m = row.at("horizontal_m"),
                  .vertical_m = row.at("vertical_m"),
                  .rotation_deg = row.at("rotation_deg")};
      // Files of before know the whole rotation only, which is never less.
      o.yaw_deg = row.value("yaw_deg", o.errors.rotation_deg);
      o.floor_m = row.at("floor_m");
      o.places_m = row.at("places_m");
      o.scale_error = row.at("scale_error");
      o.confidence = row.at("confidence");
      o.cpu_s = row.at("cpu_s");
      o.memory_mb = row.value("memory_mb", 0.0);
      o.reason = row.at("reason");
      for (const auto& [name, value] : row.at("scores").items()) {
        o.scores.push_back({name, value.is_number() ? value.get<double>() : 0.0});
      }
      outcomes.push_back(std::move(o));
    }
  } catch (const nlohmann::json::exception& error) {
    return fail(ErrorCode::kParse, fmt::format("{}: {}", path, error.what()));
  }
  return outcomes;
}

Expected<void> write_json(const std::vector<Outcome>& outcomes, const std::string& path) {
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
                    {"yaw_deg", o.yaw_deg},
                    {"floor_m", o.floor_m},
                    {"places_m", o.places_m},
                    {"scale_error", o.scale_error},
                    {"confidence", o.confidence},
                    {"cpu_s", o.cpu_s},
                    {"memory_mb", o.memory_mb},
                    {"reason", o.reason},
                    {"scores", scores}});
  }
  return write_file_atomically(path, rows.dump(1) + '\n');
}

}  // namespace hybridfusion::benchmark
