#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

struct RollingShutterOptions {
  std::string correction = "auto";
  double readout_ms = 0.0;
};
template <>
struct OptionFields<RollingShutterOptions> {
  using T = RollingShutterOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::correction,
            {.key = "correction",
             .choices = "auto|off",
             .doc = "Whether pixels are moved to where a shutter that opens at once would show "
                    "them: where the camera moves by more than half a pixel on the ground during "
                    "the readout.",
             .source = "ours"}},
      Field{&T::readout_ms,
            {.key = "readout_ms",
             .unit = "ms",
             .min = 0,
             .max = 1000,
             .doc = "Time from the first to the last row of a photo; 0: by a table of cameras, "
                    "where those that are not in it count as reading all rows at once.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
