#include "stereo_depth.hpp"

#include "sky_fringe.hpp"
#include "stereo_matcher.hpp"

#include <hybridfusion/core/floor.hpp>

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxOverlapping = 10;
constexpr double kMaxDisparities = 512.0;

struct Pair {
  PosedCamera first;
  PosedCamera second;
};

PosedCamera posed(const Reconstruction& reconstruction,
                  std::uint32_t view,
                  const WorkImage& image) {
  return {.intrinsics = image.intrinsics,
          .enu_from_camera = *reconstruction.views[view].enu_from_camera};
}

/// Depth range along the rectified axis: what the shared points span, and a margin for what lies
/// between and beyond them.
Expected<RectificationRequest> request_for(const Reconstruction& reconstruction,
                                           const StereoPartner& partner,
                                           const Pair& pair) {
  std::vector<double> depths;
  for (const std::uint32_t point : partner.shared_points) {
    const double z =
        rectified_depth_m(pair.first, pair.second, reconstruction.points[point].point_in_enu);
    if (z > 0.0) depths.push_back(z);
  }
  if (depths.size() < 10) return fail(ErrorCode::kInsufficient, "too few shared points in front");
  std::ranges::sort(depths);
  const double low = depths[depths.size() / 100];
  const double high = depths[depths.size() - 1 - depths.size() / 100];
  constexpr double kMargin = 0.15;
  const double focal_px = pair.first.intrinsics.focal_px;
  const double far_m = high * (1.0 + kMargin);
  // Something very near would multiply the candidates of every pixel: it is given up instead.
  const double focal_times_baseline =
      focal_px *
      (pair.second.enu_from_camera.translation - pair.first.enu_from_camera.translation).norm();
  const double nearest_m = focal_times_baseline / (focal_times_baseline / far_m + kMaxDisparities);
  return RectificationRequest{
      .focal_px = focal_px, .near_m = std::max(low / (1.0 + kMargin), nearest_m), .far_m = far_m};
}

/// Median distance of corresponding features from one row: a wrong camera model shows here first.
double vertical_parallax_px(const Reconstruction& reconstruction,
                            std::uint32_t reference,
                            const StereoPartner& partner,
                            const RectifiedGeometry& geometry) {
  const auto row = [&](std::uint32_t view, std::uint32_t point) -> std::optional<double> {
    const View& v = reconstruction.views[view];
    for (const ViewObservation& seen : reconstruction.points[point].track) {
      if (seen.view != view) continue;
      const Eigen::Vector2d pixel = v.observations[seen.observation].pixel.cast<double>();
      const Eigen::Vector3d ray = unproject(reconstruction.cameras[v.camera], pixel).homogeneous();
      const Eigen::Vector3d turned =
          geometry.enu_from_rectified.conjugate() * (v.enu_from_camera->rotation * ray);
      if (turned.z() > 0.0) return geometry.left.focal_px * turned.y() / turned.z();
    }
    return std::nullopt;
  };
  std::vector<double> gaps;
  for (const std::uint32_t point : partner.shared_points) {
    const auto a = row(reference, point);
    const auto b = row(partner.view, point);
    if (a && b) gaps.push_back(std::abs(*a - *b));
  }
  if (gaps.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::ranges::nth_element(gaps, middle);
  return *middle;
}

ImagePlane<std::uint8_t> plane_of(const cv::Mat& grey) {
  ImagePlane<std::uint8_t> plane(grey.cols, grey.rows);
  for (int y = 0; y < grey.rows; ++y)
    std::copy_n(grey.ptr<std::uint8_t>(y), grey.cols, plane.row(y));
  return plane;
}

RectifiedImages rectified_images(const Pair& pair,
                                 const WorkImage& first,
                                 const WorkImage& second,
                                 const RectifiedGeometry& geometry) {
  const auto map = [&](const PosedCamera& camera, const PinholeGrid& grid) {
    return warp_map(camera.intrinsics,
                    grid,
                    camera.enu_from_camera.rotation.conjugate() * geometry.enu_from_rectified);
  };
  const WarpMap left = map(pair.first, geometry.left);
  const WarpMap right = map(pair.second, geometry.right);
  return {.left = plane_of(resample(first.grey, left)),
          .right = plane_of(resample(second.grey, right)),
          .left_mask = plane_of(left.mask),
          .right_mask = plane_of(right.mask),
          .num_disparities = geometry.num_disparities};
}

/// Disparity between pixels of one surface; NaN elsewhere.
float sample(const ImagePlane<float>& disparity, double u, double v) {
  constexpr float kSameSurfacePx = 1.0F;
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  if (!(u >= 0.0 && v >= 0.0 && u < disparity.width && v < disparity.height)) return kNothing;
  const int x = floor_to_int(u);
  const int y = floor_to_int(v);
  if (!disparity.contains(x + 1, y + 1)) return kNothing;
  const float a = disparity.at(x, y);
  const float b = disparity.at(x + 1, y);
  const float c = disparity.at(x, y + 1);
  const float d = disparity.at(x + 1, y + 1);
  const auto [low, high] = std::minmax({a, b, c, d});
  if (!(high - low <= kSameSurfacePx) || std::isnan(a + b + c + d)) return kNothing;
  const auto s = static_cast<float>(u - x);
  const auto t = static_cast<float>(v - y);
  return (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * c + s * d);
}

/// Depths that one partner gave, on the reference photo's grid; NaN where it gave none.
struct PairDepths {
  ImagePlane<float> depth_m;
  ImagePlane<float> sigma_m;
};

/// Moves the disparities of a pair onto the reference photo's grid.
PairDepths pair_depths(const DepthMap& map,
                       const RectifiedGeometry& geometry,
                       const ImagePlane<float>& disparity) {
  const int width = map.grid.width_px;
  const int height = map.grid.height_px;
  PairDepths result{.depth_m = {width, height, std::numeric_limits<float>::quiet_NaN()},
                    .sigma_m = {width, height}};
  const Eigen::Matrix3d rectified_from_camera =
      (geometry.enu_from_rectified.conjugate() * map.enu_from_camera.rotation).toRotationMatrix();
  const Eigen::Vector3d column_step = rectified_from_camera.col(0) / map.grid.focal_px;
  for (int y = 0; y < height; ++y) {
    const Eigen::Vector3d row_begin = rectified_from_camera * ray_of(map.grid, {0, y});
    for (int x = 0; x < width; ++x) {
      const Eigen::Vector3d ray = row_begin + x * column_step;
      if (!(ray.z() > 0.0)) continue;
      const Eigen::Vector2d pixel = pixel_of(geometry.left, ray);
      const float k = sample(disparity, pixel.x(), pixel.y());
      if (std::isnan(k)) continue;
      const double z = geometry.depth_m(k);  // along the rectified axis
      // sigma_z = z^2 / (f B) sigma_d; both scale by 1 / ray.z() to the photo's own axis.
      const double sigma =
          z * z / (geometry.left.focal_px * geometry.baseline_m) * map.disparity_sigma_px;
      result.depth_m.at(x, y) = static_cast<float>(z / ray.z());
      result.sigma_m.at(x, y) = static_cast<float>(sigma / ray.z());
    }
  }
  return result;
}

/// Inverse-variance mean of what the partners agree on, pixel by pixel.
void merge_pairs(const std::vector<PairDepths>& pairs, DepthMap& map) {
  std::vector<DepthGuess> guesses;
  for (std::size_t i = 0; i < map.depth_m.values.size(); ++i) {
    guesses.clear();
    for (const PairDepths& pair : pairs) {
      if (std::isnan(pair.depth_m.values[i])) continue;
      guesses.push_back({pair.depth_m.values[i], pair.sigma_m.values[i]});
    }
    if (guesses.empty()) continue;
    const DepthGuess merged = merge_guesses(guesses);
    map.depth_m.values[i] = static_cast<float>(merged.depth_m);
    map.sigma_m.values[i] = static_cast<float>(merged.sigma_m);
    map.num_pairs.values[i] = static_cast<std::uint8_t>(merged.count);
  }
}

DepthMap empty_map(const Reconstruction& reconstruction,
                   std::uint32_t reference,
                   const WorkImage& image) {
  DepthMap map;
  map.view = reference;
  map.grid = undistorted_grid(image.intrinsics);
  map.enu_from_camera = *reconstruction.views[reference].enu_from_camera;
  map.overlapping = overlapping_views(reconstruction, reference, kMaxOverlapping);
  map.depth_m = {map.grid.width_px, map.grid.height_px, std::numeric_limits<float>::quiet_NaN()};
  map.sigma_m = {map.grid.width_px, map.grid.height_px, 0.0F};
  map.num_pairs = {map.grid.width_px, map.grid.height_px, 0};
  map.rgb = {map.grid.width_px, map.grid.height_px};
  const WarpMap from_photo = warp_map(image.intrinsics, map.grid, Eigen::Quaterniond::Identity());
  const cv::Mat undistorted = resample(image.rgb, from_photo);
  map.mask = plane_of(from_photo.mask);
  for (int y = 0; y < map.grid.height_px; ++y) {
    const auto* row = undistorted.ptr<cv::Vec3b>(y);
    for (int x = 0; x < map.grid.width_px; ++x)
      map.rgb.at(x, y) = {row[x][0], row[x][1], row[x][2]};
  }
  map.grey = grey_plane(map.rgb);
  return map;
}

/// Depths of the reference photo from one partner. @returns why there are none.
Expected<PairDepths> match_partner(const Reconstruction& reconstruction,
                                   const DepthMap& map,
                                   const StereoPartner& partner,
                                   const WorkImage& first,
                                   const WorkImage& second,
                                   const StereoOptions& options,
                                   DeviceMatcher* device) {
  const Pair pair{.first = posed(reconstruction, map.view, first),
                  .second = posed(reconstruction, partner.view, second)};
  HF_TRY(const RectificationRequest request, request_for(reconstruction, partner, pair));
  HF_TRY(const RectifiedGeometry geometry, rectify(pair.first, pair.second, request));
  const double parallax = vertical_parallax_px(reconstruction, map.view, partner, geometry);
  if (!(parallax <= options.max_vertical_parallax_px)) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("rows do not correspond: median vertical parallax {:.2f} px, more than "
                            "stereo.max_vertical_parallax_px = {:.2f}",
                            parallax,
                            options.max_vertical_parallax_px));
  }
  HF_TRY(const ImagePlane<float> disparity,
         match_pair(rectified_images(pair, first, second, geometry), options, device));
  return pair_depths(map, geometry, disparity);
}

}  // namespace

