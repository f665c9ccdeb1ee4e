#pragma once

#include "mesh_builder.hpp"
#include "scene.hpp"

#include <cstdint>
#include <vector>

namespace hybridfusion {

/// Plan of the streets in the block frame (turned by yaw_rad about the ENU origin).
struct StreetPlan {
  double yaw_rad = 0.0;
  double street_width_m = 9.0;
  double pavement_width_m = 2.6;
  std::vector<double> street_x = {};  ///< Centre lines of the streets along y, ascending [m].
  std::vector<double> street_y = {};  ///< Centre lines of the streets along x, ascending [m].
  Eigen::Vector2d core_half_m = {40.0, 36.0};  ///< Built-up area in the block frame.
  bool streets = true;
};

enum class GroundKind : std::uint8_t { kRoad, kPavement, kYard, kGrass };

/// The ground: slope, waves, hills around, streets a kerb lower.
class Terrain {
 public:
  Terrain(StreetPlan plan, double relief_m, std::uint64_t seed);

  [[nodiscard]] const StreetPlan& plan() const { return plan_; }
  [[nodiscard]] GroundFrame frame() const { return {.yaw_rad = plan_.yaw_rad}; }
  /// Smooth ground without kerbs at a point of the block frame [m].
  [[nodiscard]] double height(double x, double y) const;
  [[nodiscard]] GroundKind kind(double x, double y) const;
  /// Of the surface one stands on: as height(), less the kerb on a road.
  [[nodiscard]] double surface_height(double x, double y) const;
  [[nodiscard]] Eigen::Vector3d on_ground(double x, double y) const {
    return {x, y, surface_height(x, y)};
  }

 private:
  StreetPlan plan_;
  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();
  double wave_m_ = 0.0;
  double hills_m_ = 0.0;
  Eigen::Vector2d phase_ = Eigen::Vector2d::Zero();
};

inline constexpr double kKerbHeight_m = 0.12;

/// Ground mesh out to about 200 m beyond the block, kerbs and road markings.
void build_ground(const Terrain& terrain, float contrast, std::uint64_t seed, MeshBuilder& builder);

}  // namespace hybridfusion
