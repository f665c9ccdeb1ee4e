#pragma once

#include <optional>
#include <string_view>

namespace hybridfusion {

/// Simple properties of an XMP packet, written as attribute (`drone-dji:RtkFlag="50"`) or element
/// (`<drone-dji:RtkFlag>50</drone-dji:RtkFlag>`).
class Xmp {
 public:
  /// @param packet  Must outlive the object.
  explicit Xmp(std::string_view packet) : packet_(packet) {}

  /// Trimmed value of the qualified name; empty when absent.
  [[nodiscard]] std::string_view text(std::string_view name) const;
  /// The value as a finite number ("+349.58" included).
  [[nodiscard]] std::optional<double> number(std::string_view name) const;

 private:
  std::string_view packet_;
};

}  // namespace hybridfusion
