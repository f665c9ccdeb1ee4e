#include "las_output.hpp"

#include "byte_reader.hpp"
#include "crs.hpp"
#include "las_time.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// LAS 1.2, LAS 1.3 R11, LAS 1.4 R15.
constexpr std::uint16_t kColorBytes = 6;  // more in formats 3 and 7

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

/// What the versions have differently.
struct VersionFacts {
  std::uint16_t header_bytes;
  std::uint8_t plain_format;  ///< Time, no colours.
  std::uint8_t color_format;
  std::uint16_t plain_point_bytes;
};

[[nodiscard]] VersionFacts facts_of(LasVersion version) {
  switch (version) {
    case LasVersion::k12:
      return {.header_bytes = 227, .plain_format = 1, .color_format = 3, .plain_point_bytes = 28};
    case LasVersion::k13:
      return {.header_bytes = 235, .plain_format = 1, .color_format = 3, .plain_point_bytes = 28};
    case LasVersion::k14:
      break;
  }
  return {.header_bytes = 375, .plain_format = 6, .color_format = 7, .plain_point_bytes = 30};
}

/// GeoKeyDirectoryTag (GeoTIFF 1.0, section 2.4) of the EPSG codes of a projected system; empty
/// when it has none.
[[nodiscard]] std::string geo_keys(const std::string& wkt, const Eigen::Vector3d& units_m) {
  const auto unit_code = [](double metres) {
    return metres == 1.0 ? 9001 : std::abs(metres - 0.3048) < 1e-9 ? 9002 : 9003;
  };
  const EpsgCodes codes = epsg_codes(wkt);
  if (codes.horizontal == 0) return {};
  std::vector<std::pair<int, int>> keys = {{1024, 1},  // projected
                                           {1025, 1},  // a point is a point, not a pixel
                                           {3072, codes.horizontal},
                                           {3076, unit_code(units_m.x())}};
  if (codes.vertical != 0) keys.emplace_back(4096, codes.vertical);
  keys.emplace_back(4099, unit_code(units_m.z()));
  std::string out;
  const auto put = [&out](int value) { append_value(out, static_cast<std::uint16_t>(value)); };
  for (const int value : {1, 1, 0, static_cast<int>(keys.size())}) put(value);
  for (const auto& [key, value] : keys) {
    for (const int number : {key, 0, 1, value}) put(number);
  }
  return out;
}

struct Layout {
  std::string vlrs = {};
  std::uint32_t num_vlrs = 0;
  std::uint16_t header_bytes = 0;
  std::uint16_t point_bytes = 0;
  std::uint8_t point_format = 0;
};

[[nodiscard]] Layout make_layout(const LasChannels& channels, const LasScaling& scaling) {
  const VersionFacts facts = facts_of(scaling.version);
  Layout layout = {.header_bytes = facts.header_bytes,
                   .point_bytes = facts.plain_point_bytes,
                   .point_format = facts.plain_format};
  const auto add = [&layout](const std::string& record) {
    layout.vlrs += record;
    ++layout.num_vlrs;
  };
  if (!scaling.wkt.empty()) {
    const std::string keys =
        scaling.version == LasVersion::k14 ? "" : geo_keys(scaling.wkt, scaling.units_m);
    if (!keys.empty()) add(vlr("LASF_Projection", 34735, "GeoTIFF keys", keys));
    add(vlr("LASF_Projection", 2112, "OGC WKT", scaling.wkt + '\0'));
  }
  if (channels.colors) {
    layout.point_format = facts.color_format;
    layout.point_bytes += kColorBytes;
  }
  std::string descriptors;
  for (const LasExtraOutput& extra : channels.extra) {
    descriptors += las_extra_descriptor(extra.name, extra.description, extra.type);
    layout.point_bytes += static_cast<std::uint16_t>(size_of(extra.type));
  }
  if (!descriptors.empty()) add(vlr("LASF_Spec", 4, "extra bytes", descriptors));
  return layout;
}

