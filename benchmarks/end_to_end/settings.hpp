#pragma once

#include <hybridfusion/core/options.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace hybridfusion::benchmark {

/// Sets each "key=value" of `settings`. @returns the error of the first that cannot be set.
template <class Options>
Expected<void> apply_settings(const std::vector<std::string>& settings, Options& options) {
  for (const std::string& setting : settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string value = setting.substr(std::min(equals + 1, setting.size()));
    if (auto set = set_option(options, setting.substr(0, equals), value); !set) return set;
  }
  return {};
}

}  // namespace hybridfusion::benchmark
