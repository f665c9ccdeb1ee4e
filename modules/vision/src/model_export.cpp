#include "model_export.hpp"

#include "georeference.hpp"
#include "robust_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Rgb8 mean_color(const Track& track, std::span<const FeatureSet> features) {
  std::array<int, 3> sum{};
  int count = 0;
  for (const TrackElement& e : track) {
    if (!e.active) continue;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += features[e.view].colors[e.feature][c];
    ++count;
  }
  Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<std::uint8_t>(sum[c] / count);
  return color;
}

void add_quality_warnings(const Reconstruction& result, std::vector<std::string>& warnings) {
  const auto registered = std::ranges::count_if(
      result.views, [](const View& view) { return view.enu_from_camera.has_value(); });
  if (static_cast<std::size_t>(registered) < result.views.size()) {
    warnings.push_back(
        fmt::format("{} of {} photos are registered", registered, result.views.size()));
  }
  const double change = result.cameras.front().focal_px / result.quality.initial_focal_px - 1.0;
  constexpr double kMaxFocalChange = 0.1;
  if (std::abs(change) > kMaxFocalChange) {
    warnings.push_back(
        fmt::format("the estimated focal length is {:.1f} % off the metadata's", 100.0 * change));
  }
}

}  // namespace

std::vector<double> export_points(const SfmModel& model,
                                  std::span<const std::uint32_t> tracks,
                                  std::span<const FeatureSet> features,
                                  Reconstruction& out) {
  std::vector<double> errors;
  for (const std::uint32_t t : tracks) {
    if (!model.points[t]) continue;
    ScenePoint point{.point_in_enu = *model.points[t],
                     .color = mean_color(model.tracks[t], features)};
    double sum = 0.0;
    for (const TrackElement& e : model.tracks[t]) {
      if (!e.active) continue;
      View& view = out.views[e.view];
      point.track.push_back(
          {.view = e.view, .observation = static_cast<std::uint32_t>(view.observations.size())});
      view.observations.push_back(
          {.point = static_cast<std::uint32_t>(out.points.size()), .pixel = e.pixel.cast<float>()});
      errors.push_back(model.error_px(e, point.point_in_enu));
      sum += errors.back();
    }
    point.mean_error_px = static_cast<float>(sum / static_cast<double>(point.track.size()));
    out.points.push_back(std::move(point));
  }
  return errors;
}

Reconstruction export_model(const Fragments& mapped,
                            const GnssTerms& terms,
                            const GnssIngest& gnss,
                            const FeatureStage& stage,
                            std::span<const PhotoMetadata> metadata) {
  const SfmModel& model = mapped.model;
  Reconstruction result;
  result.origin = gnss.origin;
  result.cameras = model.cameras;
  result.views.resize(metadata.size());
  for (std::uint32_t v = 0; v < metadata.size(); ++v) {
    View& view = result.views[v];
    view.name = metadata[v].name;
    view.camera = model.camera_of_view[v];
    view.enu_from_camera = model.world_from_view[v];
    if (v < model.pose_covariance.size()) view.pose_covariance = model.pose_covariance[v];
    view.gnss_in_enu = gnss.fixes[v].position_in_enu;
    if (view.gnss_in_enu) view.gnss_sigma_m = gnss.fixes[v].sigma_m;
    if (view.enu_from_camera) continue;
    view.reason = !stage.errors[v].empty() ? stage.errors[v] : mapped.reasons[v];
    if (view.reason.empty()) view.reason = "no matches with the registered photos";
  }
  for (const GnssObservation& o : terms.observations) {
    result.views[o.view].gnss_sigma_m = o.sigma_m;
  }
  std::vector<std::uint32_t> tracks(model.tracks.size());
  std::iota(tracks.begin(), tracks.end(), 0U);
  std::vector<double> errors = export_points(model, tracks, stage.features, result);
  if (!errors.empty()) {
    result.quality.mean_reprojection_px =
        std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    result.quality.median_reprojection_px = median(std::move(errors));
  }
  result.quality.initial_focal_px = model.priors.front().intrinsics.focal_px;
  assess_georeference(model, terms, gnss, mapped.placement, result.quality);
  result.warnings = gnss.warnings;
  result.warnings.insert(result.warnings.end(), mapped.warnings.begin(), mapped.warnings.end());
  for (const std::string& reason : result.quality.georeference_reasons) {
    result.warnings.push_back("georeference: " + reason);
  }
  add_quality_warnings(result, result.warnings);
  return result;
}

}  // namespace hybridfusion
