#include "doctor_checks.hpp"
#include "photo_places.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

// Beyond these the reconstruction calls its georeference unusable.
constexpr double kUsableScale = 0.01;
constexpr double kUsableTilt_deg = 1.0;

}  // namespace

std::string weak_georeference(std::span<const PhotoMetadata> photos,
                              const GnssOptions& options,
                              Diagnosis& diagnosis) {
  const auto ingest = ingest_gnss(photos, options);
  if (!ingest) return {};  // no place at all, which is a finding of its own
  std::vector<Eigen::Vector2d> at;
  std::vector<double> horizontal_m;
  std::vector<double> vertical_m;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const PhotoFix& fix : ingest->fixes) {
    if (!fix.position_in_enu) continue;
    at.emplace_back(fix.position_in_enu->head<2>());
    mean += at.back();
    horizontal_m.push_back(fix.sigma_m.head<2>().maxCoeff());
    if (fix.has_altitude) vertical_m.push_back(fix.sigma_m.z());
  }
  mean /= static_cast<double>(at.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& place : at) {
    scatter += (place - mean) * (place - mean).transpose();
  }
  if (!vertical_m.empty() && ingest->origin.altitude_m < 0.0) {
    diagnosis.facts.push_back(fmt::format(
        "the photos lie {:.1f} m below sea level (median): if the place does not, GPSAltitudeRef "
        "is wrong and so is the height of the result",
        -ingest->origin.altitude_m));
  }
  // Least squares of a similarity: scale over all distances from the middle, tilt over those
  // across the longer side of the block.
  const double scale = median_of(horizontal_m) / std::sqrt(std::max(scatter.trace(), 1e-12));
  const double narrow2 =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvalues().minCoeff();
  const bool has_gimbals = std::ranges::all_of(
      photos, [](const PhotoMetadata& photo) { return photo.gimbal.has_value(); });
  const double tilt_deg =
      vertical_m.empty() || has_gimbals
          ? 0.0
          : median_of(vertical_m) / std::sqrt(std::max(narrow2, 1e-12)) * 180.0 / std::numbers::pi;
  const std::string text =
      fmt::format("by GNSS alone the scale is known to about {:.1f} %{}",
                  100.0 * scale,
                  tilt_deg > 0.0 ? fmt::format(" and the tilt to {:.1f} degrees", tilt_deg) : "");
  diagnosis.facts.push_back(text);
  return scale > kUsableScale || tilt_deg > kUsableTilt_deg ? text : std::string();
}

}  // namespace hybridfusion
