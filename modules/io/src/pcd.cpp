#include "byte_reader.hpp"
#include "cloud_rows.hpp"
#include "lzf.hpp"
#include "pcd_rows.hpp"
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
  [[nodiscard]] Expected<void> end() { return sink_.row(row_); }

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
    if (auto taken = rows.end(); !taken) return taken;
  }
  return {};
}

void add_value(const PcdField& field, const std::byte* from, RowBuilder& rows) {
  if (field.packed_color) {
    rows.add_color(load<std::uint32_t>(from));
  } else {
    rows.add(field, load_scalar(from, field.type, std::endian::little));
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
    for (std::uint64_t i = 0; i < count; ++i) {
      rows.begin();
      for (std::size_t f = 0; f < header.fields.size(); ++f) {
        if (header.fields[f].count != 1) continue;
        add_value(header.fields[f], bytes.data() + i * stride + offsets[f], rows);
      }
      if (auto taken = rows.end(); !taken) return taken;
    }
    done += count;
  }
  return {};
}

/// A field of a compressed file, whose values lie together.
struct PackedColumn {
  PcdField field = {};
  LzfReader values;
};

/// One reader for each field of one value, at its first: the fields lie one behind the other.
Expected<std::vector<PackedColumn>> open_columns(const InputFile& file,
                                                 const PcdHeader& header,
                                                 std::uint64_t packed_bytes) {
  // Each column costs a buffer and the unpacking of all before it.
  constexpr std::size_t kMaxColumns = 64;
  if (header.fields.size() > kMaxColumns) {
    return file.malformed(
        fmt::format("{} compressed fields, more than {}", header.fields.size(), kMaxColumns),
        "save it as binary");
  }
  std::vector<PackedColumn> columns;
  std::uint64_t offset = 0;
  for (const PcdField& field : header.fields) {
    if (field.count == 1) {
      HF_TRY(InputFile again, InputFile::open(file.path()));
      again.seek(file.position());
      LzfReader values(std::move(again), std::min(packed_bytes, file.remaining()));
      if (auto skipped = values.skip(offset); !skipped) return std::unexpected(skipped.error());
      columns.push_back({.field = field, .values = std::move(values)});
    }
    offset += size_of(field.type) * field.count * header.points;
  }
  return columns;
}

/// All of them must unpack to what the header announces, not a byte more.
Expected<void> check_end(PackedColumn& last, std::uint64_t bytes_left, const InputFile& file) {
  if (auto skipped = last.values.skip(bytes_left); !skipped) return skipped;
  if (last.values.at_end()) return {};
  return file.malformed("the compressed data are damaged", "copy or export the file again");
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
  HF_TRY(std::vector<PackedColumn> columns, open_columns(file, header, packed_bytes));
  if (columns.empty()) return too_few_bytes(file, header);
  rows.reserve(header.points);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    rows.begin();
    for (PackedColumn& column : columns) {
      HF_TRY(const auto bytes, column.values.take(size_of(column.field.type)));
      add_value(column.field, bytes.data(), rows);
    }
    if (auto taken = rows.end(); !taken) return taken;
  }
  std::uint64_t behind_last = 0;
  for (const PcdField& field : header.fields) {
    behind_last += size_of(field.type) * field.count * header.points;
    if (field.count == 1) behind_last = 0;
  }
  return check_end(columns.back(), behind_last, file);
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

Expected<CloudFileFacts> read_pcd_cloud_rows(const std::filesystem::path& path,
                                             const CloudRowSink& sink) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const PcdHeader header, read_pcd_header(file));
  PcdHeader labelled = header;
  for (PcdField& field : labelled.fields) field.name = field.label;
  const std::vector<CloudColumn> columns = pcd_columns(labelled);
  if (!has_coordinates(columns)) {
    return file.malformed("the points have no x, y and z", "give a file with points");
  }
  // Points without a position ("no return" in organised clouds) are dropped.
  const PcdSink points = {.reserve = [&](std::uint64_t count) { sink.begin(file, columns, count); },
                          .row = [&](std::span<const double> row) -> Expected<void> {
                            HF_TRY([[maybe_unused]] const bool finite, sink.row(row));
                            return {};
                          }};
  if (auto read = read_pcd_rows(file, header, points); !read) return std::unexpected(read.error());
  CloudFileFacts facts{.viewpoint = header.viewpoint};
  for (const PcdField& field : header.fields) {
    if (field.count < 2 || field.name == "_") continue;
    facts.warnings.push_back(fmt::format(
        "field '{}' of {} values a point is left out", printable(field.name), field.count));
  }
  return facts;
}

Expected<PointCloud> read_pcd(const std::filesystem::path& path) {
  return build_cloud(path, read_pcd_cloud_rows);
}

}  // namespace hybridfusion
