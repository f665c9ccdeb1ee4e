#pragma once

#include "scalar_type.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <array>
#include <cstdint>
#include <optional>
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
  /// The format has the field whether or not it is used, at a scale that writers disagree on: zero
  /// throughout is no channel, and a colour that never exceeds 255 counts to 255.
  bool uncertain = false;
  ScalarType type = ScalarType::kFloat64;
  /// Of an uncertain column that is none of the channels: the value that says as little as zero.
  double unsaid = 0.0;
  std::string description = {};
};

/// A column that fills no channel.
struct ScalarTrait {
  std::string name = {};
  ScalarType type = ScalarType::kFloat64;
  std::string description = {};
  double smallest = 0.0;
  double largest = 0.0;
};

/// What only the whole file tells of its points.
struct CloudTraits {
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< Whole kilometres to take off.
  double color_max = 0.0;                              ///< Full scale; 0: no colours.
  bool has_intensity = false;
  float largest_intensity = 0.0F;
  float smallest_intensity = 0.0F;
  bool fractional_intensity = false;
  bool lossy_color = false;  ///< 16 bits that 8 do not hold.
  bool time_is_seconds = true;
  std::vector<ScalarTrait> scalars = {};
};

[[nodiscard]] CloudColumn cloud_column(std::string_view name, ScalarType type);
[[nodiscard]] bool has_coordinates(std::span<const CloudColumn> columns);

// A float in a local frame of +-80 km rounds by at most 4 mm.
inline constexpr double kMaxRounding_m = 0.005;

/// Whole kilometres to subtract from a cloud with this point; 0 along an axis below 10 km.
[[nodiscard]] Eigen::Vector3d whole_kilometres(const Eigen::Vector3d& point_m);

/// Turns rows of named scalars into a PointCloud. Names are compared in lower case without
/// CloudCompare's prefix "scalar_"; columns nobody knows become scalars of take().
class CloudBuilder {
 public:
  /// @param traits  Of the whole file; absent: found by the builder, which then must be given all
  ///                points before finish() or traits().
  explicit CloudBuilder(std::span<const CloudColumn> columns,
                        const std::optional<CloudTraits>& traits = {});

  void reserve(std::size_t count);
  /// False when the coordinates are not finite; the point is then left out.
  [[nodiscard]] bool add(std::span<const double> row);
  /// @returns kParse when coordinates are so large that float storage moved a point by 5 mm or more
  /// (UTM, ECEF): the cloud would silently lose its precision.
  [[nodiscard]] Expected<PointCloud> finish() &&;

  [[nodiscard]] std::size_t size() const { return cloud_.size(); }
  /// The points since the last take(), relative to the offset of the traits that were given.
  /// @returns kParse when the points spread too far for that.
  [[nodiscard]] Expected<CloudBatch> take();
  /// Drops the points and keeps what traits() needs of them.
  void forget_points();
  [[nodiscard]] CloudTraits traits() const;
  /// Names of the channels that the columns fill, for people.
  [[nodiscard]] std::vector<std::string> channels() const;

 private:
  void add_position(const Eigen::Vector3d& point);
  void add_color(std::span<const double> row);
  void add_scalars(std::span<const double> row);
  void find_scalars(std::span<const CloudColumn> columns);
  [[nodiscard]] bool scale_is_known() const;
  void finish_colors();

  std::array<int, 3> position_ = {-1, -1, -1};  ///< Column indices; -1: absent.
  std::array<int, 3> normal_ = {-1, -1, -1};
  std::array<int, 3> color_ = {-1, -1, -1};
  int intensity_ = -1;
  int time_ = -1;
  int sigma_ = -1;
  int confidence_ = -1;
  int source_ = -1;
  CloudColumn red_ = {};
  bool uncertain_intensity_ = false;
  std::optional<CloudTraits> given_ = {};
  std::optional<Eigen::Vector3d> offset_m_ = {};  ///< Of cloud_, once it has a point.
  double largest_color_ = 0.0;
  float largest_intensity_ = 0.0F;
  double largest_rounding_m_ = 0.0;        ///< Without the offset.
  double largest_local_rounding_m_ = 0.0;  ///< With the offset.
  std::array<double, 3> rounded_point_ = {};
  std::vector<Eigen::Vector3f> raw_colors_ = {};  ///< While their scale is not known.
  float smallest_intensity_ = 0.0F;
  bool fractional_intensity_ = false;
  bool lossy_color_ = false;
  double largest_time_ = 0.0;
  CloudColumn time_column_ = {};
  std::vector<CloudColumn> scalar_columns_ = {};
  std::vector<int> scalar_from_ = {};  ///< Column of each.
  std::vector<double> smallest_ = {};
  std::vector<double> largest_ = {};
  PointCloud cloud_ = {};
  std::vector<std::vector<double>> scalars_ = {};  ///< When traits are given.
};

}  // namespace hybridfusion
