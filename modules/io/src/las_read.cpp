#include "byte_reader.hpp"
#include "cloud_rows.hpp"
#include "las_header.hpp"
#include "las_time.hpp"
#include "text.hpp"

#include <hybridfusion/io/cloud_stream.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kBlockPoints = 4096;
constexpr std::size_t kInfraredByte = 36;  // of formats 8 and 10

/// Turns point records into rows.
class LasRows {
 public:
  LasRows(const LasHeader& header, const CloudRowSink& sink)
      : header_(header), layout_(kLasLayouts[header.point_format]), sink_(sink) {
    for (const LasExtraField& field : header.extra.fields) {
      is_ours_ = is_ours_ || (field.name == "source" && field.type == ScalarType::kUint8);
    }
  }

  [[nodiscard]] std::vector<CloudColumn> columns() const;
  [[nodiscard]] Expected<void> add(const std::byte* record);
  [[nodiscard]] CloudFileFacts facts() const;

 private:
  [[nodiscard]] bool is_withheld(const std::byte* record) const;
  [[nodiscard]] bool has_time() const { return layout_.time != 0; }
  [[nodiscard]] bool has_infrared() const {
    return header_.point_format == 8 || header_.point_format == 10;
  }

  const LasHeader& header_;
  LasPointLayout layout_;
  const CloudRowSink& sink_;
  bool is_ours_ = false;  ///< Point source and synthetic say what `source` says.
  std::vector<double> row_ = {};
  std::uint64_t withheld_ = 0;
};

std::vector<CloudColumn> LasRows::columns() const {
  std::vector<CloudColumn> columns;
  for (const char* const name : {"x", "y", "z"}) {
    columns.push_back(cloud_column(name, ScalarType::kFloat64));
  }
  // Both are in every record. Many writers put 8 bits of colour where 16 belong.
  const auto add_uncertain = [&columns](const char* name) {
    columns.push_back({.name = name,
                       .integer_max = std::numeric_limits<std::uint16_t>::max(),
                       .uncertain = true});
  };
  add_uncertain("intensity");
  if (layout_.color != 0) {
    for (const char* const name : {"red", "green", "blue"}) add_uncertain(name);
  }
  if (has_time()) {
    // Seconds of a week are no time of day; they keep the name of the field.
    columns.push_back(
        cloud_column(header_.absolute_time ? "time" : "gps_time", ScalarType::kFloat64));
    columns.back().uncertain = true;
    columns.back().unsaid = 0.0;
  }
  if (has_infrared()) columns.push_back(cloud_column("near_infrared", ScalarType::kUint16));
  for (CloudColumn& column : las_attribute_columns(header_.point_format)) {
    const bool told = column.name == "point_source_id" || column.name == "synthetic";
    if (is_ours_ && told) column.name.clear();
    columns.push_back(std::move(column));
  }
  for (const LasExtraField& field : header_.extra.fields) {
    columns.push_back(cloud_column(field.name, field.scaled ? ScalarType::kFloat64 : field.type));
    columns.back().uncertain = false;
    columns.back().description = field.description;
  }
  return columns;
}

bool LasRows::is_withheld(const std::byte* record) const {
  constexpr std::uint8_t kFormat6 = 6;
  return header_.point_format < kFormat6 ? (load<std::uint8_t>(record + 15) & 0x80U) != 0
                                         : (load<std::uint8_t>(record + 15) & 0x04U) != 0;
}

Expected<void> LasRows::add(const std::byte* record) {
  if (is_withheld(record)) {
    ++withheld_;
    return {};
  }
  row_.clear();
  for (int axis = 0; axis < 3; ++axis) {
    row_.push_back(
        (load<std::int32_t>(record + 4 * axis) * header_.scale[axis] + header_.offset[axis]) *
        header_.crs.to_metres[axis]);
  }
  row_.push_back(load<std::uint16_t>(record + 12));
  for (int k = 0; k < 3 && layout_.color != 0; ++k) {
    row_.push_back(load<std::uint16_t>(record + layout_.color + 2 * k));
  }
  if (has_time()) {
    const double time_s = load<double>(record + layout_.time);
    row_.push_back(header_.absolute_time ? unix_time_of_las(time_s) : time_s);
  }
  if (has_infrared()) row_.push_back(load<std::uint16_t>(record + kInfraredByte));
  append_las_attributes(record, header_.point_format, row_);
  for (const LasExtraField& field : header_.extra.fields) {
    const double raw = load_scalar(record + field.begin, field.type, std::endian::little);
    row_.push_back(raw * field.scale + field.offset);
  }
  HF_TRY([[maybe_unused]] const bool kept, sink_.row(row_));
  return {};
}

CloudFileFacts LasRows::facts() const {
  CloudFileFacts facts = {.crs = header_.crs.crs, .warnings = header_.crs.warnings};
  if (withheld_ > 0) {
    facts.warnings.push_back(fmt::format("{} withheld points are left out", withheld_));
  }
  for (const std::string& name : header_.extra.left_out) {
    facts.warnings.push_back(fmt::format("extra bytes '{}' are left out", printable(name)));
  }
  if (header_.extra.end < header_.point_bytes) {
    facts.warnings.push_back(
        fmt::format("{} extra bytes a point without a description are left out",
                    header_.point_bytes - header_.extra.end));
  }
  constexpr std::array<int, 4> kWithWaves = {4, 5, 9, 10};
  if (std::ranges::find(kWithWaves, header_.point_format) != kWithWaves.end()) {
    facts.warnings.emplace_back("its waveforms are left out");
  }
  return facts;
}

}  // namespace

Expected<CloudFileFacts> read_las_rows(const std::filesystem::path& path,
                                       const CloudRowSink& sink) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const LasHeader header, read_las_header(file));
  LasRows rows(header, sink);
  sink.begin(file, rows.columns(), header.points);
  file.seek(header.points_begin);
  for (std::uint64_t done = 0; done < header.points;) {
    const std::uint64_t count = std::min(kBlockPoints, header.points - done);
    HF_TRY(const auto bytes, file.take(count * header.point_bytes));
    for (std::uint64_t i = 0; i < count; ++i) {
      if (auto added = rows.add(bytes.data() + i * header.point_bytes); !added) {
        return std::unexpected(added.error());
      }
    }
    done += count;
  }
  return rows.facts();
}

Expected<PlacedCloud> read_las(const std::filesystem::path& path) {
  HF_TRY(const CloudSurvey survey, survey_rows(path, read_las_rows, {}));
  return collect_rows(path, survey, read_las_rows);
}

}  // namespace hybridfusion
