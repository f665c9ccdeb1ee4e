#include "digest.hpp"
#include "doctor_checks.hpp"
#include "position_sources.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPhotos = 3;
constexpr std::size_t kGoodPhotos = 8;
constexpr double kMaxSpan_s = 24.0 * 3600.0;

std::vector<std::string> names_of(std::span<const PhotoMetadata> photos, const auto& matches) {
  std::vector<std::string> names;
  for (const PhotoMetadata& photo : photos) {
    if (matches(photo)) names.push_back(photo.name);
  }
  return names;
}

void check_count(std::size_t usable, const std::filesystem::path& folder, Diagnosis& diagnosis) {
  const std::string cause = fmt::format("{}: {} usable photos", folder.string(), usable);
  if (usable < kMinPhotos) {
    diagnosis.findings.add("photos.too_few", cause);
  } else if (usable < kGoodPhotos) {
    diagnosis.findings.add("photos.few", cause);
  }
}

void check_times(std::span<const PhotoMetadata> photos, Diagnosis& diagnosis) {
  std::optional<Timestamp> first;
  std::optional<Timestamp> last;
  for (const PhotoMetadata& photo : photos) {
    if (!photo.time) continue;
    first = std::min(first.value_or(*photo.time), *photo.time);
    last = std::max(last.value_or(*photo.time), *photo.time);
  }
  if (!first || to_seconds(*last - *first) <= kMaxSpan_s) return;
  diagnosis.findings.add(
      "photos.several_days",
      fmt::format("the photos span {:.1f} days", to_seconds(*last - *first) / 86400.0));
}

void report_listing(const PhotoListing& listing, Diagnosis& diagnosis) {
  PhotoFolderNotes notes = notes_of(listing);
  diagnosis.facts.insert(diagnosis.facts.end(), notes.facts.begin(), notes.facts.end());
  if (notes.left_out.empty()) return;
  diagnosis.findings.add(
      "photos.other_formats",
      fmt::format("{} image files are not JPEG: {}", notes.left_out.size(), listed(notes.left_out)),
      notes.left_out);
}

}  // namespace

void check_cameras(std::span<const PhotoMetadata> photos, Diagnosis& diagnosis) {
  using Key = std::tuple<std::string, std::string, std::string, int, int, double>;
  std::map<Key, std::vector<std::string>> cameras;
  for (const PhotoMetadata& photo : photos) {
    cameras[{photo.make,
             photo.model,
             photo.serial,
             photo.width,
             photo.height,
             photo.focal_mm.value_or(0.0)}]
        .push_back(photo.name);
  }
  if (cameras.size() > 1) {
    std::string cause = fmt::format("{} cameras:", cameras.size());
    std::vector<std::string> rare;
    const auto most = std::ranges::max_element(
        cameras, {}, [](const auto& camera) { return camera.second.size(); });
    for (auto camera = cameras.begin(); camera != cameras.end(); ++camera) {
      const auto& [make, model, serial, width, height, focal_mm] = camera->first;
      const std::vector<std::string> name = {model.empty() ? "unnamed" : model};
      cause += fmt::format(" {} {}x{} at {:g} mm ({} photos)",
                           listed(name),
                           width,
                           height,
                           focal_mm,
                           camera->second.size());
      if (camera != most) rare.insert(rare.end(), camera->second.begin(), camera->second.end());
    }
    diagnosis.findings.add("photos.mixed_cameras", cause, rare);
  }
  auto names = names_of(photos, [](const PhotoMetadata& photo) {
    return !photo.focal_mm && !photo.focal_35mm && !photo.calibrated_focal_px;
  });
  if (!names.empty()) {
    diagnosis.findings.add("photos.no_focal", "no focal length: " + listed(names), names);
  }
  names = names_of(photos, [](const PhotoMetadata& photo) {
    return photo.original_width && *photo.original_width != photo.width &&
           *photo.original_width != photo.height;
  });
  if (!names.empty()) {
    const auto first = std::ranges::find(photos, names.front(), &PhotoMetadata::name);
    diagnosis.findings.add("photos.exif_size",
                           fmt::format("{} is {} px wide, its metadata say {}; so {} photos: {}",
                                       listed({&names.front(), 1}),
                                       first->width,
                                       *first->original_width,
                                       names.size(),
                                       listed(names)),
                           names);
  }
  check_times(photos, diagnosis);
}

