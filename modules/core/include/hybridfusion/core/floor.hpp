#pragma once

namespace hybridfusion {

// std::floor is a call into the library on processors without SSE 4.1; these are not.

/// Largest whole number that is not above `value`. @pre |value| < 2^31
template <class Real>
[[nodiscard]] inline int floor_to_int(Real value) {
  const int whole = static_cast<int>(value);
  return static_cast<Real>(whole) > value ? whole - 1 : whole;
}

/// The same as a float, without a branch. @pre |value| < 2^31
[[nodiscard]] inline float floor_of(float value) {
  const auto truncated = static_cast<float>(static_cast<int>(value));
  return truncated - static_cast<float>(truncated > value);
}

}  // namespace hybridfusion
