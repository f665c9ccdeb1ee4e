#include "html.hpp"

#include <array>
#include <cmath>
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
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kMaxArrayText ? text : fmt::format("{} entries", value.size());
}

/// A key as part of a JSON pointer (RFC 6901).
std::string pointer_part(const std::string& key) {
  std::string part;
  for (const char c : key) {
    part += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return part;
}

std::string value_html(const Json& value, const std::string& source) {
  if (value.is_number_float()) return traced(value.get<double>(), "{:.6g}", source);
  if (value.is_number()) return traced(value.get<double>(), "{:.0f}", source);
  return fmt::format("<data title='{}'>{}</data>", escaped(source), escaped(value_text(value)));
}

void append_rows(const Json& object,
                 const std::string& prefix,
                 const std::string& source,
                 std::string& rows) {
  for (const auto& [key, value] : object.items()) {
    const NameAndUnit label = split_unit(key);
    const std::string path = prefix.empty() ? label.name : prefix + " › " + label.name;
    const std::string member = source + "/" + pointer_part(key);
    if (value.is_object()) {
      append_rows(value, path, member, rows);
    } else {
      rows += fmt::format("<tr><td>{}</td><td class=v>{}</td><td>{}</td></tr>\n",
                          escaped(path),
                          value_html(value, member),
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

std::string traced(double value, std::string_view format, std::string_view formula) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("<data value='{}' title='{}'>{}</data>",
                     value,
                     escaped(formula),
                     fmt::vformat(format, fmt::make_format_args(value)));
}

std::string html_table(const Json& object, const std::string& source) {
  std::string rows;
  append_rows(object, {}, source, rows);
  return "<table><tr><th>figure</th><th>value</th><th>unit</th></tr>\n" + rows + "</table>\n";
}

std::string html_head(std::string_view title) {
  constexpr std::string_view kStyle = R"css(
body{font:15px/1.5 system-ui,"DejaVu Sans",sans-serif;max-width:60rem;margin:0 auto;padding:1.5rem 1.2rem 3rem;color:#1f2328;background:#fff}
h1{font-size:1.5rem;margin:0 0 1rem;overflow-wrap:anywhere}h2{font-size:1.25rem;margin:2.2rem 0 .6rem;padding-bottom:.25rem;border-bottom:2px solid #d8dee4}
h3{font-size:1rem;margin:0 0 .5rem}h4{font-size:.92rem;margin:.9rem 0 .2rem}p.sub{margin:.3rem 0 0;font-size:.85rem;color:#57606a}
figure{margin:0 0 1.6rem;padding:1rem;border:1px solid #d8dee4;border-radius:8px;overflow-x:auto;break-inside:avoid}
figcaption{margin-top:.6rem;font-size:.87rem;color:#3d444d;max-width:46rem}.src{color:#6e7781;font-size:.8rem}code{font-size:.95em}
table{border-collapse:collapse;margin:.2rem 0 .6rem;font-size:.9rem}td,th{border:1px solid #d8dee4;padding:.15rem .6rem;text-align:left}
th{background:#f6f8fa;font-weight:600}td.v{text-align:right;font-variant-numeric:tabular-nums}td.quiet{color:#6e7781}tr.sum td{font-weight:600}
td.green{background:#cdeccd}td.amber{background:#fbe7b5}td.red{background:#f6c9c4}
.verdict{display:flex;gap:.9rem;align-items:center;padding:.7rem 1rem;border-radius:8px;margin:0 0 1rem}.verdict b{font-size:1.15rem;letter-spacing:.04em}
.verdict.green{background:#cdeccd}.verdict.amber{background:#fbe7b5}.verdict.red{background:#f6c9c4}
nav{margin:.4rem 0 0}nav a{display:inline-block;margin-right:1rem;color:#0969da;text-decoration:none}
svg{display:block;max-width:100%;height:auto;margin:.3rem 0}svg text{font:11px "DejaVu Sans",sans-serif;fill:#3d444d}svg text.t{font-size:12px;fill:#1f2328}
svg .g{stroke:#e3e7eb}svg.map{background:#f4f5f7;border-radius:4px}img.wide{display:block;width:100%;border-radius:4px}
.ramp{display:flex;align-items:center;font-size:.82rem;margin:.3rem 0}.ramp i{width:12px;height:11px}.ramp span{margin:0 .5rem}.ramp span:first-child{margin-left:0}
.keys{font-size:.85rem;margin:.3rem 0}.keys span{margin-right:.9rem;white-space:nowrap}.keys i{display:inline-block;width:11px;height:11px;border-radius:2px;margin-right:.35rem}
data{cursor:help}details{margin:.4rem 0}summary{cursor:pointer;color:#0969da}footer{margin-top:2rem;color:#6e7781;font-size:.82rem}
@media print{details{display:none}nav{display:none}}
)css";
  return fmt::format(
      "<!doctype html><html lang=en><head><meta charset=utf-8><meta name=viewport "
      "content='width=device-width'><title>{0}</title><style>{1}</style></head><body><h1>{0}</"
      "h1>\n",
      escaped(title),
      kStyle);
}

}  // namespace hybridfusion
