#include "point_time.hpp"
#include "ros_message.hpp"
#include "text.hpp"
#include "zstd_stream.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint32_t kMaxFields = 256;

struct PointField {
  std::string name = {};
  std::size_t offset = 0;
  ScalarType type = ScalarType::kFloat32;
};

/// A sensor_msgs/PointCloud2 whose declared sizes were checked against its bytes.
struct PointCloud2 {
  Timestamp stamp{};
  std::size_t height = 0;
  std::size_t width = 0;
  std::vector<PointField> fields = {};
  std::endian order = std::endian::little;
  std::size_t point_step = 0;
  std::size_t row_step = 0;
  std::span<const std::byte> data = {};
  std::vector<std::byte> unpacked = {};  ///< What `data` is, when it came compressed.
  std::vector<std::string> unread =
      {};  ///< Fields of types that are not read: "name (datatype 11)".

  [[nodiscard]] const PointField* find(std::string_view name) const {
    const auto found = std::ranges::find_if(
        fields, [name](const PointField& field) { return lower_case(field.name) == name; });
    return found == fields.end() ? nullptr : &*found;
  }
  [[nodiscard]] std::vector<std::string> unread_names() const {
    std::vector<std::string> names;
    for (const std::string& text : unread) names.push_back(text.substr(0, text.find(" (")));
    return names;
  }
  [[nodiscard]] double value(std::size_t row, std::size_t column, const PointField& field) const {
    return load_scalar(
        data.data() + row * row_step + column * point_step + field.offset, field.type, order);
  }
};

[[nodiscard]] std::unexpected<Error> damaged(std::string_view cause) {
  return fail(
      ErrorCode::kParse,
      fmt::format("a PointCloud2 message is damaged: {}; record again if there are many", cause));
}

Expected<void> check_layout(const PointCloud2& cloud) {
  if (cloud.height == 0 || cloud.width == 0) return {};
  // All factors are below 2^32, so the products do not wrap in 64 bits.
  if (cloud.width * cloud.point_step > cloud.row_step && cloud.height > 1) {
    return damaged(fmt::format("{} points of {} bytes do not fit rows of {} bytes",
                               cloud.width,
                               cloud.point_step,
                               cloud.row_step));
  }
  const std::size_t last_row = (cloud.height - 1) * cloud.row_step;
  const std::size_t row_bytes = cloud.width * cloud.point_step;
  if (last_row > cloud.data.size() || row_bytes > cloud.data.size() - last_row) {
    return damaged(fmt::format("{} x {} points of {} bytes do not fit {} bytes of data",
                               cloud.height,
                               cloud.width,
                               cloud.point_step,
                               cloud.data.size()));
  }
  for (const PointField& field : cloud.fields) {
    if (field.offset + size_of(field.type) > cloud.point_step) {
      return damaged(fmt::format("field '{}' lies outside the point", printable(field.name)));
    }
  }
  if (cloud.point_step == 0) return damaged("points of no bytes");
  return {};
}

void read_fields(RosReader& reader, std::uint32_t num_fields, PointCloud2& cloud) {
  for (std::uint32_t i = 0; i < num_fields && !reader.failed(); ++i) {
    PointField field;
    field.name = reader.read_string();
    field.offset = reader.read<std::uint32_t>();
    const auto datatype = reader.read<std::uint8_t>();
    const auto count = reader.read<std::uint32_t>();  // we read the first element of an array
    // PointField ends with 8; PCL 1.13 goes on with 9 (int64), 10 (uint64) and 11 (bool). Single
    // bytes in a row are a number that only its driver knows.
    const bool known = datatype >= 1 && datatype <= 10 && !(datatype <= 2 && count > 1);
    if (!known) {
      cloud.unread.push_back(fmt::format(
          "{} (datatype {}, count {})", printable(field.name), static_cast<int>(datatype), count));
      continue;
    }
    field.type = static_cast<ScalarType>(datatype - 1);
    cloud.fields.push_back(std::move(field));
  }
}

