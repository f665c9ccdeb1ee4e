#include "byte_reader.hpp"
#include "cloud_builder.hpp"
#include "las_header.hpp"
#include "las_time.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kBlockPoints = 4096;

/// Collects points; colours stay 16 bits wide until their scale is known.
class LasCollector {
 public:
  explicit LasCollector(const LasHeader& header)
      : header_(header), layout_(kLasLayouts[header.point_format]) {}

  void reserve(std::uint64_t points);
  void add(const std::byte* record);
  [[nodiscard]] Expected<PlacedCloud> finish(const InputFile& file) &&;

 private:
  [[nodiscard]] bool is_withheld(const std::byte* record) const;
  void add_position(const std::byte* record);

  const LasHeader& header_;
  LasPointLayout layout_;
  PlacedCloud result_ = {};
  std::vector<std::array<std::uint16_t, 3>> colors_ = {};
  std::uint64_t withheld_ = 0;
  double largest_rounding_m_ = 0.0;
};

void LasCollector::reserve(std::uint64_t points) {
  PointCloud& cloud = result_.cloud;
  cloud.points.reserve(points);
  cloud.intensities.reserve(points);
  if (layout_.color != 0) colors_.reserve(points);
  if (layout_.time != 0 && header_.absolute_time) cloud.times_s.reserve(points);
  if (header_.source_byte != 0) cloud.sources.reserve(points);
}

bool LasCollector::is_withheld(const std::byte* record) const {
  constexpr std::uint8_t kFormat6 = 6;
  return header_.point_format < kFormat6 ? (load<std::uint8_t>(record + 15) & 0x80U) != 0
                                         : (load<std::uint8_t>(record + 15) & 0x04U) != 0;
}

void LasCollector::add_position(const std::byte* record) {
  Eigen::Vector3d position_m;
  for (int axis = 0; axis < 3; ++axis) {
    position_m[axis] =
        (load<std::int32_t>(record + 4 * axis) * header_.scale[axis] + header_.offset[axis]) *
        header_.crs.metres_per_unit;
  }
  if (result_.cloud.empty()) result_.offset_m = whole_kilometres(position_m);
  const Eigen::Vector3d local = position_m - result_.offset_m;
  const Eigen::Vector3f stored = local.cast<float>();
  largest_rounding_m_ =
      std::max(largest_rounding_m_, (local - stored.cast<double>()).cwiseAbs().maxCoeff());
  result_.cloud.points.push_back(stored);
}

void LasCollector::add(const std::byte* record) {
  if (is_withheld(record)) {
    ++withheld_;
    return;
  }
  add_position(record);
  PointCloud& cloud = result_.cloud;
  cloud.intensities.push_back(load<std::uint16_t>(record + 12));
  if (layout_.color != 0) {
    const std::byte* const from = record + layout_.color;
    colors_.push_back(
        {load<std::uint16_t>(from), load<std::uint16_t>(from + 2), load<std::uint16_t>(from + 4)});
  }
  if (layout_.time != 0 && header_.absolute_time) {
    const auto time = load<double>(record + layout_.time);
    cloud.times_s.push_back(std::isfinite(time) ? unix_time_of_las(time) : 0.0);
  }
  if (header_.source_byte != 0) {
    cloud.sources.push_back(load<std::uint8_t>(record + header_.source_byte) == 0
                                ? PointSource::kVision
                                : PointSource::kLidar);
  }
}

Expected<PlacedCloud> LasCollector::finish(const InputFile& file) && {
  if (largest_rounding_m_ >= kMaxRounding_m) {
    return file.malformed(
        fmt::format("the points spread so far that they cannot be kept to better than {:.3f} m",
                    largest_rounding_m_),
        "cut the cloud into tiles first");
  }
  std::uint16_t largest = 0;
  for (const auto& color : colors_) largest = std::max(largest, std::ranges::max(color));
  // Many writers put 8 bits where 16 belong; black throughout is no colour at all.
  const unsigned divisor = largest > 255 ? 257 : 1;
  if (largest > 0) {
    for (const auto& color : colors_) {
      Rgb8& out = result_.cloud.colors.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        out[k] = static_cast<std::uint8_t>((color[k] + divisor / 2) / divisor);
      }
    }
  }
  if (std::ranges::all_of(result_.cloud.intensities, [](float value) { return value == 0.0F; })) {
    result_.cloud.intensities.clear();
  }
  if (withheld_ > 0) {
    result_.warnings.push_back(fmt::format("{} withheld points are left out", withheld_));
  }
  if (layout_.time != 0 && !header_.absolute_time) {
    result_.warnings.emplace_back("times count from the start of a week; they are left out");
  }
  result_.crs = header_.crs;
  if (result_.crs.metres_per_unit != 1.0) {
    // What the system says of its unit no longer holds.
    result_.crs.wkt.clear();
    result_.warnings.push_back(
        fmt::format("its unit of {:.6g} m became metres; the coordinate system is left out",
                    result_.crs.metres_per_unit));
  }
  return std::move(result_);
}

}  // namespace

Expected<PlacedCloud> read_las(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const LasHeader header, read_las_header(file));
  if (header.crs.geographic) {
    return file.malformed(
        fmt::format("its coordinates are degrees ({}), not metres", header.crs.name),
        "project them first, for example to UTM (pdal, las2las)");
  }
  LasCollector points(header);
  points.reserve(header.points);
  file.seek(header.points_begin);
  for (std::uint64_t done = 0; done < header.points;) {
    const std::uint64_t count = std::min(kBlockPoints, header.points - done);
    HF_TRY(const auto bytes, file.take(count * header.point_bytes));
    for (std::uint64_t i = 0; i < count; ++i) points.add(bytes.data() + i * header.point_bytes);
    done += count;
  }
  return std::move(points).finish(file);
}

}  // namespace hybridfusion
