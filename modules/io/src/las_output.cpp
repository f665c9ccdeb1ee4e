#include "las_output.hpp"

#include "byte_reader.hpp"
#include "las_time.hpp"

#include <algorithm>
#include <cmath>
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

struct Bounds {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

[[nodiscard]] std::string header(std::uint64_t num_points,
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
  for (int i = 0; i < 3; ++i) append_value(out, kLasScale_m);
  for (const double value : bounds.offset) append_value(out, value);
  for (int axis = 0; axis < 3; ++axis) {
    append_value(out, bounds.high[axis]);
    append_value(out, bounds.low[axis]);
  }
  append_value(out, std::uint64_t{0});  // waveforms
  append_value(out, std::uint64_t{0});  // extended VLRs
  append_value(out, std::uint32_t{0});
  append_value(out, num_points);
  append_value(out, num_points);  // all are first returns
  out.append(14 * sizeof(std::uint64_t), '\0');
  return out;
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

float las_intensity_factor(float largest) {
  constexpr float kMax = 65535.0F;
  if (largest > 0.0F && largest <= 1.0F) return kMax;
  return largest > kMax && std::isfinite(largest) ? kMax / largest : 1.0F;
}

Expected<LasPieceWriter> LasPieceWriter::create(const std::filesystem::path& path,
                                                LasScaling scaling) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return LasPieceWriter(path, std::move(file), std::move(scaling));
}

Expected<void> LasPieceWriter::add(const PointCloud& piece, const LasWorld& to_world) {
  HF_CHECK(validate(piece).has_value());
  if (piece.empty()) return {};
  if (num_points_ == 0) {
    channels_ = select(piece, {0});
    file_.write(start());
  }
  std::string record;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    HF_TRY(const Eigen::Vector3d world, to_world(piece.points[i]));
    const Eigen::Array3d steps = ((world - scaling_.offset) / kLasScale_m).array().round();
    constexpr double kMaxSteps = std::numeric_limits<std::int32_t>::max();
    if (!(steps.abs() <= kMaxSteps).all()) {  // also NaN
      return fail(ErrorCode::kDegenerate,
                  fmt::format("{}: a point {:g} m from the first is further than LAS can hold in "
                              "millimetres; remove far points",
                              path_.string(),
                              (world - scaling_.offset).cwiseAbs().maxCoeff()));
    }
    const Eigen::Vector3i stored = steps.cast<int>();
    low_ = low_.cwiseMin(stored);
    high_ = high_.cwiseMax(stored);
    record.clear();
    append_point(record, piece, i, stored, scaling_.intensity_factor);
    file_.write(record);
  }
  num_points_ += piece.size();
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
  const Layout layout = make_layout(channels_, scaling_.wkt);
  // The header must bound the coordinates as stored.
  const Bounds bounds = {.low = scaling_.offset + low_.cast<double>() * kLasScale_m,
                         .high = scaling_.offset + high_.cast<double>() * kLasScale_m,
                         .offset = scaling_.offset};
  return header(num_points_, layout, bounds) + layout.vlrs;
}

}  // namespace hybridfusion
