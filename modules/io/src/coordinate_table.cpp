#include "coordinate_table.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr std::string_view kRemedy =
    "give the coordinate system in the first line (EPSG:4326, WGS84 UTM 32N), then one photo a "
    "line";

constexpr std::array kImageExtensions = {
    ".jpg", ".jpeg", ".png", ".tif", ".tiff", ".dng", ".heic", ".heif", ".webp", ".bmp"};

bool ends_as_image(std::string_view text) {
  const std::string lower = lower_case(text);
  return std::ranges::any_of(kImageExtensions,
                             [&](const char* extension) { return lower.ends_with(extension); });
}

std::string unquoted(std::string_view field) {
  const bool quoted = field.size() >= 2 && (field.front() == '"' || field.front() == '\'') &&
                      field.back() == field.front();
  return std::string(quoted ? field.substr(1, field.size() - 2) : field);
}

/// Fields between separators; one inside quotes is none.
std::vector<std::string> split_quoted(std::string_view line, char separator) {
  std::vector<std::string> fields;
  std::string field;
  char quote = 0;
  for (const char c : line) {
    const bool opens = quote == 0 && (c == '"' || c == '\'') && trimmed(field).empty();
    if (opens) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    }
    if (c == separator && quote == 0) {
      fields.push_back(unquoted(trimmed(field)));
      field.clear();
    } else {
      field += c;
    }
  }
  fields.push_back(unquoted(trimmed(field)));
  return fields;
}

void append_words(std::string_view text, std::vector<std::string>& out) {
  for (const std::string_view word : split_words(text)) out.emplace_back(word);
}

/// What stands between the columns; ' ' for runs of blanks. Tabs go before commas, which may be
/// decimal ones or part of a name, unless they only follow them.
char separator_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ';';
  if (line.find('\t') != std::string_view::npos) {
    const auto fields = split_fields(line, '\t');
    const bool after_commas =
        std::ranges::any_of(fields, [](std::string_view field) { return field.ends_with(','); });
    return after_commas ? ',' : '\t';
  }
  return line.find(',') != std::string_view::npos ? ',' : ' ';
}

/// Columns between blanks: the name ends with its quotes, at an image's extension, or at a blank.
std::optional<CoordinateRow> row_of_words(std::string_view line, std::size_t num_before) {
  CoordinateRow row;
  std::string_view rest = trimmed(line);
  for (std::size_t k = 0; k < num_before; ++k) {
    const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
    if (end == 0) return std::nullopt;
    row.before.emplace_back(rest.substr(0, end));
    rest = trimmed(rest.substr(end));
  }
  if (rest.empty()) return std::nullopt;
  std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
  if (rest.front() == '"' || rest.front() == '\'') {
    const std::size_t close = rest.find(rest.front(), 1);
    if (close != std::string_view::npos) end = close + 1;
  } else {
    for (std::size_t at = end;; at = std::min(rest.find_first_of(" \t", at + 1), rest.size())) {
      if (ends_as_image(rest.substr(0, at))) {
        end = at;
        break;
      }
      if (at == rest.size()) break;
    }
  }
  row.photo = unquoted(rest.substr(0, end));
  append_words(rest.substr(end), row.after);
  return row;
}

}  // namespace

Expected<CoordinateTable> CoordinateTable::open(const std::filesystem::path& path) {
  HF_TRY(TextLines lines, TextLines::open(path));
  return CoordinateTable(std::move(lines));
}

Expected<std::optional<std::string>> CoordinateTable::next() {
  constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
  while (true) {
    HF_TRY(const auto line, lines_.next());
    if (!line) return std::optional<std::string>{};
    std::string_view text = *line;
    if (first_ && (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))) {
      return lines_.malformed("the text is UTF-16", "save it as UTF-8");
    }
    if (first_ && text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
    first_ = false;
    text = trimmed(text);
    if (text.starts_with('#')) {
      constexpr std::size_t kMaxComments = 64;
      if (comments_.size() < kMaxComments) comments_.emplace_back(trimmed(text.substr(1)));
      continue;
    }
    if (!text.empty()) return std::optional<std::string>(text);
  }
}

std::unexpected<Error> CoordinateTable::malformed(std::string_view cause) const {
  return lines_.malformed(cause, kRemedy);
}

std::vector<std::string> split_row(std::string_view line) {
  const char separator = separator_of(line);
  std::vector<std::string> fields;
  if (separator == ' ') {
    append_words(line, fields);
    return fields;
  }
  fields = split_quoted(line, separator);
  if (separator == ',') return fields;
  for (std::string& field : fields) {
    std::string point = field;
    std::ranges::replace(point, ',', '.');
    if (parse_number<double>(point)) field = point;
  }
  return fields;
}

std::optional<CoordinateRow> row_of(std::string_view line, std::size_t num_before) {
  const char separator = separator_of(line);
  if (separator == ' ') return row_of_words(line, num_before);
  std::vector<std::string> fields = split_row(line);
  if (separator == '\t') {
    // Tabs as further blanks between the columns leave empty fields.
    std::erase_if(fields, [](const std::string& field) { return field.empty(); });
    // Tabs and blanks mixed: a column of numbers that holds a blank is two of them.
    const bool mixed = std::ranges::any_of(fields, [](const std::string& field) {
      const auto words = split_words(field);
      return words.size() > 1 && std::ranges::all_of(words, [](std::string_view word) {
               return parse_number<double>(word).has_value();
             });
    });
    if (mixed || fields.size() <= num_before + 1) return row_of_words(line, num_before);
  }
  if (fields.size() <= num_before) return std::nullopt;
  const auto name = fields.begin() + static_cast<std::ptrdiff_t>(num_before);
  return CoordinateRow{
      .before = {fields.begin(), name}, .photo = *name, .after = {name + 1, fields.end()}};
}

std::optional<double> finite_field(const std::vector<std::string>& fields, std::size_t at) {
  if (at >= fields.size()) return std::nullopt;
  const auto number = parse_number<double>(fields[at]);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<double> positive_field(const std::vector<std::string>& fields, std::size_t at) {
  const auto number = finite_field(fields, at);
  return number && *number > 0.0 ? number : std::nullopt;
}

}  // namespace hybridfusion