/// Unpacks the data of a point_cloud_interfaces/CompressedPointCloud2.
Expected<void> unpack(RosReader& reader, PointCloud2& cloud) {
  reader.skip<std::uint8_t>();  // is_dense
  const std::string format(reader.read_string());
  if (!is_zstd(cloud.data)) {
    return fail(ErrorCode::kNotFound,
                fmt::format("the clouds are compressed with '{}'; only zstd is read: play the "
                            "recording through 'ros2 run point_cloud_transport republish' and "
                            "record the raw points",
                            printable(format)));
  }
  // All factors are below 2^32: no product of two wraps.
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 29;
  const std::uint64_t row_bytes =
      std::max<std::uint64_t>(cloud.row_step, cloud.width * cloud.point_step);
  if (row_bytes > kMaxBytes || cloud.height * row_bytes > kMaxBytes) {
    return damaged(fmt::format("it announces {} rows of {} bytes", cloud.height, row_bytes));
  }
  const std::uint64_t declared = cloud.height * row_bytes;
  ZstdStream stream;
  std::span<const std::byte> packed = cloud.data;
  while ((!packed.empty() || stream.has_more()) && cloud.unpacked.size() <= declared) {
    const auto piece = stream.unpack(packed);
    if (!stream.problem().empty()) return damaged(stream.problem());
    cloud.unpacked.insert(cloud.unpacked.end(), piece.begin(), piece.end());
  }
  cloud.data = cloud.unpacked;
  return {};
}

enum class Packing : std::uint8_t { kNone, kCompressed };

Expected<PointCloud2> parse(std::span<const std::byte> message, RosWire wire, Packing packing) {
  RosReader reader(message, wire);
  PointCloud2 cloud;
  cloud.stamp = read_ros_header(reader).stamp;
  cloud.height = reader.read<std::uint32_t>();
  cloud.width = reader.read<std::uint32_t>();
  const auto num_fields = reader.read<std::uint32_t>();
  if (num_fields > kMaxFields) return damaged(fmt::format("it announces {} fields", num_fields));
  read_fields(reader, num_fields, cloud);
  cloud.order = reader.read<std::uint8_t>() != 0 ? std::endian::big : std::endian::little;
  cloud.point_step = reader.read<std::uint32_t>();
  cloud.row_step = reader.read<std::uint32_t>();
  cloud.data = reader.take(reader.read<std::uint32_t>());
  if (reader.failed()) return damaged("it ends early");
  if (packing == Packing::kCompressed) {
    if (auto unpacked = unpack(reader, cloud); !unpacked) return std::unexpected(unpacked.error());
  }
  if (auto layout = check_layout(cloud); !layout) return std::unexpected(layout.error());
  return cloud;
}

/// Whether the coordinates are sensible in this byte order. A wrong one turns metres into numbers
/// of any size: of 24 bits of exponent and mantissa at most a few come out between 0.1 mm and 1 km.
[[nodiscard]] double sensible_share(const PointCloud2& cloud,
                                    const std::array<const PointField*, 3>& position,
                                    std::endian order) {
  constexpr std::size_t kPoints = 500;
  constexpr double kMin_m = 1e-4;
  constexpr double kMax_m = 1e4;
  std::size_t tried = 0;
  std::size_t sensible = 0;
  const std::size_t step = std::max<std::size_t>(1, cloud.height * cloud.width / kPoints);
  for (std::size_t i = 0; i < cloud.height * cloud.width; i += step) {
    const std::byte* const point =
        cloud.data.data() + i / cloud.width * cloud.row_step + i % cloud.width * cloud.point_step;
    for (const PointField* const field : position) {
      const double value = load_scalar(point + field->offset, field->type, order);
      if (value == 0.0) continue;
      const double swapped =
          load_scalar(point + field->offset,
                      field->type,
                      order == std::endian::big ? std::endian::little : std::endian::big);
      if (!std::isfinite(value) && !std::isfinite(swapped)) continue;
      ++tried;
      if (std::abs(value) >= kMin_m && std::abs(value) <= kMax_m) ++sensible;
    }
  }
  constexpr std::size_t kFewest = 30;
  return tried < kFewest ? -1.0 : static_cast<double>(sensible) / static_cast<double>(tried);
}

