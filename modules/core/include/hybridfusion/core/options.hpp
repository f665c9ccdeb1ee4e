#pragma once

/// @file
/// Options are plain aggregates with defaults. Beside each struct stands one table,
/// `option_fields`, that gives every member its key, unit, valid range, meaning and source. YAML
/// reading, YAML writing, validation, command line flags and the reference page are all walks over
/// that table; nothing else knows the names.

#include <hybridfusion/core/error.hpp>

#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace YAML {
class Node;
}

namespace hybridfusion {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

struct FieldInfo {
  std::string_view key = {};
  std::string_view unit = {};  ///< "m", "rad", "1" for ratios, "" for flags and names.
  double min = -kUnbounded;
  double max = kUnbounded;
  std::string_view choices = {};  ///< For names: the allowed values, "sgm|sgbm". Empty: any text.
  std::string_view doc = {};
  std::string_view source = {};  ///< "HybridFusion III-C.2, Eq. (4)", "ours", ...
};

template <class Options, class Value>
struct Field {
  Value Options::* member;
  FieldInfo info;
};
template <class Options, class Value>
Field(Value Options::*, FieldInfo) -> Field<Options, Value>;

/// Specialise with `static constexpr auto fields = std::tuple{Field{&T::x, {...}}, ...};`
template <class Options>
struct OptionFields;

namespace detail {
struct AnyValue {
  template <class T>
  constexpr operator T()
      const noexcept;  // NOLINT(google-explicit-constructor): probe type, never defined
};
template <class T, class... Probe>
consteval std::size_t aggregate_arity(Probe... probe) {
  if constexpr (requires { T{probe..., AnyValue{}}; }) {
    return aggregate_arity<T>(probe..., AnyValue{});
  } else {
    return sizeof...(Probe);
  }
}
}  // namespace detail

template <class T>
concept HasOptionFields = requires { OptionFields<T>::fields; };

/// Calls `visitor(info, options.*member)` for each field, in table order.
template <HasOptionFields Options, class Self, class Visitor>
void visit_fields_of(Self& options, Visitor&& visitor) {
  constexpr auto& kFields = OptionFields<Options>::fields;
  static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(kFields)>> ==
                    detail::aggregate_arity<Options>(),
                "every member of an options struct needs one entry in its OptionFields table");
  std::apply([&](const auto&... field) { (visitor(field.info, options.*field.member), ...); },
             kFields);
}
template <class Options, class Visitor>
void visit_fields(Options& options, Visitor&& visitor) {
  visit_fields_of<std::remove_const_t<Options>>(options, std::forward<Visitor>(visitor));
}

namespace detail {
[[nodiscard]] bool is_choice(std::string_view choices, std::string_view value);
[[nodiscard]] std::string to_text(double value);
[[nodiscard]] inline std::string to_text(bool value) {
  return value ? "true" : "false";
}
[[nodiscard]] inline std::string to_text(const std::string& value) {
  return value;
}
template <std::integral Integer>
[[nodiscard]] std::string to_text(Integer value) {
  return std::to_string(value);
}
/// Parses `text` into an option; false when it is not a value of that type.
[[nodiscard]] bool from_text(std::string_view text, double& value);
[[nodiscard]] bool from_text(std::string_view text, int& value);
[[nodiscard]] bool from_text(std::string_view text, bool& value);
[[nodiscard]] bool from_text(std::string_view text, std::string& value);

/// "0 .. 1", "a|b", or "" for an unbounded number.
[[nodiscard]] std::string range_text(const FieldInfo& info);

[[nodiscard]] inline std::string join_key(const std::string& prefix, std::string_view key) {
  return prefix.empty() ? std::string(key) : prefix + "." + std::string(key);
}
}  // namespace detail

/// First violated range, named by its full key ("registration.candidates.ring_ratio").
template <HasOptionFields Options>
[[nodiscard]] Expected<void> validate(const Options& options, const std::string& prefix = {}) {
  Expected<void> result;
  visit_fields(options, [&]<class Value>(const FieldInfo& info, const Value& value) {
    if (!result) return;
    const std::string key = detail::join_key(prefix, info.key);
    if constexpr (HasOptionFields<Value>) {
      result = validate(value, key);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      const auto number = static_cast<double>(value);
      if (!(number >= info.min && number <= info.max)) {
        result = fail(ErrorCode::kInvalidOptions,
                      key + " = " + detail::to_text(value) + " is outside [" +
                          detail::to_text(info.min) + ", " + detail::to_text(info.max) + "] " +
                          std::string(info.unit));
      }
    } else if (!detail::is_choice(info.choices, value)) {
      result = fail(ErrorCode::kInvalidOptions,
                    key + " = '" + value + "' is not one of " + std::string(info.choices));
    }
  });
  return result;
}

/// Markdown reference table, one row per leaf option.
template <HasOptionFields Options>
void append_reference(std::string& markdown,
                      const Options& defaults,
                      const std::string& prefix = {}) {
  visit_fields(defaults, [&]<class Value>(const FieldInfo& info, const Value& value) {
    const std::string key = detail::join_key(prefix, info.key);
    if constexpr (HasOptionFields<Value>) {
      append_reference(markdown, value, key);
    } else {
      markdown += "| `" + key + "` | " + detail::to_text(value) + " | " + std::string(info.unit) +
                  " | " + detail::range_text(info) + " | " + std::string(info.doc) + " | " +
                  std::string(info.source) + " |\n";
    }
  });
}

/// Sets one leaf from text: `set_option(options, "candidates.ring_ratio", "0.3")`.
/// @returns kInvalidOptions for an unknown key (naming the known ones) or a value of another type.
template <HasOptionFields Options>
[[nodiscard]] Expected<void> set_option(Options& options,
                                        std::string_view key,
                                        std::string_view value,
                                        const std::string& prefix = {}) {
  const std::string_view head = key.substr(0, key.find('.'));
  const std::string_view tail = head.size() < key.size() ? key.substr(head.size() + 1) : "";
  Expected<void> result = fail(ErrorCode::kInvalidOptions, {});
  bool found = false;
  std::string known;
  visit_fields(options, [&]<class Value>(const FieldInfo& info, Value& member) {
    known += (known.empty() ? "" : ", ") + std::string(info.key);
    if (info.key != head) return;
    found = true;
    const std::string full = detail::join_key(prefix, info.key);
    if constexpr (HasOptionFields<Value>) {
      result = set_option(member, tail, value, full);
    } else if (tail.empty() && detail::from_text(value, member)) {
      result = {};
    } else {
      result = fail(ErrorCode::kInvalidOptions,
                    "'" + std::string(value) + "' is not a valid value for " + full);
    }
  });
  if (!found) {
    result = fail(ErrorCode::kInvalidOptions,
                  "unknown option '" + detail::join_key(prefix, head) + "'; known here: " + known);
  }
  return result;
}

}  // namespace hybridfusion
