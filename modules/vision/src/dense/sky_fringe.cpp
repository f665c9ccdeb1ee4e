#include "sky_fringe.hpp"

#include "census.hpp"
#include "texture_mask.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace hybridfusion {
namespace {

constexpr double kHorizonSin = -0.035;  // 2 degrees below: the attitude is no better known
constexpr int kObjectReach_px = 3;      // in which a pixel of the object itself is sought
constexpr float kSkyShare = 0.3F;       // of the way from the sky's colour to the object's

struct Pixel {
  int x = 0;
  int y = 0;
};
constexpr std::array<Pixel, 4> kSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

class Horizon {
 public:
  explicit Horizon(const DepthMap& map)
      : grid_(map.grid),
        up_in_camera_(map.enu_from_camera.rotation.conjugate().toRotationMatrix().col(2)) {}
  [[nodiscard]] bool below(int x, int y) const {
    const Eigen::Vector3d ray = ray_of(grid_, {x, y});
    return up_in_camera_.dot(ray) < kHorizonSin * ray.norm();
  }
  /// Whether the whole photo lies below: what is above is a half plane of pixels.
  [[nodiscard]] bool not_in_sight() const {
    const int right = grid_.width_px - 1;
    const int bottom = grid_.height_px - 1;
    return below(0, 0) && below(right, 0) && below(0, bottom) && below(right, bottom);
  }

 private:
  const PinholeGrid& grid_;
  Eigen::Vector3d up_in_camera_;
};

/// Whether the photo ends within reach of the windows that tell texture.
bool at_border(const DepthMap& map, Pixel p) {
  constexpr int kReach_px = 2 * kCensusHalfWidth;
  return std::ranges::any_of(kSides, [&](Pixel side) {
    const int x = p.x + kReach_px * side.x;
    const int y = p.y + kReach_px * side.y;
    return !map.mask.contains(x, y) || map.mask.at(x, y) == 0;
  });
}

/// Pixels of the sky proper; `sky` is 1 there.
std::vector<Pixel> find_sky(const DepthMap& map, double min_grey, ImagePlane<std::uint8_t>& sky) {
  const Horizon horizon(map);
  if (horizon.not_in_sight()) return {};
  const ImagePlane<std::uint8_t> weak = weak_texture(map.grey, min_grey);
  const auto may_be_sky = [&](int x, int y) {
    return weak.contains(x, y) && weak.at(x, y) != 0 && sky.at(x, y) == 0 &&
           map.mask.at(x, y) != 0 && !map.has_depth(x, y) && !horizon.below(x, y);
  };
  std::vector<Pixel> found;
  const auto take = [&](Pixel p) {
    sky.at(p.x, p.y) = 1;
    found.push_back(p);
  };
  for (int y = 0; y < weak.height; ++y) {
    for (int x = 0; x < weak.width; ++x) {
      if (may_be_sky(x, y) && at_border(map, {x, y})) take({x, y});
    }
  }
  for (std::size_t next = 0; next < found.size();) {
    const Pixel from = found[next++];
    for (const Pixel side : kSides) {
      const Pixel to{from.x + side.x, from.y + side.y};
      if (may_be_sky(to.x, to.y)) take(to);
    }
  }
  return found;
}

float squared_difference(const Rgb8& a, const Rgb8& b) {
  float sum = 0.0F;
  for (std::size_t c = 0; c < 3; ++c) {
    const float d = static_cast<float>(a[c]) - static_cast<float>(b[c]);
    sum += d * d;
  }
  return sum;
}

bool has_colour_of_sky(const DepthMap& map, Pixel p, const Rgb8& sky) {
  float object = 0.0F;  // how far the object's colour is from the sky's
  for (int v = p.y - kObjectReach_px; v <= p.y + kObjectReach_px; ++v) {
    for (int u = p.x - kObjectReach_px; u <= p.x + kObjectReach_px; ++u) {
      if (!map.mask.contains(u, v) || map.mask.at(u, v) == 0) continue;
      object = std::max(object, squared_difference(map.rgb.at(u, v), sky));
    }
  }
  return squared_difference(map.rgb.at(p.x, p.y), sky) <= kSkyShare * kSkyShare * object;
}

}  // namespace

void drop_sky_fringe(DepthMap& map, double min_grey, int reach_px) {
  if (reach_px <= 0) return;
  ImagePlane<std::uint8_t> reached(map.grid.width_px, map.grid.height_px);
  // Every pixel near the sky is compared with the sky that lies nearest to it (in steps along rows
  // and columns), of which it is handed the colour.
  struct Front {
    Pixel at = {};
    Rgb8 sky = {};
  };
  std::vector<Front> front;
  for (const Pixel p : find_sky(map, min_grey, reached)) front.push_back({p, map.rgb.at(p.x, p.y)});
  for (int step = 0; step < reach_px && !front.empty(); ++step) {
    std::vector<Front> next;
    for (const Front& from : front) {
      for (const Pixel side : kSides) {
        const Pixel to{from.at.x + side.x, from.at.y + side.y};
        if (!reached.contains(to.x, to.y) || reached.at(to.x, to.y) != 0) continue;
        reached.at(to.x, to.y) = 1;
        next.push_back({to, from.sky});
        if (map.has_depth(to.x, to.y) && has_colour_of_sky(map, to, from.sky)) {
          map.depth_m.at(to.x, to.y) = std::numeric_limits<float>::quiet_NaN();
        }
      }
    }
    front = std::move(next);
  }
}

}  // namespace hybridfusion
