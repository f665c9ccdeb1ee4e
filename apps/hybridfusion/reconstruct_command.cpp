#include "cli.hpp"

#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {
namespace {

struct ReconstructArguments {
  std::string images = {};
  std::string output = {};
  std::string poses = {};
};

}  // namespace

void add_reconstruct_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "reconstruct",
      "Module A: photos -> camera poses and dense cloud. Writes OUTPUT/vision: COLMAP text model, "
      "positions.csv, dense.ply, origin.json.");
  auto arguments = std::make_shared<ReconstructArguments>();
  command->add_option("--images", arguments->images, "Folder of JPEG photos with GNSS")->required();
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  command->add_option("--poses", arguments->poses, kPosesHelp);
  command->footer(
      help_footer("hybridfusion reconstruct --images flight/ --output result/",
                  "IMAGES: *.jpg, *.jpeg with GNSS and focal length in EXIF or XMP",
                  "OUTPUT/vision/cameras.txt, images.txt, points3D.txt, positions.csv, "
                  "origin.json,\n  dense.ply; OUTPUT/config.yaml, run.json, report/index.html"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) {
      std::optional<std::filesystem::path> poses;
      if (!arguments->poses.empty()) poses = arguments->poses;
      return run_stages(session, arguments->output, {}, {[&](Project& project) {
                          return reconstruct_stage(
                              project, arguments->images, session.context, poses);
                        }});
    };
  });
}

}  // namespace hybridfusion::cli