StereoDepthResult stereo_depth(const Reconstruction& reconstruction,
                               std::uint32_t reference,
                               WorkImages& images,
                               const DensifyOptions& options,
                               DeviceMatcher* device) {
  const WorkImages::Handle first = images.get(reference);
  HF_CHECK(first != nullptr);
  StereoDepthResult result{.map = empty_map(reconstruction, reference, *first)};
  result.map.disparity_sigma_px = options.stereo.disparity_sigma_px;
  std::vector<PairDepths> pairs;
  for (const StereoPartner& partner : choose_partners(reconstruction, reference, options)) {
    const WorkImages::Handle second = images.get(partner.view);
    if (!second) continue;
    auto depths =
        match_partner(reconstruction, result.map, partner, *first, *second, options.stereo, device);
    if (!depths) {
      result.refusals.push_back(fmt::format("{} with {}: {}",
                                            reconstruction.views[reference].name,
                                            reconstruction.views[partner.view].name,
                                            depths.error().message));
      continue;
    }
    pairs.push_back(std::move(*depths));
    result.map.partners.push_back(partner.view);
    ++result.num_pairs;
  }
  merge_pairs(pairs, result.map);
  erode_depth_edges(result.map, options.check.edge_step, options.check.edge_margin_px);
  drop_sky_fringe(result.map, options.stereo.min_texture_grey, options.check.sky_reach_px);
  return result;
}

}  // namespace hybridfusion
