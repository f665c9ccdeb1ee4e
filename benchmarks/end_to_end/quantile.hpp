#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion::benchmark {

/// The value that `share` of the values do not exceed (nearest rank). @pre values is not empty
inline double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(at));
  return values[at];
}

/// "-" where there is nothing to take a quantile of.
inline std::string figure(const std::vector<double>& values, double share, int digits) {
  return values.empty() ? "-" : fmt::format("{:.{}f}", quantile(values, share), digits);
}

}  // namespace hybridfusion::benchmark
