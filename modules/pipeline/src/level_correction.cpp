#include "level_correction.hpp"

#include "positions_csv.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kMaxCsvBytes = 64U << 20U;
constexpr double kDegPerRad = 180.0 / std::numbers::pi;
/// The LiDAR map must know the vertical this much better than the photo model.
constexpr double kMinGain = 2.0;
/// A tilt beyond this many deviations is a contradiction, not an error to be corrected.
constexpr double kMaxDeviations = 5.0;

/// Covariance of the rotation about the camera's axes [rad^2] in a record of pose_covariance.csv.
std::optional<Eigen::Matrix3d> rotation_covariance(const std::vector<std::string>& fields) {
  constexpr std::size_t kColumns = 28;
  constexpr std::size_t kFirst = 22;  // c44 c45 c46 c55 c56 c66
  if (fields.size() != kColumns) return std::nullopt;
  std::array<double, 6> c{};
  for (std::size_t k = 0; k < c.size(); ++k) {
    const std::string& field = fields[kFirst + k];
    const char* end = field.data() + field.size();
    const auto parsed = std::from_chars(field.data(), end, c[k]);
    if (parsed.ec != std::errc{} || parsed.ptr != end || !std::isfinite(c[k])) return std::nullopt;
  }
  Eigen::Matrix3d covariance;
  covariance << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return covariance;
}

/// Median over the photos of the deviation of a horizontal axis; the photos of a block share their
/// tilt.
Expected<std::optional<double>> tilt_sigma_of(const std::filesystem::path& covariances,
                                              const std::map<std::string, Rigid3>& poses) {
  HF_TRY(const std::string text, read_text_file(covariances, kMaxCsvBytes));
  std::vector<double> sigmas;
  std::size_t at = 0;
  next_csv_record(text, at);  // the header
  while (at < text.size()) {
    const std::vector<std::string> fields = next_csv_record(text, at);
    const auto in_camera = rotation_covariance(fields);
    if (!in_camera) {
      return fail(ErrorCode::kParse,
                  fmt::format("{}: a record does not hold a name and 27 numbers; run reconstruct "
                              "again",
                              covariances.string()));
    }
    const auto pose = poses.find(fields.front());
    if (pose == poses.end()) continue;
    const Eigen::Matrix3d rotation = pose->second.rotation.toRotationMatrix();
    const Eigen::Matrix3d in_enu = rotation * *in_camera * rotation.transpose();
    sigmas.push_back(std::sqrt(std::max(0.0, 0.5 * in_enu.topLeftCorner<2, 2>().trace())));
  }
  if (sigmas.empty()) return std::nullopt;
  const auto middle = sigmas.begin() + std::ssize(sigmas) / 2;
  std::ranges::nth_element(sigmas, middle);
  return *middle;
}

std::string reason_against(const LevelCorrection& level, const LevelEvidence& evidence) {
  if (!evidence.lidar_sigma_rad) return "how level the LiDAR map is is not known";
  if (!evidence.vision_sigma_rad || !evidence.cameras_middle) {
    return "how level the photo model is is not known";
  }
  if (level.lidar_sigma_rad * kMinGain > level.vision_sigma_rad) {
    return fmt::format("the photo model is level to {:.3f} deg, the LiDAR map to {:.3f} deg",
                       kDegPerRad * level.vision_sigma_rad,
                       kDegPerRad * level.lidar_sigma_rad);
  }
  const double expected = std::hypot(level.vision_sigma_rad, level.lidar_sigma_rad);
  if (level.tilt_rad > kMaxDeviations * expected) {
    return fmt::format(
        "a tilt of {:.2f} deg contradicts the deviations of both, {:.3f} and {:.3f} "
        "deg",
        kDegPerRad * level.tilt_rad,
        kDegPerRad * level.vision_sigma_rad,
        kDegPerRad * level.lidar_sigma_rad);
  }
  return {};
}

}  // namespace

Expected<LevelEvidence> read_level_evidence(const std::optional<std::filesystem::path>& covariances,
                                            const std::optional<std::filesystem::path>& level) {
  LevelEvidence evidence;
  if (level) {
    HF_TRY(evidence.lidar_sigma_rad, read_map_level(*level));
  }
  if (!covariances) return evidence;
  HF_TRY(const auto poses, read_camera_poses(covariances->parent_path()));
  HF_TRY(evidence.vision_sigma_rad, tilt_sigma_of(*covariances, poses));
  if (poses.empty()) return evidence;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [name, enu_from_camera] : poses) sum += enu_from_camera.translation;
  evidence.cameras_middle = sum / static_cast<double>(poses.size());
  return evidence;
}

LevelCorrection level_correction(const RegistrationResult& result, const LevelEvidence& evidence) {
  const Eigen::Vector3d up = result.vision_from_lidar.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()).normalized();
  // Of the pose: rotations about x and y of the LiDAR frame, where z is up.
  const double pose_variance = 0.5 * (result.covariance(3, 3) + result.covariance(4, 4));
  LevelCorrection level{.tilt_rad = rotation_distance_rad(turn, Eigen::Quaterniond::Identity()),
                        .lidar_sigma_rad = std::hypot(evidence.lidar_sigma_rad.value_or(0.0),
                                                      std::sqrt(std::max(0.0, pose_variance))),
                        .vision_sigma_rad = evidence.vision_sigma_rad.value_or(0.0)};
  level.reason = reason_against(level, evidence);
  level.applied = level.reason.empty();
  if (!level.applied) return level;
  const Eigen::Vector3d middle = *evidence.cameras_middle;
  level.level_from_vision = {.rotation = turn, .translation = middle - turn * middle};
  return level;
}

Json json_of(const LevelCorrection& level) {
  return {{"corrected", level.applied},
          {"tilt_deg", kDegPerRad * level.tilt_rad},
          {"lidar_sigma_deg", kDegPerRad * level.lidar_sigma_rad},
          {"vision_sigma_deg", kDegPerRad * level.vision_sigma_rad},
          {"reason", level.reason}};
}

}  // namespace hybridfusion
