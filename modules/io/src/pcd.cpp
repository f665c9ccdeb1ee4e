#include "byte_reader.hpp"
#include "lzf.hpp"
#include "pcd_rows.hpp"
#include "placed_readers.hpp"
#include "text.hpp"

#include <hybridfusion/io/pcd.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kAgain = "export the cloud again";

/// Collects the values of a point and hands them on as a row.
class RowBuilder {
 public:
  explicit RowBuilder(const PcdSink& sink) : sink_(sink) {}

  void reserve(std::uint64_t points) { sink_.reserve(points); }
  void begin() { row_.clear(); }
  void add(const PcdField& field, double value) {
    if (field.count == 1) row_.push_back(value);
  }
  void add_color(std::uint32_t argb) {
    for (const unsigned shift : {16U, 8U, 0U}) row_.push_back((argb >> shift) & 0xffU);
  }
  void end() { sink_.row(row_); }

 private:
  const PcdSink& sink_;
  std::vector<double> row_ = {};
};

[[nodiscard]] std::unexpected<Error> too_few_bytes(const InputFile& file, const PcdHeader& header) {
  return file.malformed(
      fmt::format("truncated: the header announces {} points, but only {} bytes follow",
                  header.points,
                  file.remaining()),
      "copy or export the file again");
}

Expected<void> read_ascii(InputFile& file, const PcdHeader& header, RowBuilder& rows) {
  std::size_t values = 0;
  for (const PcdField& field : header.fields) values += field.count;
  if (header.points > (file.remaining() + 1) / (2 * values)) return too_few_bytes(file, header);
  rows.reserve(header.points);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    rows.begin();
    for (const PcdField& field : header.fields) {
      for (std::size_t k = 0; k < field.count; ++k) {
        HF_TRY(const auto word, file.token());
        if (!word) return too_few_bytes(file, header);
        const auto value = parse_number<double>(*word);
        if (!value) {
          return file.malformed(
              fmt::format("'{}' of point {} is not a number", printable(*word), i), kAgain);
        }
        if (!field.packed_color) {
          rows.add(field, *value);
        } else if (is_integer(field.type) || (*value >= 256.0 && *value == std::floor(*value))) {
          // Writers of float fields put the bits as a whole number or as the float they make.
          rows.add_color(static_cast<std::uint32_t>(std::clamp(*value, 0.0, 4294967295.0)));
        } else {
          rows.add_color(std::bit_cast<std::uint32_t>(static_cast<float>(*value)));
        }
      }
    }
    rows.end();
  }
  return {};
}

/// Points one after the other in `bytes` (stride apart), or field after field.
/// @param at  Byte offset of value k of field f of point i.
template <class At>
void add_points(std::span<const std::byte> bytes,
                std::uint64_t points,
                const PcdHeader& header,
                RowBuilder& rows,
                At&& at) {
  for (std::uint64_t i = 0; i < points; ++i) {
    rows.begin();
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      const PcdField& field = header.fields[f];
      if (field.count != 1) continue;
      const std::byte* const from = bytes.data() + at(i, f);
      if (field.packed_color) {
        rows.add_color(load<std::uint32_t>(from));
      } else {
        rows.add(field, load_scalar(from, field.type, std::endian::little));
      }
    }
    rows.end();
  }
}

Expected<void> read_binary(InputFile& file, const PcdHeader& header, RowBuilder& rows) {
  const std::size_t stride = header.point_bytes();
  if (header.points > file.remaining() / stride) return too_few_bytes(file, header);
  rows.reserve(header.points);
  std::vector<std::size_t> offsets;
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    offsets.push_back(offset);
    offset += size_of(field.type) * field.count;
  }
  constexpr std::uint64_t kBlock = 1024;
  for (std::uint64_t done = 0; done < header.points;) {
    const std::uint64_t count = std::min(kBlock, header.points - done);
    HF_TRY(const auto bytes, file.take(count * stride));
    add_points(bytes, count, header, rows, [&](std::uint64_t i, std::size_t f) {
      return i * stride + offsets[f];
    });
    done += count;
  }
  return {};
}

Expected<void> read_compressed(InputFile& file, const PcdHeader& header, RowBuilder& rows) {
  HF_TRY(const auto sizes, file.take(2 * sizeof(std::uint32_t)));
  const std::uint64_t packed_bytes = load<std::uint32_t>(sizes.data());
  const std::uint64_t unpacked_bytes = load<std::uint32_t>(sizes.data() + sizeof(std::uint32_t));
  const std::size_t stride = header.point_bytes();
  if (packed_bytes > file.remaining() || unpacked_bytes / stride != header.points ||
      unpacked_bytes % stride != 0 || unpacked_bytes / kMaxLzfRatio > packed_bytes) {
    return too_few_bytes(file, header);
  }
  HF_TRY(const auto packed, file.take(packed_bytes));
  const auto bytes = lzf_unpack(packed, unpacked_bytes);
  if (!bytes)
    return file.malformed("the compressed data are damaged", "copy or export the file again");
  rows.reserve(header.points);
  std::vector<std::size_t> offsets;
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    offsets.push_back(offset);
    offset += size_of(field.type) * field.count * header.points;
  }
  add_points(*bytes, header.points, header, rows, [&](std::uint64_t i, std::size_t f) {
    return offsets[f] + i * size_of(header.fields[f].type);
  });
  return {};
}

Expected<void> read_data(InputFile& file, const PcdHeader& header, RowBuilder& rows) {
  if (header.data == "ascii") return read_ascii(file, header, rows);
  if (header.data == "binary") return read_binary(file, header, rows);
  if (header.data == "binary_compressed") return read_compressed(file, header, rows);
  return file.malformed(fmt::format("DATA '{}' is unknown", printable(header.data)), kAgain);
}

}  // namespace

std::vector<CloudColumn> pcd_columns(const PcdHeader& header) {
  std::vector<CloudColumn> columns;
  for (const PcdField& field : header.fields) {
    if (field.packed_color) {
      for (const char* const name : {"red", "green", "blue"}) {
        columns.push_back(cloud_column(name, ScalarType::kUint8));
      }
    } else if (field.count == 1) {
      columns.push_back(cloud_column(field.name, field.type));
    }
  }
  return columns;
}

Expected<void> read_pcd_rows(InputFile& file, const PcdHeader& header, const PcdSink& sink) {
  RowBuilder rows(sink);
  return read_data(file, header, rows);
}

namespace {

Expected<CloudBuilder> build_pcd(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const PcdHeader header, read_pcd_header(file));
  CloudBuilder builder(pcd_columns(header));
  if (!builder.has_coordinates()) {
    return file.malformed("the points have no x, y and z", "give a file with points");
  }
  // Points without a position ("no return" in organised clouds) are dropped.
  const PcdSink sink = {
      .reserve = [&builder](std::uint64_t points) { builder.reserve(points); },
      .row = [&builder](std::span<const double> row) { static_cast<void>(builder.add(row)); }};
  if (auto read = read_pcd_rows(file, header, sink); !read) return std::unexpected(read.error());
  return builder;
}

}  // namespace

Expected<PointCloud> read_pcd(const std::filesystem::path& path) {
  HF_TRY(CloudBuilder builder, build_pcd(path));
  return finished(path, std::move(builder).finish());
}

Expected<PlacedCloud> read_placed_pcd(const std::filesystem::path& path) {
  HF_TRY(CloudBuilder builder, build_pcd(path));
  return finished(path, std::move(builder).finish_placed());
}

}  // namespace hybridfusion