struct Bounds {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// All returns are the first of one.
void append_counts(std::string& out, std::uint64_t num_points, LasVersion version) {
  if (version == LasVersion::k14) {
    append_value(out, num_points);
    append_value(out, num_points);
    out.append(14 * sizeof(std::uint64_t), '\0');
    return;
  }
  append_value(out, static_cast<std::uint32_t>(num_points));
  append_value(out, static_cast<std::uint32_t>(num_points));
  out.append(4 * sizeof(std::uint32_t), '\0');
}

[[nodiscard]] std::string header(std::uint64_t num_points,
                                 const Layout& layout,
                                 const Bounds& bounds,
                                 LasVersion version,
                                 bool week_time) {
  const std::uint16_t kStandardGpsTime = week_time ? 0 : 1;
  constexpr std::uint16_t kWktBit = 1U << 4U;  // LAS 1.4 only
  std::string out = "LASF";
  append_value(out, std::uint16_t{0});  // file source
  append_value(out,
               static_cast<std::uint16_t>(
                   kStandardGpsTime | (version == LasVersion::k14 ? kWktBit : std::uint16_t{0})));
  out.append(16, '\0');  // project GUID
  append_value(out, std::uint8_t{1});
  append_value(out, static_cast<std::uint8_t>(version));
  append_padded(out, "EXTRACTION", 32);
  append_padded(out, "HybridFusion", 32);
  // The date is left at zero: the same input gives the same bytes on any day.
  append_value(out, std::uint16_t{0});
  append_value(out, std::uint16_t{0});
  append_value(out, layout.header_bytes);
  append_value(out, static_cast<std::uint32_t>(layout.header_bytes + layout.vlrs.size()));
  append_value(out, layout.num_vlrs);
  append_value(out, layout.point_format);
  append_value(out, layout.point_bytes);
  if (version == LasVersion::k14) {
    out.append(4 + 5 * 4, '\0');  // legacy counts, unused by formats 6 and 7
  } else {
    append_counts(out, num_points, version);
  }
  for (int i = 0; i < 3; ++i) append_value(out, kLasScale_m);
  for (const double value : bounds.offset) append_value(out, value);
  for (int axis = 0; axis < 3; ++axis) {
    append_value(out, bounds.high[axis]);
    append_value(out, bounds.low[axis]);
  }
  if (version == LasVersion::k12) return out;
  append_value(out, std::uint64_t{0});  // waveforms
  if (version == LasVersion::k13) return out;
  append_value(out, std::uint64_t{0});  // extended VLRs
  append_value(out, std::uint32_t{0});
  append_counts(out, num_points, version);
  return out;
}

void append_scalar(std::string& out, double value, ScalarType type) {
  const auto put = [&]<class T>(T) {
    if constexpr (std::is_integral_v<T>) {
      constexpr auto kLow = static_cast<double>(std::numeric_limits<T>::min());
      constexpr auto kHigh = static_cast<double>(std::numeric_limits<T>::max());
      const double bounded = value > kLow ? std::min(value, kHigh) : kLow;  // NaN is the lowest
      append_value(out, bounded >= kHigh ? std::numeric_limits<T>::max() : static_cast<T>(bounded));
    } else {
      append_value(out, static_cast<T>(value));
    }
  };
  switch (type) {
    case ScalarType::kInt8:
      return put(std::int8_t{});
    case ScalarType::kUint8:
      return put(std::uint8_t{});
    case ScalarType::kInt16:
      return put(std::int16_t{});
    case ScalarType::kUint16:
      return put(std::uint16_t{});
    case ScalarType::kInt32:
      return put(std::int32_t{});
    case ScalarType::kUint32:
      return put(std::uint32_t{});
    case ScalarType::kInt64:
      return put(std::int64_t{});
    case ScalarType::kUint64:
      return put(std::uint64_t{});
    case ScalarType::kFloat32:
      return put(float{});
    case ScalarType::kFloat64:
      return put(double{});
  }
}

/// `synthetic` marks what was not observed directly.
[[nodiscard]] LasAttributes attributes_of(const CloudBatch& cloud,
                                          const LasChannels& channels,
                                          std::size_t i) {
  LasAttributes attributes;
  if (!cloud.sources.empty()) {
    attributes.synthetic = cloud.sources[i] == PointSource::kInterpolated ? 1.0 : 0.0;
    attributes.point_source_id = static_cast<double>(cloud.sources[i]) + 1.0;
  }
  for (const auto& [member, scalar] : channels.attributes) {
    attributes.*member = cloud.scalars[scalar].values[i];
  }
  return attributes;
}

void append_point(std::string& out,
                  const CloudBatch& cloud,
                  const LasChannels& channels,
                  std::size_t i,
                  const Eigen::Vector3i& steps,
                  const LasScaling& scaling) {
  for (const int value : steps) append_value(out, static_cast<std::int32_t>(value));
  const float intensity =
      cloud.intensities.empty() ? 0.0F : cloud.intensities[i] * scaling.intensity_factor;
  append_value(out, static_cast<std::uint16_t>(std::lround(std::clamp(intensity, 0.0F, 65535.0F))));
  out += las_attribute_bytes(attributes_of(cloud, channels, i), scaling.version != LasVersion::k14);
  double time_s = cloud.times_s.empty() ? 0.0 : las_time(cloud.times_s[i]);
  if (channels.gps_time) time_s = cloud.scalars[*channels.gps_time].values[i];
  append_value(out, time_s);
  if (channels.colors) {
    for (const std::uint8_t channel : cloud.colors[i]) {
      append_value(out, static_cast<std::uint16_t>(channel * 257));
    }
  }
  for (const LasExtraOutput& extra : channels.extra) {
    append_scalar(out, extra.value(cloud, i), extra.type);
  }
}

[[nodiscard]] LasChannels channels_of(const CloudBatch& cloud) {
  LasChannels channels{.colors = !cloud.colors.empty()};
  if (!cloud.sources.empty()) {
    channels.extra.push_back({.name = "source",
                              .description = "0 vision 1 lidar 2 interpolated",
                              .type = ScalarType::kUint8,
                              .value = [](const CloudBatch& from, std::size_t i) {
                                return static_cast<double>(from.sources[i]);
                              }});
  }
  if (!cloud.sigmas_m.empty()) {
    channels.extra.push_back({.name = "sigma",
                              .description = "standard deviation [m]",
                              .type = ScalarType::kFloat32,
                              .value = [](const CloudBatch& from, std::size_t i) {
                                return static_cast<double>(from.sigmas_m[i]);
                              }});
  }
  if (!cloud.confidences.empty()) {
    channels.extra.push_back({.name = "confidence",
                              .description = "larger is better",
                              .type = ScalarType::kFloat32,
                              .value = [](const CloudBatch& from, std::size_t i) {
                                return static_cast<double>(from.confidences[i]);
                              }});
  }
  for (std::size_t k = 0; k < cloud.scalars.size(); ++k) {
    const PointScalar& scalar = cloud.scalars[k];
    const auto member = las_attribute(scalar.name);
    const bool taken = std::ranges::any_of(
        channels.attributes, [member](const auto& known) { return known.first == member; });
    if (member != nullptr && !taken) {
      channels.attributes.emplace_back(member, k);
    } else if (plain_scalar_name(scalar.name) == "gpstime" && cloud.times_s.empty() &&
               !channels.gps_time) {
      channels.gps_time = k;
    } else {
      channels.extra.push_back({.name = scalar.name,
                                .description = scalar.description,
                                .type = scalar.type,
                                .value = [k](const CloudBatch& from, std::size_t i) {
                                  return from.scalars[k].values[i];
                                }});
    }
  }
  return channels;
}

}  // namespace

