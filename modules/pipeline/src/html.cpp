#include "html.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxArrayText = 200;  // longer arrays stay in the JSON files

struct NameAndUnit {
  std::string name;
  std::string_view unit;
};

NameAndUnit split_unit(const std::string& key) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kUnits = {{
      {"_m3", "m³"},
      {"_m", "m"},
      {"_deg", "°"},
      {"_px", "px"},
      {"_mib", "MiB"},
      {"_rad", "rad"},
      {"_mps2", "m/s²"},
      {"_hz", "Hz"},
      {"cpu_seconds", "s"},
      {"seconds", "s"},
      {"scale_error", "1"},
      {"_s", "s"},
  }};
  std::string name = key;
  std::string_view unit;
  for (const auto& [suffix, text] : kUnits) {
    if (!key.ends_with(suffix)) continue;
    unit = text;
    if (suffix.starts_with('_')) name.resize(name.size() - suffix.size());
    break;
  }
  for (char& c : name) {
    if (c == '_') c = ' ';
  }
  return {name, unit};
}

std::string value_text(const Json& value) {
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kMaxArrayText ? text : fmt::format("{} entries", value.size());
}

void append_rows(const Json& object, const std::string& prefix, std::string& rows) {
  for (const auto& [key, value] : object.items()) {
    const NameAndUnit label = split_unit(key);
    const std::string path = prefix.empty() ? label.name : prefix + " › " + label.name;
    if (value.is_object()) {
      append_rows(value, path, rows);
    } else {
      rows += fmt::format("<tr><td>{}</td><td class=v>{}</td><td>{}</td></tr>\n",
                          escaped(path),
                          escaped(value_text(value)),
                          value.is_null() ? "" : label.unit);
    }
  }
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string html_table(const Json& object) {
  std::string rows;
  append_rows(object, {}, rows);
  return "<table><tr><th>figure</th><th>value</th><th>unit</th></tr>\n" + rows + "</table>\n";
}

std::string html_head(std::string_view title) {
  return fmt::format(
      "<!doctype html><html lang=en><head><meta charset=utf-8><title>{0}</title><style>"
      "body{{font:15px/1.5 sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;color:#222}}"
      "table{{border-collapse:collapse;margin:.5rem 0 1.5rem}}td,th{{border:1px solid #ccc;"
      "padding:.15rem .6rem;text-align:left}}td.v{{text-align:right;"
      "font-variant-numeric:tabular-nums}}.green{{background:#cdeccd}}.amber{{background:#fbe7b5}}"
      ".red{{background:#f6c9c4}}svg{{background:#fafafa;border:1px solid #ccc}}"
      "</style></head><body><h1>{0}</h1>\n",
      escaped(title));
}

}  // namespace hybridfusion
