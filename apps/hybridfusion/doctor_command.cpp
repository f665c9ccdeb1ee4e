#include "cli.hpp"

#include <hybridfusion/pipeline/doctor.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

struct DoctorArguments {
  std::string images = {};
  std::string geo = {};
  std::string gcp = {};
  std::string bag = {};
  std::string sensors = {};
  std::string workspace = {};
  bool list = false;
};

int exit_code_of(const DoctorReport& report) {
  if (!report.has_errors()) return kDone;
  return report.only_resource_errors() ? kOutOfResource : kBadInput;
}

void print_json(const DoctorReport& report) {
  const int code = exit_code_of(report);
  nlohmann::ordered_json json = {{"status", code == kDone ? "ok" : "problems"},
                                 {"exit_code", code}};
  json.update(nlohmann::ordered_json::parse(to_json(report)));
  fmt::print("{}\n", json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_text(const DoctorReport& report) {
  for (const std::string& fact : report.facts) fmt::print("{}\n", fact);
  for (const Finding& finding : report.findings) {
    fmt::print("\n{} {}\n  {}\n  -> {}\n",
               to_string(finding.severity),
               finding.id,
               finding.cause,
               finding.remedy);
  }
  const auto errors = std::ranges::count(report.findings, Severity::kError, &Finding::severity);
  fmt::print("\n{} errors, {} warnings\n",
             errors,
             static_cast<std::ptrdiff_t>(report.findings.size()) - errors);
}

int run_doctor(const DoctorArguments& arguments, Session& session) {
  if (arguments.list) {
    fmt::print("{}", findings_reference());
    return kDone;
  }
  const auto report = examine({.images = optional_path(arguments.images),
                               .geo_tags = optional_path(arguments.geo),
                               .control = optional_path(arguments.gcp),
                               .bag = optional_path(arguments.bag),
                               .sensors = optional_path(arguments.sensors),
                               .workspace = optional_path(arguments.workspace)},
                              session.options,
                              session.context);
  if (!report) return report_error(session, report.error());
  if (session.globals.json) {
    print_json(*report);
  } else {
    print_text(*report);
  }
  return exit_code_of(*report);
}

}  // namespace

void add_doctor_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "doctor",
      "Finds what would go wrong before an hour is spent. Reads photos, their positions and ground "
      "control, recording and sensors.yaml "
      "as far as they are given, looks at memory, disk and workspace, and tells each problem with "
      "cause and remedy. Writes nothing. Exit code 3 when an input would fail the run, 5 when only "
      "memory, disk or workspace would; warnings alone are 0.");
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::Option* images = command->add_option(
      "--images", arguments->images, "Folder of JPEG photos, searched with its subfolders");
  command
      ->add_option("--geo", arguments->geo, "Positions of the photos (default: geo.txt in IMAGES)")
      ->needs(images);
  command
      ->add_option(
          "--gcp", arguments->gcp, "Ground control points (default: gcp_list.txt in IMAGES)")
      ->needs(images);
  command->add_option("--bag", arguments->bag, "ROS 1 bag with LiDAR, IMU and GNSS");
  command->add_option(
      "--sensors", arguments->sensors, "sensors.yaml (default: the one beside the bag)");
  command->add_option("workspace", arguments->workspace, "Workspace that the run would write");
  command->add_flag("--list", arguments->list, "Print every possible finding as a table, and end");
  command->footer(
      help_footer("hybridfusion doctor --images flight/ --bag street.bag result/",
                  "photos, geo.txt, gcp_list.txt, recording, sensors.yaml; WORKSPACE/run.json",
                  "nothing; the findings on stdout"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return run_doctor(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
