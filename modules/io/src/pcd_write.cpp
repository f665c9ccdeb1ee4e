#include "byte_reader.hpp"
#include "lzf.hpp"
#include "pcd_output.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/pcd.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hybridfusion {
namespace {

// A compressed PCD keeps its sizes in 32 bits.
constexpr std::uint64_t kMaxCompressedBytes = 0xffffffffU;

/// A name in one word.
[[nodiscard]] std::string field_name(std::string name) {
  std::ranges::replace_if(name, [](char c) { return c <= ' '; }, '_');
  return name.empty() ? "_" : name;
}

template <class T>
[[nodiscard]] T bounded(double value) {
  if constexpr (std::is_integral_v<T>) {
    constexpr auto kLow = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto kHigh = static_cast<double>(std::numeric_limits<T>::max());
    if (value >= kHigh) return std::numeric_limits<T>::max();
    return value > kLow ? static_cast<T>(value) : std::numeric_limits<T>::min();
  } else {
    return static_cast<T>(value);
  }
}

template <class Column>
void visit_scalar(const PointScalar& scalar, Column&& column) {
  const std::string name = field_name(scalar.name);
  const auto put = [&]<class T>(T) {
    const char type = std::is_floating_point_v<T> ? 'F' : std::is_signed_v<T> ? 'I' : 'U';
    column(name.c_str(), type, static_cast<int>(sizeof(T)), [&scalar](std::size_t i) {
      return bounded<T>(scalar.values[i]);
    });
  };
  switch (scalar.type) {
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

/// Calls `column(name, type, size, value_of)` for each column of the file; value_of(i) gives the
/// value of point i in the type that is stored.
template <class Column>
void visit_columns(const CloudBatch& cloud, Column&& column) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  constexpr const char* kNormals[] = {"normal_x", "normal_y", "normal_z"};
  for (int axis = 0; axis < 3; ++axis) {
    column(kAxes[axis], 'F', 4, [&cloud, axis](std::size_t i) { return cloud.points[i][axis]; });
  }
  for (int axis = 0; axis < 3 && !cloud.normals.empty(); ++axis) {
    column(
        kNormals[axis], 'F', 4, [&cloud, axis](std::size_t i) { return cloud.normals[i][axis]; });
  }
  if (!cloud.colors.empty()) {
    // The bits as a float under the name "rgb", without alpha: what PCL's PointXYZRGB takes, and
    // the only form that three.js and loaders.gl know.
    column("rgb", 'F', 4, [&cloud](std::size_t i) {
      const Rgb8& color = cloud.colors[i];
      return std::bit_cast<float>(std::uint32_t{color[0]} << 16U | std::uint32_t{color[1]} << 8U |
                                  color[2]);
    });
  }
  if (!cloud.intensities.empty())
    column("intensity", 'F', 4, [&cloud](std::size_t i) { return cloud.intensities[i]; });
  if (!cloud.times_s.empty())
    column("time", 'F', 8, [&cloud](std::size_t i) { return cloud.times_s[i]; });
  if (!cloud.sigmas_m.empty())
    column("sigma", 'F', 4, [&cloud](std::size_t i) { return cloud.sigmas_m[i]; });
  if (!cloud.confidences.empty())
    column("confidence", 'F', 4, [&cloud](std::size_t i) { return cloud.confidences[i]; });
  if (!cloud.sources.empty())
    column("source", 'U', 1, [&cloud](std::size_t i) {
      return static_cast<std::uint8_t>(cloud.sources[i]);
    });
  for (const PointScalar& scalar : cloud.scalars) visit_scalar(scalar, column);
}

[[nodiscard]] std::string header(const CloudBatch& cloud,
                                 std::uint64_t num_points,
                                 PcdFormat format,
                                 const Viewpoint& viewpoint) {
  constexpr const char* kNames[] = {"binary_compressed", "binary", "ascii"};  // as PcdFormat
  std::string fields;
  std::string sizes;
  std::string types;
  std::string counts;
  visit_columns(cloud, [&](const char* name, char type, int size, auto&&) {
    fields += fmt::format(" {}", name);
    sizes += fmt::format(" {}", size);
    types += fmt::format(" {}", type);
    counts += " 1";
  });
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\n"
      "WIDTH {}\nHEIGHT 1\nVIEWPOINT {}\nPOINTS {}\nDATA {}\n",
      fields,
      sizes,
      types,
      counts,
      num_points,
      fmt::join(viewpoint, " "),
      num_points,
      kNames[static_cast<std::size_t>(format)]);
}

void write_rows(AtomicFile& file, const CloudBatch& cloud, PcdFormat format) {
  std::string row;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    row.clear();
    visit_columns(cloud, [&](const char*, char, int, auto&& value_of) {
      if (format == PcdFormat::kAscii) {
        fmt::format_to(std::back_inserter(row), "{} ", value_of(i));
      } else {
        append_value(row, value_of(i));
      }
    });
    if (format == PcdFormat::kAscii) row.back() = '\n';
    file.write(row);
  }
}

