#include "json_file.hpp"
#include "text.hpp"
#include "text_lines.hpp"

#include <hybridfusion/io/dataset_truth.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr std::string_view kAgain = "copy the data set again";

[[nodiscard]] std::optional<TrueCamera> read_camera(const nlohmann::json& root) {
  const auto found = root.find("camera");
  if (found == root.end() || !found->is_object()) return std::nullopt;
  const auto width = json_number(*found, "width");
  const auto height = json_number(*found, "height");
  const auto focal = json_number(*found, "f");
  const auto cx = json_number(*found, "cx");
  const auto cy = json_number(*found, "cy");
  if (!width || !height || !focal || !cx || !cy) return std::nullopt;
  return TrueCamera{.width_px = static_cast<int>(std::clamp(*width, 0.0, 1e6)),
                    .height_px = static_cast<int>(std::clamp(*height, 0.0, 1e6)),
                    .focal_px = *focal,
                    .principal_point_px = {*cx, *cy},
                    .k1 = json_number(*found, "k1").value_or(0.0),
                    .k2 = json_number(*found, "k2").value_or(0.0)};
}

Expected<std::optional<Rigid3>> optional_rigid(const std::filesystem::path& path,
                                               const nlohmann::json& root,
                                               std::string_view key) {
  if (!root.contains(key)) return std::nullopt;
  HF_TRY(const Rigid3 rigid, json_rigid(path, root, key));
  return rigid;
}

/// Columns of cameras.csv; the last three may be missing.
enum Column : std::size_t {
  kName,
  kTime,
  kX,
  kY,
  kZ,
  kQw,
  kQx,
  kQy,
  kQz,
  kGnssE,
  kGnssN,
  kGnssU,
  kColumns
};

[[nodiscard]] std::optional<TruePhotoPose> parse_pose(const std::vector<std::string_view>& fields) {
  if (fields.size() < kGnssE) return std::nullopt;
  std::array<std::optional<double>, kColumns> numbers = {};
  for (std::size_t i = kTime; i < std::min<std::size_t>(fields.size(), kColumns); ++i) {
    const auto value = parse_number<double>(fields[i]);
    if (value && std::isfinite(*value)) numbers[i] = value;
    if (!numbers[i] && i < kGnssE) return std::nullopt;
  }
  const Eigen::Quaterniond rotation(*numbers[kQw], *numbers[kQx], *numbers[kQy], *numbers[kQz]);
  if (!(rotation.norm() > 1e-3)) return std::nullopt;
  TruePhotoPose pose = {
      .name = std::string(fields[kName]),
      .time_s = *numbers[kTime],
      .enu_from_camera = {.rotation = rotation.normalized(),
                          .translation = {*numbers[kX], *numbers[kY], *numbers[kZ]}}};
  if (numbers[kGnssE] && numbers[kGnssN] && numbers[kGnssU]) {
    pose.gnss_in_enu = Eigen::Vector3d(*numbers[kGnssE], *numbers[kGnssN], *numbers[kGnssU]);
  }
  return pose;
}

}  // namespace

Expected<DatasetTruth> read_dataset_truth(const std::filesystem::path& dataset_json) {
  HF_TRY(const nlohmann::json root, read_json_object(dataset_json));
  const auto origin = root.find("origin");
  const bool has_origin = origin != root.end() && origin->is_object();
  const auto latitude = has_origin ? json_number(*origin, "lat") : std::nullopt;
  const auto longitude = has_origin ? json_number(*origin, "lon") : std::nullopt;
  const auto height = has_origin ? json_number(*origin, "h") : std::nullopt;
  if (!latitude || !longitude || !height) {
    return fail(
        ErrorCode::kParse,
        fmt::format(
            "{}: there is no origin with lat, lon and h; {}", dataset_json.string(), kAgain));
  }
  DatasetTruth truth = {
      .origin = {.latitude_deg = *latitude, .longitude_deg = *longitude, .altitude_m = *height},
      .camera = read_camera(root)};
  HF_TRY(truth.enu_from_imu_at_first_scan,
         optional_rigid(dataset_json, root, "T_enu_imu_at_first_scan"));
  HF_TRY(truth.imu_from_lidar, optional_rigid(dataset_json, root, "T_imu_lidar"));
  return truth;
}

Expected<std::vector<TruePhotoPose>> read_true_photo_poses(
    const std::filesystem::path& cameras_csv) {
  HF_TRY(TextLines lines, TextLines::open(cameras_csv));
  std::vector<TruePhotoPose> poses;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return poses;
    const std::vector<std::string_view> fields = split_fields(*line, ',');
    const bool is_heading = fields.front() == "name";
    if (trimmed(*line).empty() || is_heading) continue;
    auto pose = parse_pose(fields);
    if (!pose) return lines.malformed("not 'name,time,x,y,z,qw,qx,qy,qz,...'", kAgain);
    poses.push_back(std::move(*pose));
  }
}

}  // namespace hybridfusion
