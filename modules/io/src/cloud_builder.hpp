#pragma once

#include "scalar_type.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// A scalar field of a point as a file declares it.
struct CloudColumn {
  std::string name = {};
  bool floating = false;     ///< float or double.
  double integer_max = 0.0;  ///< Largest value of an integer type (full scale of a colour).
};

[[nodiscard]] CloudColumn cloud_column(std::string_view name, ScalarType type);

// A float in a local frame of +-80 km rounds by at most 4 mm.
inline constexpr double kMaxRounding_m = 0.005;

/// Whole kilometres to subtract from a cloud with this point; 0 along an axis below 10 km.
[[nodiscard]] Eigen::Vector3d whole_kilometres(const Eigen::Vector3d& point_m);

/// Turns rows of named scalars into a PointCloud. Names are compared in lower case without
/// CloudCompare's prefix "scalar_"; columns nobody knows are ignored.
class CloudBuilder {
 public:
  explicit CloudBuilder(std::span<const CloudColumn> columns);

  [[nodiscard]] bool has_coordinates() const;
  void reserve(std::size_t count);
  /// False when the coordinates are not finite; the point is then left out.
  [[nodiscard]] bool add(std::span<const double> row);
  /// @returns kParse when coordinates are so large that float storage moved a point by 5 mm or more
  /// (UTM, ECEF): the cloud would silently lose its precision.
  [[nodiscard]] Expected<PointCloud> finish() &&;
  /// As finish(), but coordinates of 10 km and more are taken relative to whole kilometres. kParse
  /// only when the points spread too far for that.
  [[nodiscard]] Expected<PlacedCloud> finish_placed() &&;

 private:
  void add_color(std::span<const double> row);
  void finish_colors();

  std::array<int, 3> position_ = {-1, -1, -1};  ///< Column indices; -1: absent.
  std::array<int, 3> normal_ = {-1, -1, -1};
  std::array<int, 3> color_ = {-1, -1, -1};
  int intensity_ = -1;
  int time_ = -1;
  int sigma_ = -1;
  int confidence_ = -1;
  int source_ = -1;
  double color_max_ = 255.0;  ///< Full scale of an integer colour; 0 for floating colours.
  Eigen::Vector3d offset_m_ = Eigen::Vector3d::Zero();  ///< Of cloud_, while it is collected.
  double largest_rounding_m_ = 0.0;                     ///< Without the offset.
  double largest_local_rounding_m_ = 0.0;               ///< With the offset.
  std::array<double, 3> rounded_point_ = {};
  std::vector<Eigen::Vector3f> floating_colors_ = {};
  PointCloud cloud_ = {};
};

}  // namespace hybridfusion
