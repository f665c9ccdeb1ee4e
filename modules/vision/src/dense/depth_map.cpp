#include "depth_map.hpp"

#include <algorithm>
#include <limits>

namespace hybridfusion {

ImagePlane<std::uint8_t> grey_plane(const ImagePlane<Rgb8>& rgb) {
  ImagePlane<std::uint8_t> grey(rgb.width, rgb.height);
  // Weights of ITU-R BT.601 in 1/65536.
  std::ranges::transform(rgb.values, grey.values.begin(), [](const Rgb8& c) {
    return static_cast<std::uint8_t>((19595 * c[0] + 38470 * c[1] + 7471 * c[2] + 32768) >> 16);
  });
  return grey;
}

DepthGuess merge_guesses(const std::vector<DepthGuess>& guesses) {
  const auto agree = [](const DepthGuess& a, const DepthGuess& b) {
    const double gap = a.depth_m - b.depth_m;
    return gap * gap <= 9.0 * (a.sigma_m * a.sigma_m + b.sigma_m * b.sigma_m);
  };
  int best_count = 0;
  double best_support = 0.0;
  double best_sum = 0.0;
  for (const DepthGuess& candidate : guesses) {
    double support = 0.0;
    double sum = 0.0;
    int count = 0;
    for (const DepthGuess& g : guesses) {
      if (!agree(g, candidate)) continue;
      const double weight = 1.0 / (g.sigma_m * g.sigma_m);
      support += weight;
      sum += weight * g.depth_m;
      ++count;
    }
    if (support > best_support) {
      best_support = support;
      best_sum = sum;
      best_count = count;
    }
    if (count == static_cast<int>(guesses.size())) break;  // none has more support
  }
  return {.depth_m = best_sum / best_support,
          .sigma_m = 1.0 / std::sqrt(best_support),
          .count = best_count};
}

void drop_far_depths(DepthMap& map, double max_depth_m) {
  for (float& depth : map.depth_m.values) {
    if (depth > max_depth_m) depth = std::numeric_limits<float>::quiet_NaN();
  }
}

void erode_depth_edges(DepthMap& map, double edge_step, int margin_px) {
  const ImagePlane<float> depth = map.depth_m;
  const auto step_to = [&](int x, int y, int u, int v) {
    return map.has_depth(u, v) && std::abs(depth.at(x, y) - depth.at(u, v)) >
                                      edge_step * std::min(depth.at(x, y), depth.at(u, v));
  };
  std::vector<std::pair<int, int>> edges;
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      if (!std::isnan(depth.at(x, y)) && (step_to(x, y, x + 1, y) || step_to(x, y, x, y + 1))) {
        edges.emplace_back(x, y);
      }
    }
  }
  for (const auto& [x, y] : edges) {
    for (int v = std::max(0, y - margin_px + 1); v <= std::min(depth.height - 1, y + margin_px);
         ++v) {
      for (int u = std::max(0, x - margin_px + 1); u <= std::min(depth.width - 1, x + margin_px);
           ++u) {
        map.depth_m.at(u, v) = std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
}

double median_depth_m(const DepthMap& map) {
  std::vector<float> depths;
  for (std::size_t i = 0; i < map.depth_m.values.size(); i += 7) {
    if (!std::isnan(map.depth_m.values[i])) depths.push_back(map.depth_m.values[i]);
  }
  if (depths.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::ranges::nth_element(depths, middle);
  return *middle;
}

}  // namespace hybridfusion
