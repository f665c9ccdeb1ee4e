#include "cli.hpp"

#include <hybridfusion/pipeline/watch.hpp>

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

struct ReconstructArguments {
  PhotoArguments photos = {};
  std::string output = {};
  std::string watch = {};
  double idle_s = 30.0;
  bool preview_only = false;
};

/// One line on stdout a photo; with --json one object.
void print_photo(const WatchedPhoto& photo, bool json) {
  if (json) {
    const nlohmann::ordered_json event = {{"event", "photo"},
                                          {"name", photo.name},
                                          {"arrived_s", photo.arrived_s},
                                          {"latency_s", photo.latency_s},
                                          {"cpu_s", photo.cpu_s},
                                          {"registered", photo.registered},
                                          {"reason", photo.reason},
                                          {"num_features", photo.num_features},
                                          {"num_pairs", photo.num_pairs},
                                          {"total_photos", photo.total_photos},
                                          {"total_registered", photo.total_registered},
                                          {"num_preview_points", photo.num_preview_points},
                                          {"georeferenced", photo.georeferenced}};
    fmt::print("{}\n",
               event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{:7.1f} s  {}  {:.2f} s ({:.2f} CPU s)  {}/{} with a pose, {} points{}\n",
               photo.arrived_s,
               photo.name,
               photo.latency_s,
               photo.cpu_s,
               photo.total_registered,
               photo.total_photos,
               photo.num_preview_points,
               photo.registered ? "" : "; this one not: " + photo.reason);
  }
  std::fflush(stdout);
}

/// Watches, then reconstructs what came.
int watch(Session& session, const ReconstructArguments& arguments) {
  PhotoInputs inputs = photo_inputs(arguments.photos);
  inputs.images = arguments.watch;
  const WatchRequest request{
      .inputs = inputs, .idle_s = arguments.idle_s, .on_photo = [&](const WatchedPhoto& photo) {
        print_photo(photo, session.globals.json);
      }};
  std::vector<std::function<Expected<StageOutcome>(Project&)>> stages = {
      [&](Project& project) { return watch_stage(project, request, session.context); }};
  if (!arguments.preview_only) {
    stages.emplace_back(
        [&](Project& project) { return reconstruct_stage(project, inputs, session.context); });
  }
  return run_stages(session, arguments.output, {}, stages);
}

void add_watch_options(CLI::App& command, ReconstructArguments& arguments) {
  CLI::Option* images = command.get_option("--images")->required(false);
  CLI::Option* watched =
      command
          .add_option("--watch",
                      arguments.watch,
                      "Instead of --images: take photos up as they arrive in this folder, with "
                      "poses and a growing preview cloud, and reconstruct them when no more come")
          ->excludes(images)
          ->excludes(command.get_option("--poses"));
  command
      .add_option("--idle-s", arguments.idle_s, "--watch ends when no photo came for so long [s]")
      ->check(CLI::Range(1.0, 86400.0))
      ->capture_default_str()
      ->needs(watched);
  command
      .add_flag(
          "--preview-only", arguments.preview_only, "--watch without the reconstruction behind it")
      ->needs(watched);
}

}  // namespace

void add_reconstruct_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "reconstruct",
      "Module A: photos -> camera poses and dense cloud. Writes OUTPUT/vision: COLMAP text model, "
      "positions.csv, dense.ply, origin.json.");
  auto arguments = std::make_shared<ReconstructArguments>();
  add_photo_options(*command, arguments->photos);
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  add_watch_options(*command, *arguments);
  command->footer(help_footer(
      "hybridfusion reconstruct --images flight/ --output result/\n"
      "  hybridfusion reconstruct --watch incoming/ --output result/ --idle-s 60",
      "IMAGES, WATCH: *.jpg, *.jpeg with GNSS and focal length in EXIF or XMP",
      "OUTPUT/vision/cameras.txt, images.txt, points3D.txt, positions.csv, "
      "origin.json,\n  dense.ply; OUTPUT/config.yaml, run.json, report/index.html; with "
      "--watch after each photo\n  OUTPUT/vision/preview.ply, preview_origin.json, "
      "cameras.csv, and a line on stdout\n  (an object with --json)"));
  command->callback([arguments, &chosen] {
    if (arguments->photos.images.empty() && arguments->watch.empty()) {
      throw CLI::RequiredError("--images or --watch");
    }
    chosen = [arguments](Session& session) {
      if (!arguments->watch.empty()) return watch(session, *arguments);
      return run_stages(session, arguments->output, {}, {[&](Project& project) {
                          return reconstruct_stage(
                              project, photo_inputs(arguments->photos), session.context);
                        }});
    };
  });
}

}  // namespace hybridfusion::cli
