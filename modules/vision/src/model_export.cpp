#include "model_export.hpp"

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

/// Fills points and observations; returns the errors of all observations [px, reduced photo].
std::vector<double> export_points(const SfmModel& model,
                                  std::span<const FeatureSet> features,
                                  Reconstruction& out) {
  std::vector<double> errors;
  for (std::size_t t = 0; t < model.tracks.size(); ++t) {
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

void fill_gnss_quality(const SfmModel& model, const GnssTerms& terms, ReconstructionQuality& out) {
  const std::vector<Eigen::Vector3d> residuals = gnss_residuals(model, terms);
  if (residuals.empty()) return;
  std::vector<double> horizontal;
  std::vector<double> vertical;
  std::vector<double> sigmas;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const auto count = static_cast<double>(residuals.size());
  for (const GnssObservation& o : terms.observations) mean += o.position / count;
  double spread2 = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    horizontal.insert(horizontal.end(), {residuals[i].x(), residuals[i].y()});
    sigmas.push_back(terms.observations[i].sigma_m.x());
    spread2 += (terms.observations[i].position - mean).head<2>().squaredNorm();
    out.gnss_horizontal_rms_m += residuals[i].head<2>().squaredNorm() / count;
    if (terms.observations[i].sigma_m.z() < 1e3) vertical.push_back(residuals[i].z());
  }
  for (const double v : vertical) {
    out.gnss_vertical_rms_m += v * v / static_cast<double>(vertical.size());
  }
  out.gnss_horizontal_rms_m = std::sqrt(out.gnss_horizontal_rms_m);
  out.gnss_vertical_rms_m = std::sqrt(out.gnss_vertical_rms_m);
  out.estimated_sigma_horizontal_m = robust_sigma_about_zero(std::move(horizontal));
  if (!vertical.empty()) {
    out.estimated_sigma_vertical_m = robust_sigma_about_zero(std::move(vertical));
  }
  // Slope of a regression of GNSS on vision positions, errors taken as independent.
  if (spread2 > 0.0) out.scale_sigma = median(std::move(sigmas)) / std::sqrt(spread2);
}

void add_quality_warnings(const Reconstruction& result,
                          const GnssIngest& stated,
                          std::vector<std::string>& warnings) {
  const auto registered = std::ranges::count_if(
      result.views, [](const View& view) { return view.enu_from_camera.has_value(); });
  if (static_cast<std::size_t>(registered) < result.views.size()) {
    warnings.push_back(
        fmt::format("{} of {} photos are registered", registered, result.views.size()));
  }
  // The adjustment raised the deviations where the residuals were larger than stated.
  Eigen::Vector3d excess = Eigen::Vector3d::Ones();
  for (std::size_t v = 0; v < result.views.size(); ++v) {
    if (!result.views[v].enu_from_camera || !result.views[v].gnss_sigma_m) continue;
    Eigen::Vector3d ratio = result.views[v].gnss_sigma_m->cwiseQuotient(stated.fixes[v].sigma_m);
    if (!stated.fixes[v].has_altitude) ratio.z() = 1.0;
    excess = excess.cwiseMax(ratio);
  }
  constexpr double kMaxExcess = 3.0;
  if (excess.maxCoeff() > kMaxExcess) {
    warnings.push_back(
        fmt::format("GNSS residuals are {:.1f} (horizontal) and {:.1f} (vertical) times the stated "
                    "deviations: place, scale and tilt of the model are as uncertain",
                    excess.head<2>().maxCoeff(),
                    excess.z()));
  }
  const double change = result.cameras.front().focal_px / result.quality.initial_focal_px - 1.0;
  constexpr double kMaxFocalChange = 0.1;
  if (std::abs(change) > kMaxFocalChange) {
    warnings.push_back(
        fmt::format("the estimated focal length is {:.1f} % off the metadata's", 100.0 * change));
  }
}

}  // namespace

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
    view.gnss_in_enu = gnss.fixes[v].position_in_enu;
    if (view.gnss_in_enu) view.gnss_sigma_m = gnss.fixes[v].sigma_m;
    if (view.enu_from_camera) continue;
    view.reason = !stage.errors[v].empty() ? stage.errors[v] : mapped.reasons[v];
    if (view.reason.empty()) view.reason = "no matches with the registered photos";
  }
  for (const GnssObservation& o : terms.observations) {
    result.views[o.view].gnss_sigma_m = o.sigma_m;
  }
  std::vector<double> errors = export_points(model, stage.features, result);
  if (!errors.empty()) {
    result.quality.mean_reprojection_px =
        std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
    result.quality.median_reprojection_px = median(std::move(errors));
  }
  result.quality.initial_focal_px = model.priors.front().intrinsics.focal_px;
  fill_gnss_quality(model, terms, result.quality);
  result.warnings = gnss.warnings;
  result.warnings.insert(result.warnings.end(), mapped.warnings.begin(), mapped.warnings.end());
  add_quality_warnings(result, gnss, result.warnings);
  return result;
}

}  // namespace hybridfusion
