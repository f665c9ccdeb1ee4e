#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A coordinate reference system as a file names it.
struct CrsDescription {
  std::string name = {};                  ///< "WGS 84 / UTM zone 32N"; empty: none or unknown.
  std::string wkt = {};                   ///< Empty when it cannot be said.
  bool geographic = false;                ///< Coordinates are degrees.
  double metres_per_unit = 1.0;           ///< Of the horizontal coordinates.
  double vertical_metres_per_unit = 1.0;  ///< Of the heights.
};

/// A cloud whose coordinates may be too large for float.
struct PlacedCloud {
  PointCloud cloud = {};
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< Position in the CRS = cloud + offset.
  CrsDescription crs = {};
  std::vector<std::string> warnings = {};
};

/// Says where a local cloud lies: its coordinates are east, north, up at `origin`.
struct Georeference {
  GeodeticOrigin origin = {};
  std::string crs = {};  ///< Target: "EPSG:n" or "EPSG:n+m"; empty: the UTM zone of the origin.
  bool allow_ballpark = false;  ///< Also where PROJ promises no better than 5 m.
};

/// Brings the clouds of one place into the coordinates of a CRS.
class CloudProjector {
 public:
  /// @returns kInvalidOptions for a CRS that cannot be used, kDegenerate where it does not reach.
  [[nodiscard]] static Expected<CloudProjector> create(const Georeference& georeference);
  CloudProjector(CloudProjector&&) noexcept;
  CloudProjector& operator=(CloudProjector&&) noexcept;
  ~CloudProjector();

  /// Without the normals, whose axes are not those of the grid. @returns kDegenerate for a point
  /// that the CRS does not reach.
  [[nodiscard]] Expected<PointCloud> operator()(PointCloud cloud) const;
  [[nodiscard]] const Eigen::Vector3d& offset_m() const;  ///< Position in the CRS = point + offset.
  [[nodiscard]] const CrsDescription& crs() const;
  [[nodiscard]] const std::string& warning() const;  ///< On the accuracy; empty: none.

 private:
  struct State;
  explicit CloudProjector(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion
