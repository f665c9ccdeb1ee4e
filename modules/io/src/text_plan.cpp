#include "text_plan.hpp"

#include "text.hpp"
#include "text_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kSampleRows = 200;

[[nodiscard]] std::optional<std::uint64_t> single_count(std::string_view line) {
  return parse_number<std::uint64_t>(trimmed(line));
}

/// The names in a line, however they are separated.
[[nodiscard]] std::vector<std::string_view> names_in(std::string_view line, std::size_t wanted) {
  line = trimmed(line.substr(std::min(line.find_first_not_of("#/%!"), line.size())));
  std::vector<std::string_view> best;
  std::vector<std::string_view> names;
  using Separator = TextDialect::Separator;
  for (const Separator separator : {Separator::kComma,
                                    Separator::kSemicolon,
                                    Separator::kTab,
                                    Separator::kSpace,
                                    Separator::kCommaSpace}) {
    split_table_line(line, separator, names);
    if (best.empty() || names.size() == wanted ||
        (best.size() != wanted && names_position(names) && !names_position(best))) {
      best = names;
    }
    if (names.size() == wanted) break;
  }
  return best;
}

[[nodiscard]] TextSample sample_of(const TextStart& start, const TextPlan& plan) {
  TextSample sample;
  sample.columns.resize(plan.num_fields);
  std::vector<std::string_view> fields;
  for (const std::string& row : start.rows) {
    split_table_line(row, plan.dialect.separator, fields);
    for (std::size_t i = 0; i < std::min(fields.size(), plan.num_fields); ++i) {
      const auto number = table_number(fields[i], plan.dialect.decimal_comma);
      if (!number) continue;
      const bool whole = fields[i].find_first_not_of("0123456789+-") == std::string_view::npos;
      sample.columns[i].integers &= whole || std::isnan(*number);
      sample.columns[i].values.push_back(*number);
    }
  }
  return sample;
}

/// Fills the columns from names; those that hold texts are left out.
Expected<void> take_names(const InputFile& file,
                          const TextStart& start,
                          const TextColumns& columns,
                          TextPlan& plan) {
  if (!columns.doubt.empty()) {
    return file.malformed(columns.doubt, columns.remedy.empty() ? kNameTheColumns : columns.remedy);
  }
  const TextSample sample = sample_of(start, plan);
  for (std::size_t i = 0; i < plan.num_fields; ++i) {
    const std::string& name = columns.names[i];
    if (name.empty()) continue;
    const bool is_coordinate = name == "x" || name == "y" || name == "z";
    if (sample.columns[i].values.size() < start.rows.size() && !is_coordinate) {
      plan.warnings.push_back(
          fmt::format("column '{}' holds no numbers and is left out", printable(name)));
      continue;
    }
    plan.columns.push_back(cloud_column(name, ScalarType::kFloat64));
    plan.fields.push_back(i);
  }
  return {};
}

/// The line of the head that names the columns; nullptr: none.
Expected<const std::string*> find_heading(const InputFile& file,
                                          const TextStart& start,
                                          std::size_t num_fields) {
  const std::string* heading = nullptr;
  for (const std::string& line : start.head) {
    if (single_count(line)) continue;
    const auto names = names_in(line, num_fields);
    if (lower_case(line).starts_with("ncols")) {
      return file.malformed("a grid (ESRI ASCII), not points",
                            "turn it into points first (gdal_translate -of XYZ)");
    }
    const bool comment = is_text_comment(line);
    const bool known = names_position(names) || (names.size() > 1 && are_known_names(names));
    if (names.size() == num_fields && (known || !comment)) {
      heading = &line;
    } else if (known && (!comment || are_known_names(names))) {
      return file.malformed(fmt::format("the heading '{}' has {} names for {} columns",
                                        printable(line),
                                        names.size(),
                                        num_fields),
                            kNameTheColumns);
    }
  }
  return heading;
}

/// The number of fields that the heading, if there is one, most likely has.
[[nodiscard]] std::size_t announced_fields(const TextStart& start) {
  for (const std::string& line : start.head) {
    const auto names = names_in(line, 0);
    if (!single_count(line) && (names_position(names) || are_known_names(names))) {
      return names.size();
    }
  }
  return 0;
}

}  // namespace

bool is_text_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%') ||
         line.find_first_not_of(",; \t") == std::string_view::npos;
}

std::string_view text_of_line(std::string_view line) {
  constexpr std::string_view kUtf8 = "\xef\xbb\xbf";
  return trimmed(line.starts_with(kUtf8) ? line.substr(kUtf8.size()) : line);
}

Expected<TextStart> read_text_start(TextLines& lines) {
  TextStart start;
  while (start.rows.size() < kSampleRows) {
    HF_TRY(const auto line, lines.next());
    if (!line) break;
    if (line->starts_with("\xff\xfe") || line->starts_with("\xfe\xff")) {
      return lines.malformed("the text is UTF-16", "save it as UTF-8 (iconv -f UTF-16 -t UTF-8)");
    }
    const std::string_view text = text_of_line(*line);
    if (text.find('\0') != std::string_view::npos) {
      return lines.malformed("not a text file", "give a text file with a point on each line");
    }
    const bool is_row = !text.empty() && !is_text_comment(text) && is_table_row(text);
    if (is_row) {
      start.rows.emplace_back(text);
    } else if (start.rows.empty()) {
      ++start.num_head_lines;
      if (!text.empty()) start.head.emplace_back(text);
    }
  }
  if (!start.rows.empty()) return start;
  return lines.malformed("there are no points", "give a point, at least x y z, on each line");
}

Expected<TextPlan> plan_text(const InputFile& file,
                             const TextStart& start,
                             const std::vector<std::string>& given) {
  const DialectGuess guess =
      guess_dialect(start.rows, given.empty() ? announced_fields(start) : given.size());
  if (!guess.doubt.empty()) {
    return file.malformed(guess.doubt,
                          "write decimals with points; where commas separate whole numbers, give "
                          "--columns x,y,z,...");
  }
  TextPlan plan{.dialect = guess.dialect};
  std::vector<std::string_view> fields;
  split_table_line(start.rows.front(), plan.dialect.separator, fields);
  plan.num_fields = fields.size();
  const bool is_pts = lower_case(file.path().extension().string()) == ".pts";
  TextColumns columns;
  if (!given.empty()) {
    if (given.size() != plan.num_fields) {
      return file.malformed(
          fmt::format(
              "--columns names {} columns, the rows have {}", given.size(), plan.num_fields),
          "name every column, '-' for one to leave out");
    }
    columns = columns_of_names(std::vector<std::string_view>(given.begin(), given.end()));
  } else {
    HF_TRY(const std::string* heading, find_heading(file, start, plan.num_fields));
    if (heading != nullptr) {
      plan.heading = *heading;
      columns = columns_of_names(names_in(*heading, plan.num_fields));
    } else if (plan.num_fields < 3) {
      columns.doubt = fmt::format("{} columns are no points", plan.num_fields);
    } else {
      columns = guess_columns(sample_of(start, plan), is_pts);
      if (plan.num_fields > 3 && columns.doubt.empty()) {
        plan.warnings.push_back(
            fmt::format("no heading: its columns are taken as {}", fmt::join(columns.names, " ")));
      }
    }
  }
  if (auto taken = take_names(file, start, columns, plan); !taken) {
    return std::unexpected(taken.error());
  }
  return plan;
}

}  // namespace hybridfusion
