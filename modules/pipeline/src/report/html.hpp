#pragma once

#include "../json_text.hpp"

#include <string>
#include <string_view>

namespace hybridfusion {

/// Text made safe for HTML content and attribute values.
[[nodiscard]] std::string escaped(std::string_view text);

/// Nested objects as one table: path of keys, value, unit (taken from the key's suffix).
[[nodiscard]] std::string html_table(const Json& object);

/// Opens the page with its style; close it with "</body></html>".
[[nodiscard]] std::string html_head(std::string_view title);

}  // namespace hybridfusion
