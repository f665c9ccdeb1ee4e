#include "byte_reader.hpp"
#include "cloud_rows.hpp"
#include "las_header.hpp"
#include "las_time.hpp"

#include <hybridfusion/io/cloud_stream.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kBlockPoints = 4096;

/// Turns point records into rows.
class LasRows {
 public:
  LasRows(const LasHeader& header, const CloudRowSink& sink)
      : header_(header), layout_(kLasLayouts[header.point_format]), sink_(sink) {}

  [[nodiscard]] std::vector<CloudColumn> columns() const;
  [[nodiscard]] Expected<void> add(const std::byte* record);
  [[nodiscard]] CloudFileFacts facts() const;

 private:
  [[nodiscard]] bool is_withheld(const std::byte* record) const;
  [[nodiscard]] bool has_time() const { return layout_.time != 0 && header_.absolute_time; }

  const LasHeader& header_;
  LasPointLayout layout_;
  const CloudRowSink& sink_;
  std::vector<double> row_ = {};
  std::uint64_t withheld_ = 0;
  std::uint64_t not_finite_ = 0;
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
  if (has_time()) columns.push_back(cloud_column("time", ScalarType::kFloat64));
  if (header_.source_byte != 0) columns.push_back(cloud_column("source", ScalarType::kUint8));
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
        header_.crs.metres_per_unit);
  }
  row_.push_back(load<std::uint16_t>(record + 12));
  for (int k = 0; k < 3 && layout_.color != 0; ++k) {
    row_.push_back(load<std::uint16_t>(record + layout_.color + 2 * k));
  }
  if (has_time()) row_.push_back(unix_time_of_las(load<double>(record + layout_.time)));
  if (header_.source_byte != 0) row_.push_back(load<std::uint8_t>(record + header_.source_byte));
  HF_TRY(const bool finite, sink_.row(row_));
  if (!finite) ++not_finite_;
  return {};
}

CloudFileFacts LasRows::facts() const {
  CloudFileFacts facts = {.crs = header_.crs};
  if (withheld_ > 0) {
    facts.warnings.push_back(fmt::format("{} withheld points are left out", withheld_));
  }
  if (not_finite_ > 0) {
    facts.warnings.push_back(fmt::format("{} points out of range are left out", not_finite_));
  }
  if (layout_.time != 0 && !header_.absolute_time) {
    facts.warnings.emplace_back("times count from the start of a week; they are left out");
  }
  if (facts.crs.metres_per_unit != 1.0) {
    // What the system says of its unit no longer holds.
    facts.crs.wkt.clear();
    facts.warnings.push_back(
        fmt::format("its unit of {:.6g} m became metres; the coordinate system is left out",
                    facts.crs.metres_per_unit));
  }
  return facts;
}

}  // namespace

Expected<CloudFileFacts> read_las_rows(const std::filesystem::path& path,
                                       const CloudRowSink& sink) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const LasHeader header, read_las_header(file));
  if (header.crs.geographic) {
    return file.malformed(
        fmt::format("its coordinates are degrees ({}), not metres", header.crs.name),
        "project them first, for example to UTM (pdal, las2las)");
  }
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
