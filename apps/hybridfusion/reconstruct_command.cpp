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
  std::string geo = {};
  std::string gcp = {};
};

std::optional<std::filesystem::path> optional_path(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return text;
}

}  // namespace

void add_reconstruct_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "reconstruct",
      "Module A: photos -> camera poses and dense cloud. Writes OUTPUT/vision: COLMAP text model, "
      "positions.csv, dense.ply, origin.json.");
  auto arguments = std::make_shared<ReconstructArguments>();
  command
      ->add_option(
          "--images",
          arguments->images,
          "Folder of JPEG photos; without GNSS the result has an arbitrary frame (exit code 4)")
      ->required();
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  command->add_option("--poses",
                      arguments->poses,
                      "Folder of a COLMAP text model (cameras.txt, images.txt, points3D.txt) whose "
                      "poses are used as they are; placed by the photos' GNSS, or by origin.json "
                      "beside it when it is in metres east, north, up");
  command->add_option("--geo",
                      arguments->geo,
                      "Positions that replace those in the photos: geo.txt of OpenDroneMap, or "
                      "name,lat,lon,alt[,sigma_h,sigma_v] (default: geo.txt in IMAGES, if there)");
  command->add_option("--gcp",
                      arguments->gcp,
                      "Ground control points, gcp_list.txt of OpenDroneMap; three or more take the "
                      "place of GNSS, names that start with CHK are for checking only (default: "
                      "gcp_list.txt in IMAGES, if there)");
  command->footer(
      help_footer("hybridfusion reconstruct --images flight/ --output result/",
                  "IMAGES: *.jpg, *.jpeg with GNSS and focal length in EXIF or XMP",
                  "OUTPUT/vision/cameras.txt, images.txt, points3D.txt, positions.csv, "
                  "origin.json,\n  dense.ply; OUTPUT/config.yaml, run.json, report/index.html"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) {
      const PhotoInputs inputs{.images = arguments->images,
                               .poses = optional_path(arguments->poses),
                               .geo_tags = optional_path(arguments->geo),
                               .control = optional_path(arguments->gcp)};
      return run_stages(session, arguments->output, {}, {[&](Project& project) {
                          return reconstruct_stage(project, inputs, session.context);
                        }});
    };
  });
}

}  // namespace hybridfusion::cli
