#include "workspace_data.hpp"

#include "json_text.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/colmap_model.hpp>

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kMaxJsonBytes = 256U << 20U;

GeodeticOrigin origin_of(const Json& json) {
  return {.latitude_deg = json.at("latitude_deg"),
          .longitude_deg = json.at("longitude_deg"),
          .altitude_m = json.at("altitude_m")};
}

Sim3 sim3_of(const Eigen::Matrix4d& matrix) {
  const double scale = std::cbrt(matrix.topLeftCorner<3, 3>().determinant());
  Eigen::Matrix4d rigid = matrix;
  rigid.topLeftCorner<3, 3>() /= scale;
  const Rigid3 motion = Rigid3::from_matrix(rigid);
  return {.rotation = motion.rotation, .translation = motion.translation, .scale = scale};
}

/// Runs a reader of JSON members, turning its exceptions into an error that names the file.
template <class Read>
auto parsed(const std::filesystem::path& path, Read read)
    -> Expected<decltype(read(std::declval<const Json&>()))> {
  HF_TRY(const Json json, read_json(path));
  try {
    return read(json);
  } catch (const Json::exception& error) {
    return fail(
        ErrorCode::kParse,
        fmt::format("{}: {}; run the stage that writes it again", path.string(), error.what()));
  }
}

}  // namespace

Expected<Json> read_json(const std::filesystem::path& path) {
  HF_TRY(const std::string text, read_text_file(path, kMaxJsonBytes));
  try {
    return Json::parse(text);
  } catch (const Json::exception& error) {
    return fail(ErrorCode::kParse, fmt::format("{}: not JSON ({})", path.string(), error.what()));
  }
}

Eigen::Matrix4d matrix_of(const Json& numbers) {
  const auto values = numbers.get<std::array<double, 16>>();
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
}

Expected<void> write_origin(const std::filesystem::path& path, const GeodeticOrigin& origin) {
  const Json json = {{"latitude_deg", origin.latitude_deg},
                     {"longitude_deg", origin.longitude_deg},
                     {"altitude_m", origin.altitude_m},
                     {"datum", "WGS84"}};
  return write_file_atomically(path, to_text(json));
}

Expected<GeodeticOrigin> read_origin(const std::filesystem::path& path) {
  HF_TRY(const GeodeticOrigin origin, parsed(path, origin_of));
  const bool on_earth = std::abs(origin.latitude_deg) <= 90.0 &&
                        std::abs(origin.longitude_deg) <= 360.0 && std::isfinite(origin.altitude_m);
  if (!on_earth) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: latitude {}, longitude {}, altitude {} is no place on Earth; give "
                            "degrees and metres",
                            path.string(),
                            origin.latitude_deg,
                            origin.longitude_deg,
                            origin.altitude_m));
  }
  return origin;
}

Expected<MapGeoreference> read_map_georeference(const std::filesystem::path& path) {
  return parsed(path, [](const Json& json) {
    return MapGeoreference{
        .origin = origin_of(json.at("origin")),
        .enu_from_map = Rigid3::from_matrix(matrix_of(json.at("enu_from_map"))),
        .heading_sigma_rad = json.at("heading_sigma_deg").get<double>() * std::numbers::pi / 180.0};
  });
}

Expected<double> read_map_level(const std::filesystem::path& path) {
  return parsed(path, [](const Json& json) {
    return json.at("vertical_sigma_deg").get<double>() * std::numbers::pi / 180.0;
  });
}

Expected<StoredRegistration> read_registration(const std::filesystem::path& path) {
  return parsed(path, [](const Json& json) {
    StoredRegistration result{.ok = json.at("status") == "ok"};
    result.confidence = json.value("confidence", 0.0);
    result.seconds = json.value("seconds", 0.0);
    result.method = json.value("method", "");
    result.reason = json.value("reason", "");
    if (json.contains("initial") && json["initial"].is_array()) {
      result.initial = Rigid3::from_matrix(matrix_of(json["initial"]));
    }
    if (!result.ok) return result;
    result.vision_from_lidar = Rigid3::from_matrix(matrix_of(json.at("vision_from_lidar")));
    if (json.contains("fused_from_vision")) {
      result.fused_from_vision = sim3_of(matrix_of(json["fused_from_vision"]));
    }
    result.fused_from_lidar = json.contains("fused_from_lidar")
                                  ? Rigid3::from_matrix(matrix_of(json["fused_from_lidar"]))
                                  : result.vision_from_lidar;
    return result;
  });
}

Expected<std::map<std::string, Rigid3>> read_camera_poses(const std::filesystem::path& folder) {
  HF_TRY(const ColmapModel model, read_colmap_model(folder));
  std::map<std::string, Rigid3> poses;
  for (const ColmapImage& image : model.images) {
    const Rigid3 camera_from_enu{.rotation = image.camera_from_world,
                                 .translation = image.camera_from_world_translation};
    poses[image.name] = camera_from_enu.inverse();
  }
  return poses;
}

Rigid3 enu_from_enu(const GeodeticOrigin& target, const GeodeticOrigin& source) {
  std::array<Eigen::Vector3d, 4> points = {Eigen::Vector3d::Zero(),
                                           Eigen::Vector3d::UnitX() * 1000.0,
                                           Eigen::Vector3d::UnitY() * 1000.0,
                                           Eigen::Vector3d::UnitZ() * 1000.0};
  std::array<Eigen::Vector3d, 4> mapped;
  for (std::size_t i = 0; i < points.size(); ++i) {
    mapped[i] = enu_from_geodetic(target, geodetic_from_enu(source, points[i]));
  }
  const auto rigid = fit_rigid3(mapped, points);
  HF_CHECK(rigid.has_value());  // four points in general position
  return *rigid;
}

}  // namespace hybridfusion
