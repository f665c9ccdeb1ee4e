#include "scan_folder_files.hpp"

#include "pcd_rows.hpp"
#include "text.hpp"
#include "time_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kTimesRemedy =
    "name the scans by their time (1700000000.100000000.pcd, seconds or nanoseconds since the "
    "epoch) or add times.txt with 'name time' on each line";

Expected<std::vector<std::filesystem::path>> pcd_files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    if (lower_case(entry->path().extension().string()) == ".pcd") files.push_back(entry->path());
  }
  if (code) {
    return fail(ErrorCode::kIo, fmt::format("{}: {}", folder.string(), code.message()));
  }
  std::ranges::sort(files);
  return files;
}

/// The time in a name such as "scan_1700000000.100000000.pcd"; nothing for a mere number.
[[nodiscard]] std::optional<Timestamp> time_in_name(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  const std::size_t first = stem.find_first_of("0123456789");
  if (first == std::string::npos) return std::nullopt;
  const std::string_view text = std::string_view(stem).substr(first);
  const auto time = parse_stamp(text);
  constexpr std::chrono::seconds kSmallestEpoch{100'000'000};
  const bool is_number_of_a_file =
      text.find('.') == std::string_view::npos && time && *time < Timestamp(kSmallestEpoch);
  return is_number_of_a_file ? std::nullopt : time;
}

Expected<std::map<std::string, Timestamp>> read_times(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::map<std::string, Timestamp> times;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) return times;
    const std::vector<std::string_view> words = split_words(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    const auto time = words.size() == 2 ? parse_stamp(words[1]) : std::nullopt;
    if (!time) {
      return lines.malformed(fmt::format("'{}' is no scan with a time", printable(*line)),
                             "write 'name time' on each line");
    }
    times[std::string(words[0])] = *time;
  }
}

/// Where the values of a point lie in the rows of a PCD file; -1: absent.
struct ScanColumns {
  std::array<int, 3> position = {-1, -1, -1};
  int intensity = -1;
  int ring = -1;
  int time = -1;
  ScalarType time_type = ScalarType::kFloat32;
  std::string time_name = {};
};

Expected<ScanColumns> find_columns(const InputFile& file,
                                   const PcdHeader& header,
                                   const PointTimeReader& times) {
  std::vector<std::string> names;
  for (const CloudColumn& column : pcd_columns(header)) names.push_back(column.name);
  const auto index_of = [&names](std::initializer_list<std::string_view> wanted) {
    for (const std::string_view name : wanted) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (lower_case(names[i]) == name) return static_cast<int>(i);
      }
    }
    return -1;
  };
  ScanColumns columns = {.position = {index_of({"x"}), index_of({"y"}), index_of({"z"})},
                         .intensity = index_of({"intensity", "reflectivity"}),
                         .ring = index_of({"ring", "line", "channel"})};
  if (std::ranges::min(columns.position) < 0) {
    return file.malformed("the points have no x, y and z", "export the scans again");
  }
  const std::string& asked = times.options().field;
  if (asked == "none") return columns;
  const auto chosen = times.choose_field(names);
  if (chosen) {
    columns.time = static_cast<int>(*chosen);
    columns.time_name = names[*chosen];
    for (const PcdField& field : header.fields) {
      if (field.name == columns.time_name) columns.time_type = field.type;
    }
  } else if (!asked.empty()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: no time field '{}'; the fields are: {}; choose another",
                            file.path().string(),
                            printable(asked),
                            printable(fmt::format("{}", fmt::join(names, ", ")))));
  }
  return columns;
}

}  // namespace

Expected<std::vector<ScanFile>> list_scan_files(const std::filesystem::path& folder) {
  HF_TRY(std::vector<std::filesystem::path> paths, pcd_files_in(folder));
  std::error_code code;
  if (paths.empty() && std::filesystem::is_directory(folder / "scans", code)) {
    HF_TRY(paths, pcd_files_in(folder / "scans"));
  }
  if (paths.empty()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: no scans; put them as .pcd files into the folder or into scans/",
                            folder.string()));
  }
  std::map<std::string, Timestamp> times;
  const bool has_times = std::filesystem::exists(folder / kTimesFile, code);
  if (has_times) {
    HF_TRY(times, read_times(folder / kTimesFile));
  }
  std::vector<ScanFile> files;
  for (std::filesystem::path& path : paths) {
    const auto listed = times.find(path.filename().string());
    const auto time = listed != times.end() ? std::optional(listed->second)
                      : has_times           ? std::nullopt
                                            : time_in_name(path);
    if (!time) {
      return fail(
          ErrorCode::kParse,
          fmt::format("{}: {}; {}",
                      path.string(),
                      has_times ? "times.txt has no line for this scan" : "the name holds no time",
                      kTimesRemedy));
    }
    files.push_back({.path = std::move(path), .stamp = *time});
  }
  std::ranges::stable_sort(files, {}, &ScanFile::stamp);
  return files;
}

Expected<LidarScan> read_scan_file(const ScanFile& scan_file, PointTimeReader& times) {
  HF_TRY(InputFile file, InputFile::open(scan_file.path));
  HF_TRY(const PcdHeader header, read_pcd_header(file));
  HF_TRY(const ScanColumns columns, find_columns(file, header, times));
  LidarScan scan = {.stamp = scan_file.stamp};
  RawPointTimes raw = {.field = columns.time_name, .type = columns.time_type};
  const PcdSink sink = {
      .reserve = [&scan](std::uint64_t points) { scan.points.reserve(points); },
      .row = [&](std::span<const double> row) -> Expected<void> {
        LidarPoint& point = scan.points.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
          point.point_in_lidar[axis] = static_cast<float>(row[columns.position[axis]]);
        }
        if (columns.intensity >= 0) {
          point.intensity = static_cast<float>(row[columns.intensity]);
        }
        const double ring = columns.ring >= 0 ? row[columns.ring] : 0.0;
        point.ring = static_cast<std::uint16_t>(ring >= 0.0 && ring <= 65535.0 ? ring : 0.0);
        if (columns.time >= 0) raw.values.push_back(row[columns.time]);
        return {};
      }};
  if (auto read = read_pcd_rows(file, header, sink); !read) return std::unexpected(read.error());
  times.assign(scan, raw);
  return scan;
}

Expected<CsvRows> CsvRows::open(const std::filesystem::path& path,
                                std::size_t min_values,
                                std::string_view columns) {
  HF_TRY(TextLines lines, TextLines::open(path));
  return CsvRows(std::move(lines), min_values, columns);
}

Expected<std::optional<CsvRows::Row>> CsvRows::next() {
  for (;;) {
    HF_TRY(const auto line, lines_.next());
    if (!line) return std::nullopt;
    if (trimmed(*line).empty() || line->starts_with('#')) continue;
    const std::vector<std::string_view> fields = split_fields(*line, ',');
    const auto time = parse_stamp(fields[0]);
    const bool heading = std::exchange(heading_allowed_, false) && !time;
    if (heading) continue;
    Row row = {.count = std::min(fields.size() - 1, kMaxColumns)};
    bool sound = time.has_value() && row.count >= min_values_;
    if (sound) row.time = *time;
    for (std::size_t i = 0; sound && i < row.count; ++i) {
      const auto value = parse_number<double>(fields[i + 1]);
      sound = value && std::isfinite(*value);
      if (sound) row.values[i] = *value;
    }
    if (sound) return row;
    return lines_.malformed(fmt::format("'{}' is no row of {}", printable(*line), columns_),
                            "export the file again");
  }
}

}  // namespace hybridfusion
