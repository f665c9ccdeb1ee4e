#include "cloud_builder.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] std::string normalised(std::string_view name) {
  const std::string lower = lower_case(name);
  constexpr std::string_view kPrefix = "scalar_";
  return lower.starts_with(kPrefix) ? lower.substr(kPrefix.size()) : lower;
}

[[nodiscard]] int find_column(std::span<const CloudColumn> columns,
                              std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (normalised(columns[i].name) == name) return static_cast<int>(i);
    }
  }
  return -1;
}

[[nodiscard]] bool complete(const std::array<int, 3>& columns) {
  return std::ranges::all_of(columns, [](int column) { return column >= 0; });
}

[[nodiscard]] Eigen::Vector3d gather(std::span<const double> row, const std::array<int, 3>& from) {
  return {row[from[0]], row[from[1]], row[from[2]]};
}

[[nodiscard]] std::uint8_t to_byte(double share) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

}  // namespace

CloudColumn cloud_column(std::string_view name, ScalarType type) {
  constexpr std::array<double, 10> kMax = {
      127.0, 255.0, 32767.0, 65535.0, 255.0, 255.0, 0.0, 0.0, 255.0, 255.0};
  return {.name = std::string(name),
          .floating = !is_integer(type),
          .integer_max = kMax[static_cast<std::size_t>(type)],  // wider integers count to 255 too
          // MeshLab writes an alpha to every colour.
          .uncertain = lower_case(name) == "alpha",
          .type = type,
          .unsaid = 255.0};
}

CloudBuilder::CloudBuilder(std::span<const CloudColumn> columns,
                           const std::optional<CloudTraits>& traits)
    : position_{find_column(columns, {"x"}),
                find_column(columns, {"y"}),
                find_column(columns, {"z"})},
      normal_{find_column(columns, {"nx", "normal_x"}),
              find_column(columns, {"ny", "normal_y"}),
              find_column(columns, {"nz", "normal_z"})},
      color_{find_column(columns, {"red", "diffuse_red", "r"}),
             find_column(columns, {"green", "diffuse_green", "g"}),
             find_column(columns, {"blue", "diffuse_blue", "b"})},
      intensity_(find_column(columns, {"intensity", "intensities", "reflectivity", "reflectance"})),
      time_(find_column(columns, {"time", "timestamp"})),
      sigma_(find_column(columns, {"sigma"})),
      confidence_(find_column(columns, {"confidence"})),
      source_(find_column(columns, {"source"})),
      given_(traits) {
  if (complete(color_)) red_ = columns[color_[0]];
  if (intensity_ >= 0) uncertain_intensity_ = columns[intensity_].uncertain;
  if (time_ >= 0) time_column_ = columns[time_];
  if (given_ && !given_->time_is_seconds) time_ = -1;
  find_scalars(columns);
  if (!given_) return;
  offset_m_ = given_->offset_m;
  if (given_->color_max == 0.0) color_ = {-1, -1, -1};
  if (!given_->has_intensity) intensity_ = -1;
}

void CloudBuilder::find_scalars(std::span<const CloudColumn> columns) {
  const auto fills_channel = [this](int column) {
    const auto among = [column](const std::array<int, 3>& part) {
      return complete(part) && std::ranges::find(part, column) != part.end();
    };
    return among(position_) || among(normal_) || among(color_) || column == intensity_ ||
           column == time_ || column == sigma_ || column == confidence_ || column == source_;
  };
  for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
    if (columns[i].name.empty() || columns[i].name == "_" || fills_channel(i)) continue;
    CloudColumn column = columns[i];
    const auto taken = [this](const std::string& name) {
      return std::ranges::any_of(scalar_columns_,
                                 [&name](const CloudColumn& c) { return c.name == name; });
    };
    for (int k = 2; taken(column.name); ++k) column.name = fmt::format("{}_{}", columns[i].name, k);
    const auto wanted = [&column](const ScalarTrait& trait) { return trait.name == column.name; };
    if (given_ && std::ranges::none_of(given_->scalars, wanted)) continue;
    scalar_columns_.push_back(std::move(column));
    scalar_from_.push_back(i);
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  smallest_.assign(scalar_from_.size(), kInfinity);
  largest_.assign(scalar_from_.size(), -kInfinity);
  if (given_) scalars_.resize(scalar_from_.size());
}

void CloudBuilder::add_scalars(std::span<const double> row) {
  for (std::size_t i = 0; i < scalar_from_.size(); ++i) {
    const double value = row[scalar_from_[i]];
    if (given_) {
      scalars_[i].push_back(value);
    } else if (!std::isnan(value)) {
      smallest_[i] = std::min(smallest_[i], value);
      largest_[i] = std::max(largest_[i], value);
    }
  }
}

