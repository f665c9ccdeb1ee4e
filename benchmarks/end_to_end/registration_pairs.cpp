/// Registers simulated pairs by every method and counts right, refused and wrong answers
/// (docs/reference/registration-benchmark.md).

#include "pair_cases.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace hybridfusion::benchmark {
namespace {

struct Settings {
  int scenes = 9;
  std::uint64_t first_seed = 1;
  std::vector<std::string> methods = {"hybrid"};
  std::vector<std::string> only = {};
  std::string json = {};
  int threads = 1;
  bool strict = false;  ///< Anything but right answers and due refusals is an error.
};

/// One registration.
struct Outcome {
  std::string group;
  std::uint64_t seed = 0;
  std::string method;
  bool ok = false;     ///< The method vouches for its pose.
  bool right = false;  ///< Within 1 m and 2 degrees of the truth.
  RegistrationErrors errors = {};
  double floor_m = 0.0;
  double places_m =
      0.0;  ///< Root mean square distance of the straightened LiDAR cloud to its place.
  double scale_error = 0.0;
  double confidence = 0.0;
  double cpu_s = 0.0;
  std::string reason = {};
  std::vector<RegistrationScore> scores = {};
};

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

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

/// How far the LiDAR points end up from where they belong in the vision cloud; after a scale was
/// found the places are those in the rescaled cloud.
double distance_to_places(const RegistrationPair& pair,
                          const RegistrationResult& result,
                          const RunContext& ctx) {
  const auto straight = without_drift(pair.lidar, result.drift, pair.input.sensor_positions, ctx);
  if (!straight) return 0.0;
  const Sim3 lidar_from_vision = result.lidar_from_vision_similarity;
  double squares = 0.0;
  for (std::size_t k = 0; k < pair.checked.size(); ++k) {
    const Eigen::Vector3d place = lidar_from_vision * pair.places_in_vision[k];
    squares += (straight->points[pair.checked[k]].cast<double>() - place).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, pair.checked.size())));
}

Outcome run_one(const CaseGroup& group,
                std::uint64_t seed,
                const std::string& method,
                const RegistrationPair& pair,
                const RunContext& ctx) {
  // Nothing is known but the start: every heading, and a little more than the farthest start.
  RegistrationOptions options;
  options.method = method;
  options.max_offset_m = 40.0;
  options.max_yaw_rad = std::numbers::pi;
  Outcome outcome{.group = std::string(group.name), .seed = seed, .method = method};
  const double before = cpu_seconds();
  const auto result = register_cross_source(pair.vision, pair.lidar, pair.input, options, ctx);
  outcome.cpu_s = cpu_seconds() - before;
  if (!result) {
    outcome.reason = result.error().message;
    return outcome;
  }
  outcome.ok = result->status == RegistrationStatus::kOk;
  outcome.reason = result->reason;
  outcome.confidence = result->confidence;
  outcome.scores = result->scores;
  outcome.floor_m = pair.truth.floor_rmse_m;
  outcome.errors = registration_errors(
      pair.truth.vision_from_lidar, result->vision_from_lidar, pair.truth.centroid_in_lidar);
  outcome.right = !group.must_refuse && outcome.errors.success();
  outcome.places_m = distance_to_places(pair, *result, ctx);
  if (result->vision_scale_supported) {
    outcome.scale_error = result->vision_scale * group.scale - 1.0;
  } else {
    outcome.scale_error = group.scale - 1.0;
  }
  return outcome;
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

void print_table(const std::vector<Outcome>& outcomes, const Settings& settings) {
  for (const std::string& method : settings.methods) {
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

void say(const Outcome& o) {
  fmt::print(stderr,
             "{} seed {} {}: {}{} {:.3f} m {:.2f} deg, confidence {:.2f}, {:.1f} CPU s {}\n",
             o.group,
             o.seed,
             o.method,
             o.ok ? "ok" : "refused",
             o.ok && !o.right ? " WRONG" : "",
             o.errors.at_centroid_m,
             o.errors.rotation_deg,
             o.confidence,
             o.cpu_s,
             o.reason);
}

/// All groups on the scene of one seed. @returns false when a pair cannot be made.
bool run_seed(std::uint64_t seed,
              bool only_refusals,
              const Settings& settings,
              std::vector<Outcome>& outcomes) {
  const RunContext ctx{.num_threads = settings.threads};
  SceneCache scenes;
  for (const CaseGroup& group : case_groups()) {
    const bool wanted = settings.only.empty() ||
                        std::ranges::find(settings.only, group.name) != settings.only.end();
    if (!wanted || (only_refusals && !group.must_refuse)) continue;
    const auto pair = make_pair(group, seed, scenes, ctx);
    if (!pair) {
      fmt::print(stderr, "{} seed {}: {}\n", group.name, seed, pair.error().message);
      return false;
    }
    for (const std::string& method : settings.methods) {
      outcomes.push_back(run_one(group, seed, method, *pair, ctx));
      say(outcomes.back());
    }
  }
  return true;
}

int run(const Settings& settings) {
  std::vector<Outcome> outcomes;
  // Six groups must be refused, fourteen not: about as many pairs of either kind.
  for (int i = 0; i < 2 * settings.scenes; ++i) {
    const std::uint64_t seed = settings.first_seed + static_cast<std::uint64_t>(i);
    if (!run_seed(seed, i >= settings.scenes, settings, outcomes)) return 1;
  }
  print_table(outcomes, settings);
  if (!settings.json.empty()) write_json(outcomes, settings.json);
  const auto is_good = [](const Outcome& o) {
    const auto group = std::ranges::find(case_groups(), o.group, &CaseGroup::name);
    return group->must_refuse ? !o.ok : o.ok && o.right;
  };
  return !settings.strict || std::ranges::all_of(outcomes, is_good) ? 0 : 1;
}

}  // namespace
}  // namespace hybridfusion::benchmark

int main(int argc, char** argv) try {
  hybridfusion::benchmark::Settings settings;
  CLI::App app("Registers simulated pairs of vision and LiDAR clouds and counts what came out.");
  app.add_option("--scenes",
                 settings.scenes,
                 "Pairs of each group; twice as many of those that must be refused")
      ->capture_default_str();
  app.add_option("--first-seed", settings.first_seed, "Seed of the first scene")
      ->capture_default_str();
  app.add_option("--methods", settings.methods, "hybrid, paper, gicp, ndt")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--only", settings.only, "Groups to run")->delimiter(',');
  app.add_flag("--strict", settings.strict, "Exit 1 unless every answer is right or a due refusal");
  app.add_option("--json", settings.json, "File for every single outcome");
  app.add_option("--threads", settings.threads, "Threads of a registration")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return hybridfusion::benchmark::run(settings);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
