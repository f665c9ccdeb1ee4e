#pragma once

/// @file
/// YAML binding of option tables. Private: yaml-cpp is heavy, and no user of the library sees it.

#include <hybridfusion/core/options.hpp>

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace hybridfusion {

/// Overwrites the members of `options` that `node` names. An unknown key is an error with its line
/// number: a misspelt option must never fall back to its default in silence.
template <HasOptionFields Options>
[[nodiscard]] Expected<void> read_yaml(const YAML::Node& node,
                                       Options& options,
                                       const std::string& prefix = {}) {
  if (!node.IsMap()) {
    return fail(ErrorCode::kParse,
                fmt::format("line {}: expected a map at '{}'", node.Mark().line + 1, prefix));
  }
  std::vector<std::string> known;
  Expected<void> result;
  visit_fields(options, [&]<class Value>(const FieldInfo& info, Value& value) {
    known.emplace_back(info.key);
    const YAML::Node child = node[std::string(info.key)];
    if (!result || !child) return;
    const std::string key = detail::join_key(prefix, info.key);
    if constexpr (HasOptionFields<Value>) {
      result = read_yaml(child, value, key);
    } else {
      try {
        value = child.template as<Value>();
      } catch (const YAML::Exception&) {
        result = fail(ErrorCode::kParse,
                      fmt::format("line {}: '{}' is not a valid value for {}",
                                  child.Mark().line + 1,
                                  child.Scalar(),
                                  key));
      }
    }
  });
  if (!result) return result;
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    if (std::ranges::find(known, key) == known.end()) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("line {}: unknown option '{}{}{}'; known here: {}",
                              entry.first.Mark().line + 1,
                              prefix,
                              prefix.empty() ? "" : ".",
                              key,
                              fmt::join(known, ", ")));
    }
  }
  return {};
}

/// Appends `options` as nested YAML maps in table order: the effective configuration of a run.
template <HasOptionFields Options>
void write_yaml(YAML::Emitter& out, const Options& options) {
  out << YAML::BeginMap;
  visit_fields(options, [&]<class Value>(const FieldInfo& info, const Value& value) {
    out << YAML::Key << std::string(info.key) << YAML::Value;
    if constexpr (HasOptionFields<Value>) {
      write_yaml(out, value);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      out << value;
    } else {
      out << detail::to_text(value);
    }
  });
  out << YAML::EndMap;
}

}  // namespace hybridfusion
