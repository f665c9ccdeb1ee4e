#include "xyz.hpp"

#include "placed_readers.hpp"
#include "text.hpp"
#include "text_lines.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <algorithm>
#include <optional>

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

[[nodiscard]] std::vector<std::string_view> words_of(std::string& line) {
  std::ranges::replace_if(line, [](char c) { return c == ',' || c == ';'; }, ' ');
  return split_words(line);
}

[[nodiscard]] std::optional<std::vector<double>> numbers_of(
    const std::vector<std::string_view>& words) {
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const auto value = parse_number<double>(word);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

Expected<CloudBuilder> build_xyz(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  std::optional<CloudBuilder> builder;
  std::size_t num_columns = 0;
  bool first = true;
  for (;;) {
    HF_TRY(const auto line, lines.next());
    if (!line) break;
    std::string copy(*line);
    const std::vector<std::string_view> words = words_of(copy);
    if (words.empty() || words[0].starts_with('#') || words[0].starts_with("//")) continue;
    const auto numbers = numbers_of(words);
    const bool is_heading = first && (!numbers || numbers->size() == 1);
    first = false;
    if (is_heading) continue;
    if (!builder && numbers) {
      num_columns = numbers->size();
      builder.emplace(columns_for(num_columns));
    }
    if (!numbers || numbers->size() < 3 || numbers->size() != num_columns ||
        !builder->add(*numbers)) {
      return lines.malformed(fmt::format("'{}' is no point like those before", printable(*line)),
                             kExpected);
    }
  }
  if (!builder) return lines.malformed("there are no points", kExpected);
  return std::move(*builder);
}

}  // namespace

Expected<PointCloud> read_xyz(const std::filesystem::path& path) {
  HF_TRY(CloudBuilder builder, build_xyz(path));
  return finished(path, std::move(builder).finish());
}

Expected<PlacedCloud> read_placed_xyz(const std::filesystem::path& path) {
  HF_TRY(CloudBuilder builder, build_xyz(path));
  return finished(path, std::move(builder).finish_placed());
}

Expected<void> write_xyz(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const Eigen::Vector3d& offset_m) {
  HF_CHECK(validate(cloud).has_value());
  HF_TRY(AtomicFile file, AtomicFile::create(path));
  std::string row;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& at = cloud.points[i];
    row.clear();
    if (offset_m.isZero()) {
      fmt::format_to(std::back_inserter(row), "{} {} {}", at.x(), at.y(), at.z());
    } else {
      const Eigen::Vector3d placed = at.cast<double>() + offset_m;
      fmt::format_to(
          std::back_inserter(row), "{:.4f} {:.4f} {:.4f}", placed.x(), placed.y(), placed.z());
    }
    if (!cloud.intensities.empty())
      fmt::format_to(std::back_inserter(row), " {}", cloud.intensities[i]);
    if (!cloud.colors.empty()) {
      const Rgb8& color = cloud.colors[i];
      fmt::format_to(std::back_inserter(row), " {} {} {}", color[0], color[1], color[2]);
    }
    file.write(row + "\n");
  }
  return file.commit();
}

}  // namespace hybridfusion
