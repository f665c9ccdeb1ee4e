#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

struct IntrinsicsOptions {
  double focal_px = 0.0;
  double focal_sigma_factory = 0.01;
  double focal_sigma_exif = 0.02;
  double focal_sigma_guess = 0.15;
  double radial_sigma = 0.3;
  double tangential_sigma = 0.005;
  double principal_point_sigma = 0.005;
  int principal_point_min_views = 10;
  bool probe_lens = true;
};
template <>
struct OptionFields<IntrinsicsOptions> {
  using T = IntrinsicsOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::focal_px,
          {.key = "focal_px",
           .unit = "px",
           .min = 0,
           .max = 1e6,
           .doc = "Focal length of all photos, in pixels of the photo as stored; 0: from EXIF/XMP.",
           .source = "ours"}},
      Field{&T::focal_sigma_factory,
            {.key = "focal_sigma_factory",
             .unit = "1",
             .min = 1e-5,
             .max = 1,
             .doc = "Relative standard deviation of a focal length from the factory calibration.",
             .source = "ours"}},
      Field{
          &T::focal_sigma_exif,
          {.key = "focal_sigma_exif",
           .unit = "1",
           .min = 1e-5,
           .max = 1,
           .doc = "Relative standard deviation of a focal length that metadata or the user states.",
           .source = "ours"}},
      Field{&T::focal_sigma_guess,
            {.key = "focal_sigma_guess",
             .unit = "1",
             .min = 1e-5,
             .max = 1,
             .doc = "Relative standard deviation of a guessed focal length.",
             .source = "ours"}},
      Field{&T::radial_sigma,
            {.key = "radial_sigma",
             .unit = "1",
             .min = 1e-6,
             .max = 10,
             .doc = "Standard deviation of k1 about the probed value and of k2 about 0 (k3: half).",
             .source = "ours"}},
      Field{&T::tangential_sigma,
            {.key = "tangential_sigma",
             .unit = "1",
             .min = 1e-7,
             .max = 1,
             .doc = "Standard deviation of p1 and p2 about 0.",
             .source = "ours"}},
      Field{
          &T::principal_point_sigma,
          {.key = "principal_point_sigma",
           .unit = "1",
           .min = 1e-6,
           .max = 0.2,
           .doc = "Standard deviation of the principal point about the image centre, as a share of "
                  "the longest side.",
           .source = "ours"}},
      Field{&T::principal_point_min_views,
            {.key = "principal_point_min_views",
             .unit = "photos",
             .min = 2,
             .max = 100000,
             .doc = "The principal point, k3, p1 and p2 are estimated from this many photos on.",
             .source = "ours"}},
      Field{&T::probe_lens,
            {.key = "probe_lens",
             .unit = "",
             .doc = "Search k1 (and a guessed focal length) by counting epipolar inliers first.",
             .source = "ours"}},
  };
};

struct MappingOptions {
  double max_error_px = 4.0;
  double min_angle_deg = 1.5;
  int min_resection_inliers = 20;
  double global_growth = 1.15;
  int min_model_photos = 3;
};
template <>
struct OptionFields<MappingOptions> {
  using T = MappingOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::max_error_px,
            {.key = "max_error_px",
             .unit = "px",
             .min = 0.1,
             .max = 50,
             .doc = "Largest reprojection error of an observation, in pixels of the reduced photo.",
             .source = "ours"}},
      Field{&T::min_angle_deg,
            {.key = "min_angle_deg",
             .unit = "deg",
             .min = 0.05,
             .max = 45,
             .doc = "Smallest angle between two rays of a triangulated point.",
             .source = "ours"}},
      Field{&T::min_resection_inliers,
            {.key = "min_resection_inliers",
             .unit = "points",
             .min = 6,
             .max = 10000,
             .doc = "A photo is registered only with this many model points in agreement.",
             .source = "ours"}},
      Field{&T::global_growth,
            {.key = "global_growth",
             .unit = "1",
             .min = 1.01,
             .max = 10,
             .doc = "All photos are adjusted each time their number grew by this factor.",
             .source = "ours"}},
      Field{&T::min_model_photos,
            {.key = "min_model_photos",
             .unit = "photos",
             .min = 2,
             .max = 1000,
             .doc = "A fragment with fewer photos is dropped.",
             .source = "ours"}},
  };
};

struct AdjustmentOptions {
  double sigma_px = 0.5;
  double loss_width_px = 1.5;
  int max_iterations = 50;
  int rounds = 3;
};
template <>
struct OptionFields<AdjustmentOptions> {
  using T = AdjustmentOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::sigma_px,
          {.key = "sigma_px",
           .unit = "px",
           .min = 0.01,
           .max = 100,
           .doc = "Least standard deviation of an image coordinate against GNSS and priors, in "
                  "pixels of the reduced photo; larger residuals raise it. Covers the errors that "
                  "neighbouring points share.",
           .source = "ours"}},
      Field{
          &T::loss_width_px,
          {.key = "loss_width_px",
           .unit = "px",
           .min = 0.05,
           .max = 100,
           .doc = "Width of the soft L1 loss of a reprojection residual, in pixels of the reduced "
                  "photo.",
           .source = "HybridFusion Eq. (1)-(2); loss ours"}},
      Field{&T::max_iterations,
            {.key = "max_iterations",
             .unit = "1",
             .min = 1,
             .max = 1000,
             .doc = "Iterations of one bundle adjustment.",
             .source = "ours"}},
      Field{&T::rounds,
            {.key = "rounds",
             .unit = "1",
             .min = 1,
             .max = 10,
             .doc = "Final adjustments, each after filtering and triangulating again.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
