#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// A group within a group, for the tests of everything that walks an option table.
struct InnerOptions {
  double ring_ratio = 0.2;
  int min_points = 500;
};
template <>
struct OptionFields<InnerOptions> {
  using T = InnerOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::ring_ratio, {.key = "ring_ratio", .unit = "1", .min = 0.0, .max = 1.0, .doc = "d"}},
      Field{&T::min_points, {.key = "min_points", .unit = "points", .min = 1.0, .doc = "d"}},
  };
};

struct OuterOptions {
  InnerOptions inner = {};
  std::string method = "sgm";
  bool refine = true;
};
template <>
struct OptionFields<OuterOptions> {
  using T = OuterOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::inner, {.key = "inner"}},
      Field{&T::method, {.key = "method", .choices = "sgm|fast", .doc = "d"}},
      Field{&T::refine, {.key = "refine", .doc = "d"}},
  };
};

}  // namespace hybridfusion
