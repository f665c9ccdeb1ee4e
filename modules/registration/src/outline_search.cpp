#include "outline_search.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace hybridfusion {
namespace {

Eigen::Matrix2d rotation(double yaw_rad) {
  return Eigen::Rotation2Dd(yaw_rad).toRotationMatrix();
}

double wrapped(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

/// Transforms of the vision maps, padded so that the pattern may hang over each side.
struct Spectra {
  RasterGrid grid;  ///< Of the vision maps.
  int width = 0;
  int height = 0;
  cv::Mat edge;
  cv::Mat interior;
};

cv::Mat padded_spectrum(const Raster& raster, int width, int height) {
  cv::Mat image(height, width, CV_32F, cv::Scalar(0.0));
  for (int y = 0; y < raster.grid.height; ++y) {
    std::copy_n(&raster.values[raster.grid.index(0, y)], raster.grid.width, image.ptr<float>(y));
  }
  cv::dft(image, image, 0, raster.grid.height);
  return image;
}

Spectra transform(const VisionMaps& vision, double reach_m) {
  const RasterGrid& grid = vision.edge.grid;
  const int pad = 2 * static_cast<int>(std::ceil(reach_m / grid.cell_m)) + 2;
  Spectra spectra{.grid = grid,
                  .width = cv::getOptimalDFTSize(grid.width + pad),
                  .height = cv::getOptimalDFTSize(grid.height + pad),
                  .edge = {},
                  .interior = {}};
  spectra.edge = padded_spectrum(vision.edge, spectra.width, spectra.height);
  spectra.interior = padded_spectrum(vision.interior, spectra.width, spectra.height);
  return spectra;
}

/// Adds `weight` at `cell` (in cells, may be negative: the image wraps) bilinearly.
void splat(cv::Mat& image, const Eigen::Vector2d& cell, double weight) {
  const int x0 = static_cast<int>(std::floor(cell.x()));
  const int y0 = static_cast<int>(std::floor(cell.y()));
  const double fx = cell.x() - x0;
  const double fy = cell.y() - y0;
  const auto add = [&](int x, int y, double w) {
    const int wrapped_x = (x % image.cols + image.cols) % image.cols;
    const int wrapped_y = (y % image.rows + image.rows) % image.rows;
    image.at<float>(wrapped_y, wrapped_x) += static_cast<float>(w);
  };
  add(x0, y0, weight * (1.0 - fx) * (1.0 - fy));
  add(x0 + 1, y0, weight * fx * (1.0 - fy));
  add(x0, y0 + 1, weight * (1.0 - fx) * fy);
  add(x0 + 1, y0 + 1, weight * fx * fy);
}

/// score(t) for every shift t in cells (wrapping) at one heading.
cv::Mat correlate(const Spectra& spectra,
                  const PlanarPattern& pattern,
                  double yaw_rad,
                  double free_penalty) {
  const Eigen::Matrix2d turn = rotation(yaw_rad) / spectra.grid.cell_m;
  cv::Mat facades(spectra.height, spectra.width, CV_32F, cv::Scalar(0.0));
  cv::Mat open(spectra.height, spectra.width, CV_32F, cv::Scalar(0.0));
  for (const PlanarPattern::Facade& f : pattern.facades) splat(facades, turn * f.point, f.weight);
  for (const Eigen::Vector2d& p : pattern.free_points) {
    splat(open, turn * p, free_penalty * kFreeWeight);
  }
  cv::dft(facades, facades);
  cv::dft(open, open);
  cv::mulSpectrums(spectra.edge, facades, facades, 0, true);
  cv::mulSpectrums(spectra.interior, open, open, 0, true);
  facades -= open;
  cv::dft(facades, facades, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  return facades;
}

void keep_best(std::vector<PlanarPose>& peaks, std::size_t count, const OutlineOptions& options) {
  std::ranges::stable_sort(peaks, std::ranges::greater{}, &PlanarPose::score);
  std::vector<PlanarPose> kept;
  for (const PlanarPose& peak : peaks) {
    if (kept.size() >= count) break;
    const bool is_new = std::ranges::none_of(
        kept, [&](const PlanarPose& other) { return same_peak(peak, other, options); });
    if (is_new) kept.push_back(peak);
  }
  peaks = std::move(kept);
}

/// The three best local maxima inside the window at one heading.
std::vector<PlanarPose> peaks_of(const cv::Mat& scores,
                                 const Spectra& spectra,
                                 double yaw_rad,
                                 const SearchWindow& window,
                                 double reach_m,
                                 const OutlineOptions& options) {
  const double cell = spectra.grid.cell_m;
  const int reach = static_cast<int>(reach_m / cell);
  const auto value = [&](int x, int y) {
    return scores.at<float>((y + scores.rows) % scores.rows, (x + scores.cols) % scores.cols);
  };
  std::vector<PlanarPose> peaks;
  for (int y = -reach; y < spectra.grid.height + reach; ++y) {
    for (int x = -reach; x < spectra.grid.width + reach; ++x) {
      const float here = value(x, y);
      if (here <= 0.0F) continue;
      if (here < value(x - 1, y) || here <= value(x + 1, y) || here < value(x, y - 1) ||
          here <= value(x, y + 1)) {
        continue;
      }
      // A splat at cell coordinate c lies at origin + (c + 1/2) cells of the vision maps.
      const Eigen::Vector2d position =
          spectra.grid.origin + cell * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (window.position && (position - *window.position).norm() > window.max_offset_m) continue;
      peaks.push_back({.position = position, .yaw_rad = yaw_rad, .score = here});
    }
  }
  keep_best(peaks, 3, options);
  return peaks;
}

}  // namespace

bool same_peak(const PlanarPose& a, const PlanarPose& b, const OutlineOptions& options) {
  return (a.position - b.position).norm() < options.peak_distance_m &&
         std::abs(wrapped(a.yaw_rad - b.yaw_rad)) < options.peak_angle_rad;
}

PlanarPattern make_pattern(const LidarMaps& maps, const Eigen::Matrix3d& tilt) {
  PlanarPattern pattern;
  double weight = 0.0;
  for (const FacadeCell& f : maps.facades) {
    pattern.centre += f.weight * (tilt * f.mean).head<2>();
    weight += f.weight;
  }
  if (weight > 0.0) pattern.centre /= weight;
  for (const FacadeCell& f : maps.facades) {
    pattern.facades.push_back({(tilt * f.mean).head<2>() - pattern.centre, f.outward, f.weight});
    pattern.reach_m = std::max(pattern.reach_m, pattern.facades.back().point.norm());
  }
  for (std::size_t i = 0; i < maps.free_cells.size(); i += static_cast<std::size_t>(kFreeWeight)) {
    pattern.free_points.emplace_back((tilt * maps.free_cells[i]).head<2>() - pattern.centre);
    pattern.reach_m = std::max(pattern.reach_m, pattern.free_points.back().norm());
  }
  return pattern;
}

Expected<OutlineSearch> search_outlines(const VisionMaps& vision,
                                        const PlanarPattern& pattern,
                                        const SearchWindow& window,
                                        const OutlineOptions& options,
                                        const RunContext& ctx) {
  if (pattern.facades.empty()) {
    return fail(ErrorCode::kInsufficient, "the LiDAR cloud has no facade to register on");
  }
  const int half = window.max_yaw_rad >= std::numbers::pi
                       ? 0
                       : static_cast<int>(std::ceil(window.max_yaw_rad / options.yaw_step_rad));
  const int full = static_cast<int>(std::lround(2.0 * std::numbers::pi / options.yaw_step_rad));
  const int all = window.max_yaw_rad > 0.0 ? full : 1;
  const int num_yaws = half > 0 ? 2 * half + 1 : all;
  const double step = half > 0 ? options.yaw_step_rad : 2.0 * std::numbers::pi / full;
  std::vector<std::vector<PlanarPose>> per_yaw(static_cast<std::size_t>(num_yaws));
  const auto yaw_of = [&](std::size_t k) {
    return wrapped(window.yaw_rad + (static_cast<double>(k) - half) * step);
  };
  try {
    const Spectra spectra = transform(vision, pattern.reach_m);
    parallel_for(ctx, per_yaw.size(), 4, [&](std::size_t begin, std::size_t end) {
      if (ctx.stopped()) return;
      for (std::size_t k = begin; k < end; ++k) {
        const double yaw = yaw_of(k);
        const cv::Mat scores = correlate(spectra, pattern, yaw, options.free_penalty);
        per_yaw[k] = peaks_of(scores, spectra, yaw, window, pattern.reach_m, options);
      }
    });
  } catch (const cv::Exception& error) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("correlating the outline maps failed: {}", error.what()));
  }
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped in the outline search");
  OutlineSearch search;
  for (std::size_t k = 0; k < per_yaw.size(); ++k) {
    const std::vector<PlanarPose>& peaks = per_yaw[k];
    search.peaks.insert(search.peaks.end(), peaks.begin(), peaks.end());
    search.yaw_scores.push_back({yaw_of(k), peaks.empty() ? 0.0 : peaks.front().score});
  }
  keep_best(search.peaks, static_cast<std::size_t>(options.num_peaks), options);
  return search;
}

}  // namespace hybridfusion