/// Simulators and converters set is_bigendian without swapping a byte, or the other way round.
void correct_byte_order(PointCloud2& cloud,
                        const std::array<const PointField*, 3>& position,
                        PointTimeReader& times) {
  if (cloud.height * cloud.width == 0) return;
  if (sensible_share(cloud, position, cloud.order) > 0.5) return;
  const std::endian other =
      cloud.order == std::endian::big ? std::endian::little : std::endian::big;
  if (sensible_share(cloud, position, other) < 0.9) return;
  cloud.order = other;
  times.warn_once(fmt::format("is_bigendian says the wrong byte order; the points are read as {}",
                              other == std::endian::big ? "big-endian" : "little-endian"));
}

/// Bits 4 and 5 of a Livox tag grade the point: 0x00 and 0x10 are good, the others noise.
[[nodiscard]] bool is_livox_noise(std::uint8_t tag) {
  return (tag & 0x30U) > 0x10U;
}

[[nodiscard]] std::uint16_t to_ring(double value) {
  return static_cast<std::uint16_t>(value >= 0.0 && value <= 65535.0 ? value : 0.0);
}

/// The fields of a scan that we read; those that may be missing are nullptr.
struct ScanFields {
  std::array<const PointField*, 3> position = {};
  const PointField* intensity = nullptr;
  const PointField* ring = nullptr;
  const PointField* tag = nullptr;
  const PointField* time = nullptr;
  const PointField* time_ns = nullptr;  ///< Rest of a time in two parts, which `time` counts in s.
  std::string no_time = {};             ///< Why there is no time.
};

Expected<ScanFields> find_fields(const PointCloud2& cloud, const PointTimeReader& times) {
  std::vector<std::string> names;
  for (const PointField& field : cloud.fields) names.push_back(field.name);
  const auto refuse = [&names](std::string_view cause) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}; the fields are: {}; choose another topic or time field",
                            cause,
                            printable(fmt::format("{}", fmt::join(names, ", ")))));
  };
  ScanFields fields = {.position = {cloud.find("x"), cloud.find("y"), cloud.find("z")}};
  if (std::ranges::count(fields.position, nullptr) > 0) return refuse("the scans have no x, y, z");
  fields.intensity = cloud.find("intensity");
  if (fields.intensity == nullptr) fields.intensity = cloud.find("reflectivity");
  for (const char* const name : {"channel", "line", "ring"}) {
    if (const PointField* const found = cloud.find(name)) fields.ring = found;
  }
  fields.tag = cloud.find("tag");
  if (fields.tag != nullptr && fields.tag->type != ScalarType::kUint8) fields.tag = nullptr;
  const std::string& asked = times.options().field;
  if (asked == "none") return fields;
  if (const auto index = times.choose_field(names)) {
    fields.time = &cloud.fields[*index];
  } else if (!asked.empty()) {
    return refuse(fmt::format("the scans have no time field '{}'", printable(asked)));
  } else if (cloud.find("time_sec") != nullptr && cloud.find("time_nsec") != nullptr) {
    fields.time = cloud.find("time_sec");  // Hesai SDK 2 with whole seconds and nanoseconds apart
    fields.time_ns = cloud.find("time_nsec");
  } else if (const auto unread = times.choose_field(cloud.unread_names())) {
    fields.no_time =
        fmt::format("the time field {} is of a type that is not read", cloud.unread[*unread]);
  } else {
    fields.no_time = fmt::format("the scans have no time per point (fields: {})",
                                 printable(fmt::format("{}", fmt::join(names, ", "))));
  }
  return fields;
}

