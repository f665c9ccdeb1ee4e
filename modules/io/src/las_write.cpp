#include "byte_reader.hpp"
#include "crs.hpp"
#include "las_time.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/las.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// LAS 1.4 R15.
constexpr std::uint16_t kHeaderBytes = 375;
constexpr std::uint16_t kVlrHeaderBytes = 54;
constexpr std::uint16_t kExtraBytesDescriptor = 192;
constexpr std::uint16_t kPlainPointBytes = 30;  // format 6
constexpr std::uint16_t kColorBytes = 6;        // more in format 7
constexpr double kScale_m = 0.001;

using ToWorld = std::function<Expected<Eigen::Vector3d>(const Eigen::Vector3f&)>;

struct Bounds {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// Steps of kScale_m from the offset.
[[nodiscard]] Eigen::Vector3i quantized(const Eigen::Vector3d& world,
                                        const Eigen::Vector3d& offset) {
  return ((world - offset) / kScale_m).array().round().cast<int>();
}

Expected<Bounds> measure(const PointCloud& cloud, const ToWorld& to_world) {
  Bounds bounds;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (const Eigen::Vector3f& point : cloud.points) {
    HF_TRY(const Eigen::Vector3d world, to_world(point));
    low = low.cwiseMin(world);
    high = high.cwiseMax(world);
  }
  bounds.offset = low.array().floor();
  // 2^31 steps of a millimetre; also false for NaN.
  constexpr double kMaxExtent_m = 2.1e6;
  if (!((high - low).maxCoeff() < kMaxExtent_m)) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("the cloud extends over {:g} m, more than LAS can hold in millimetres ({:g}); "
                    "remove far or non-finite points",
                    (high - low).maxCoeff(),
                    kMaxExtent_m));
  }
  // The header must bound the coordinates as stored.
  const auto stored = [&](const Eigen::Vector3d& world) {
    return Eigen::Vector3d(bounds.offset +
                           quantized(world, bounds.offset).cast<double>() * kScale_m);
  };
  bounds.low = stored(low);
  bounds.high = stored(high);
  return bounds;
}

void append_padded(std::string& out, std::string_view text, std::size_t bytes) {
  std::string field(text.substr(0, bytes));
  field.resize(bytes, '\0');
  out += field;
}

[[nodiscard]] std::string vlr(std::string_view user,
                              std::uint16_t record,
                              std::string_view what,
                              const std::string& data) {
  std::string out;
  append_value(out, std::uint16_t{0});
  append_padded(out, user, 16);
  append_value(out, record);
  append_value(out, static_cast<std::uint16_t>(data.size()));
  append_padded(out, what, 32);
  return out + data;
}

/// Extra bytes descriptor of the one byte `source`.
[[nodiscard]] std::string source_descriptor() {
  std::string out(2, '\0');            // reserved
  append_value(out, std::uint8_t{1});  // unsigned char
  append_value(out, std::uint8_t{0});  // no options
  append_padded(out, "source", 32);
  out.resize(kExtraBytesDescriptor - 32, '\0');
  append_padded(out, "0 vision, 1 lidar", 32);
  return out;
}

struct Layout {
  std::string vlrs = {};
  std::uint32_t num_vlrs = 0;
  std::uint16_t point_bytes = kPlainPointBytes;
  std::uint8_t point_format = 6;
};

[[nodiscard]] Layout make_layout(const PointCloud& cloud, const std::string& wkt) {
  Layout layout;
  if (!wkt.empty()) {
    layout.vlrs += vlr("LASF_Projection", 2112, "OGC WKT", wkt + '\0');
    ++layout.num_vlrs;
  }
  if (!cloud.colors.empty()) {
    layout.point_format = 7;
    layout.point_bytes += kColorBytes;
  }
  if (!cloud.sources.empty()) {
    layout.vlrs += vlr("LASF_Spec", 4, "extra bytes", source_descriptor());
    ++layout.num_vlrs;
    ++layout.point_bytes;
  }
  return layout;
}

