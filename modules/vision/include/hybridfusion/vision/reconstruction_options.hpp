#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

struct FeatureOptions {
  int max_size_px = 1600;
  int min_keypoints = 4000;
  int max_keypoints = 8000;
  double contrast = 0.02;
  double min_contrast = 0.005;
  double edge_ratio = 10.0;
};
template <>
struct OptionFields<FeatureOptions> {
  using T = FeatureOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::max_size_px,
            {.key = "max_size_px",
             .unit = "px",
             .min = 200,
             .max = 20000,
             .doc = "Photos are reduced to this longest side before features are detected.",
             .source = "ours"}},
      Field{&T::min_keypoints,
            {.key = "min_keypoints",
             .unit = "1",
             .min = 50,
             .max = 100000,
             .doc = "The contrast threshold is halved until a photo has this many keypoints.",
             .source = "ours"}},
      Field{&T::max_keypoints,
            {.key = "max_keypoints",
             .unit = "1",
             .min = 100,
             .max = 100000,
             .doc = "Keypoints kept per photo, strongest first in each cell of an 8 x 8 grid.",
             .source = "ours"}},
      Field{&T::contrast,
            {.key = "contrast",
             .unit = "1",
             .min = 0.001,
             .max = 0.2,
             .doc = "First contrast threshold of the SIFT detector.",
             .source = "Lowe 2004"}},
      Field{&T::min_contrast,
            {.key = "min_contrast",
             .unit = "1",
             .min = 0.0005,
             .max = 0.2,
             .doc = "The contrast threshold is not lowered below this.",
             .source = "ours"}},
      Field{&T::edge_ratio,
            {.key = "edge_ratio",
             .unit = "1",
             .min = 2,
             .max = 100,
             .doc = "Largest ratio of principal curvatures of a keypoint.",
             .source = "Lowe 2004"}},
  };
};

struct PairOptions {
  int spatial_neighbors = 8;
  int temporal_neighbors = 3;
  int exhaustive_photos = 12;
};
template <>
struct OptionFields<PairOptions> {
  using T = PairOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::spatial_neighbors,
          {.key = "spatial_neighbors",
           .unit = "photos",
           .min = 1,
           .max = 200,
           .doc = "Each photo is matched with this many nearest ones (by GNSS, and by the point on "
                  "the ground where the gimbal looks).",
           .source = "ours"}},
      Field{&T::temporal_neighbors,
            {.key = "temporal_neighbors",
             .unit = "photos",
             .min = 0,
             .max = 100,
             .doc = "Each photo is matched with this many next ones in time.",
             .source = "HybridFusion III-A.2, adjacent frames"}},
      Field{&T::exhaustive_photos,
            {.key = "exhaustive_photos",
             .unit = "photos",
             .min = 2,
             .max = 500,
             .doc = "Up to this many photos, every pair is matched.",
             .source = "ours"}},
  };
};

struct MatchingOptions {
  double ratio = 0.8;
  double max_error_px = 2.0;
  int min_inliers = 20;
  double min_inlier_ratio = 0.15;
  int max_iterations = 1000;
};
template <>
struct OptionFields<MatchingOptions> {
  using T = MatchingOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::ratio,
            {.key = "ratio",
             .unit = "1",
             .min = 0.1,
             .max = 1.0,
             .doc = "Largest ratio of the nearest to the second nearest descriptor distance.",
             .source = "Lowe 2004"}},
      Field{&T::max_error_px,
            {.key = "max_error_px",
             .unit = "px",
             .min = 0.1,
             .max = 50,
             .doc = "Epipolar (Sampson) error of an inlier, in pixels of the reduced photo.",
             .source = "ours"}},
      Field{&T::min_inliers,
            {.key = "min_inliers",
             .unit = "matches",
             .min = 6,
             .max = 10000,
             .doc = "A pair with fewer inliers is dropped.",
             .source = "ours"}},
      Field{&T::min_inlier_ratio,
            {.key = "min_inlier_ratio",
             .unit = "1",
             .min = 0,
             .max = 1,
             .doc = "A pair with a smaller share of inliers is dropped.",
             .source = "ours"}},
      Field{&T::max_iterations,
            {.key = "max_iterations",
             .unit = "1",
             .min = 10,
             .max = 1000000,
             .doc = "Upper bound of RANSAC samples a pair.",
             .source = "ours"}},
  };
};

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

struct GnssOptions {
  std::string form = "absolute";
  double default_sigma_m = 3.0;
  double min_sigma_vertical_m = 5.0;
  double sigma_per_dop_m = 3.0;
  double min_sigma_rtk_m = 0.02;
  double max_jump_m = 50.0;
  double loss_width = 3.0;
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

struct ReconstructionOptions {
  FeatureOptions features = {};
  PairOptions pairs = {};
  MatchingOptions matching = {};
  IntrinsicsOptions intrinsics = {};
  MappingOptions mapping = {};
  GnssOptions gnss = {};
  AdjustmentOptions adjustment = {};
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
  };
};

}  // namespace hybridfusion
