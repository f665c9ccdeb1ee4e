#include "byte_reader.hpp"
#include "lzf.hpp"
#include "pcd_output.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/pcd.hpp>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// A compressed PCD keeps its sizes in 32 bits.
constexpr std::uint64_t kMaxCompressedBytes = 0xffffffffU;

/// Calls `column(name, type, size, value_of)` for each column of the file; value_of(i) gives the
/// value of point i in the type that is stored.
template <class Column>
void visit_columns(const PointCloud& cloud, Column&& column) {
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
    column("rgba", 'U', 4, [&cloud](std::size_t i) {
      const Rgb8& color = cloud.colors[i];
      return 0xff000000U | std::uint32_t{color[0]} << 16U | std::uint32_t{color[1]} << 8U |
             color[2];
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
}

[[nodiscard]] std::string header(const PointCloud& cloud,
                                 std::uint64_t num_points,
                                 PcdFormat format) {
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
      "WIDTH {}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA {}\n",
      fields,
      sizes,
      types,
      counts,
      num_points,
      num_points,
      kNames[static_cast<std::size_t>(format)]);
}

void write_rows(AtomicFile& file, const PointCloud& cloud, PcdFormat format) {
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

void write_columns_packed(AtomicFile& file, const PointCloud& cloud) {
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

[[nodiscard]] std::uint64_t point_bytes(const PointCloud& cloud) {
  std::uint64_t bytes = 0;
  visit_columns(cloud, [&](const char*, char, int size, auto&&) {
    bytes += static_cast<std::uint64_t>(size);
  });
  return bytes;
}

/// The format that can hold so many points: a compressed PCD keeps its sizes in 32 bits.
[[nodiscard]] PcdFormat possible_format(PcdFormat wanted,
                                        const PointCloud& channels,
                                        std::uint64_t num_points) {
  const std::uint64_t bytes = point_bytes(channels);
  // Packing adds at most one byte in 32.
  const bool fits = num_points <= kMaxCompressedBytes / (bytes + bytes / 16 + 1);
  return wanted == PcdFormat::kBinaryCompressed && !fits ? PcdFormat::kBinary : wanted;
}

}  // namespace

Expected<PcdPieceWriter> PcdPieceWriter::create(const std::filesystem::path& path,
                                                std::uint64_t num_points,
                                                CloudEncoding encoding) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return PcdPieceWriter(std::move(file), num_points, encoding);
}

void PcdPieceWriter::start(const PointCloud& channels) {
  // Compressing takes the whole cloud, so that it is not done to large ones unasked.
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 26U;
  PcdFormat wanted = PcdFormat::kBinaryCompressed;
  if (encoding_ == CloudEncoding::kAscii) wanted = PcdFormat::kAscii;
  const bool is_large = num_points_ > kMaxBytes / point_bytes(channels);
  if (encoding_ == CloudEncoding::kBinary || (encoding_ == CloudEncoding::kDefault && is_large)) {
    wanted = PcdFormat::kBinary;
  }
  format_ = possible_format(wanted, channels, num_points_);
  file_.write(header(channels, num_points_, *format_));
}

void PcdPieceWriter::add(const PointCloud& piece) {
  HF_CHECK(validate(piece).has_value());
  if (!format_) start(piece);
  if (*format_ == PcdFormat::kBinaryCompressed) {
    whole_ = concatenate(std::move(whole_), piece);
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
  file.add(cloud);
  return file.commit();
}

}  // namespace hybridfusion
