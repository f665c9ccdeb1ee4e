#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

struct GnssOptions {
  std::string form = "absolute";
  double default_sigma_m = 3.0;
  double min_sigma_vertical_m = 5.0;
  double sigma_per_dop_m = 3.0;
  double min_sigma_rtk_m = 0.02;
  double max_jump_m = 50.0;
  double loss_width = 3.0;
  double antenna_right_m = 0.0;
  double antenna_down_m = 0.0;
  double antenna_forward_m = 0.0;
};
template <>
struct OptionFields<GnssOptions> {
  using T = GnssOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::form,
          {.key = "form",
           .choices = "absolute|displacement",
           .doc = "GNSS error: position of each photo (ours), or displacement between frames that "
                  "follow each other in time (the paper's).",
           .source = "HybridFusion Eq. (3)"}},
      Field{&T::default_sigma_m,
            {.key = "default_sigma_m",
             .unit = "m",
             .min = 0.001,
             .max = 1000,
             .doc = "Horizontal standard deviation of a fix that states none.",
             .source = "ours"}},
      Field{&T::min_sigma_vertical_m,
            {.key = "min_sigma_vertical_m",
             .unit = "m",
             .min = 0.001,
             .max = 1000,
             .doc = "Vertical standard deviation of a fix without RTK is twice the horizontal, at "
                    "least this.",
             .source = "ours"}},
      Field{&T::sigma_per_dop_m,
            {.key = "sigma_per_dop_m",
             .unit = "m",
             .min = 0.001,
             .max = 100,
             .doc = "Horizontal standard deviation per unit of GPSDOP.",
             .source = "ours"}},
      Field{&T::min_sigma_rtk_m,
            {.key = "min_sigma_rtk_m",
             .unit = "m",
             .min = 0.0001,
             .max = 10,
             .doc = "Floor of the stated RTK deviations: shutter lag and antenna lever arm.",
             .source = "ours"}},
      Field{&T::max_jump_m,
            {.key = "max_jump_m",
             .unit = "m",
             .min = 1,
             .max = 1e6,
             .doc = "A fix farther than this (and 5 deviations) from its neighbours in time is "
                    "rejected.",
             .source = "ours"}},
      Field{&T::loss_width,
            {.key = "loss_width",
             .unit = "sigma",
             .min = 0.1,
             .max = 1e6,
             .doc = "Width of the Cauchy loss of a GNSS residual.",
             .source = "ours"}},
      Field{&T::antenna_right_m,
            {.key = "antenna_right_m",
             .unit = "m",
             .min = -100,
             .max = 100,
             .doc = "Place of the GNSS antenna in the camera frame, to the right of the photo.",
             .source = "ours"}},
      Field{&T::antenna_down_m,
            {.key = "antenna_down_m",
             .unit = "m",
             .min = -100,
             .max = 100,
             .doc = "The same, towards the lower edge of the photo.",
             .source = "ours"}},
      Field{&T::antenna_forward_m,
            {.key = "antenna_forward_m",
             .unit = "m",
             .min = -100,
             .max = 100,
             .doc = "The same, along the viewing direction: a camera that looks down under its "
                    "antenna has a negative one.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
