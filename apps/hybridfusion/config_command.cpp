#include "cli.hpp"

#include <hybridfusion/pipeline/options_file.hpp>

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hybridfusion::cli {

void add_config_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("config",
                                         "Prints every option with its value as YAML (--json: as "
                                         "JSON), as --config reads it; --config and --set are "
                                         "applied first, so it also checks a file.");
  auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "Reference table: unit, default, range, meaning");
  command->footer(
      help_footer("hybridfusion config > options.yaml\n  hybridfusion config --set "
                  "registration.max_offset_m=40",
                  "the file of --config, if given",
                  "nothing; the options on stdout"));
  command->callback([markdown, &chosen] {
    chosen = [markdown](Session& session) {
      if (*markdown && session.globals.json) {
        session.print_error("config: --markdown is a page for people; take one of it and --json");
        return kUsage;
      }
      fmt::print("{}",
                 *markdown              ? options_reference() + simulation_reference()
                 : session.globals.json ? to_json(session.options) + "\n"
                                        : to_yaml(session.options));
      return kDone;
    };
  });
}

}  // namespace hybridfusion::cli