std::vector<std::string> CloudBuilder::channels() const {
  std::vector<std::string> names;
  if (complete(normal_)) names.emplace_back("normals");
  if (traits().color_max > 0.0) names.emplace_back("colours");
  if (traits().has_intensity) names.emplace_back("intensity");
  if (time_ >= 0 && traits().time_is_seconds && largest_time_ > 0.0) names.emplace_back("time");
  if (sigma_ >= 0) names.emplace_back("sigma");
  if (confidence_ >= 0) names.emplace_back("confidence");
  if (source_ >= 0) names.emplace_back("source");
  return names;
}

bool has_coordinates(std::span<const CloudColumn> columns) {
  return find_column(columns, {"x"}) >= 0 && find_column(columns, {"y"}) >= 0 &&
         find_column(columns, {"z"}) >= 0;
}

Eigen::Vector3d whole_kilometres(const Eigen::Vector3d& point_m) {
  constexpr double kLarge_m = 1e4;  // from here on float spacing is a millimetre
  constexpr double kStep_m = 1000.0;
  return point_m.unaryExpr([](double value) {
    return std::abs(value) < kLarge_m ? 0.0 : kStep_m * std::floor(value / kStep_m);
  });
}

bool CloudBuilder::scale_is_known() const {
  return given_.has_value() || (!red_.floating && !red_.uncertain);
}

void CloudBuilder::reserve(std::size_t count) {
  cloud_.points.reserve(count);
  if (complete(normal_)) cloud_.normals.reserve(count);
  if (complete(color_)) cloud_.colors.reserve(count);
  if (intensity_ >= 0) cloud_.intensities.reserve(count);
  if (time_ >= 0) cloud_.times_s.reserve(count);
  if (sigma_ >= 0) cloud_.sigmas_m.reserve(count);
  if (confidence_ >= 0) cloud_.confidences.reserve(count);
  if (source_ >= 0) cloud_.sources.reserve(count);
}

void CloudBuilder::add_color(std::span<const double> row) {
  const Eigen::Vector3d color = gather(row, color_);
  largest_color_ = std::max(largest_color_, color.maxCoeff<Eigen::PropagateNumbers>());
  // 16 bits hold 8 as multiples of 257.
  lossy_color_ = lossy_color_ || (red_.integer_max > 255.0 &&
                                  (color - 257.0 * (color / 257.0).array().round().matrix()).any());
  if (!scale_is_known()) {
    // Written so that NaN becomes 0.
    raw_colors_.push_back(
        color.unaryExpr([](double c) { return c > 0.0 ? c : 0.0; }).cast<float>());
    return;
  }
  const double full_scale = given_ ? given_->color_max : red_.integer_max;
  Rgb8& out = cloud_.colors.emplace_back();
  for (int k = 0; k < 3; ++k) out[k] = to_byte(color[k] > 0.0 ? color[k] / full_scale : 0.0);
}

void CloudBuilder::add_position(const Eigen::Vector3d& point) {
  if (!offset_m_) offset_m_ = whole_kilometres(point);
  const Eigen::Vector3d local = point - *offset_m_;
  const auto rounding_m = [](const Eigen::Vector3d& exact) {
    return (exact - exact.cast<float>().cast<double>()).cwiseAbs().maxCoeff();
  };
  largest_local_rounding_m_ = std::max(largest_local_rounding_m_, rounding_m(local));
  if (rounding_m(point) > largest_rounding_m_) {
    largest_rounding_m_ = rounding_m(point);
    rounded_point_ = {point.x(), point.y(), point.z()};
  }
  cloud_.points.emplace_back(local.cast<float>());
}

bool CloudBuilder::add(std::span<const double> row) {
  const Eigen::Vector3d point = gather(row, position_);
  if (!point.cast<float>().allFinite()) return false;
  add_position(point);
  if (complete(normal_)) {
    const Eigen::Vector3d normal = gather(row, normal_);
    const bool usable = normal.allFinite() && normal.norm() < 1e6;
    cloud_.normals.push_back(usable ? Eigen::Vector3f(normal.cast<float>())
                                    : Eigen::Vector3f(Eigen::Vector3f::Zero()));
  }
  if (complete(color_)) add_color(row);
  const auto finite = [&row](int column) { return std::isfinite(row[column]) ? row[column] : 0.0; };
  if (intensity_ >= 0) {
    cloud_.intensities.push_back(static_cast<float>(finite(intensity_)));
    const float intensity = cloud_.intensities.back();
    largest_intensity_ = std::max(largest_intensity_, intensity);
    smallest_intensity_ = std::min(smallest_intensity_, intensity);
    fractional_intensity_ = fractional_intensity_ || intensity != std::round(intensity);
  }
  if (time_ >= 0) {
    cloud_.times_s.push_back(finite(time_));
    largest_time_ = std::max(largest_time_, cloud_.times_s.back());
  }
  if (sigma_ >= 0) cloud_.sigmas_m.push_back(static_cast<float>(finite(sigma_)));
  if (confidence_ >= 0) cloud_.confidences.push_back(static_cast<float>(finite(confidence_)));
  if (source_ >= 0) {
    cloud_.sources.push_back(row[source_] == 0.0   ? PointSource::kVision
                             : row[source_] == 2.0 ? PointSource::kInterpolated
                                                   : PointSource::kLidar);
  }
  add_scalars(row);
  return true;
}

