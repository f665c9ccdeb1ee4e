#include "xmp.hpp"

#include "text.hpp"

#include <cmath>

namespace hybridfusion {
namespace {

/// What `rest`, which follows the property's name, gives as its value; nothing when the name goes
/// on or is a closing tag.
[[nodiscard]] std::optional<std::string_view> value_after_name(std::string_view rest) {
  const std::string_view after = trimmed(rest.substr(0, 256));
  if (after.starts_with('=')) {
    const std::size_t open = rest.find_first_of("\"'");
    if (open == std::string_view::npos) return std::nullopt;
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == std::string_view::npos) return std::nullopt;
    return rest.substr(open + 1, close - open - 1);
  }
  if (rest.starts_with('>')) return rest.substr(1, rest.substr(1).find('<'));
  return std::nullopt;
}

}  // namespace

std::string_view Xmp::text(std::string_view name) const {
  for (std::size_t at = packet_.find(name); at != std::string_view::npos;
       at = packet_.find(name, at + 1)) {
    const char before = at == 0 ? ' ' : packet_[at - 1];
    const bool starts_here =
        before == ' ' || before == '<' || before == '\n' || before == '\t' || before == '\r';
    if (!starts_here) continue;
    if (const auto value = value_after_name(packet_.substr(at + name.size())))
      return trimmed(*value);
  }
  return {};
}

std::optional<double> Xmp::number(std::string_view name) const {
  const auto value = parse_number<double>(text(name));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace hybridfusion
