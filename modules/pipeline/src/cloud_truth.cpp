#include "cloud_truth.hpp"

#include <hybridfusion/evaluation/cloud_error.hpp>
#include <hybridfusion/evaluation/sheet_error.hpp>
#include <hybridfusion/io/ply.hpp>

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMinPhotos = 2.0;
constexpr std::array<const char*, kNumSurfaceLabels> kLabelNames = {
    "ground", "building", "vegetation", "other"};

Json json_of(const DistanceStatistics& statistics) {
  return {{"num_points", statistics.num_points},
          {"mean_m", statistics.mean_m},
          {"median_m", statistics.median_m},
          {"p95_m", statistics.percentile95_m},
          {"share_beyond_0.5_m", statistics.share_beyond[0]},
          {"share_beyond_3_m", statistics.share_beyond[1]}};
}

Json json_of(const CloudAccuracy& accuracy) {
  Json json = {{"all", json_of(accuracy.all)}};
  if (accuracy.hard.num_points > 0) json["hard"] = json_of(accuracy.hard);
  for (std::size_t label = 0; label < kNumSurfaceLabels; ++label) {
    if (accuracy.by_label[label].num_points == 0) continue;
    json[kLabelNames[label]] = json_of(accuracy.by_label[label]);
  }
  return json;
}

Json json_of(const CloudCompleteness& completeness) {
  Json json = {{"num_samples", completeness.num_samples}};
  for (std::size_t k = 0; k < kCompletenessDistances_m.size(); ++k) {
    json[fmt::format("within_{}_m", kCompletenessDistances_m[k])] = completeness.share[k];
  }
  return json;
}

std::vector<Eigen::Vector3f> mapped(const std::vector<Eigen::Vector3f>& points,
                                    const Sim3& truth_from_cloud,
                                    std::size_t stride) {
  std::vector<Eigen::Vector3f> result;
  result.reserve(points.size() / stride + 1);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    result.emplace_back((truth_from_cloud * points[i].cast<double>()).cast<float>());
  }
  return result;
}

struct Samples {
  std::vector<Eigen::Vector3f> points = {};
  std::vector<Eigen::Vector3f> normals = {};
};

Samples samples_of(const CloudTruth& truth, SampleView view) {
  Samples samples;
  for (std::size_t i = 0; i < truth.samples.size(); ++i) {
    const bool drone = truth.seen_by_drone[i] && view != SampleView::kVehicle;
    const bool vehicle = truth.seen_by_vehicle[i] && view != SampleView::kDrone;
    if (!drone && !vehicle) continue;
    samples.points.push_back(truth.samples[i]);
    if (!truth.normals.empty()) samples.normals.push_back(truth.normals[i]);
  }
  return samples;
}

/// Median error over stated deviation by the kind of surface.
Json sigma_json(const PointCloud& cloud,
                const std::vector<Eigen::Vector3f>& points_in_truth,
                double scale,
                std::size_t stride,
                const CloudTruth& truth,
                const RunContext& ctx) {
  std::vector<float> sigmas;
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    sigmas.push_back(static_cast<float>(scale) * cloud.sigmas_m[i]);
  }
  const SigmaCalibration found =
      sigma_calibration(points_in_truth, sigmas, *truth.surface, truth.triangle_labels, ctx);
  Json json = {{"hard", found.hard}};
  for (std::size_t label = 0; label < kNumSurfaceLabels; ++label) {
    if (std::isfinite(found.by_label[label])) json[kLabelNames[label]] = found.by_label[label];
  }
  return json;
}

Expected<void> load_samples(const std::filesystem::path& path, CloudTruth& truth) {
  HF_TRY(const PlyTable table, read_ply_columns(path));
  const auto* x = table.find("x");
  const auto* y = table.find("y");
  const auto* z = table.find("z");
  const auto* drone = table.find("drone");
  const auto* vehicle = table.find("vehicle");
  if (!x || !y || !z || !drone || !vehicle) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: needs the columns x y z drone vehicle", path.string()));
  }
  const auto* nx = table.find("nx");
  const auto* ny = table.find("ny");
  const auto* nz = table.find("nz");
  const bool has_normals = nx && ny && nz;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (has_normals) {
      truth.normals.emplace_back(Eigen::Vector3d((*nx)[i], (*ny)[i], (*nz)[i]).cast<float>());
    }
    truth.samples.emplace_back(Eigen::Vector3d((*x)[i], (*y)[i], (*z)[i]).cast<float>());
    truth.seen_by_drone.push_back((*drone)[i] >= kMinPhotos);
    truth.seen_by_vehicle.push_back((*vehicle)[i] > 0.0);
  }
  return {};
}

}  // namespace