CloudTraits CloudBuilder::traits() const {
  constexpr double kMostSeconds = 1e11;  // the year 5138; larger counts are nanoseconds
  CloudTraits traits = {
      .offset_m = offset_m_.value_or(Eigen::Vector3d::Zero()),
      .has_intensity = intensity_ >= 0 && (!uncertain_intensity_ || largest_intensity_ > 0.0F),
      .largest_intensity = largest_intensity_,
      .smallest_intensity = smallest_intensity_,
      .fractional_intensity = fractional_intensity_,
      .time_is_seconds = largest_time_ < kMostSeconds};
  if (!traits.time_is_seconds) {
    traits.scalars.push_back(
        {.name = time_column_.name, .type = time_column_.type, .largest = largest_time_});
  }
  for (std::size_t i = 0; i < scalar_columns_.size(); ++i) {
    const CloudColumn& column = scalar_columns_[i];
    const bool constant = !(smallest_[i] < largest_[i]);
    const bool unsaid = smallest_[i] == 0.0 || smallest_[i] == column.unsaid;
    if (column.uncertain && constant && unsaid) continue;
    traits.scalars.push_back({.name = column.name,
                              .type = column.type,
                              .description = column.description,
                              .smallest = smallest_[i],
                              .largest = largest_[i]});
  }
  if (!complete(color_) || (red_.uncertain && largest_color_ <= 0.0)) return traits;
  traits.color_max = red_.integer_max;
  if (red_.floating) {
    traits.color_max = largest_color_ <= 1.0 ? 1.0 : largest_color_ <= 255.0 ? 255.0 : 65535.0;
  }
  if (red_.uncertain && largest_color_ <= 255.0) traits.color_max = 255.0;
  traits.lossy_color = traits.color_max > 255.0 && lossy_color_;
  return traits;
}

void CloudBuilder::finish_colors() {
  const double full_scale = traits().color_max;
  for (const Eigen::Vector3f& color : raw_colors_) {
    cloud_.colors.push_back({to_byte(color.x() / full_scale),
                             to_byte(color.y() / full_scale),
                             to_byte(color.z() / full_scale)});
  }
  raw_colors_.clear();
}

Expected<PointCloud> CloudBuilder::finish() && {
  if (largest_rounding_m_ >= kMaxRounding_m) {
    return fail(ErrorCode::kParse,
                fmt::format("coordinates as large as ({:.2f}, {:.2f}, {:.2f}) cannot be kept to "
                            "better than {:.3f} m; subtract a common offset from the clouds first "
                            "(hybridfusion convert takes one off)",
                            rounded_point_[0],
                            rounded_point_[1],
                            rounded_point_[2],
                            largest_rounding_m_));
  }
  finish_colors();
  if (offset_m_ && !offset_m_->isZero()) {
    for (Eigen::Vector3f& point : cloud_.points) {
      point = (point.cast<double>() + *offset_m_).cast<float>();
    }
  }
  return std::move(cloud_);
}

Expected<CloudBatch> CloudBuilder::take() {
  HF_CHECK(given_.has_value());
  if (largest_local_rounding_m_ >= kMaxRounding_m) {
    return fail(ErrorCode::kParse,
                fmt::format("the points spread so far that they cannot be kept to better than "
                            "{:.3f} m; cut the cloud into tiles first",
                            largest_local_rounding_m_));
  }
  CloudBatch batch;
  static_cast<PointCloud&>(batch) = std::exchange(cloud_, {});
  for (std::size_t i = 0; i < scalar_columns_.size(); ++i) {
    batch.scalars.push_back({.name = scalar_columns_[i].name,
                             .type = scalar_columns_[i].type,
                             .description = scalar_columns_[i].description,
                             .values = std::exchange(scalars_[i], {})});
  }
  return batch;
}

void append(CloudBatch& a, CloudBatch b) {
  if (a.empty()) {
    a = std::move(b);
    return;
  }
  static_cast<PointCloud&>(a) = concatenate(std::move(static_cast<PointCloud&>(a)), b);
  HF_CHECK(b.empty() || a.scalars.size() == b.scalars.size());
  for (std::size_t i = 0; i < b.scalars.size(); ++i) {
    std::vector<double>& values = a.scalars[i].values;
    values.insert(values.end(), b.scalars[i].values.begin(), b.scalars[i].values.end());
  }
}

void CloudBuilder::forget_points() {
  cloud_ = {};
  raw_colors_.clear();
}

}  // namespace hybridfusion
