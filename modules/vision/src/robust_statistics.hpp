#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace hybridfusion {

/// Upper median. @pre not empty
[[nodiscard]] inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The value that a share of the others lies below. @pre not empty, 0 <= share < 1
[[nodiscard]] inline double upper_quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Standard deviation of a normal distribution with the same median absolute deviation.
[[nodiscard]] inline double robust_sigma(std::vector<double> values) {
  const double centre = median(values);
  for (double& value : values) value = std::abs(value - centre);
  return 1.4826 * median(std::move(values));
}

/// As robust_sigma about zero: for residuals.
[[nodiscard]] inline double robust_sigma_about_zero(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return 1.4826 * median(std::move(values));
}

}  // namespace hybridfusion
