// CPU time, errors and memory of module A on one folder of photos, as one JSON object.
// `vision_goals` beside this file prints the table. See --help.
#include "dense/checked_depths.hpp"
#include "dense/depth_fusion.hpp"
#include "features.hpp"
#include "imported_poses.hpp"
#include "matching_speed.hpp"
#include "pair_selection.hpp"
#include "vision_files.hpp"

#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace {

using namespace hybridfusion;             // NOLINT(google-build-using-namespace): a program
using namespace hybridfusion::benchmark;  // NOLINT(google-build-using-namespace)
using Json = nlohmann::ordered_json;

struct Arguments {
  std::string images = {};
  std::string poses = {};
  std::string pairs_file = {};
  std::string model = {};
  std::string scratch = {};
  std::vector<std::string> settings = {};
};

/// VmHWM, not ru_maxrss: the latter inherits the peak of the parent process.
double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
  }
  return 0.0;
}

/// When each stage was first and last heard of.
struct StageClock {
  struct Stage {
    double first_s = 0.0;
    double last_s = 0.0;
    std::int64_t total = 0;
  };
  std::map<std::string, Stage, std::less<>> stages = {};
  std::string verified = {};  // the log line about pairs

  RunContext context() {
    return {
        .log =
            [this](LogLevel, std::string_view line) {
              if (line.find("pairs verified") != line.npos) verified = line;
            },
        .progress =
            [this](const ProgressEvent& event) {
              const double now = cpu_s();
              Stage& stage =
                  stages.try_emplace(std::string(event.stage), Stage{now, now, 0}).first->second;
              stage.last_s = now;
              stage.total = std::max(stage.total, event.total);
            },
        .num_threads = 1};
  }
};

Json feature_figures(const PhotoFolder& folder, const FeatureOptions& options) {
  constexpr std::size_t kPhotos = 4;
  std::vector<double> seconds;
  std::vector<std::size_t> keypoints;
  const std::size_t step = std::max<std::size_t>(1, folder.photos.size() / kPhotos);
  for (std::size_t i = 0; i < folder.photos.size(); i += step) {
    const auto image = folder.photos[i].load();
    if (!image) continue;
    const double start = cpu_s();
    const auto features = extract_features(*image, options);
    if (!features) continue;
    seconds.push_back(cpu_s() - start);
    keypoints.push_back(features->size());
  }
  if (seconds.empty()) return nullptr;
  std::ranges::sort(seconds);
  std::ranges::sort(keypoints);
  return {{"cpu_s_per_photo", seconds[seconds.size() / 2]},
          {"keypoints", keypoints[keypoints.size() / 2]}};
}

/// The pairs that are matched, as COLMAP's `matches_importer --match_type pairs` reads them.
Expected<std::size_t> write_pairs(const PhotoFolder& folder,
                                  const ReconstructionOptions& options,
                                  const std::string& file) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : folder.photos) metadata.push_back(photo.metadata);
  const auto ingested = ingest_gnss(metadata, options.gnss);
  const GnssIngest gnss = ingested ? *ingested : without_gnss(metadata, ingested.error().message);
  const std::vector<PhotoPair> pairs = select_pairs(metadata, gnss, options.pairs);
  if (!file.empty()) {
    std::ofstream out(file);
    for (const PhotoPair& pair : pairs) {
      out << metadata[pair.first].name << ' ' << metadata[pair.second].name << '\n';
    }
  }
  return pairs.size();
}

/// With given poses the photos become those of its cameras.
Expected<Reconstruction> poses_of(PhotoFolder& folder,
                                  const Arguments& arguments,
                                  const ReconstructionOptions& options,
                                  Json& json) {
  if (!arguments.poses.empty()) {
    HF_TRY(PosedPhotos posed, import_poses(arguments.poses, folder.photos, {.gnss = options.gnss}));
    folder.photos = std::move(posed.photos);
    return std::move(posed.reconstruction);
  }
  json["features"] = feature_figures(folder, options.features);
  HF_TRY(const std::size_t num_pairs, write_pairs(folder, options, arguments.pairs_file));
  StageClock clock;
  const double start = cpu_s();
  auto reconstruction = reconstruct(folder.photos, options, clock.context());
  if (!reconstruction) return reconstruction;
  const double features_end = clock.stages["vision/features"].last_s;
  const double mapping_begin = clock.stages["vision/mapping"].first_s;
  json["sfm"] = {
      {"cpu_s", cpu_s() - start},
      {"pairs", num_pairs},
      {"matching_cpu_s_per_pair", (mapping_begin - features_end) / static_cast<double>(num_pairs)},
      {"verified", clock.verified},
      {"mean_reprojection_px", reconstruction->quality.mean_reprojection_px},
      {"memory_mib", peak_memory_mib()}};
  return reconstruction;
}

/// Checked depths against scene points that at least three photos saw.
class CheckPoints {
 public:
  explicit CheckPoints(const Reconstruction& reconstruction) : reconstruction_(reconstruction) {}

  void compare(const DepthMap& map) {
    const Rigid3 camera_from_enu = map.enu_from_camera.inverse();
    megapixels_ += static_cast<double>(map.depth_m.values.size()) * 1e-6;
    pairs_ += map.partners.size();
    for (const Observation& observation : reconstruction_.views[map.view].observations) {
      const ScenePoint& point = reconstruction_.points[observation.point];
      if (point.track.size() < 3) continue;
      const Eigen::Vector3d p = camera_from_enu * point.point_in_enu;
      if (!(p.z() > 0.0)) continue;
      ++count_;
      const Eigen::Vector2f pixel = pixel_of(map.grid, p).cast<float>();
      const double depth = depth_at(map, pixel.x(), pixel.y());
      if (std::isnan(depth)) continue;
      const double error = std::abs(depth - p.z());
      if (error < 0.01 * p.z()) ++within_;
      errors_gsd_.push_back(error * map.grid.focal_px / p.z());
      gsd_m_.push_back(p.z() / map.grid.focal_px);
    }
  }

