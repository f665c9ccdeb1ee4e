#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// Reconstruction of photos while they arrive: what one photo may cost.
struct StreamingOptions {
  int max_pairs = 5;
  int max_waiting_photos = 4;
  double global_growth = 1.3;
  bool preview = true;
  int preview_size_px = 480;
  int preview_neighbors = 2;
  double preview_voxel_m = 0.0;
  int preview_points_per_photo = 20000;
  int preview_max_points = 1000000;
};

template <>
struct OptionFields<StreamingOptions> {
  using T = StreamingOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::max_pairs,
            {.key = "max_pairs",
             .unit = "photos",
             .min = 2,
             .max = 100,
             .doc = "Photos that a new one is matched with at once: those before and after it in "
                    "time and the nearest by position.",
             .source = "ours"}},
      Field{
          &T::max_waiting_photos,
          {.key = "max_waiting_photos",
           .unit = "photos",
           .min = 0,
           .max = 100,
           .doc = "Of the photos without a pose, so many are tried again with each new one: those "
                  "that see most points, if they see more than before.",
           .source = "ours"}},
      Field{&T::global_growth,
            {.key = "global_growth",
             .unit = "1",
             .min = 1.01,
             .max = 10,
             .doc = "All photos are adjusted and placed by GNSS anew each time their number grew "
                    "by this factor.",
             .source = "ours"}},
      Field{&T::preview, {.key = "preview", .doc = "Make the preview cloud.", .source = "ours"}},
      Field{&T::preview_size_px,
            {.key = "preview_size_px",
             .unit = "px",
             .min = 200,
             .max = 4000,
             .doc = "Photos are matched at this longest side for the preview cloud.",
             .source = "ours"}},
      Field{&T::preview_neighbors,
            {.key = "preview_neighbors",
             .unit = "photos",
             .min = 1,
             .max = 10,
             .doc = "Photos that a new one is matched with for the preview cloud.",
             .source = "HybridFusion III-A.2; value ours"}},
      Field{&T::preview_voxel_m,
            {.key = "preview_voxel_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "Spacing of the preview cloud; 0: twice what its pixels resolve on the ground.",
             .source = "ours"}},
      Field{&T::preview_points_per_photo,
            {.key = "preview_points_per_photo",
             .unit = "points",
             .min = 100,
             .max = 10000000,
             .doc = "A photo gives the preview cloud at most so many points.",
             .source = "ours"}},
      Field{&T::preview_max_points,
            {.key = "preview_max_points",
             .unit = "points",
             .min = 1000,
             .max = 100000000,
             .doc = "When the preview cloud has more points its spacing is doubled.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
