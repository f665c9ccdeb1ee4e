#include "cli.hpp"
#include "console.hpp"
#include "signals.hpp"

#include <hybridfusion/pipeline/options_file.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>

#include <csignal>
#include <exception>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hybridfusion::cli {
namespace {

void add_global_options(CLI::App& app, GlobalOptions& globals) {
  app.add_option("--config", globals.config, "YAML file with options (see `hybridfusion config`)");
  app.add_option("--set", globals.settings, "One option: group.option=value (repeatable)")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--threads", globals.threads, "Threads; 0 uses every core")
      ->check(CLI::Range(0, 1024));
  app.add_option("--seed", globals.seed, "Seed of every random choice");
  auto* quiet = app.add_flag("--quiet", globals.quiet, "Only errors on stderr");
  app.add_flag("--verbose", globals.verbose, "Details on stderr")->excludes(quiet);
  app.add_flag("--json", globals.json, "The result as one JSON object on stdout");
  app.set_version_flag("--version", "hybridfusion " + std::string(program_version()));
  app.fallthrough();  // they may also stand behind the command
}

Expected<void> apply_globals(const GlobalOptions& globals, PipelineOptions& options) {
  if (!globals.config.empty()) {
    if (auto loaded = load_options(globals.config, options); !loaded) return loaded;
  }
  for (const std::string& setting : globals.settings) {
    if (setting.starts_with(kSimulationPrefix)) continue;  // read by that command
    if (auto set = apply_setting(setting, options); !set) return set;
  }
  return {};
}

int execute(const Command& command, const GlobalOptions& globals) {
  const SignalWatch signals;
  Console console(globals);
  PipelineOptions options;
  Session session{.globals = globals, .options = options};
  session.context.log = [&](LogLevel level, std::string_view text) { console.log(level, text); };
  session.context.progress = [&](const ProgressEvent& event) { console.progress(event); };
  session.context.stop = signals.token();
  session.context.num_threads = globals.threads;
  session.context.seed = globals.seed;
  session.print_error = [&](std::string_view text) { console.error(text); };
  try {
    if (auto applied = apply_globals(globals, options); !applied) {
      return report_error(session, applied.error());
    }
    const int code = command(session);
    if (code == kInterrupted && signals.signal() == SIGTERM) return kTerminated;
    return code;
  } catch (const std::bad_alloc&) {
    console.error("out of memory; close other programs, use fewer --threads or a smaller data set");
    return kOutOfResource;
  } catch (const std::exception& error) {
    console.error(fmt::format("internal error: {}; please report it", error.what()));
    return kInternal;
  }
}

}  // namespace
}  // namespace hybridfusion::cli

int main(int argc, char** argv) {
  using namespace hybridfusion::cli;
  CLI::App app{"Fuses drone photos and a street LiDAR recording into one point cloud.",
               "hybridfusion"};
  GlobalOptions globals;
  Command chosen;
  add_global_options(app, globals);
  app.require_subcommand(1);
  add_run_command(app, chosen);
  add_reconstruct_command(app, chosen);
  add_map_command(app, chosen);
  add_register_command(app, chosen);
  add_evaluate_command(app, chosen);
  add_convert_command(app, chosen);
  add_config_command(app, chosen);
  add_simulate_command(app, chosen);
  add_view_command(app, chosen);
  add_doctor_command(app, chosen);
  add_completion_command(app, chosen);
  app.footer(
      "Example:\n"
      "  hybridfusion run --images flight/ --bag street.bag --output result/\n"
      "`hybridfusion COMMAND --help` tells what a command reads and writes.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kUsage;
  }
  return execute(chosen, globals);
}
