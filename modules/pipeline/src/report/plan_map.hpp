#pragma once

#include "splat.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

namespace hybridfusion {

enum class Orientation : std::uint8_t { kNorthUp, kOwnFrame };

/// A map seen from above as inline SVG with a scale bar and, where y is north, an arrow that says
/// so. Coordinates are x to the right and y up [m].
class PlanMap {
 public:
  explicit PlanMap(const Eigen::AlignedBox2d& box,
                   double width_px = 720.0,
                   Orientation orientation = Orientation::kNorthUp);

  /// A picture made by `view_from_above(box(), ...)`.
  void background(const std::string& data_uri, double opacity);
  void line(std::span<const Eigen::Vector2d> points, std::string_view color, double width_px);
  void polygon(std::span<const Eigen::Vector2d> corners,
               std::string_view fill,
               double fill_opacity,
               std::string_view stroke);
  /// @param name  Shown by the browser while the pointer rests on it; may be empty.
  void dot(const Eigen::Vector2d& at,
           std::string_view color,
           double radius_px,
           std::string_view name);
  void ring(const Eigen::Vector2d& at, std::string_view color, double radius_px);
  void square(const Eigen::Vector2d& corner, double side_m, std::string_view color);
  [[nodiscard]] std::string svg() const;
  [[nodiscard]] const Eigen::AlignedBox2d& box() const { return box_; }

 private:
  [[nodiscard]] Eigen::Vector2d page(const Eigen::Vector2d& at) const;

  Eigen::AlignedBox2d box_;
  Orientation orientation_;
  double px_per_m_ = 1.0;
  double width_px_ = 0.0;
  double height_px_ = 0.0;
  std::string body_ = {};
};

/// The cloud in its colours for PlanMap::background; empty for an empty cloud.
[[nodiscard]] std::string cloud_from_above(const PointCloud& cloud, const Eigen::AlignedBox2d& box);

/// Bounding box of all but `share` of the points on each side, grown by `margin_m`.
[[nodiscard]] Eigen::AlignedBox2d trimmed_box(std::span<const Eigen::Vector3f> points,
                                              double share,
                                              double margin_m);

}  // namespace hybridfusion
