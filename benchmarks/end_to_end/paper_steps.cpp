/// What each step of the published chain keeps of the truth, as published and with each change
/// (docs/reference/registration-benchmark.md).

#include "pair_cases.hpp"
#include "paper_step_figures.hpp"
#include "process_meter.hpp"

#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/transform_json.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

struct Settings {
  std::vector<std::string> pairs = {};
  std::vector<std::uint64_t> seeds = {};
  std::vector<std::string> starts = {"start_5m"};
  std::vector<std::string> variants = {"published"};
  int threads = 1;
};

struct NamedPair {
  std::string name = {};
  PointCloud vision = {};
  PointCloud lidar = {};
  RegistrationInput input = {};
  Rigid3 truth = {};
};

/// None of the changes, to which some are added.
PaperImprovements alone() {
  return {.half_step_patches = false,
          .describe_spliced = false,
          .describe_above_m = 0.0,
          .best_candidates = 0,
          .min_overlap = 0.0};
}

/// Switches one change on; false when none is called so.
bool add_change(std::string_view name, PaperImprovements& changes) {
  if (name == "half_step_patches") {
    changes.half_step_patches = true;
  } else if (name == "describe_spliced") {
    changes.describe_spliced = true;
  } else if (name == "describe_above_m") {
    changes.describe_above_m = 2.0;
  } else if (name == "best_candidates") {
    changes.best_candidates = 5;
  } else if (name == "min_overlap") {
    changes.min_overlap = 0.5;
  } else {
    return false;
  }
  return true;
}

/// The published chain, the improved one as the options have it, or some changes joined by '+'.
Expected<RegistrationOptions> options_of(const std::string& variant) {
  RegistrationOptions options;
  options.method = "paper";
  if (variant == "published") return options;
  options.paper.variant = "improved";
  if (variant == "improved") return options;
  options.paper.improved = alone();
  for (const auto part : std::views::split(variant, '+')) {
    const std::string_view name(part.begin(), part.end());
    if (add_change(name, options.paper.improved)) continue;
    return fail(ErrorCode::kInvalidOptions, fmt::format("no variant is called '{}'", name));
  }
  return options;
}

const CaseGroup* group_of(const std::string& start) {
  const auto group = std::ranges::find(case_groups(), start, &CaseGroup::name);
  return group == case_groups().end() ? nullptr : &*group;
}

/// G.ply, L.ply and truth.json of a folder, with a start that is wrong as in the group.
Expected<NamedPair> read_pair(const std::filesystem::path& folder, const CaseGroup& group) {
  NamedPair pair{.name = fmt::format("{} {}", folder.filename().string(), group.name)};
  HF_TRY(pair.vision, read_ply(folder / "G.ply"));
  HF_TRY(pair.lidar, read_ply(folder / "L.ply"));
  HF_TRY(pair.truth, read_transform_json(folder / "truth.json", "vision_from_lidar"));
  Random random(1, pair.name);
  pair.input.vision_from_lidar_initial =
      wrong_start(pair.truth, centroid(pair.lidar), group, random);
  return pair;
}

Expected<NamedPair> simulated_pair(std::uint64_t seed,
                                   const CaseGroup& group,
                                   SceneCache& scenes,
                                   const RunContext& ctx) {
  HF_TRY(RegistrationPair pair, make_pair(group, seed, scenes, ctx));
  return NamedPair{.name = fmt::format("seed {} {}", seed, group.name),
                   .vision = std::move(pair.vision),
                   .lidar = std::move(pair.lidar),
                   .input = std::move(pair.input),
                   .truth = pair.truth.vision_from_lidar};
}

