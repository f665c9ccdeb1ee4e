#pragma once

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace hybridfusion {

/// vision/origin.json.
[[nodiscard]] Expected<void> write_origin(const std::filesystem::path& path,
                                          const GeodeticOrigin& origin);

/// lidar/gnss.json as far as other stages need it.
struct MapGeoreference {
  GeodeticOrigin origin = {};
  Rigid3 enu_from_map = {};
  double heading_sigma_rad = 0.0;  ///< Standard deviation of the rotation about up.
};
[[nodiscard]] Expected<MapGeoreference> read_map_georeference(const std::filesystem::path& path);

/// Standard deviation of the vertical of the LiDAR map in lidar/level.json [rad].
[[nodiscard]] Expected<double> read_map_level(const std::filesystem::path& path);

/// registration/registration.json as far as other stages need it.
struct StoredRegistration {
  bool ok = false;
  Rigid3 vision_from_lidar = {};
  Sim3 fused_from_vision = {};   ///< Identity unless G was rescaled or levelled before fusion.
  Rigid3 fused_from_lidar = {};  ///< vision_from_lidar unless G was levelled.
  std::optional<Rigid3> initial = {};
  double confidence = 0.0;
  double seconds = 0.0;
  std::string method = {};
  std::string reason = {};
};
[[nodiscard]] Expected<StoredRegistration> read_registration(const std::filesystem::path& path);

/// enu_from_camera of the registered photos of a COLMAP model, by name.
[[nodiscard]] Expected<std::map<std::string, Rigid3>> read_camera_poses(
    const std::filesystem::path& folder);

/// Maps coordinates in the east-north-up plane at `source` to the one at `target`; exact, because
/// both are Cartesian frames of the same earth.
[[nodiscard]] Rigid3 enu_from_enu(const GeodeticOrigin& target, const GeodeticOrigin& source);

}  // namespace hybridfusion