[[nodiscard]] std::string header(const PointCloud& cloud,
                                 const Layout& layout,
                                 const Bounds& bounds) {
  constexpr std::uint16_t kStandardGpsTime = 1;
  constexpr std::uint16_t kWktBit = 1U << 4U;
  std::string out = "LASF";
  append_value(out, std::uint16_t{0});  // file source
  append_value(out, static_cast<std::uint16_t>(kStandardGpsTime | kWktBit));
  out.append(16, '\0');  // project GUID
  append_value(out, std::uint8_t{1});
  append_value(out, std::uint8_t{4});
  append_padded(out, "EXTRACTION", 32);
  append_padded(out, "HybridFusion", 32);
  // The date is left at zero: the same input gives the same bytes on any day.
  append_value(out, std::uint16_t{0});
  append_value(out, std::uint16_t{0});
  append_value(out, kHeaderBytes);
  append_value(out, static_cast<std::uint32_t>(kHeaderBytes + layout.vlrs.size()));
  append_value(out, layout.num_vlrs);
  append_value(out, layout.point_format);
  append_value(out, layout.point_bytes);
  out.append(4 + 5 * 4, '\0');  // legacy counts, unused by formats 6 and 7
  for (int i = 0; i < 3; ++i) append_value(out, kScale_m);
  for (const double value : bounds.offset) append_value(out, value);
  for (int axis = 0; axis < 3; ++axis) {
    append_value(out, bounds.high[axis]);
    append_value(out, bounds.low[axis]);
  }
  append_value(out, std::uint64_t{0});  // waveforms
  append_value(out, std::uint64_t{0});  // extended VLRs
  append_value(out, std::uint32_t{0});
  append_value(out, static_cast<std::uint64_t>(cloud.size()));
  append_value(out, static_cast<std::uint64_t>(cloud.size()));  // all are first returns
  out.append(14 * sizeof(std::uint64_t), '\0');
  return out;
}

/// Factor that brings intensities into 16 bits: 0..1 is stretched, larger ranges are compressed.
[[nodiscard]] float intensity_factor(const PointCloud& cloud) {
  constexpr float kMax = 65535.0F;
  const float largest = cloud.intensities.empty() ? 0.0F : std::ranges::max(cloud.intensities);
  if (largest > 0.0F && largest <= 1.0F) return kMax;
  return largest > kMax && std::isfinite(largest) ? kMax / largest : 1.0F;
}

void append_point(std::string& out,
                  const PointCloud& cloud,
                  std::size_t i,
                  const Eigen::Vector3i& steps,
                  float factor) {
  for (const int value : steps) append_value(out, static_cast<std::int32_t>(value));
  const float intensity = cloud.intensities.empty() ? 0.0F : cloud.intensities[i] * factor;
  append_value(out, static_cast<std::uint16_t>(std::clamp(intensity, 0.0F, 65535.0F)));
  append_value(out, std::uint8_t{0x11});  // return 1 of 1
  append_value(out, std::uint8_t{0});     // flags
  append_value(out, std::uint8_t{1});     // class: unclassified
  append_value(out, std::uint8_t{0});     // user data
  append_value(out, std::int16_t{0});     // scan angle
  append_value(out,
               static_cast<std::uint16_t>(
                   cloud.sources.empty() ? 0 : static_cast<int>(cloud.sources[i]) + 1));
  append_value(out, cloud.times_s.empty() ? 0.0 : las_time(cloud.times_s[i]));
  if (!cloud.colors.empty()) {
    for (const std::uint8_t channel : cloud.colors[i]) {
      append_value(out, static_cast<std::uint16_t>(channel * 257));
    }
  }
  if (!cloud.sources.empty()) append_value(out, static_cast<std::uint8_t>(cloud.sources[i]));
}

}  // namespace

Expected<void> write_las(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const LasWriteOptions& options) {
  HF_CHECK(validate(cloud).has_value());
  if (cloud.empty()) {
    return fail(ErrorCode::kInsufficient, fmt::format("{}: no points to write", path.string()));
  }
  HF_CHECK(!options.georeference || (options.wkt.empty() && options.offset_m.isZero()));
  std::optional<EnuToProjected> projection;
  if (options.georeference) {
    HF_TRY(projection,
           EnuToProjected::create(options.georeference->origin, options.georeference->crs));
  }
  const ToWorld to_world = [&](const Eigen::Vector3f& point) -> Expected<Eigen::Vector3d> {
    if (!projection) return Eigen::Vector3d(point.cast<double>() + options.offset_m);
    return (*projection)(point.cast<double>());
  };
  HF_TRY(const Bounds bounds, measure(cloud, to_world));
  const Layout layout = make_layout(cloud, projection ? projection->wkt() : options.wkt);
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  file.write(header(cloud, layout, bounds));
  file.write(layout.vlrs);
  const float factor = intensity_factor(cloud);
  std::string record;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    HF_TRY(const Eigen::Vector3d world, to_world(cloud.points[i]));
    record.clear();
    append_point(record, cloud, i, quantized(world, bounds.offset), factor);
    file.write(record);
  }
  return file.commit();
}

}  // namespace hybridfusion