void print_row(const NamedPair& pair,
               const std::string& variant,
               const StepFigures& f,
               const RegistrationResult& result,
               double cpu_s) {
  const double n = std::max(1.0, static_cast<double>(f.num_patches));
  const auto mean = [&](std::size_t sum) { return static_cast<double>(sum) / n; };
  const auto percent = [&](std::size_t count) { return 100.0 * static_cast<double>(count) / n; };
  const RegistrationErrors errors =
      registration_errors(pair.truth, result.vision_from_lidar, centroid(pair.lidar));
  fmt::print(
      "| {} | {} | {} | {} -> {:.1f} -> {:.1f} -> {:.1f} | {:.0f} / {:.0f} / {:.0f} | {:.0f} / "
      "{:.0f} | {:.2f} | {} of {} | {} of {} | {} of {} | {} | {:.3f} m, {:.2f} deg | {:.1f} |\n",
      pair.name,
      variant,
      f.num_patches,
      f.num_cells,
      mean(f.in_ring),
      mean(f.correlated),
      mean(f.similar),
      percent(f.true_in_ring),
      percent(f.true_correlated),
      percent(f.true_similar),
      f.rank_median,
      f.rank_ring_median,
      f.auc,
      f.chosen_true,
      f.num_2d,
      f.right_2d,
      f.num_2d,
      f.right_3d,
      f.num_3d,
      result.status != RegistrationStatus::kOk ? "refused"
                                               : (errors.success() ? "ok" : "**wrong**"),
      errors.at_centroid_m,
      errors.rotation_deg,
      cpu_s);
  std::fflush(stdout);
}

Expected<void> run_pair(const NamedPair& pair, const Settings& settings) {
  const RunContext ctx{.num_threads = settings.threads};
  std::optional<DescribedScene> scene;
  PaperImprovements described;
  for (const std::string& variant : settings.variants) {
    HF_TRY(const RegistrationOptions options, options_of(variant));
    const double before = cpu_seconds();
    HF_TRY(const RegistrationResult result,
           register_cross_source(pair.vision, pair.lidar, pair.input, options, ctx));
    const double cpu_s = cpu_seconds() - before;
    const PaperImprovements changes =
        options.paper.variant == "improved" ? options.paper.improved : alone();
    if (!scene || changes.half_step_patches != described.half_step_patches ||
        changes.describe_spliced != described.describe_spliced ||
        changes.describe_above_m != described.describe_above_m) {
      HF_TRY(scene, describe_scene(pair.vision, pair.lidar, pair.input, options, ctx));
      described = changes;
    }
    const StepFigures figures = paper_step_figures(*scene, options.paper, result, pair.truth);
    print_row(pair, variant, figures, result, cpu_s);
  }
  return {};
}

Expected<void> run(const Settings& settings) {
  fmt::print(
      "| pair | variant | LiDAR patches | cells -> ring -> descriptor -> neighbours | true cell "
      "kept by each [%] | median rank of the true cell: of all / in the ring | AUC | true cell "
      "chosen | 2D poses right | 3D poses right | answer | error | CPU s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const RunContext ctx{.num_threads = settings.threads};
  for (const std::string& start : settings.starts) {
    const CaseGroup* group = group_of(start);
    if (!group) return fail(ErrorCode::kInvalidOptions, "no start is called '" + start + "'");
    for (const std::string& folder : settings.pairs) {
      HF_TRY(const NamedPair pair, read_pair(folder, *group));
      if (auto done = run_pair(pair, settings); !done) return done;
    }
  }
  for (const std::uint64_t seed : settings.seeds) {
    SceneCache scenes;
    for (const std::string& start : settings.starts) {
      HF_TRY(const NamedPair pair, simulated_pair(seed, *group_of(start), scenes, ctx));
      if (auto done = run_pair(pair, settings); !done) return done;
    }
  }
  return {};
}

}  // namespace
}  // namespace hybridfusion::benchmark

int main(int argc, char** argv) try {
  hybridfusion::benchmark::Settings settings;
  CLI::App app("Follows the truth through the steps of the published registration chain.");
  app.add_option("pairs", settings.pairs, "Folders with G.ply, L.ply and truth.json");
  app.add_option("--seeds", settings.seeds, "Simulated pairs")->delimiter(',');
  app.add_option("--starts", settings.starts, "Groups of registration_pairs that give the start")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option(
         "--variants",
         settings.variants,
         "published, improved, or changes joined by +: half_step_patches, describe_spliced, "
         "describe_above_m, best_candidates, min_overlap")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "Threads of a registration")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const auto done = hybridfusion::benchmark::run(settings);
  if (!done) fmt::print(stderr, "{}\n", done.error().message);
  return done ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
