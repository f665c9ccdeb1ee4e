#pragma once

#include "point_time.hpp"
#include "text_lines.hpp"

#include <hybridfusion/core/sensor_data.hpp>

#include <array>
#include <filesystem>
#include <vector>

namespace hybridfusion {

inline constexpr std::string_view kTimesFile = "times.txt";

struct ScanFile {
  std::filesystem::path path = {};
  Timestamp stamp{};
};

/// The .pcd files of a folder (or of its folder scans/) in the order of their times, which come
/// from times.txt if it is there, else from the file names.
/// @returns kNotFound without such files; kParse naming the file or the line without a time.
[[nodiscard]] Expected<std::vector<ScanFile>> list_scan_files(const std::filesystem::path& folder);

/// A scan with point times by the rules for PointCloud2 fields. Points without a position stay.
[[nodiscard]] Expected<LidarScan> read_scan_file(const ScanFile& file, PointTimeReader& times);

/// Rows of a CSV file: a time and then numbers. Lines that start with '#' and a heading are
/// skipped; a damaged row is an error of code kParse, after which reading goes on.
class CsvRows {
 public:
  static constexpr std::size_t kMaxColumns = 16;
  struct Row {
    Timestamp time{};
    std::size_t count = 0;  ///< Of the values behind the time.
    std::array<double, kMaxColumns> values = {};
  };

  /// @param min_values  Fewer numbers behind the time make a row damaged.
  [[nodiscard]] static Expected<CsvRows> open(const std::filesystem::path& path,
                                              std::size_t min_values,
                                              std::string_view columns);
  /// Nothing at the end.
  [[nodiscard]] Expected<std::optional<Row>> next();

 private:
  CsvRows(TextLines lines, std::size_t min_values, std::string_view columns)
      : lines_(std::move(lines)), min_values_(min_values), columns_(columns) {}

  TextLines lines_;
  std::size_t min_values_;
  std::string columns_;
  bool heading_allowed_ = true;
};

}  // namespace hybridfusion
