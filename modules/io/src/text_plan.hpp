#pragma once

#include "cloud_builder.hpp"
#include "text_lines.hpp"
#include "text_table.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// The lines before the first row of a text table, and the first rows.
struct TextStart {
  std::vector<std::string> head = {};  ///< Without those that are empty.
  std::size_t num_head_lines = 0;
  std::vector<std::string> rows = {};
};

/// What all rows of the file have in common.
struct TextPlan {
  TextDialect dialect = {};
  std::vector<CloudColumn> columns = {};
  std::vector<std::size_t> fields = {};  ///< One for each column.
  std::size_t num_fields = 0;
  std::string heading = {};
  std::vector<std::string> warnings = {};
};

inline constexpr std::string_view kNameTheColumns =
    "name them with a heading or --columns x,y,z,... ('-' leaves a column out)";

[[nodiscard]] bool is_text_comment(std::string_view line);
/// Without white space at the ends and the mark that UTF-8 may begin with.
[[nodiscard]] std::string_view text_of_line(std::string_view line);

/// @returns kParse for a file without points, and for one that is no text in UTF-8.
[[nodiscard]] Expected<TextStart> read_text_start(TextLines& lines);

/// @param given  Names of the columns; empty: from the heading or what they hold.
/// @returns kParse where the columns can be read in several ways.
[[nodiscard]] Expected<TextPlan> plan_text(const InputFile& file,
                                           const TextStart& start,
                                           const std::vector<std::string>& given);

}  // namespace hybridfusion