Expected<LidarScan> scan_of(PointCloud2& cloud, PointTimeReader& times) {
  HF_TRY(const ScanFields fields, find_fields(cloud, times));
  correct_byte_order(cloud, fields.position, times);
  LidarScan scan = {.stamp = cloud.stamp};
  RawPointTimes raw = {.missing = fields.no_time};
  scan.points.reserve(cloud.height * cloud.width);
  if (fields.time != nullptr) {
    raw.field = fields.time->name;
    raw.type = fields.time->type;
    raw.values.reserve(cloud.height * cloud.width);
  }
  for (std::size_t row = 0; row < cloud.height; ++row) {
    for (std::size_t column = 0; column < cloud.width; ++column) {
      const auto value = [&](const PointField& field) { return cloud.value(row, column, field); };
      if (fields.tag != nullptr && is_livox_noise(static_cast<std::uint8_t>(value(*fields.tag)))) {
        continue;
      }
      LidarPoint& point = scan.points.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        point.point_in_lidar[axis] = static_cast<float>(value(*fields.position[axis]));
      }
      if (fields.intensity != nullptr)
        point.intensity = static_cast<float>(value(*fields.intensity));
      if (fields.ring != nullptr) point.ring = to_ring(value(*fields.ring));
      if (fields.time_ns != nullptr) {
        raw.values.push_back(1e9 * value(*fields.time) + value(*fields.time_ns));
      } else if (fields.time != nullptr) {
        raw.values.push_back(value(*fields.time));
      }
    }
  }
  times.assign(scan, raw);
  return scan;
}

}  // namespace

ScanDecoder::ScanDecoder(PointTimeOptions options)
    : times_(std::make_unique<PointTimeReader>(std::move(options))) {}
ScanDecoder::ScanDecoder(ScanDecoder&&) noexcept = default;
ScanDecoder& ScanDecoder::operator=(ScanDecoder&&) noexcept = default;
ScanDecoder::~ScanDecoder() = default;

Expected<LidarScan> ScanDecoder::decode_point_cloud2(std::span<const std::byte> message,
                                                     RosWire wire) {
  HF_TRY(PointCloud2 cloud, parse(message, wire, Packing::kNone));
  return scan_of(cloud, *times_);
}

Expected<LidarScan> ScanDecoder::decode_compressed(std::span<const std::byte> message,
                                                   RosWire wire) {
  HF_TRY(PointCloud2 cloud, parse(message, wire, Packing::kCompressed));
  return scan_of(cloud, *times_);
}

Expected<LidarScan> ScanDecoder::decode_livox(std::span<const std::byte> message, RosWire wire) {
  constexpr std::size_t kPointBytes = 19;
  // CDR pads each point to the alignment of its offset, but not behind the last one.
  const std::size_t stride = wire == RosWire::kRos1 ? kPointBytes : 20;
  RosReader reader(message, wire);
  LidarScan scan = {.stamp = read_ros_header(reader).stamp};
  const auto timebase_ns = reader.read<std::uint64_t>();
  reader.skip<std::uint32_t>();  // point_num
  reader.skip<std::uint8_t>(4);  // lidar_id, reserved
  const auto num_points = reader.read<std::uint32_t>();
  const auto points =
      reader.take(num_points == 0 ? 0 : (std::uint64_t{num_points} - 1) * stride + kPointBytes);
  if (reader.failed()) {
    return fail(
        ErrorCode::kParse,
        fmt::format("a Livox message of {} bytes ends early; record again if there are many",
                    message.size()));
  }
  constexpr std::uint64_t kMaxTime = std::uint64_t{1} << 62;
  if (scan.stamp == Timestamp{} && timebase_ns < kMaxTime) scan.stamp = Timestamp(timebase_ns);
  RawPointTimes raw = {.field = "offset_time", .type = ScalarType::kUint32};
  const std::endian order = reader.order();
  scan.points.reserve(num_points);
  raw.values.reserve(num_points);
  for (std::size_t i = 0; i < num_points; ++i) {
    const std::byte* const bytes = points.data() + i * stride;
    if (is_livox_noise(load<std::uint8_t>(bytes + 17))) continue;
    LidarPoint& point = scan.points.emplace_back();
    raw.values.push_back(load<std::uint32_t>(bytes, order));
    point.point_in_lidar = {load<float>(bytes + 4, order),
                            load<float>(bytes + 8, order),
                            load<float>(bytes + 12, order)};
    point.intensity = load<std::uint8_t>(bytes + 16);
    point.ring = load<std::uint8_t>(bytes + 18);
  }
  if (times_->options().field == "none") raw.values.clear();
  times_->assign(scan, raw);
  return scan;
}

const std::string& ScanDecoder::point_time() const {
  return times_->description();
}

bool ScanDecoder::made_up() const {
  return times_->made_up();
}

std::vector<std::string> ScanDecoder::take_warnings() {
  return times_->take_warnings();
}

}  // namespace hybridfusion
