#include "imported_place.hpp"

#include "workspace_data.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Model positions onto measured ones: least squares, once more without the worst.
Expected<Sim3> align_to_fixes(const std::vector<Eigen::Vector3d>& target,
                              const std::vector<Eigen::Vector3d>& source) {
  HF_TRY(Sim3 first, fit_sim3(target, source));
  std::vector<double> residuals;
  for (std::size_t i = 0; i < target.size(); ++i) {
    residuals.push_back((first * source[i] - target[i]).norm());
  }
  std::vector<double> sorted = residuals;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  constexpr double kGate = 4.0;
  const double limit = kGate * sorted[sorted.size() / 2];
  std::vector<Eigen::Vector3d> kept_target;
  std::vector<Eigen::Vector3d> kept_source;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (residuals[i] > limit) continue;
    kept_target.push_back(target[i]);
    kept_source.push_back(source[i]);
  }
  auto refined = fit_sim3(kept_target, kept_source);
  return refined ? refined : Expected<Sim3>(first);
}

void apply(const Sim3& enu_from_model, Reconstruction& reconstruction) {
  for (View& view : reconstruction.views) {
    if (!view.enu_from_camera) continue;
    view.enu_from_camera = enu_from_model.map_pose(*view.enu_from_camera);
  }
  for (ScenePoint& point : reconstruction.points) {
    point.point_in_enu = enu_from_model * point.point_in_enu;
  }
}

std::vector<PhotoMetadata> metadata_of(std::span<const Photo> photos) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : photos) metadata.push_back(photo.metadata);
  return metadata;
}

}  // namespace

Expected<void> place_by_photos(std::span<const Photo> photos,
                               const GnssOptions& options,
                               Reconstruction& reconstruction) {
  HF_TRY(const GnssIngest gnss, ingest_gnss(metadata_of(photos), options));
  std::vector<Eigen::Vector3d> target;
  std::vector<Eigen::Vector3d> source;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    View& view = reconstruction.views[i];
    view.gnss_in_enu = gnss.fixes[i].position_in_enu;
    if (view.gnss_in_enu) view.gnss_sigma_m = gnss.fixes[i].sigma_m;
    if (!view.enu_from_camera || !view.gnss_in_enu) continue;
    target.push_back(*view.gnss_in_enu);
    source.push_back(view.enu_from_camera->translation);
  }
  constexpr std::size_t kMinFixes = 3;
  if (target.size() < kMinFixes) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} photos of the given poses have a position, at least {} are needed "
                            "to place the model; add origin.json if it is in metres east, north, "
                            "up already",
                            target.size(),
                            kMinFixes));
  }
  HF_TRY(const Sim3 enu_from_model, align_to_fixes(target, source));
  apply(enu_from_model, reconstruction);
  reconstruction.origin = gnss.origin;
  reconstruction.warnings = gnss.warnings;
  return {};
}

void note_positions(std::span<const Photo> photos,
                    const GnssOptions& options,
                    Reconstruction& reconstruction) {
  const auto gnss = ingest_gnss(metadata_of(photos), options);
  if (!gnss) return;  // the photos know nothing of their place
  const Rigid3 enu_from_gnss = enu_from_enu(reconstruction.origin, gnss->origin);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const auto& position = gnss->fixes[i].position_in_enu;
    if (!position) continue;
    reconstruction.views[i].gnss_in_enu = enu_from_gnss * *position;
    reconstruction.views[i].gnss_sigma_m = gnss->fixes[i].sigma_m;
  }
}

Expected<void> judge_place(const std::string& placed_by,
                           const PositionLimits& limits,
                           Reconstruction& reconstruction) {
  for (const PositionConflict& conflict :
       compare_placement(reconstruction, {.what = placed_by}, limits)) {
    if (is_error(conflict)) return fail(ErrorCode::kInsufficient, conflict.text);
    reconstruction.warnings.push_back(conflict.text);
  }
  return {};
}

void measure_quality(Reconstruction& reconstruction) {
  ReconstructionQuality& quality = reconstruction.quality;
  std::vector<double> errors_px;
  for (const ScenePoint& point : reconstruction.points) errors_px.push_back(point.mean_error_px);
  for (const double error_px : errors_px) quality.mean_reprojection_px += error_px;
  if (!errors_px.empty()) {
    quality.mean_reprojection_px /= static_cast<double>(errors_px.size());
    const auto middle = errors_px.begin() + static_cast<std::ptrdiff_t>(errors_px.size() / 2);
    std::ranges::nth_element(errors_px, middle);
    quality.median_reprojection_px = *middle;
  }
  double horizontal = 0.0;
  double vertical = 0.0;
  double count = 0.0;
  for (const View& view : reconstruction.views) {
    if (!view.enu_from_camera || !view.gnss_in_enu) continue;
    const Eigen::Vector3d gap = view.enu_from_camera->translation - *view.gnss_in_enu;
    horizontal += gap.head<2>().squaredNorm();
    vertical += gap.z() * gap.z();
    count += 1.0;
  }
  if (count > 0.0) {
    quality.gnss_horizontal_rms_m = std::sqrt(horizontal / count);
    quality.gnss_vertical_rms_m = std::sqrt(vertical / count);
  }
}

}  // namespace hybridfusion