Expected<CloudTruth> load_cloud_truth(const std::filesystem::path& truth_folder) {
  CloudTruth truth;
  std::error_code code;
  if (std::filesystem::exists(truth_folder / "mesh.ply", code)) {
    HF_TRY(TriangleMesh mesh, read_ply_mesh(truth_folder / "mesh.ply"));
    HF_TRY(truth.surface, SurfaceDistance::build(mesh.vertices, mesh.triangles));
    truth.triangle_labels = std::move(mesh.labels);
  }
  if (std::filesystem::exists(truth_folder / "samples.ply", code)) {
    if (auto loaded = load_samples(truth_folder / "samples.ply", truth); !loaded) {
      return std::unexpected(loaded.error());
    }
  }
  return truth;
}

Expected<Json> cloud_truth_json(const PointCloud& cloud,
                                const CloudTruth& truth,
                                SampleView view,
                                const std::vector<CloudAlignment>& alignments,
                                const EvaluationOptions& options,
                                const RunContext& ctx) {
  const auto max_points = static_cast<std::size_t>(options.max_points);
  const std::size_t stride = std::max<std::size_t>(1, (cloud.size() + max_points - 1) / max_points);
  const Samples samples = samples_of(truth, view);
  Json json = {{"num_points", cloud.size()}};
  for (const CloudAlignment& alignment : alignments) {
    Json entry;
    if (truth.surface) {
      const std::vector<Eigen::Vector3f> points =
          mapped(cloud.points, alignment.truth_from_cloud, stride);
      HF_TRY(const CloudAccuracy accuracy,
             cloud_accuracy(points, *truth.surface, truth.triangle_labels, ctx));
      entry["accuracy"] = json_of(accuracy);
      if (!cloud.sigmas_m.empty() && !truth.triangle_labels.empty()) {
        entry["error_over_sigma"] =
            sigma_json(cloud, points, alignment.truth_from_cloud.scale, stride, truth, ctx);
      }
    }
    if (!samples.points.empty()) {
      const std::vector<Eigen::Vector3f> points =
          mapped(cloud.points, alignment.truth_from_cloud, 1);
      HF_TRY(const CloudCompleteness completeness, cloud_completeness(samples.points, points, ctx));
      entry["completeness"] = json_of(completeness);
      // A cloud without a flat piece has no thickness, which is no reason to fail.
      if (const auto sheet = sheet_error(samples.points, samples.normals, points, ctx); sheet) {
        entry["sheet"] = {{"num_patches", sheet->num_patches},
                          {"thickness_m", sheet->thickness_m},
                          {"bias_m", sheet->bias_m}};
      }
    }
    json[std::string(alignment.name)] = std::move(entry);
  }
  return json;
}

std::string cloud_truth_line(std::string_view cloud, const Json& json) {
  for (const auto& [name, entry] : json.items()) {
    if (!entry.is_object()) continue;
    std::string line = fmt::format("{} cloud ({}):", cloud, name);
    if (entry.contains("accuracy")) {
      const Json& all = entry["accuracy"]["all"];
      line += fmt::format(" median {:.3f} m, mean {:.3f} m, 95 % {:.3f} m",
                          all["median_m"].get<double>(),
                          all["mean_m"].get<double>(),
                          all["p95_m"].get<double>());
    }
    if (entry.contains("completeness")) {
      const Json& shares = entry["completeness"];
      line += fmt::format("; complete {:.1f} / {:.1f} / {:.1f} % at 0.1 / 0.2 / 0.5 m",
                          100.0 * shares["within_0.1_m"].get<double>(),
                          100.0 * shares["within_0.2_m"].get<double>(),
                          100.0 * shares["within_0.5_m"].get<double>());
    }
    return line;
  }
  return fmt::format("{} cloud: not compared", cloud);
}

}  // namespace hybridfusion
