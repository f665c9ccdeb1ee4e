#pragma once

#include "text_lines.hpp"

#include <hybridfusion/core/error.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Lines of a table of positions that hold something; comments (#) are dropped, and the byte order
/// mark that Windows editors put first.
class CoordinateTable {
 public:
  /// @returns kParse for UTF-16 as well.
  [[nodiscard]] static Expected<CoordinateTable> open(const std::filesystem::path& path);

  /// The next line, without blanks around; nothing at the end.
  [[nodiscard]] Expected<std::optional<std::string>> next();
  /// The comments so far, without '#': some programs hide the heading or the system there.
  [[nodiscard]] const std::vector<std::string>& comments() const { return comments_; }
  [[nodiscard]] const std::filesystem::path& path() const { return lines_.file().path(); }

  [[nodiscard]] std::unexpected<Error> malformed(std::string_view cause) const;

 private:
  explicit CoordinateTable(TextLines lines) : lines_(std::move(lines)) {}
  TextLines lines_;
  bool first_ = true;
  std::vector<std::string> comments_ = {};
};

/// A row with the name of a photo in it.
struct CoordinateRow {
  std::vector<std::string> before = {};  ///< Fields in front of the name.
  std::string photo = {};                ///< Quotes removed, blanks inside kept as they are.
  std::vector<std::string> after = {};   ///< Fields behind the name.
};

/// Fields between semicolons, else tabs, else commas, else runs of blanks; quoted ones whole. Where
/// the comma separates nothing, a decimal comma becomes a point.
[[nodiscard]] std::vector<std::string> split_row(std::string_view line);

/// The row with its photo behind `num_before` fields. A name with blanks between columns of blanks
/// ends at the extension of an image, or with the quotes around it.
[[nodiscard]] std::optional<CoordinateRow> row_of(std::string_view line, std::size_t num_before);

/// The finite number that the field is; nothing when there is none.
[[nodiscard]] std::optional<double> finite_field(const std::vector<std::string>& fields,
                                                 std::size_t at);
/// A deviation that says something: finite and above 0.
[[nodiscard]] std::optional<double> positive_field(const std::vector<std::string>& fields,
                                                   std::size_t at);

}  // namespace hybridfusion