float las_intensity_factor(float largest) {
  constexpr float kMax = 65535.0F;
  if (largest > 0.0F && largest <= 1.0F) return kMax;
  return largest > kMax && std::isfinite(largest) ? kMax / largest : 1.0F;
}

Expected<LasPieceWriter> LasPieceWriter::create(const std::filesystem::path& path,
                                                LasScaling scaling) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  scaling.offset = scaling.offset.cwiseQuotient(scaling.units_m).array().floor();
  return LasPieceWriter(path, std::move(file), std::move(scaling));
}

Expected<void> LasPieceWriter::add(const CloudBatch& piece, const LasWorld& to_world) {
  HF_CHECK(validate(piece).has_value());
  if (piece.empty()) return {};
  if (num_points_ == 0) {
    channels_ = channels_of(piece);
    file_.write(start());
  }
  std::string record;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    HF_TRY(const Eigen::Vector3d world, to_world(piece.points[i]));
    const Eigen::Vector3d local = world.cwiseQuotient(scaling_.units_m) - scaling_.offset;
    const Eigen::Array3d steps = (local / kLasScale_m).array().round();
    constexpr double kMaxSteps = std::numeric_limits<std::int32_t>::max();
    if (!(steps.abs() <= kMaxSteps).all()) {  // also NaN
      return fail(ErrorCode::kDegenerate,
                  fmt::format("{}: a point {:g} m from the first is further than LAS can hold in "
                              "millimetres; remove far points",
                              path_.string(),
                              local.cwiseAbs().maxCoeff()));
    }
    const Eigen::Vector3i stored = steps.cast<int>();
    low_ = low_.cwiseMin(stored);
    high_ = high_.cwiseMax(stored);
    record.clear();
    append_point(record, piece, channels_, i, stored, scaling_);
    if (channels_.gps_time) {
      largest_gps_time_s_ =
          std::max(largest_gps_time_s_, piece.scalars[*channels_.gps_time].values[i]);
    }
    file_.write(record);
  }
  num_points_ += piece.size();
  if (scaling_.version != LasVersion::k14 &&
      num_points_ > std::numeric_limits<std::uint32_t>::max()) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("{}: more points than LAS 1.{} can count (2^32 - 1); write LAS 1.4",
                            path_.string(),
                            static_cast<int>(scaling_.version)));
  }
  return {};
}

Expected<void> LasPieceWriter::commit() {
  if (num_points_ == 0) {
    return fail(ErrorCode::kInsufficient, fmt::format("{}: no points to write", path_.string()));
  }
  file_.overwrite_start(start());
  return file_.commit();
}

std::string LasPieceWriter::start() const {
  const Layout layout = make_layout(channels_, scaling_);
  // The header must bound the coordinates as stored.
  const Bounds bounds = {.low = scaling_.offset + low_.cast<double>() * kLasScale_m,
                         .high = scaling_.offset + high_.cast<double>() * kLasScale_m,
                         .offset = scaling_.offset};
  constexpr double kWeek_s = 604800.0;
  const bool week_time = channels_.gps_time && largest_gps_time_s_ <= kWeek_s;
  return header(num_points_, layout, bounds, scaling_.version, week_time) + layout.vlrs;
}

}  // namespace hybridfusion
