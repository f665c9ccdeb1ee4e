/// Registers simulated pairs by every method and counts right, refused and wrong answers
/// (docs/reference/registration-benchmark.md).

#include "pair_cases.hpp"
#include "pair_table.hpp"
#include "process_meter.hpp"
#include "settings.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

struct Settings {
  int scenes = 9;
  std::uint64_t first_seed = 1;
  std::vector<std::string> methods = {"hybrid"};
  std::vector<std::string> only = {};
  std::vector<std::string> set = {};
  std::string json = {};
  std::string from_json = {};
  int threads = 1;
  bool resume = false;
  bool strict = false;  ///< Anything but right answers and due refusals is an error.
};

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

/// Nothing is known but the start: every heading, and a little more than the farthest start.
Expected<RegistrationOptions> options_of(const std::string& method,
                                         const std::vector<std::string>& settings) {
  RegistrationOptions options;
  options.method = method;
  if (method == "paper-improved") {
    options.method = "paper";
    options.paper.variant = "improved";
  }
  options.max_offset_m = 40.0;
  options.max_yaw_rad = std::numbers::pi;
  if (auto applied = apply_settings(settings, options); !applied) {
    return std::unexpected(applied.error());
  }
  return options;
}

double heading_rad(const Rigid3& pose) {
  const Eigen::Vector3d forward = pose.rotation * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

Outcome run_one(const CaseGroup& group,
                std::uint64_t seed,
                const std::string& method,
                const RegistrationOptions& options,
                const RegistrationPair& pair,
                const RunContext& ctx) {
  Outcome outcome{.group = std::string(group.name), .seed = seed, .method = method};
  const MemoryMeter memory;
  const double before = cpu_seconds();
  const auto result = register_cross_source(pair.vision, pair.lidar, pair.input, options, ctx);
  outcome.cpu_s = cpu_seconds() - before;
  outcome.memory_mb = memory.peak_mb();
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
  const Rigid3 error = pair.truth.vision_from_lidar.inverse() * result->vision_from_lidar;
  outcome.yaw_deg = 180.0 / std::numbers::pi * heading_rad(error);
  outcome.right = !group.must_refuse() && outcome.errors.success();
  outcome.places_m = distance_to_places(pair, *result, ctx);
  if (result->vision_scale_supported) {
    outcome.scale_error = result->vision_scale * group.scale - 1.0;
  } else {
    outcome.scale_error = group.scale - 1.0;
  }
  return outcome;
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
    if (!wanted || (only_refusals && !group.must_refuse())) continue;
    std::vector<std::string> missing;  // of a run that was stopped; all methods without one
    std::ranges::copy_if(
        settings.methods, std::back_inserter(missing), [&](const std::string& method) {
          return std::ranges::none_of(outcomes, [&](const Outcome& o) {
            return o.seed == seed && o.group == group.name && o.method == method;
          });
        });
    if (missing.empty()) continue;
    const auto pair = make_pair(group, seed, scenes, ctx);
    if (!pair) {
      fmt::print(stderr, "{} seed {}: {}\n", group.name, seed, pair.error().message);
      return false;
    }
    for (const std::string& method : missing) {
      const auto options = options_of(method, settings.set);
      if (!options) {
        fmt::print(stderr, "{}\n", options.error().message);
        return false;
      }
      outcomes.push_back(run_one(group, seed, method, *options, *pair, ctx));
      say(outcomes.back());
    }
  }
  return true;
}

int tabulate(const std::string& path, const std::vector<std::string>& methods) {
  const auto outcomes = read_json(path);
  if (!outcomes) {
    fmt::print(stderr, "{}\n", outcomes.error().message);
    return 1;
  }
  print_table(*outcomes, methods);
  print_goals(*outcomes, methods.front());
  print_calibration(*outcomes, methods);
  return 0;
}

/// The outcomes of a run that was stopped.
Expected<std::vector<Outcome>> finished_outcomes(const Settings& settings) {
  if (!settings.resume || !std::filesystem::exists(settings.json)) return std::vector<Outcome>{};
  auto outcomes = read_json(settings.json);
  if (!outcomes) return outcomes;
  for (const Outcome& o : *outcomes) {
    if (std::ranges::find(settings.methods, o.method) == settings.methods.end()) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("{} holds outcomes of {}: give the methods of the run it is of",
                              settings.json,
                              o.method));
    }
  }
  return outcomes;
}

int run(const Settings& settings) {
  if (!settings.from_json.empty()) return tabulate(settings.from_json, settings.methods);
  auto finished = finished_outcomes(settings);
  if (!finished) {
    fmt::print(stderr, "{}\n", finished.error().message);
    return 1;
  }
  std::vector<Outcome> outcomes = std::move(*finished);
  // Six groups must be refused, fourteen not: about as many pairs of either kind.
  for (int i = 0; i < 2 * settings.scenes; ++i) {
    const std::uint64_t seed = settings.first_seed + static_cast<std::uint64_t>(i);
    if (!run_seed(seed, i >= settings.scenes, settings, outcomes)) return 1;
    // After every scene: a long run that is stopped keeps what it has.
    if (settings.json.empty()) continue;
    if (const auto written = write_json(outcomes, settings.json); !written) {
      fmt::print(stderr, "{}\n", written.error().message);
      return 1;
    }
  }
  print_table(outcomes, settings.methods);
  print_goals(outcomes, settings.methods.front());
  print_calibration(outcomes, settings.methods);
  const auto is_good = [](const Outcome& o) {
    const auto group = std::ranges::find(case_groups(), o.group, &CaseGroup::name);
    return group->must_refuse() ? !o.ok : o.ok && o.right;
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
  app.add_option("--methods", settings.methods, "hybrid, paper, paper-improved, gicp, ndt")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--only", settings.only, "Groups to run")->delimiter(',');
  app.add_flag("--strict", settings.strict, "Exit 1 unless every answer is right or a due refusal");
  app.add_option("--set", settings.set, "Option of every registration, key=value");
  auto* json = app.add_option("--json", settings.json, "File for every single outcome");
  app.add_flag(
         "--resume",
         settings.resume,
         "Leave out what the file of --json holds from a run that was stopped, with the same --set")
      ->needs(json);
  app.add_option("--from-json",
                 settings.from_json,
                 "Register nothing: the tables of the outcomes in this file");
  app.add_option("--threads", settings.threads, "Threads of a registration")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return hybridfusion::benchmark::run(settings);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
