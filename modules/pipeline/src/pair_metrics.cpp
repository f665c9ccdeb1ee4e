#include "pair_metrics.hpp"

#include "truth_metrics.hpp"

#include <hybridfusion/evaluation/boundary_accuracy.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/evaluation/supplement_degree.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

using Boundary = std::vector<Eigen::Vector2f>;

/// Shares of the LiDAR boundary by distance to the vision boundary; the last bin holds the rest.
Json histogram_json(const std::vector<float>& distances_m) {
  constexpr double kBin_m = 0.1;
  constexpr std::size_t kBins = 30;
  std::vector<std::size_t> counts(kBins, 0);
  for (const float distance_m : distances_m) {
    const double bin = std::isfinite(distance_m) ? distance_m / kBin_m : kBins;
    ++counts[static_cast<std::size_t>(std::min(bin, kBins - 1.0))];
  }
  return {{"bin_m", kBin_m}, {"counts", counts}};
}

Json json_of(const BoundaryAccuracy& accuracy) {
  return {{"accuracy_m", accuracy.mean_m},
          {"share_with_partner", accuracy.share_with_partner},
          {"trimmed_mean_m", accuracy.trimmed_mean_m},
          {"num_vision_boundary_points", accuracy.num_vision},
          {"num_lidar_boundary_points", accuracy.num_lidar},
          {"num_outside_vision_extent", accuracy.num_outside},
          {"histogram", histogram_json(accuracy.distances_m)}};
}

/// Boundary accuracy of L under several poses against one boundary of G.
class BoundaryJudge {
 public:
  BoundaryJudge(const RegisteredPair& pair,
                const BoundaryAccuracyOptions& options,
                const RunContext& ctx)
      : pair_(pair), options_(options), ctx_(ctx) {
    auto boundary = standing_boundary(pair.vision.points, options, ctx);
    if (boundary) {
      vision_ = *std::move(boundary);
    } else {
      ctx.warn("no boundary accuracy, vision cloud: " + boundary.error().message);
    }
  }

  std::optional<BoundaryAccuracy> judge(const Rigid3& vision_from_lidar) const {
    if (vision_.empty()) return std::nullopt;
    const PointCloud registered =
        transformed(vision_from_lidar, PointCloud{.points = pair_.lidar.points});
    const auto lidar = standing_boundary(registered.points, options_, ctx_);
    if (!lidar) {
      ctx_.warn("no boundary accuracy, LiDAR cloud: " + lidar.error().message);
      return std::nullopt;
    }
    const BoundaryAccuracy accuracy = boundary_accuracy(vision_, *lidar, options_.partner_m);
    if (accuracy.num_lidar > 0) return accuracy;
    ctx_.warn("no boundary accuracy: the LiDAR cloud stands outside the vision cloud");
    return std::nullopt;
  }

 private:
  const RegisteredPair& pair_;
  const BoundaryAccuracyOptions& options_;
  const RunContext& ctx_;
  Boundary vision_ = {};
};

void add_supplement(const RegisteredPair& pair,
                    double headline_leaf_m,
                    const RunContext& ctx,
                    PairMetrics& metrics) {
  const PointCloud registered =
      transformed(pair.vision_from_lidar, PointCloud{.points = pair.lidar.points});
  std::vector<double> leaves_m = {0.2, 0.5, 1.0};
  if (std::ranges::find(leaves_m, headline_leaf_m) == leaves_m.end()) {
    leaves_m.push_back(headline_leaf_m);
  }
  Json rows = Json::array();
  for (const double leaf_m : leaves_m) {
    const auto volumes = compare_volumes(pair.vision, registered, leaf_m);
    if (!volumes) {
      ctx.warn("no supplement degree: " + volumes.error().message);
      return;
    }
    rows.push_back({{"leaf_m", leaf_m},
                    {"vision_volume_m3", volumes->vision_volume_m3},
                    {"result_volume_m3", volumes->fused_volume_m3},
                    {"supplement_degree", volumes->supplement_degree}});
    if (leaf_m != headline_leaf_m) continue;
    metrics.json["leaf_m"] = leaf_m;
    metrics.json["vision_volume_m3"] = volumes->vision_volume_m3;
    metrics.json["result_volume_m3"] = volumes->fused_volume_m3;
    metrics.json["supplement_degree"] = volumes->supplement_degree;
    metrics.summary.push_back(
        fmt::format("supplement degree {:.2f} % at {} m leaves: {:.2f} -> {:.2f} m3 inside the "
                    "rectangle of the LiDAR cloud",
                    100.0 * volumes->supplement_degree,
                    leaf_m,
                    volumes->vision_volume_m3,
                    volumes->fused_volume_m3));
  }
  metrics.json["extent"] =
      "both clouds cut to the bounding rectangle of the registered LiDAR cloud grown by one leaf";
  metrics.json["supplement"] = std::move(rows);
}

