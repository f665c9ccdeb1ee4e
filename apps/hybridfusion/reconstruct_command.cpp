#include "cli.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {
namespace {

struct ReconstructArguments {
  PhotoArguments photos = {};
  std::string output = {};
};

}  // namespace

void add_reconstruct_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "reconstruct",
      "Module A: photos -> camera poses and dense cloud. Writes OUTPUT/vision: COLMAP text model, "
      "positions.csv, dense.ply, origin.json.");
  auto arguments = std::make_shared<ReconstructArguments>();
  add_photo_options(*command, arguments->photos);
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  command->footer(
      help_footer("hybridfusion reconstruct --images flight/ --output result/",
                  "IMAGES: *.jpg, *.jpeg with GNSS and focal length in EXIF or XMP",
                  "OUTPUT/vision/cameras.txt, images.txt, points3D.txt, positions.csv, "
                  "origin.json,\n  dense.ply; OUTPUT/config.yaml, run.json, report/index.html"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) {
      return run_stages(session, arguments->output, {}, {[&](Project& project) {
                          return reconstruct_stage(
                              project, photo_inputs(arguments->photos), session.context);
                        }});
    };
  });
}

}  // namespace hybridfusion::cli
