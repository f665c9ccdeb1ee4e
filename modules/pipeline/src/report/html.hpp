#pragma once

#include "../json_text.hpp"

#include <string>
#include <string_view>

namespace hybridfusion {

/// Text made safe for HTML content and attribute values.
[[nodiscard]] std::string escaped(std::string_view text);

/// A number that can be followed to its file: `<data value='..' title='formula'>text</data>`.
/// @param format   As of fmt, e.g. "{:.2f}"; "–" is shown for what is not finite.
/// @param formula  How it comes from files of the workspace: members as "FILE.json#/pointer",
/// cameras
///                 as "FILE.txt#id/parameter", numbers, operators and mathematical functions, e.g.
///                 "100 * run.json#/stages/map/result/result/x"; or one of the medians in words.
[[nodiscard]] std::string traced(double value, std::string_view format, std::string_view formula);

/// Nested objects as one table: path of keys, value, unit (taken from the key's suffix).
/// @param source  Of the object itself, e.g. "run.json#/stages/map/result/result".
[[nodiscard]] std::string html_table(const Json& object, const std::string& source);

/// Opens the page with its style; close it with "</body></html>".
[[nodiscard]] std::string html_head(std::string_view title);

}  // namespace hybridfusion