void write_columns_packed(AtomicFile& file, const CloudBatch& cloud) {
  std::string bytes;
  visit_columns(cloud, [&](const char*, char, int, auto&& value_of) {
    for (std::size_t i = 0; i < cloud.size(); ++i) append_value(bytes, value_of(i));
  });
  const std::string packed = lzf_pack(bytes);
  std::string sizes;
  append_value(sizes, static_cast<std::uint32_t>(packed.size()));
  append_value(sizes, static_cast<std::uint32_t>(bytes.size()));
  file.write(sizes);
  file.write(packed);
}

[[nodiscard]] std::uint64_t point_bytes(const CloudBatch& cloud) {
  std::uint64_t bytes = 0;
  visit_columns(cloud, [&](const char*, char, int size, auto&&) {
    bytes += static_cast<std::uint64_t>(size);
  });
  return bytes;
}

/// The format that can hold so many points: a compressed PCD keeps its sizes in 32 bits.
[[nodiscard]] PcdFormat possible_format(PcdFormat wanted,
                                        const CloudBatch& channels,
                                        std::uint64_t num_points) {
  const std::uint64_t bytes = point_bytes(channels);
  // Packing adds at most one byte in 32.
  const bool fits = num_points <= kMaxCompressedBytes / (bytes + bytes / 16 + 1);
  return wanted == PcdFormat::kBinaryCompressed && !fits ? PcdFormat::kBinary : wanted;
}

}  // namespace

Expected<PcdPieceWriter> PcdPieceWriter::create(const std::filesystem::path& path,
                                                std::uint64_t num_points,
                                                CloudEncoding encoding,
                                                const Viewpoint& viewpoint) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return PcdPieceWriter(std::move(file), num_points, encoding, viewpoint);
}

void PcdPieceWriter::start(const CloudBatch& channels) {
  // Compressing takes the whole cloud, so that it is not done to large ones unasked.
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 26U;
  PcdFormat wanted = PcdFormat::kBinaryCompressed;
  if (encoding_ == CloudEncoding::kAscii) wanted = PcdFormat::kAscii;
  const bool is_large = num_points_ > kMaxBytes / point_bytes(channels);
  if (encoding_ == CloudEncoding::kBinary || (encoding_ == CloudEncoding::kDefault && is_large)) {
    wanted = PcdFormat::kBinary;
  }
  format_ = possible_format(wanted, channels, num_points_);
  file_.write(header(channels, num_points_, *format_, viewpoint_));
}

void PcdPieceWriter::add(const CloudBatch& piece) {
  HF_CHECK(validate(piece).has_value());
  if (!format_) start(piece);
  if (*format_ == PcdFormat::kBinaryCompressed) {
    append(whole_, piece);
  } else {
    write_rows(file_, piece, *format_);
  }
}

Expected<void> PcdPieceWriter::commit() {
  if (!format_) start({});
  if (*format_ == PcdFormat::kBinaryCompressed) write_columns_packed(file_, whole_);
  return file_.commit();
}

Expected<void> write_pcd(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const PcdWriteOptions& options) {
  constexpr CloudEncoding kEncodings[] = {// as PcdFormat
                                          CloudEncoding::kCompressed,
                                          CloudEncoding::kBinary,
                                          CloudEncoding::kAscii};
  HF_TRY(PcdPieceWriter file,
         PcdPieceWriter::create(
             path, cloud.size(), kEncodings[static_cast<std::size_t>(options.format)]));
  CloudBatch batch;
  static_cast<PointCloud&>(batch) = cloud;
  file.add(batch);
  return file.commit();
}

}  // namespace hybridfusion
