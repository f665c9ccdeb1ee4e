#include "xyz.hpp"

#include "cloud_rows.hpp"
#include "text.hpp"
#include "text_lines.hpp"

#include <algorithm>
#include <iterator>

namespace hybridfusion {
namespace {

constexpr std::string_view kExpected =
    "give 'x y z', 'x y z intensity', 'x y z r g b' or 'x y z intensity r g b' on each line";

[[nodiscard]] std::vector<CloudColumn> columns_for(std::size_t count) {
  std::vector<std::string_view> names = {"x", "y", "z"};
  if (count == 4 || count >= 7) names.push_back("intensity");
  if (count >= 6) names.insert(names.end(), {"red", "green", "blue"});
  std::vector<CloudColumn> columns;
  for (const std::string_view name : names)
    columns.push_back(cloud_column(name, ScalarType::kFloat64));
  return columns;
}

constexpr auto kIsSeparator = [](char c) {
  return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
};

/// The numbers of a line; false when one of its words is none.
[[nodiscard]] bool parse_numbers(std::string_view line, std::vector<double>& numbers) {
  numbers.clear();
  const char* const end = line.data() + line.size();
  for (const char* from = line.data();;) {
    from = std::find_if_not(from, end, kIsSeparator);
    if (from == end) return true;
    const char* const stop = std::find_if(from, end, kIsSeparator);
    const auto value = parse_number<double>({from, stop});
    if (!value) return false;
    numbers.push_back(*value);
    from = stop;
  }
}

[[nodiscard]] bool is_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.find_first_not_of(",; \t") == std::string_view::npos || text.starts_with('#') ||
         text.starts_with("//");
}

}  // namespace

Expected<CloudFileFacts> read_xyz_rows(const std::filesystem::path& path,
                                       const CloudRowSink& sink) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::size_t num_columns = 0;
  std::vector<double> numbers;
  bool first = true;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) break;
    if (is_comment(*line)) continue;
    const bool are_numbers = parse_numbers(*line, numbers);
    const bool is_heading = first && (!are_numbers || numbers.size() == 1);
    first = false;
    if (is_heading) continue;
    const auto bad = [&] {
      return lines.malformed(fmt::format("'{}' is no point like those before", printable(*line)),
                             kExpected);
    };
    if (!are_numbers || numbers.size() < 3) return bad();
    if (num_columns == 0) {
      num_columns = numbers.size();
      sink.begin(lines.file(), columns_for(num_columns), 0);
    }
    if (numbers.size() != num_columns) return bad();
    HF_TRY(const bool finite, sink.row(numbers));
    if (!finite) return bad();
  }
  if (num_columns == 0) return lines.malformed("there are no points", kExpected);
  return CloudFileFacts{};
}

Expected<PointCloud> read_xyz(const std::filesystem::path& path) {
  return build_cloud(path, read_xyz_rows);
}

Expected<XyzPieceWriter> XyzPieceWriter::create(const std::filesystem::path& path,
                                                const Eigen::Vector3d& offset_m) {
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  return XyzPieceWriter(std::move(file), offset_m);
}

void XyzPieceWriter::add(const PointCloud& piece) {
  HF_CHECK(validate(piece).has_value());
  std::string row;
  const auto out = std::back_inserter(row);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Eigen::Vector3f& at = piece.points[i];
    row.clear();
    if (offset_m_.isZero()) {
      fmt::format_to(out, "{} {} {}", at.x(), at.y(), at.z());
    } else {
      const Eigen::Vector3d placed = at.cast<double>() + offset_m_;
      fmt::format_to(out, "{:.4f} {:.4f} {:.4f}", placed.x(), placed.y(), placed.z());
    }
    if (!piece.intensities.empty()) fmt::format_to(out, " {}", piece.intensities[i]);
    if (!piece.colors.empty()) {
      const Rgb8& color = piece.colors[i];
      fmt::format_to(out, " {} {} {}", color[0], color[1], color[2]);
    }
    row += '\n';
    file_.write(row);
  }
}

Expected<void> XyzPieceWriter::commit() {
  return file_.commit();
}

Expected<void> write_xyz(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const Eigen::Vector3d& offset_m) {
  HF_TRY(XyzPieceWriter file, XyzPieceWriter::create(path, offset_m));
  file.add(cloud);
  return file.commit();
}

}  // namespace hybridfusion
