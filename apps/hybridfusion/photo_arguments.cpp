#include "cli.hpp"

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {

std::optional<std::filesystem::path> optional_path(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return text;
}

void add_photo_options(CLI::App& command, PhotoArguments& arguments) {
  command
      .add_option(
          "--images",
          arguments.images,
          "Folder of JPEG photos, searched with its subfolders; without GNSS the result has an "
          "arbitrary frame (exit code 4)")
      ->required();
  command.add_option(
      "--poses",
      arguments.poses,
      "Folder of a COLMAP model (cameras, images and points3D as .txt or .bin) whose "
      "poses are used as they are; placed by the photos' GNSS, or by origin.json "
      "beside it when it is in metres east, north, up");
  command.add_option("--geo",
                     arguments.geo,
                     "Positions that replace those in the photos: geo.txt of OpenDroneMap, or "
                     "name,lat,lon,alt[,sigma_h,sigma_v] (default: geo.txt in IMAGES, if there)");
  command.add_option("--gcp",
                     arguments.gcp,
                     "Ground control points, gcp_list.txt of OpenDroneMap; three or more take the "
                     "place of GNSS, names that start with CHK are for checking only (default: "
                     "gcp_list.txt in IMAGES, if there)");
}

PhotoInputs photo_inputs(const PhotoArguments& arguments) {
  return {.images = arguments.images,
          .poses = optional_path(arguments.poses),
          .geo_tags = optional_path(arguments.geo),
          .control = optional_path(arguments.gcp)};
}

}  // namespace hybridfusion::cli