void add_boundary(const RegisteredPair& pair, const BoundaryJudge& judge, PairMetrics& metrics) {
  const auto ours = judge.judge(pair.vision_from_lidar);
  if (!ours) return;
  Json json = json_of(*ours);
  std::string oracle_text;
  if (pair.truth) {
    if (const auto oracle = judge.judge(*pair.truth)) {
      json["oracle_m"] = oracle->mean_m;
      oracle_text = fmt::format(", {:.3f} m at the true pose", oracle->mean_m);
    }
  }
  metrics.summary.push_back(
      fmt::format("boundary accuracy {:.3f} m{}; {:.0f} % have a partner, mean of these {:.3f} m",
                  ours->mean_m,
                  oracle_text,
                  100.0 * ours->share_with_partner,
                  ours->trimmed_mean_m));
  metrics.json["boundary_accuracy_m"] = ours->mean_m;
  metrics.json["boundary"] = std::move(json);
}

/// One run of a baseline and what it is worth; an error of the baseline is its result.
Expected<Json> baseline_json(const std::string& method,
                             const Rigid3& start_pose,
                             const RegisteredPair& pair,
                             const BoundaryJudge& judge,
                             const PipelineOptions& options,
                             const RunContext& ctx) {
  RegistrationOptions chosen = options.registration;
  chosen.method = method;
  const auto start = std::chrono::steady_clock::now();
  const auto result = register_cross_source(
      pair.vision, pair.lidar, {.vision_from_lidar_initial = start_pose}, chosen, ctx);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!result) {
    if (result.error().code == ErrorCode::kCancelled) return std::unexpected(result.error());
    return Json{{"error", result.error().message}};
  }
  Json json = {{"converged", result->status == RegistrationStatus::kOk},
               {"seconds", seconds.count()},
               {"vision_from_lidar", matrix_json(result->vision_from_lidar)}};
  if (const auto accuracy = judge.judge(result->vision_from_lidar)) {
    json["accuracy_m"] = accuracy->mean_m;
  }
  if (pair.truth) {
    json["truth_error"] =
        registration_error_json(*pair.truth, result->vision_from_lidar, centroid(pair.lidar));
  }
  return json;
}

std::string baseline_line(const std::string& name, const Json& json) {
  if (json.contains("error")) {
    return fmt::format("baseline {}: {}", name, json["error"].get<std::string>());
  }
  std::string line = fmt::format("baseline {}: {}, {:.1f} s",
                                 name,
                                 json["converged"].get<bool>() ? "converged" : "refused",
                                 json["seconds"].get<double>());
  if (json.contains("accuracy_m")) {
    line += fmt::format(", boundary accuracy {:.3f} m", json["accuracy_m"].get<double>());
  }
  if (json.contains("truth_error")) {
    line += fmt::format(", error {:.3f} m, {:.3f} deg",
                        json["truth_error"]["at_centroid_m"].get<double>(),
                        json["truth_error"]["rotation_deg"].get<double>());
  }
  return line;
}

Expected<void> add_baseline(const std::string& method,
                            const RegisteredPair& pair,
                            const BoundaryJudge& judge,
                            const PipelineOptions& options,
                            const RunContext& ctx,
                            PairMetrics& metrics) {
  HF_TRY(Json json,
         baseline_json(method, pair.initial.value_or(Rigid3{}), pair, judge, options, ctx));
  metrics.summary.push_back(baseline_line(method, json));
  if (method == "gicp" && pair.truth) {
    // What it makes of a perfect start: neither its metric nor its error can be charged to ours.
    HF_TRY(Json from_truth, baseline_json(method, *pair.truth, pair, judge, options, ctx));
    metrics.summary.push_back(baseline_line(method + " from the true pose", from_truth));
    json["from_truth"] = std::move(from_truth);
  }
  metrics.json["baselines"][method] = std::move(json);
  return {};
}

}  // namespace

Expected<PairMetrics> pair_metrics(const RegisteredPair& pair,
                                   const PipelineOptions& options,
                                   const RunContext& ctx) {
  PairMetrics metrics;
  add_supplement(pair, options.evaluation.leaf_m, ctx, metrics);
  // Baselines and ours are judged on the same downsampled clouds.
  const PointCloud vision =
      voxel_mean({.points = pair.vision.points}, options.registration.voxel_m);
  const PointCloud lidar = voxel_mean({.points = pair.lidar.points}, options.registration.voxel_m);
  RegisteredPair thinned{.vision = vision,
                         .lidar = lidar,
                         .vision_from_lidar = pair.vision_from_lidar,
                         .truth = pair.truth,
                         .initial = pair.initial,
                         .method = pair.method,
                         .seconds = pair.seconds};
  const BoundaryJudge judge(thinned, options.evaluation.boundary, ctx);
  add_boundary(thinned, judge, metrics);
  if (!pair.method.empty()) metrics.json["method"] = pair.method;
  if (pair.seconds > 0.0) metrics.json["seconds"] = pair.seconds;
  std::vector<std::string> baselines;
  if (options.evaluation.baselines == "gicp") baselines = {"gicp"};
  if (options.evaluation.baselines == "all") baselines = {"gicp", "ndt", "paper"};
  for (const std::string& method : baselines) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped before the baselines");
    if (auto added = add_baseline(method, thinned, judge, options, ctx, metrics); !added) {
      return std::unexpected(added.error());
    }
  }
  return metrics;
}

}  // namespace hybridfusion
