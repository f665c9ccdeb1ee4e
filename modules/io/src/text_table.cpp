#include "text_table.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

using Separator = TextDialect::Separator;

[[nodiscard]] bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

[[nodiscard]] std::string_view unquoted(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = trimmed(field.substr(1, field.size() - 2));
  }
  return field;
}

/// "1,5": digits on both sides of the only comma.
[[nodiscard]] bool has_decimal_comma(std::string_view field) {
  const std::size_t at = field.find(',');
  return at != std::string_view::npos && field.find(',', at + 1) == std::string_view::npos &&
         at + 1 < field.size() && is_digit(field[at + 1]) && at > 0 && is_digit(field[at - 1]);
}

void split_words_at(std::string_view line, std::string_view separators, auto&& take) {
  for (std::size_t first = line.find_first_not_of(separators); first != std::string_view::npos;) {
    const std::size_t last = std::min(line.find_first_of(separators, first), line.size());
    take(line.substr(first, last - first));
    first = line.find_first_not_of(separators, last);
  }
}

/// At single separators outside of quotes.
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != separator || quoted)) continue;
    fields.push_back(unquoted(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
}

constexpr std::string_view kBlank = " \t\r\v\f";

/// What the commas of fields that something else separates stand for.
DialectGuess judge_commas(std::span<const std::string> rows, Separator separator) {
  DialectGuess guess{.dialect = {.separator = separator}};
  std::string comma;
  bool point = false;
  std::vector<std::string_view> fields;
  for (const std::string& row : rows) {
    split_table_line(row, separator, fields);
    for (const std::string_view field : fields) {
      if (field.empty() || field.find_first_not_of("0123456789+-.,eE") != std::string_view::npos) {
        continue;
      }
      const bool pointed = field.find('.') != std::string_view::npos;
      point = point || pointed;
      if (field.find(',') == std::string_view::npos) continue;
      if (pointed || !has_decimal_comma(field)) {
        guess.doubt = fmt::format("'{}' has commas that are no decimals", printable(field));
        return guess;
      }
      if (comma.empty()) comma = field;
    }
  }
  if (!comma.empty() && point) {
    guess.doubt = fmt::format("'{}' has a comma where other numbers have points", printable(comma));
  }
  guess.dialect.decimal_comma = !comma.empty();
  return guess;
}

[[nodiscard]] std::vector<std::string_view> words_of(std::string_view row) {
  std::vector<std::string_view> words;
  split_words_at(row, kBlank, [&words](std::string_view word) { words.push_back(word); });
  return words;
}

/// White space separates, and the commas belong to the words: "1,5 2,5 3,5".
[[nodiscard]] bool is_blank_separated(const std::string& row) {
  constexpr std::size_t kFewest = 3;  // words of a point
  const auto words = words_of(row);
  return words.size() >= kFewest && row.find('"') == std::string::npos &&
         std::ranges::none_of(
             words, [](std::string_view w) { return w.ends_with(',') || w.starts_with(','); });
}

/// A field of several numbers: "1,2,3 10 20 30" mixes separators.
[[nodiscard]] bool holds_numbers(std::string_view field) {
  const auto words = words_of(field);
  return words.size() > 1 && std::ranges::all_of(words, [](std::string_view word) {
           return table_number(word, false).has_value();
         });
}

/// Rows whose only separators are commas, perhaps with white space.
DialectGuess judge_comma_rows(std::span<const std::string> rows, std::size_t num_names) {
  if (std::ranges::all_of(rows, is_blank_separated)) return judge_commas(rows, Separator::kSpace);
  DialectGuess guess{.dialect = {.separator = Separator::kComma}};
  std::vector<std::string_view> fields;
  bool point = false;
  std::size_t most = 0;
  for (const std::string& row : rows) {
    split_table_line(row, Separator::kComma, fields);
    most = std::max(most, fields.size());
    for (const std::string_view field : fields) {
      if (has_decimal_comma(field)) guess.dialect.decimal_comma = true;  // in quotes
      point = point || field.find('.') != std::string_view::npos;
      if (holds_numbers(field)) guess.dialect.separator = Separator::kCommaSpace;
    }
  }
  if (guess.dialect.decimal_comma && point) guess.doubt = "decimal commas beside decimal points";
  constexpr std::size_t kTwice = 6;  // three coordinates, each in two parts
  if (!point && !guess.dialect.decimal_comma && most >= kTwice && num_names != most) {
    guess.doubt = "the commas may be decimals or separators";
  }
  return guess;
}

}  // namespace

void split_table_line(std::string_view line,
                      Separator separator,
                      std::vector<std::string_view>& fields) {
  fields.clear();
  const auto take = [&fields](std::string_view word) { fields.push_back(unquoted(word)); };
  switch (separator) {
    case Separator::kSpace:
      return split_words_at(line, kBlank, take);
    case Separator::kCommaSpace:
      return split_words_at(line, ", \t\r\v\f", take);
    case Separator::kComma:
      return split_cells(line, ',', fields);
    case Separator::kSemicolon:
      return split_cells(line, ';', fields);
    case Separator::kTab:
      return split_cells(line, '\t', fields);
  }
}

std::optional<double> table_number(std::string_view field, bool decimal_comma) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  if (field.empty()) return kMissing;
  if (decimal_comma) {
    if (field.find('.') != std::string_view::npos) return std::nullopt;
    if (const std::size_t at = field.find(','); at != std::string_view::npos) {
      std::string pointed(field);
      pointed[at] = '.';
      return parse_number<double>(pointed);
    }
  }
  if (const auto number = parse_number<double>(field)) return number;
  // Microsoft's runtime writes 1.#QNAN, -1.#IND and 1.#INF.
  if (field.find(".#") != std::string_view::npos) return kMissing;
  const std::string lower = lower_case(field);
  for (const std::string_view word : {"null", "na", "n/a", "none", "-"}) {
    if (lower == word) return kMissing;
  }
  return std::nullopt;
}

bool is_table_row(std::string_view line) {
  std::size_t numbers = 0;
  split_words_at(line, ",; \t\r\v\f\"", [&numbers](std::string_view word) {
    const bool number = is_digit(word.back()) || word.back() == '.' || lower_case(word) == "nan";
    if (number && parse_number<double>(word)) ++numbers;
  });
  return numbers >= 3;
}

DialectGuess guess_dialect(std::span<const std::string> rows, std::size_t num_names) {
  const auto any = [rows](char c) {
    return std::ranges::any_of(
        rows, [c](const std::string& row) { return row.find(c) != std::string::npos; });
  };
  if (any(';')) return judge_commas(rows, Separator::kSemicolon);
  if (any('\t')) {
    // Tabs align as well as separate: they are cells only where words do not give equal rows.
    const std::size_t width = rows.empty() ? 0 : words_of(rows.front()).size();
    const bool words_do = std::ranges::all_of(
        rows, [width](const std::string& row) { return words_of(row).size() == width; });
    if (!any(',') || width >= 3) {
      return judge_commas(rows, words_do ? Separator::kSpace : Separator::kTab);
    }
  }
  if (any(',')) return judge_comma_rows(rows, num_names);
  return {.dialect = {.separator = Separator::kSpace}};
}

}  // namespace hybridfusion
