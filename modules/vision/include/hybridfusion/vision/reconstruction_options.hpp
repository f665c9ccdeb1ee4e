#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/vision/gnss_options.hpp>
#include <hybridfusion/vision/mapping_options.hpp>
#include <hybridfusion/vision/matching_options.hpp>
#include <hybridfusion/vision/rolling_shutter_options.hpp>

namespace hybridfusion {

struct ReconstructionOptions {
  FeatureOptions features = {};
  PairOptions pairs = {};
  MatchingOptions matching = {};
  IntrinsicsOptions intrinsics = {};
  MappingOptions mapping = {};
  GnssOptions gnss = {};
  AdjustmentOptions adjustment = {};
  RollingShutterOptions rolling_shutter = {};
};
template <>
struct OptionFields<ReconstructionOptions> {
  using T = ReconstructionOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::features, {.key = "features"}},
      Field{&T::pairs, {.key = "pairs"}},
      Field{&T::matching, {.key = "matching"}},
      Field{&T::intrinsics, {.key = "intrinsics"}},
      Field{&T::mapping, {.key = "mapping"}},
      Field{&T::gnss, {.key = "gnss"}},
      Field{&T::adjustment, {.key = "adjustment"}},
      Field{&T::rolling_shutter, {.key = "rolling_shutter"}},
  };
};

}  // namespace hybridfusion
