#include "cli.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

using Json = nlohmann::ordered_json;

int exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidOptions:
      return kUsage;
    case ErrorCode::kNotFound:
    case ErrorCode::kParse:
    case ErrorCode::kInsufficient:
    case ErrorCode::kDegenerate:
      return kBadInput;
    case ErrorCode::kIo:
      return kOutOfResource;
    case ErrorCode::kCancelled:
      return kInterrupted;
  }
  return kInternal;
}

void print_json(const Json& json) {
  fmt::print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
}

void print_summary(const StageOutcome& outcome) {
  fmt::print("{}{} ({:.1f} s, {:.1f} CPU s, {:.0f} MiB)\n",
             outcome.stage,
             outcome.refused      ? ": refused"
             : outcome.up_to_date ? ": up to date"
                                  : ": done",
             outcome.cost.wall_s,
             outcome.cost.cpu_s,
             outcome.cost.peak_memory_mib);
  for (const std::string& line : outcome.summary) fmt::print("  {}\n", line);
  std::fflush(stdout);
}

Json json_of(const StageOutcome& outcome) {
  return {{"status", outcome.refused ? "refused" : "ok"},
          {"up_to_date", outcome.up_to_date},
          {"seconds", outcome.cost.wall_s},
          {"cpu_seconds", outcome.cost.cpu_s},
          {"peak_memory_mib", outcome.cost.peak_memory_mib},
          {"result", Json::parse(outcome.result_json)}};
}

}  // namespace

std::string help_footer(const std::string& example,
                        const std::string& reads,
                        const std::string& writes) {
  return fmt::format(
      "{}{}Example:\n  {}\n\n"
      "Options common to all commands:\n"
      "  --config FILE --set group.option=value --threads N --seed N --quiet --verbose --json\n"
      "Exit codes: 0 done, 2 wrong usage, 3 unusable input, 4 no reliable result, 5 out of disk\n"
      "or memory, 70 internal error, 130/143 interrupted (run again to resume).",
      reads.empty() ? "" : "Reads:\n  " + reads + "\n\n",
      writes.empty() ? "" : "Writes:\n  " + writes + "\n\n",
      example);
}

int report_error(const Session& session, const Error& error) {
  const int code = exit_code_of(error.code);
  if (session.print_error) session.print_error(error.message);
  if (session.globals.json) {
    print_json({{"status", "error"},
                {"exit_code", code},
                {"code", to_string(error.code)},
                {"message", error.message}});
  }
  return code;
}

void print_outcome(const Session& session, const StageOutcome& outcome) {
  if (session.globals.json) {
    print_json(
        {{"status", "ok"}, {"exit_code", kDone}, {"result", Json::parse(outcome.result_json)}});
    return;
  }
  for (const std::string& line : outcome.summary) fmt::print("{}\n", line);
}

int run_stages(Session& session,
               const std::string& output,
               const std::vector<std::string>& forced,
               const std::vector<std::function<Expected<StageOutcome>(Project&)>>& stages) {
  auto workspace = Workspace::open(output);
  if (!workspace) return report_error(session, workspace.error());
  Project project{.workspace = *std::move(workspace), .options = session.options, .forced = forced};
  Json results = Json::object();
  bool refused = false;
  for (const auto& stage : stages) {
    const auto outcome = stage(project);
    if (!outcome) return report_error(session, outcome.error());
    refused = refused || outcome->refused;
    results[outcome->stage] = json_of(*outcome);
    if (!session.globals.json) print_summary(*outcome);
  }
  if (auto report = write_report(project, session.context); !report) {
    return report_error(session, report.error());
  }
  const int code = refused ? kRefused : kDone;
  if (session.globals.json) {
    print_json({{"status", refused ? "refused" : "ok"},
                {"exit_code", code},
                {"workspace", output},
                {"stages", results}});
  }
  return code;
}

}  // namespace hybridfusion::cli
