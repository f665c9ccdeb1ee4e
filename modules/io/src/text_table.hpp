#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// How the fields of a text table are told apart, and its decimals.
struct TextDialect {
  enum class Separator : std::uint8_t { kSpace, kComma, kSemicolon, kTab, kCommaSpace };
  Separator separator = Separator::kSpace;
  bool decimal_comma = false;
};

/// The fields of a line without quotes and white space around them. Runs of white space are one
/// separator; an empty field behind the last comma, semicolon or tab is none.
void split_table_line(std::string_view line,
                      TextDialect::Separator separator,
                      std::vector<std::string_view>& fields);

/// The number that a field says; NaN for a missing one ("", "NaN", "1.#IND", "null", "NA"); nothing
/// for another text.
[[nodiscard]] std::optional<double> table_number(std::string_view field, bool decimal_comma);

/// Whether at least three numbers stand in the line, whatever separates them.
[[nodiscard]] bool is_table_row(std::string_view line);

/// What the rows of a table have in common, or why they cannot be told apart.
struct DialectGuess {
  TextDialect dialect = {};
  std::string doubt = {};  ///< Not empty: the rows can be read in several ways.
};

/// @param num_names  Fields that a heading or the caller announces; 0: unknown.
[[nodiscard]] DialectGuess guess_dialect(std::span<const std::string> rows, std::size_t num_names);

}  // namespace hybridfusion