  [[nodiscard]] double megapixels() const { return megapixels_; }
  [[nodiscard]] std::size_t pairs() const { return pairs_; }
  [[nodiscard]] Json figures() {
    if (errors_gsd_.empty()) return nullptr;
    std::ranges::sort(errors_gsd_);
    std::ranges::sort(gsd_m_);
    const auto share = [](std::size_t a, std::size_t b) {
      return static_cast<double>(a) / static_cast<double>(b);
    };
    return {{"observations", count_},
            {"with_depth", share(errors_gsd_.size(), count_)},
            {"within_1_percent", share(within_, count_)},
            {"within_2_gsd",
             share(static_cast<std::size_t>(std::ranges::upper_bound(errors_gsd_, 2.0) -
                                            errors_gsd_.begin()),
                   count_)},
            {"within_1_percent_of_those_with_depth", share(within_, errors_gsd_.size())},
            {"gsd_m", gsd_m_[gsd_m_.size() / 2]},
            {"median_gsd", errors_gsd_[errors_gsd_.size() / 2]},
            {"p90_gsd", errors_gsd_[errors_gsd_.size() * 9 / 10]}};
  }

 private:
  const Reconstruction& reconstruction_;
  double megapixels_ = 0.0;
  std::size_t pairs_ = 0;
  std::size_t count_ = 0;
  std::size_t within_ = 0;
  std::vector<double> errors_gsd_ = {};
  std::vector<double> gsd_m_ = {};
};

Expected<Json> dense_figures(const PhotoFolder& folder,
                             const Reconstruction& reconstruction,
                             const DensifyOptions& options,
                             const std::string& scratch) {
  CheckPoints check_points(reconstruction);
  StageClock clock;
  double voxel_m = options.voxel_m;
  if (!(voxel_m > 0.0)) voxel_m = 0.1;  // fusion is timed, its cloud not judged here
  DepthFusion fusion(voxel_m);
  const double start = cpu_s();
  double comparing_s = 0.0;
  const auto visit = [&](const DepthMap& map) {
    fusion.add(map);
    const double before = cpu_s();
    check_points.compare(map);
    comparing_s += cpu_s() - before;
  };
  if (auto done =
          checked_depths(folder.photos, reconstruction, options, clock.context(), scratch, visit);
      !done) {
    return std::unexpected(done.error());
  }
  const PointCloud cloud = fusion.finish(options.min_points_per_voxel, {.num_threads = 1});
  const double total_s = cpu_s() - start - comparing_s;
  const double stereo_s = clock.stages["vision/dense/stereo"].last_s - start;
  const auto photos = static_cast<double>(std::ranges::count_if(
      reconstruction.views, [](const View& v) { return v.enu_from_camera.has_value(); }));
  const double per_photo_mpx = check_points.megapixels() / photos;
  return Json{
      {"cpu_s_per_photo", total_s / photos},
      {"stereo_cpu_s_per_mpx_and_pair",
       stereo_s / (per_photo_mpx * static_cast<double>(check_points.pairs()))},
      {"check_cpu_s_per_photo",
       (clock.stages["vision/dense/check"].last_s - start - stereo_s - comparing_s) / photos},
      {"photo_mpx", per_photo_mpx},
      {"pairs", check_points.pairs()},
      {"points", cloud.size()},
      {"voxel_m", voxel_m},
      {"check_points", check_points.figures()},
      {"memory_mib", peak_memory_mib()}};
}

Expected<Json> measure(const Arguments& arguments) {
  PipelineOptions options;
  for (const std::string& setting : arguments.settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    auto set = set_option(
        options, setting.substr(0, equals), setting.substr(std::min(equals + 1, setting.size())));
    if (!set) return std::unexpected(set.error());
  }
  HF_TRY(PhotoFolder folder, open_photo_folder(arguments.images));
  Json json{{"images", arguments.images}, {"photos", folder.photos.size()}};
  HF_TRY(const Reconstruction reconstruction,
         poses_of(folder, arguments, options.vision.reconstruction, json));
  if (!arguments.model.empty()) {
    std::filesystem::create_directories(arguments.model);
    if (auto written = write_colmap_model(arguments.model, colmap_model_of(reconstruction));
        !written) {
      return std::unexpected(written.error());
    }
  }
  json["registered"] = std::ranges::count_if(
      reconstruction.views, [](const View& v) { return v.enu_from_camera.has_value(); });
  HF_TRY(json["dense"],
         dense_figures(folder, reconstruction, options.vision.densify, arguments.scratch));
  json["sgm_cpu_s_per_mpx"] = matching_speed(folder.photos.front(), options.vision.densify);
  return json;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Figures of module A on one folder of photos, one thread, as JSON on stdout.");
  app.add_option("--images", arguments.images, "Folder of JPEG photos")->required();
  app.add_option("--poses", arguments.poses, "COLMAP text model: only the dense part is measured");
  app.add_option("--pairs-file", arguments.pairs_file, "Where to write the pairs that are matched");
  app.add_option("--model", arguments.model, "Folder for the poses, a COLMAP text model");
  app.add_option("--scratch", arguments.scratch, "Folder for depth maps that exceed the memory");
  app.add_option("--set", arguments.settings, "group.option=value (repeatable)");
  CLI11_PARSE(app, argc, argv);
  const auto json = measure(arguments);
  if (!json) {
    std::cerr << json.error().message << '\n';
    return 1;
  }
  std::cout << json->dump(1) << '\n';
  return 0;
}
