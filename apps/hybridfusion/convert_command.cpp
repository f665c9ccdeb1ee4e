#include "cli.hpp"

#include <hybridfusion/io/convert_cloud.hpp>
#include <hybridfusion/io/kitti.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ConvertArguments {
  std::string in = {};
  std::string out = {};
  std::string times = {};
  std::string dsm = {};
  std::string ortho = {};
  std::string origin = {};
  std::string crs = {};
  std::string encoding = "default";
  std::string las_version = "1.4";
  std::string columns = {};
  bool scalar_prefix = false;
  bool allow_ballpark = false;
  SurfaceRasterOptions raster = {};
};

const std::map<std::string, CloudEncoding> kEncodings = {
    {"default", CloudEncoding::kDefault},
    {"ascii", CloudEncoding::kAscii},
    {"binary", CloudEncoding::kBinary},
    {"compressed", CloudEncoding::kCompressed}};

const std::map<std::string, LasVersion> kLasVersions = {
    {"1.2", LasVersion::k12}, {"1.3", LasVersion::k13}, {"1.4", LasVersion::k14}};

void print_json(const Json& json) {
  fmt::print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
}

[[nodiscard]] int wrong_usage(const Session& session, std::string message) {
  return report_error(session, {.code = ErrorCode::kInvalidOptions, .message = std::move(message)});
}

[[nodiscard]] bool is_trajectory(const std::filesystem::path& path) {
  return path.extension() == ".tum" || path.extension() == ".kitti";
}

Expected<Trajectory> read_trajectory(const ConvertArguments& arguments) {
  if (std::filesystem::path(arguments.in).extension() == ".tum") return read_tum(arguments.in);
  if (!arguments.times.empty()) return read_kitti(arguments.in, arguments.times);
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("{}: KITTI poses have no times; give them with --times", arguments.in));
}

Expected<void> write_trajectory(const ConvertArguments& arguments, const Trajectory& trajectory) {
  if (std::filesystem::path(arguments.out).extension() == ".tum") {
    return write_tum(arguments.out, trajectory);
  }
  if (auto written = write_kitti(arguments.out, trajectory); !written) return written;
  if (arguments.times.empty()) return {};
  return write_kitti_times(arguments.times, trajectory);
}

int convert_trajectory(const ConvertArguments& arguments, Session& session) {
  if (!is_trajectory(arguments.out)) {
    return wrong_usage(session, "trajectories are written to .tum and .kitti");
  }
  const auto trajectory = read_trajectory(arguments);
  if (!trajectory) return report_error(session, trajectory.error());
  if (const auto written = write_trajectory(arguments, *trajectory); !written) {
    return report_error(session, written.error());
  }
  if (session.globals.json) {
    print_json(
        {{"status", "ok"}, {"num_poses", trajectory->poses.size()}, {"output", arguments.out}});
  } else {
    fmt::print("{}: {} poses\n", arguments.out, trajectory->poses.size());
  }
  return kDone;
}

/// origin.json as given, or that of the workspace in which the cloud lies.
[[nodiscard]] std::optional<std::filesystem::path> find_origin(const ConvertArguments& arguments) {
  if (!arguments.origin.empty()) return arguments.origin;
  if (arguments.crs.empty() && arguments.dsm.empty() && arguments.ortho.empty()) return {};
  // vision/ and fused/ are in the plane at the origin; lidar/map.ply has a frame of its own.
  const auto folder = std::filesystem::absolute(arguments.in).parent_path();
  const bool is_fused =
      folder.filename() == std::filesystem::path(workspace_file::kFusedPly).parent_path();
  const auto origin = is_fused ? folder.parent_path() / workspace_file::kOrigin
                               : folder / std::filesystem::path(workspace_file::kOrigin).filename();
  std::error_code code;
  if (std::filesystem::is_regular_file(origin, code)) return origin;
  return std::nullopt;
}

/// "x,y,z"
[[nodiscard]] std::vector<std::string> names_of(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');) names.push_back(name);
  return names;
}

Expected<CloudConversion> conversion_of(const ConvertArguments& arguments) {
  CloudConversion conversion = {.in = arguments.in,
                                .out = optional_path(arguments.out),
                                .dsm = optional_path(arguments.dsm),
                                .ortho = optional_path(arguments.ortho),
                                .format = {.encoding = kEncodings.at(arguments.encoding),
                                           .las_version = kLasVersions.at(arguments.las_version),
                                           .ply_scalar_prefix = arguments.scalar_prefix,
                                           .text_in_crs_units = !arguments.crs.empty()},
                                .columns = names_of(arguments.columns),
                                .raster = arguments.raster,
                                .keep_placed = arguments.origin.empty() && arguments.crs.empty()};
  if (const auto origin_path = find_origin(arguments)) {
    HF_TRY(const GeodeticOrigin origin, read_origin(*origin_path));
    conversion.georeference = Georeference{
        .origin = origin, .crs = arguments.crs, .allow_ballpark = arguments.allow_ballpark};
  } else if (!arguments.crs.empty()) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("{}: --crs needs to know where the cloud lies; give --origin", arguments.in));
  }
  return conversion;
}

