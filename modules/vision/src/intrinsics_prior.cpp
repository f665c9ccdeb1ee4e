#include "intrinsics_prior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDiagonal35_mm = 43.266615;  // of a 36 x 24 mm frame
constexpr double kGuess = 1.2;                // focal length over longest side, as COLMAP guesses

struct SensorRow {
  std::string_view model;
  double width_mm;
};
constexpr std::array kSensors = {
    SensorRow{"FC220", 6.17},
    SensorRow{"FC300C", 6.31},
    SensorRow{"FC300S", 6.31},
    SensorRow{"FC300X", 6.31},
    SensorRow{"FC330", 6.25},
    SensorRow{"FC350", 6.25},
    SensorRow{"FC550", 17.3},
    SensorRow{"FC6310", 13.2},
    SensorRow{"FC6310S", 13.2},
    SensorRow{"FC6360", 4.87},
    SensorRow{"FC6520", 17.3},
    SensorRow{"FC2103", 6.17},
    SensorRow{"FC2204", 6.17},
    SensorRow{"FC3170", 6.4},
    SensorRow{"FC3411", 13.2},
    SensorRow{"FC3582", 9.7},
    SensorRow{"FC7203", 6.3},
    SensorRow{"FC7303", 6.3},
    SensorRow{"L1D-20c", 13.2},
    SensorRow{"L2D-20c", 17.3},
    SensorRow{"M3E", 17.3},
    SensorRow{"ZenmuseP1", 35.9},
    SensorRow{"Anafi", 5.91},
    SensorRow{"ILCE-6000", 23.5},
    SensorRow{"ILCE-7R", 35.9},
    SensorRow{"DSC-RX1RM2", 35.9},
    SensorRow{"DSC-WX220", 6.17},
    SensorRow{"Canon PowerShot SX260 HS", 6.17},
    SensorRow{"Canon PowerShot S100", 7.44},
};

std::optional<double> sensor_width_mm(const std::string& model) {
  const auto row = std::ranges::find(kSensors, model, &SensorRow::model);
  return row != kSensors.end() ? std::optional(row->width_mm) : std::nullopt;
}

struct FocalSource {
  std::string_view name;
  double focal_px;
};

/// Everything the metadata says about the focal length, most trusted first.
std::vector<FocalSource> focal_sources(const PhotoMetadata& photo) {
  std::vector<FocalSource> sources;
  const double longest = std::max(photo.width, photo.height);
  const double reduction =
      photo.original_width && *photo.original_width > 0
          ? longest / std::max(longest, static_cast<double>(*photo.original_width))
          : 1.0;
  const auto add = [&](std::string_view name, double focal_px) {
    // A ratio outside this range is no lens but a damaged tag.
    if (focal_px > 0.2 * longest && focal_px < 50.0 * longest) sources.push_back({name, focal_px});
  };
  if (photo.calibrated_focal_px) add("factory calibration", *photo.calibrated_focal_px);
  if (photo.focal_35mm) {
    add("35 mm equivalent",
        *photo.focal_35mm / kDiagonal35_mm * std::hypot(photo.width, photo.height));
  }
  if (photo.focal_mm) {
    if (const auto width = sensor_width_mm(photo.model)) {
      add("sensor table", *photo.focal_mm / *width * longest);
    }
    // Reduced copies keep the resolution of the original: it is scaled by what EXIF says of it.
    if (photo.focal_plane_px_per_mm && photo.original_width) {
      add("focal plane resolution", *photo.focal_mm * *photo.focal_plane_px_per_mm * reduction);
    }
  }
  return sources;
}

void set_focal(CameraPrior& prior,
               const PhotoMetadata& photo,
               const IntrinsicsOptions& options,
               std::vector<std::string>& warnings) {
  prior.focal_sigma = options.focal_sigma_exif;
  if (options.focal_px > 0.0) {
    prior.intrinsics.focal_px = options.focal_px;
    return;
  }
  const std::vector<FocalSource> sources = focal_sources(photo);
  if (sources.empty()) {
    prior.intrinsics.focal_px = kGuess * std::max(photo.width, photo.height);
    prior.focal_sigma = options.focal_sigma_guess;
    prior.focal_guessed = true;
    warnings.push_back(
        fmt::format("{}: no focal length in the metadata, {:.0f} px assumed; set "
                    "vision.reconstruction.intrinsics.focal_px if "
                    "it is known",
                    photo.name,
                    prior.intrinsics.focal_px));
    return;
  }
  prior.intrinsics.focal_px = sources.front().focal_px;
  if (photo.calibrated_focal_px) prior.focal_sigma = options.focal_sigma_factory;
  for (const FocalSource& other : sources) {
    if (std::abs(std::log(other.focal_px / sources.front().focal_px)) < std::log(1.1)) continue;
    warnings.push_back(fmt::format("{}: focal length is {:.0f} px by {} but {:.0f} px by {}",
                                   photo.name,
                                   sources.front().focal_px,
                                   sources.front().name,
                                   other.focal_px,
                                   other.name));
    prior.focal_sigma = std::max(prior.focal_sigma, options.focal_sigma_guess);
  }
}

}  // namespace

CameraSetup group_cameras(std::span<const PhotoMetadata> photos,
                          const IntrinsicsOptions& options,
                          int max_size_px) {
  using Key = std::tuple<std::string, std::string, std::string, int, int, double, double>;
  std::map<Key, std::uint32_t> known;
  CameraSetup setup;
  for (const PhotoMetadata& photo : photos) {
    const Key key{photo.make,
                  photo.model,
                  photo.serial,
                  photo.width,
                  photo.height,
                  photo.focal_mm.value_or(0.0),
                  photo.focal_35mm.value_or(0.0)};
    const auto [entry, is_new] =
        known.try_emplace(key, static_cast<std::uint32_t>(setup.cameras.size()));
    setup.camera_of_photo.push_back(entry->second);
    if (!is_new) continue;
    CameraPrior prior;
    prior.intrinsics.width_px = photo.width;
    prior.intrinsics.height_px = photo.height;
    prior.intrinsics.principal_point_px = {0.5 * (photo.width - 1), 0.5 * (photo.height - 1)};
    prior.pixel_scale =
        std::max(1.0, std::max(photo.width, photo.height) / static_cast<double>(max_size_px));
    set_focal(prior, photo, options, setup.warnings);
    setup.cameras.push_back(prior);
  }
  return setup;
}

}  // namespace hybridfusion
