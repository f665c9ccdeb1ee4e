#include "text.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>

#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kMaxBytes = 1U << 20;

/// Why a value cannot be used; empty when it was stored.
using Reader = std::function<std::string(const YAML::Node&, SensorConfig&)>;

[[nodiscard]] Reader text(std::optional<std::string> SensorConfig::* member) {
  return [member](const YAML::Node& node, SensorConfig& config) {
    config.*member = node.as<std::string>();
    return std::string();
  };
}

/// @param max  Noise above it is a wrong unit, not a sensor.
[[nodiscard]] Reader density(std::optional<double> SensorConfig::* member, double max) {
  return [member, max](const YAML::Node& node, SensorConfig& config) {
    const auto value = node.as<double>();
    if (!(value > 0.0 && value <= max)) return fmt::format("{} is outside (0, {}]", value, max);
    config.*member = value;
    return std::string();
  };
}

[[nodiscard]] std::string read_unit(const YAML::Node& node, SensorConfig& config) {
  const auto unit = node.as<std::string>();
  if (unit != "s" && unit != "ms" && unit != "us" && unit != "ns") {
    return fmt::format("'{}' is not one of s, ms, us, ns", printable(unit));
  }
  config.point_time_unit = unit;
  return {};
}

[[nodiscard]] std::string read_imu_from_lidar(const YAML::Node& node, SensorConfig& config) {
  const auto numbers = node.as<std::vector<double>>();
  if (numbers.size() != 16)
    return fmt::format("{} numbers instead of 16 (4x4, row-major)", numbers.size());
  Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  constexpr double kTolerance = 1e-3;
  const bool is_rotation = matrix.allFinite() && rotation.determinant() > 0.0 &&
                           (rotation * rotation.transpose()).isIdentity(kTolerance);
  if (!is_rotation || !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), kTolerance)) {
    return "is not a rotation and a translation (4x4, row-major, last row 0 0 0 1)";
  }
  config.imu_from_lidar = Rigid3::from_matrix(matrix);
  return {};
}

[[nodiscard]] std::string read_time_offset(const YAML::Node& node, SensorConfig& config) {
  const auto value = node.as<double>();
  constexpr double kMaxOffset_s = 10.0;
  if (!(std::abs(value) <= kMaxOffset_s)) {
    return fmt::format("{} is outside [-{}, {}] s", value, kMaxOffset_s, kMaxOffset_s);
  }
  config.imu_time_offset_s = value;
  return {};
}

[[nodiscard]] std::string read_antenna(const YAML::Node& node, SensorConfig& config) {
  const auto numbers = node.as<std::vector<double>>();
  if (numbers.size() != 3) return fmt::format("{} numbers instead of 3", numbers.size());
  const Eigen::Vector3d arm(numbers[0], numbers[1], numbers[2]);
  constexpr double kMaxArm_m = 100.0;
  if (!(arm.norm() <= kMaxArm_m)) return fmt::format("is longer than {} m", kMaxArm_m);
  config.gnss_antenna_in_imu = arm;
  return {};
}

[[nodiscard]] const std::map<std::string, Reader>& readers() {
  using T = SensorConfig;
  static const std::map<std::string, Reader> kReaders = {
      {"lidar_topic", text(&T::lidar_topic)},
      {"imu_topic", text(&T::imu_topic)},
      {"gnss_topic", text(&T::gnss_topic)},
      {"lidar_frame", text(&T::lidar_frame)},
      {"imu_frame", text(&T::imu_frame)},
      {"point_time_field", text(&T::point_time_field)},
      {"point_time_unit", read_unit},
      {"imu_from_lidar", read_imu_from_lidar},
      {"imu_time_offset_s", read_time_offset},
      {"gnss_antenna_in_imu", read_antenna},
      {"gyro_noise_density", density(&T::gyro_noise_density, 10.0)},
      {"accel_noise_density", density(&T::accel_noise_density, 100.0)},
      {"gyro_bias_walk", density(&T::gyro_bias_walk, 10.0)},
      {"accel_bias_walk", density(&T::accel_bias_walk, 100.0)},
  };
  return kReaders;
}

[[nodiscard]] std::string known_keys() {
  std::string known;
  for (const auto& [key, reader] : readers()) known += (known.empty() ? "" : ", ") + key;
  return known;
}

Expected<void> read_entry(const std::string& path,
                          const YAML::Node& key_node,
                          const YAML::Node& value,
                          SensorConfig& config) {
  const int line = key_node.Mark().line + 1;
  const auto key = key_node.as<std::string>();
  const auto reader = readers().find(key);
  if (reader == readers().end()) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("{}: line {}: unknown key '{}'; known keys: {}",
                            path,
                            line,
                            printable(key),
                            known_keys()));
  }
  try {
    const std::string problem = reader->second(value, config);
    if (problem.empty()) return {};
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("{}: line {}: {}: {}; correct it or leave it out", path, line, key, problem));
  } catch (const YAML::Exception&) {
    return fail(
        ErrorCode::kParse,
        fmt::format("{}: line {}: {} has a value of the wrong type; correct it or leave it out",
                    path,
                    line,
                    key));
  }
}

}  // namespace

Expected<SensorConfig> read_sensors_yaml(const std::filesystem::path& path) {
  HF_TRY(const std::string content, read_text_file(path, kMaxBytes));
  SensorConfig config;
  try {
    const YAML::Node root = YAML::Load(content);
    if (root.IsNull()) return config;
    if (!root.IsMap()) {
      return fail(
          ErrorCode::kParse,
          fmt::format(
              "{}: not a map of 'key: value' lines; known keys: {}", path.string(), known_keys()));
    }
    for (const auto& entry : root) {
      if (auto read = read_entry(path.string(), entry.first, entry.second, config); !read) {
        return std::unexpected(read.error());
      }
    }
  } catch (const YAML::Exception& error) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: line {}: not valid YAML ({}); correct the file",
                            path.string(),
                            error.mark.line + 1,
                            error.msg));
  }
  return config;
}

std::string to_yaml(const SensorConfig& config) {
  YAML::Emitter out;
  out.SetDoublePrecision(12);
  const auto put = [&](const char* key, const auto& value) {
    if (value) out << YAML::Key << key << YAML::Value << *value;
  };
  const auto put_numbers = [&](const char* key, const std::vector<double>& numbers) {
    out << YAML::Key << key << YAML::Value << YAML::Flow << numbers;
  };
  out << YAML::BeginMap;
  put("lidar_topic", config.lidar_topic);
  put("imu_topic", config.imu_topic);
  put("gnss_topic", config.gnss_topic);
  put("lidar_frame", config.lidar_frame);
  put("imu_frame", config.imu_frame);
  put("point_time_field", config.point_time_field);
  put("point_time_unit", config.point_time_unit);
  if (config.imu_from_lidar) {
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = config.imu_from_lidar->matrix();
    put_numbers("imu_from_lidar", {matrix.data(), matrix.data() + matrix.size()});
  }
  put("imu_time_offset_s", config.imu_time_offset_s);
  if (const auto& arm = config.gnss_antenna_in_imu) {
    put_numbers("gnss_antenna_in_imu", {arm->x(), arm->y(), arm->z()});
  }
  put("gyro_noise_density", config.gyro_noise_density);
  put("accel_noise_density", config.accel_noise_density);
  put("gyro_bias_walk", config.gyro_bias_walk);
  put("accel_bias_walk", config.accel_bias_walk);
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace hybridfusion
