#include "cli.hpp"

#include <hybridfusion/io/point_cloud_file.hpp>

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

struct ConvertArguments {
  std::string in = {};
  std::string out = {};
};

int convert(const ConvertArguments& arguments, Session& session) {
  const auto cloud = read_point_cloud(arguments.in);
  if (!cloud) return report_error(session, cloud.error());
  if (const auto written = write_point_cloud(arguments.out, *cloud); !written) {
    return report_error(session, written.error());
  }
  if (session.globals.json) {
    const nlohmann::ordered_json json = {
        {"status", "ok"}, {"num_points", cloud->size()}, {"output", arguments.out}};
    fmt::print("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    fmt::print("{}: {} points\n", arguments.out, cloud->size());
  }
  return kDone;
}

}  // namespace

void add_convert_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "convert",
      "Point cloud formats by extension: reads .ply .pcd .xyz .txt .csv .pts, writes .ply .pcd "
      ".xyz .las.");
  auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("in", arguments->in, "Cloud to read")->required();
  command->add_option("out", arguments->out, "Cloud to write")->required();
  command->footer(help_footer("hybridfusion convert cloud.pcd cloud.ply",
                              "IN: .ply .pcd .xyz .txt .csv .pts",
                              "OUT: .ply .pcd .xyz .las; it is replaced when it is complete"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return convert(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
