#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// Offline refinement of the whole trajectory after the last scan.
struct LidarRefineOptions {
  bool enabled = true;
  int iterations = 4;
  double segment_s = 0.5;
  double voxel_m = 0.5;
  double max_plane_sigma_m = 0.05;
  double max_plane_noise_ratio = 1.5;
};
template <>
struct OptionFields<LidarRefineOptions> {
  using T = LidarRefineOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Adjust all poses and planes together when the recording is over.",
             .source = "after Liu and Zhang 2021, BALM"}},
      Field{&T::iterations,
            {.key = "iterations",
             .unit = "1",
             .min = 1,
             .max = 50,
             .doc = "Gauss-Newton passes of the adjustment.",
             .source = "ours"}},
      Field{&T::segment_s,
            {.key = "segment_s",
             .unit = "s",
             .min = 0.05,
             .max = 10.0,
             .doc = "Scans of this duration move together.",
             .source = "ours"}},
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.2,
             .max = 10.0,
             .doc = "Side of the cells in which points may form one plane.",
             .source = "ours"}},
      Field{&T::max_plane_sigma_m,
            {.key = "max_plane_sigma_m",
             .unit = "m",
             .min = 0.005,
             .max = 1.0,
             .doc = "Cells whose points scatter more about their plane are not used.",
             .source = "ours"}},
      Field{&T::max_plane_noise_ratio,
            {.key = "max_plane_noise_ratio",
             .unit = "1",
             .min = 1.0,
             .max = 100.0,
             .doc = "Nor are those that scatter more than this times the range noise of the "
                    "sensor, which is found from the scans: they hold edges, leaves or a rough "
                    "surface, of which each visit samples another part.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