void print_result(const ConvertArguments& arguments,
                  const ConvertedCloud& done,
                  const Session& session) {
  const Eigen::Vector3d& offset_m = done.offset_m;
  if (session.globals.json) {
    Json json = {{"status", "ok"}, {"num_points", done.num_points}};
    if (!arguments.out.empty()) json["output"] = arguments.out;
    if (!arguments.dsm.empty()) json["dsm"] = arguments.dsm;
    if (!arguments.ortho.empty()) json["ortho"] = arguments.ortho;
    if (!done.crs.name.empty()) json["crs"] = done.crs.name;
    if (!done.keeps_offset) json["subtracted_m"] = {offset_m.x(), offset_m.y(), offset_m.z()};
    print_json(json);
    return;
  }
  for (const std::string& file : {arguments.out, arguments.dsm, arguments.ortho}) {
    if (file.empty()) continue;
    fmt::print("{}: {} points{}{}\n",
               file,
               done.num_points,
               done.crs.name.empty() ? "" : ", ",
               done.crs.name);
  }
  if (!done.keeps_offset) {
    fmt::print("{}: ({}, {}, {}) m were subtracted from the coordinates\n",
               arguments.out,
               offset_m.x(),
               offset_m.y(),
               offset_m.z());
  }
}

int convert_points(const ConvertArguments& arguments, Session& session) {
  if (arguments.out.empty() && arguments.dsm.empty() && arguments.ortho.empty()) {
    return wrong_usage(session, "nothing to write: give OUT, --dsm or --ortho");
  }
  const auto conversion = conversion_of(arguments);
  if (!conversion) return report_error(session, conversion.error());
  const auto done = convert_cloud(*conversion, session.context);
  if (!done) return report_error(session, done.error());
  for (const std::string& warning : done->warnings) session.context.warn(warning);
  print_result(arguments, *done, session);
  return kDone;
}

int convert(const ConvertArguments& arguments, Session& session) {
  return is_trajectory(arguments.in) ? convert_trajectory(arguments, session)
                                     : convert_points(arguments, session);
}

}  // namespace

void add_convert_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "convert",
      "Formats by extension. Clouds: reads .ply .pcd .las .xyz .txt .csv .asc .pts, writes .ply "
      ".pcd "
      ".xyz .las, of any size; of .ply and .pcd, coordinates of 10 km and more are taken relative "
      "to "
      "whole kilometres. Trajectories: .tum and .kitti. Maps from above: --dsm and --ortho.");
  auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("in", arguments->in, "Cloud or trajectory to read")->required();
  command->add_option("out", arguments->out, "Cloud or trajectory to write");
  command
      ->add_option("--encoding",
                   arguments->encoding,
                   "Of .ply and .pcd: ascii, binary or (.pcd only) compressed; default: binary, "
                   ".pcd compressed up to 64 MiB")
      ->check(CLI::IsMember(kEncodings));
  command
      ->add_option("--las-version",
                   arguments->las_version,
                   "Of .las: 1.2 and 1.3 for old programs (system also as GeoTIFF keys), 1.4")
      ->check(CLI::IsMember(kLasVersions))
      ->capture_default_str();
  command->add_option("--columns",
                      arguments->columns,
                      "Of a text cloud: the names of its columns, for example x,y,z,intensity; '-' "
                      "leaves one out (default: from its heading or what they hold)");
  command->add_flag("--scalar-prefix",
                    arguments->scalar_prefix,
                    "Of .ply: scalars are named scalar_NAME, without which CloudCompare 2.11 drops "
                    "them");
  command->add_option("--dsm", arguments->dsm, "GeoTIFF of the surface height to write");
  command->add_option("--ortho", arguments->ortho, "GeoTIFF of the colours to write");
  command->add_option("--cell-m", arguments->raster.cell_m, "Cell of these [m]")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1000.0));
  command->add_option("--origin",
                      arguments->origin,
                      "origin.json of a cloud in metres east, north, up, which is then projected "
                      "(for --crs, --dsm and --ortho default: that of its workspace)");
  command->add_option(
      "--crs",
      arguments->crs,
      "Projected system, EPSG:n or EPSG:n+m, also in feet (default: UTM zone of the "
      "origin, ellipsoidal heights)");
  command->add_flag("--allow-ballpark",
                    arguments->allow_ballpark,
                    "Also a --crs that PROJ reaches with no better than 5 m, or without its grid");
  command->add_option(
      "--times", arguments->times, "Times of the .kitti poses, one on each line, read or written");
  command->footer(
      help_footer("hybridfusion convert result/fused/fused.ply --dsm dsm.tif --ortho ortho.tif",
                  "IN: .ply .pcd .las .xyz .txt .csv .asc .pts, or a trajectory .tum .kitti",
                  "OUT: .ply .pcd .xyz .las, .tum .kitti; replaced when it is complete"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return convert(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
