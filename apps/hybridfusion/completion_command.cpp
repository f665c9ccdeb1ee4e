#include "cli.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

struct Choice {
  std::string name = {};         ///< "--method"
  std::string description = {};  ///< First sentence, without line breaks.
  bool takes_value = false;
  std::vector<std::string> values = {};  ///< Empty: any, completed as a file name.
};

struct CommandTree {
  std::string name = {};
  std::string description = {};
  std::vector<Choice> options = {};
  bool takes_arguments = false;
};

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  const std::size_t end = std::min(text.find(". "), text.find(": "));
  return end == std::string::npos ? text : text.substr(0, end);
}

/// The members of an IsMember check, which CLI11 shows as "TEXT:{small,paper,city}".
std::vector<std::string> values_of(const std::string& type) {
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  std::vector<std::string> values;
  if (begin == std::string::npos || end == std::string::npos) return values;
  for (std::size_t at = begin + 1; at < end;) {
    const std::size_t comma = std::min(end, type.find(',', at));
    values.push_back(type.substr(at, comma - at));
    at = comma + 1;
  }
  return values;
}

CommandTree tree_of(const CLI::App& app) {
  CommandTree tree{.name = app.get_name(), .description = one_line(app.get_description())};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_lnames().empty()) {
      tree.takes_arguments = true;
      continue;
    }
    tree.options.push_back({.name = "--" + option->get_lnames().front(),
                            .description = one_line(option->get_description()),
                            .takes_value = option->get_type_size() != 0,
                            .values = values_of(option->get_type_name())});
  }
  return tree;
}

struct ProgramTree {
  CommandTree common = {};
  std::vector<CommandTree> commands = {};
};

ProgramTree tree_of_program(const CLI::App& app) {
  ProgramTree tree{.common = tree_of(app)};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    tree.commands.push_back(tree_of(*command));
  }
  return tree;
}

std::vector<std::string> names_of(const ProgramTree& tree) {
  std::vector<std::string> names;
  for (const CommandTree& command : tree.commands) names.push_back(command.name);
  return names;
}

std::string bash_case(const std::string& command, const Choice& option) {
  if (!option.takes_value) return {};
  const std::string reply = option.values.empty() ? "compgen -f -- \"$current\""
                                                  : fmt::format("compgen -W '{}' -- \"$current\"",
                                                                fmt::join(option.values, " "));
  return fmt::format(
      "    {}:{}) mapfile -t COMPREPLY < <({}); return ;;\n", command, option.name, reply);
}

std::string bash_script(const ProgramTree& tree) {
  std::string values;
  std::string options;
  for (const Choice& option : tree.common.options) values += bash_case("*", option);
  for (const CommandTree& command : tree.commands) {
    std::vector<std::string> names;
    for (const Choice& option : command.options) {
      values += bash_case(command.name, option);
      names.push_back(option.name);
    }
    options += fmt::format("    {}) words=\"{}\" ;;\n", command.name, fmt::join(names, " "));
  }
  std::vector<std::string> common;
  for (const Choice& option : tree.common.options) common.push_back(option.name);
  return fmt::format(
      R"(# bash completion of hybridfusion, made from its command tree by `hybridfusion completion bash`
_hybridfusion() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command= words= word
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case " {commands} " in *" $word "*) command=$word; break ;; esac
  done
  case $command:$previous in
{values}  esac
  if [[ -z $command ]]; then
    mapfile -t COMPREPLY < <(compgen -W "{commands} {common}" -- "$current")
    return
  fi
  case $command in
{options}  esac
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words {common}" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}
complete -o filenames -F _hybridfusion hybridfusion
)",
      fmt::arg("commands", fmt::join(names_of(tree), " ")),
      fmt::arg("common", fmt::join(common, " ")),
      fmt::arg("values", values),
      fmt::arg("options", options));
}

/// What zsh's _arguments reads as its own is taken out of a description.
std::string zsh_text(std::string text) {
  std::erase_if(text, [](char c) { return c == '\'' || c == '[' || c == ']' || c == ':'; });
  return text;
}

std::string zsh_option(const Choice& option) {
  std::string value;
  if (option.takes_value) {
    value = option.values.empty() ? ":value:_files"
                                  : fmt::format(":value:({})", fmt::join(option.values, " "));
  }
  return fmt::format("'{}[{}]{}'", option.name, zsh_text(option.description), value);
}

std::string zsh_script(const ProgramTree& tree) {
  std::vector<std::string> common;
  for (const Choice& option : tree.common.options) common.push_back(zsh_option(option));
  std::string commands;
  std::string cases;
  for (const CommandTree& command : tree.commands) {
    commands += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.description));
    std::vector<std::string> arguments;
    for (const Choice& option : command.options) arguments.push_back(zsh_option(option));
    if (command.takes_arguments) arguments.emplace_back("'*:file:_files'");
    cases +=
        fmt::format("    {}) _arguments $common {} ;;\n", command.name, fmt::join(arguments, " "));
  }
  return fmt::format(R"(#compdef hybridfusion
# zsh completion of hybridfusion, made from its command tree by `hybridfusion completion zsh`
_hybridfusion() {{
  local -a common commands
  common=({common})
  commands=(
{commands}  )
  local command=${{words[(r)({names})]}}
  case $command in
{cases}    *) _arguments $common '1:command:{{_describe command commands}}' ;;
  esac
}}
_hybridfusion "$@"
)",
                     fmt::arg("common", fmt::join(common, " ")),
                     fmt::arg("commands", commands),
                     fmt::arg("names", fmt::join(names_of(tree), "|")),
                     fmt::arg("cases", cases));
}

}  // namespace

void add_completion_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "completion", "Prints what a shell needs to complete commands, options and their values.");
  auto what = std::make_shared<std::string>();
  command->add_option("shell", *what, "bash or zsh; commands: only their names, one a line")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "commands"}));
  command->footer(help_footer("source <(hybridfusion completion bash)", "nothing", "nothing"));
  command->callback([what, &app, &chosen] {
    chosen = [what, &app](Session& session) {
      const ProgramTree tree = tree_of_program(app);
      const std::string text = *what == "bash" ? bash_script(tree)
                               : *what == "zsh"
                                   ? zsh_script(tree)
                                   : fmt::format("{}\n", fmt::join(names_of(tree), "\n"));
      if (session.globals.json) {
        const nlohmann::ordered_json json = {
            {"status", "ok"}, {"commands", names_of(tree)}, {"text", text}};
        fmt::print("{}\n", json.dump(1));
      } else {
        fmt::print("{}", text);
      }
      return kDone;
    };
  });
}

}  // namespace hybridfusion::cli
