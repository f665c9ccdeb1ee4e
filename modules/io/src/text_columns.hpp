#pragma once

#include "cloud_builder.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// What the columns of a text cloud are, or why that cannot be said.
struct TextColumns {
  /// One for each field, with the names of CloudBuilder where it knows them; "": left out.
  std::vector<std::string> names = {};
  std::string doubt = {};   ///< Not empty: the columns cannot be taken as points.
  std::string remedy = {};  ///< Empty: name the columns.
};

/// From the names of a heading or of --columns.
[[nodiscard]] TextColumns columns_of_names(std::span<const std::string_view> names);

/// Whether every name is one that a heading of points has.
[[nodiscard]] bool are_known_names(std::span<const std::string_view> names);
[[nodiscard]] bool names_position(std::span<const std::string_view> names);

/// The first rows of a table, column by column.
struct TextSample {
  struct Column {
    std::vector<double> values = {};
    bool integers = true;  ///< Written without a decimal point or an exponent.
  };
  std::vector<Column> columns = {};
};

/// From what the columns hold, when no heading names them.
/// @param is_pts  Leica's format, whose intensity stands before the colour.
[[nodiscard]] TextColumns guess_columns(const TextSample& sample, bool is_pts);

}  // namespace hybridfusion
