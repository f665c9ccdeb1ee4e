#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>

#include <memory>
#include <span>
#include <string>

#include <Eigen/Core>

namespace hybridfusion {

/// Converts east-north-up coordinates at an origin to a projected system on WGS84 with ellipsoidal
/// heights.
class EnuToProjected {
 public:
  /// @returns kInvalidOptions when PROJ does not know the code.
  [[nodiscard]] static Expected<EnuToProjected> create(const GeodeticOrigin& origin, int epsg);

  EnuToProjected(EnuToProjected&&) noexcept;
  EnuToProjected& operator=(EnuToProjected&&) noexcept;
  ~EnuToProjected();

  /// Easting, northing, ellipsoidal height [m]. @returns kDegenerate where the projection fails.
  [[nodiscard]] Expected<Eigen::Vector3d> operator()(const Eigen::Vector3d& point_in_enu) const;
  /// WKT 1 of the projected system, as LAS wants it.
  [[nodiscard]] const std::string& wkt() const;

 private:
  struct State;
  explicit EnuToProjected(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion
