/// @file
/// What faults of the GNSS tags do to the poses of a real flight. Features are extracted and
/// matched once; every fault changes the metadata only, and poses are reconstructed anew. The clean
/// run is the reference: a fault must leave tilt and scale, or the verdict must say that it did
/// not.
#include "matched_photos.hpp"

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/io/dataset_truth.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

using Tags = std::vector<PhotoMetadata>;

struct Fault {
  std::string name;
  std::function<void(Tags&)> apply;
  std::string form = "absolute";
};

void move(PhotoMetadata& photo, const Eigen::Vector3d& shift_m) {
  const GeodeticPosition at{.latitude_deg = *photo.latitude_deg,
                            .longitude_deg = *photo.longitude_deg,
                            .altitude_m = 0.0};
  const GeodeticPosition moved = geodetic_from_enu(at, shift_m);
  photo.latitude_deg = moved.latitude_deg;
  photo.longitude_deg = moved.longitude_deg;
  for (auto* altitude : {&photo.altitude_m, &photo.absolute_altitude_m}) {
    if (*altitude) **altitude += shift_m.z();
  }
}

double seconds_of(const PhotoMetadata& photo) {
  return to_seconds(*photo.time);
}

void add_noise(Tags& tags, double sigma_m) {
  Random random(1, "benchmark/noise");
  for (PhotoMetadata& photo : tags) {
    move(photo, sigma_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal()));
  }
}

void add_drift(Tags& tags, double total_m) {
  const double first_s = seconds_of(tags.front());
  const double duration_s = seconds_of(tags.back()) - first_s;
  for (PhotoMetadata& photo : tags) {
    move(photo, {0.0, 0.0, total_m * (seconds_of(photo) - first_s) / duration_s});
  }
}

/// Each tag shows where the camera was `lag_s` before, at the speed towards its nearer neighbour.
void add_lag(Tags& tags, double lag_s) {
  const Tags clean = tags;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = i + 1 < tags.size() ? i + 1 : i;
    const double to_before_s = seconds_of(clean[i]) - seconds_of(clean[before]);
    const double to_after_s = seconds_of(clean[after]) - seconds_of(clean[i]);
    const bool forward = before == i || (after != i && to_after_s < to_before_s);
    const PhotoMetadata& from = clean[forward ? i : before];
    const PhotoMetadata& to = clean[forward ? after : i];
    const Eigen::Vector3d step = enu_from_geodetic(
        {.latitude_deg = *from.latitude_deg, .longitude_deg = *from.longitude_deg},
        {.latitude_deg = *to.latitude_deg, .longitude_deg = *to.longitude_deg});
    Eigen::Vector3d back = -lag_s / (forward ? to_after_s : to_before_s) * step;
    back.z() = 0.0;
    move(tags[i], back);
  }
}

void set_altitudes(Tags& tags, const std::function<double(double)>& change) {
  for (PhotoMetadata& photo : tags) {
    for (auto* altitude : {&photo.altitude_m, &photo.absolute_altitude_m}) {
      if (*altitude) *altitude = change(**altitude);
    }
  }
}

std::vector<Fault> faults() {
  return {{"clean", [](Tags&) {}},
          {"clean, displacement form", [](Tags&) {}, "displacement"},
          {"white noise 3 m", [](Tags& t) { add_noise(t, 3.0); }},
          {"altitude drift 100 m", [](Tags& t) { add_drift(t, 100.0); }},
          {"one tag 5 km off", [](Tags& t) { move(t[t.size() / 2], {4000.0, 3000.0, 0.0}); }},
          {"altitude sign flipped", [](Tags& t) { set_altitudes(t, std::negate<>{}); }},
          {"altitudes zero", [](Tags& t) { set_altitudes(t, [](double) { return 0.0; }); }},
          {"tags 3 s late", [](Tags& t) { add_lag(t, 3.0); }},
          {"drift and late", [](Tags& t) {
             add_drift(t, 100.0);
             add_lag(t, 3.0);
           }}};
}

std::string_view word_of(GeoreferenceVerdict verdict) {
  return verdict == GeoreferenceVerdict::kGood      ? "good"
         : verdict == GeoreferenceVerdict::kLimited ? "limited"
                                                    : "unusable";
}

/// Tilt [deg], relative scale and offsets [m] of `found` against `reference`.
struct Difference {
  double tilt_deg = 0.0;
  double scale = 0.0;
  double horizontal_m = 0.0;
  double vertical_m = 0.0;
  double rms_m = 0.0;  ///< After a similarity.
};