Expected<void> check_duplicates(const PhotoFolder& folder,
                                Diagnosis& diagnosis,
                                const RunContext& ctx) {
  std::map<std::uintmax_t, std::vector<std::string>> by_size;
  for (const Photo& photo : folder.photos) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(folder.folder / photo.metadata.name, ignored);
    by_size[size].push_back(photo.metadata.name);
  }
  std::vector<std::string> copies;
  for (const auto& [size, names] : by_size) {
    if (names.size() < 2) continue;
    std::set<std::string> digests;
    for (const std::string& name : names) {
      if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while comparing photos");
      const auto digest = sha256_of_file(folder.folder / name);
      if (digest && !digests.insert(*digest).second) copies.push_back(name);
    }
  }
  if (!copies.empty()) {
    diagnosis.findings.add(
        "photos.duplicate",
        fmt::format("{} copies of other photos: {}", copies.size(), listed(copies)),
        copies);
  }
  return {};
}

Expected<PhotoEvidence> check_photos(const PhotoInputs& given,
                                     std::optional<double> ground_altitude_m,
                                     const VisionStageOptions& options,
                                     Diagnosis& diagnosis,
                                     const RunContext& ctx) {
  const PhotoInputs inputs = with_files_beside(given);
  const std::filesystem::path& images = inputs.images;
  auto folder = open_photo_folder(images);
  if (!folder) {
    diagnosis.findings.add("photos.folder", folder.error().message);
    return PhotoEvidence{};
  }
  report_listing(folder->listing, diagnosis);
  const std::size_t num_control = check_sources(inputs, options, *folder, diagnosis);
  std::vector<PhotoMetadata> photos;
  PhotoEvidence evidence{.num_photos = folder->photos.size()};
  for (const Photo& photo : folder->photos) {
    const PhotoMetadata& metadata = photo.metadata;
    photos.push_back(metadata);
    evidence.width_px = std::max(evidence.width_px, metadata.width);
    evidence.height_px = std::max(evidence.height_px, metadata.height);
    if (!metadata.latitude_deg || !metadata.longitude_deg) continue;
    evidence.positions.push_back({.latitude_deg = *metadata.latitude_deg,
                                  .longitude_deg = *metadata.longitude_deg,
                                  .altitude_m = known_altitude_m(metadata).value_or(NAN)});
    if (metadata.relative_altitude_m && known_altitude_m(metadata)) {
      evidence.take_off_altitudes_m.push_back(*known_altitude_m(metadata) -
                                              *metadata.relative_altitude_m);
    }
  }
  diagnosis.facts.push_back(fmt::format("photos: {} usable of {}, largest {} x {} px",
                                        photos.size(),
                                        photos.size() + folder->quarantined.size(),
                                        evidence.width_px,
                                        evidence.height_px));
  check_count(photos.size(), images, diagnosis);
  check_cameras(photos, diagnosis);
  check_positions(images, photos, num_control, options.reconstruction.gnss, diagnosis);
  if (num_control < kMinPhotos) {
    evidence.weak_georeference = weak_georeference(photos, options.reconstruction.gnss, diagnosis);
  }
  check_overlap(photos, ground_altitude_m, options.reconstruction.gnss, diagnosis);
  if (auto checked = check_duplicates(*folder, diagnosis, ctx); !checked) {
    return std::unexpected(checked.error());
  }
  if (auto checked = check_pixels(*folder, diagnosis, ctx); !checked) {
    return std::unexpected(checked.error());
  }
  return evidence;
}

}  // namespace hybridfusion