Expected<Difference> difference(const Reconstruction& reference, const Reconstruction& found) {
  std::vector<Eigen::Vector3d> source;
  std::vector<Eigen::Vector3d> target;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t v = 0; v < reference.views.size(); ++v) {
    const auto& a = reference.views[v].enu_from_camera;
    const auto& b = found.views[v].enu_from_camera;
    if (!a || !b) continue;
    source.push_back(a->translation);
    target.push_back(
        enu_from_geodetic(reference.origin, geodetic_from_enu(found.origin, b->translation)));
    mean += target.back() - source.back();
  }
  HF_TRY(const Sim3 fit, fit_sim3(target, source));
  mean /= static_cast<double>(source.size());
  double sum2 = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    sum2 += (fit * source[i] - target[i]).squaredNorm() / static_cast<double>(source.size());
  }
  return Difference{
      .tilt_deg = std::acos(std::min(1.0, (fit.rotation * Eigen::Vector3d::UnitZ()).z())) / kDegree,
      .scale = fit.scale - 1.0,
      .horizontal_m = mean.head<2>().norm(),
      .vertical_m = mean.z(),
      .rms_m = std::sqrt(sum2)};
}

/// The truth as a reconstruction, one view per photo.
Expected<Reconstruction> truth_of(const std::string& folder, std::span<const Photo> photos) {
  const std::filesystem::path path = folder;
  HF_TRY(const DatasetTruth dataset, read_dataset_truth(path / "dataset.json"));
  HF_TRY(const std::vector<TruePhotoPose> poses, read_true_photo_poses(path / "cameras.csv"));
  Reconstruction truth{.origin = dataset.origin};
  for (const Photo& photo : photos) {
    View view{.name = photo.metadata.name};
    const auto pose = std::ranges::find(poses, view.name, &TruePhotoPose::name);
    if (pose != poses.end()) view.enu_from_camera = pose->enu_from_camera;
    truth.views.push_back(std::move(view));
  }
  return truth;
}

Expected<void> run(const std::string& folder_name,
                   const std::string& truth,
                   const std::string& only) {
  HF_TRY(const PhotoFolder folder, open_photo_folder(folder_name));
  Tags clean;
  for (const Photo& photo : folder.photos) clean.push_back(photo.metadata);
  ReconstructionOptions options;
  const RunContext ctx;
  HF_TRY(const GnssIngest gnss, ingest_gnss(clean, options.gnss));
  HF_TRY(const MatchedPhotos matched, match_photos(folder.photos, gnss, options, ctx));
  std::optional<Reconstruction> reference;
  if (!truth.empty()) {
    HF_TRY(reference, truth_of(truth, folder.photos));
  }
  fmt::print(
      "| fault | photos | tilt deg | scale % | horizontal m | vertical m | after similarity m | "
      "reprojection px | verdict | stated scale %, tilt deg | CPU s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Fault& fault : faults()) {
    if (!only.empty() && fault.name != only && fault.name != "clean") continue;
    Tags tags = clean;
    fault.apply(tags);
    options.gnss.form = fault.form;
    const std::clock_t start = std::clock();
    const auto faulty = ingest_gnss(tags, options.gnss);
    const auto result = faulty ? pose_photos(matched, tags, *faulty, {}, options, ctx)
                               : Expected<Reconstruction>(std::unexpected(faulty.error()));
    const double cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!result) {
      fmt::print("| {} | refused: {} |\n", fault.name, result.error().message);
      continue;
    }
    if (!reference) reference = *result;
    HF_TRY(const Difference d, difference(*reference, *result));
    const auto registered = std::ranges::count_if(
        result->views, [](const View& view) { return view.enu_from_camera.has_value(); });
    fmt::print(
        "| {} | {}/{} | {:.3f} | {:+.3f} | {:.2f} | {:+.2f} | {:.3f} | {:.3f} | {} | "
        "{:.2f}, {:.2f} | {:.1f} |\n",
        fault.name,
        registered,
        result->views.size(),
        d.tilt_deg,
        100.0 * d.scale,
        d.horizontal_m,
        d.vertical_m,
        d.rms_m,
        result->quality.mean_reprojection_px,
        word_of(result->quality.georeference),
        100.0 * result->quality.scale_sigma,
        result->quality.tilt_sigma_rad / kDegree,
        cpu_s);
    for (const std::string& reason : result->quality.georeference_reasons) {
      fmt::print("<!-- {}: {} -->\n", fault.name, reason);
    }
    std::fflush(stdout);
  }
  return {};
}

}  // namespace
}  // namespace hybridfusion

int main(int argc, char** argv) {
  CLI::App app("Faults of the GNSS tags of a flight and what they leave of tilt and scale");
  std::string images;
  std::string only;
  std::string truth;
  app.add_option("--images", images, "Folder of photos with GNSS, time and altitudes")->required();
  app.add_option("--only", only, "One fault (and the clean run)");
  app.add_option("--truth", truth, "Truth folder to compare with, instead of the clean run");
  CLI11_PARSE(app, argc, argv);
  const auto done = hybridfusion::run(images, truth, only);
  if (!done) {
    fmt::print(stderr, "{}\n", done.error().message);
    return 1;
  }
  return 0;
}
