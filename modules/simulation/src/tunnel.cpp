#include "tunnel.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace hybridfusion {
namespace {

constexpr double kHalfWidth_m = 4.4;
constexpr double kWall_m = 2.6;
constexpr double kVault_m = 2.9;  ///< Height of the half ellipse above the walls.
constexpr double kFooting_m = 0.6;
constexpr double kSegment_m = 2.0;
constexpr double kNicheDepth_m = 1.5;
constexpr std::size_t kNicheSegments = 2;
constexpr double kLampEvery_m = 12.0;

Surface lining(float reflectivity, float contrast, std::uint64_t seed) {
  Surface surface{.material = Material::kConcrete, .label = FaceLabel::kBuilding};
  surface.color = {0.42F, 0.41F, 0.40F};
  surface.contrast = contrast;
  surface.seed = static_cast<std::uint32_t>(seed) + 71U;
  surface.lidar_reflectivity = reflectivity;
  return surface;
}

/// Left wall, vault, right wall: (y, z above the road).
std::vector<Eigen::Vector2d> profile() {
  constexpr int kArcs = 14;
  std::vector<Eigen::Vector2d> out = {{-kHalfWidth_m, -kFooting_m}};
  for (int i = 0; i <= kArcs; ++i) {
    const double angle = std::numbers::pi * (1.0 - static_cast<double>(i) / kArcs);
    out.emplace_back(kHalfWidth_m * std::cos(angle), kWall_m + kVault_m * std::sin(angle));
  }
  out.emplace_back(kHalfWidth_m, -kFooting_m);
  return out;
}

/// A tunnel in the making; the road may rise and fall.
class TunnelBuilder {
 public:
  TunnelBuilder(const Terrain& terrain,
                double length_m,
                float contrast,
                std::uint64_t seed,
                MeshBuilder& builder)
      : terrain_(terrain),
        half_m_(0.5 * length_m),
        random_(seed, "world/tunnel"),
        builder_(builder),
        wall_(builder.add_surface(lining(0.35F, contrast, seed), terrain.frame())),
        metal_(builder.add_surface(lining(0.5F, contrast, seed + 1), terrain.frame())) {}

  void build() {
    const auto segments = static_cast<std::size_t>(std::ceil(2.0 * half_m_ / kSegment_m));
    std::array<std::vector<bool>, 2> open = {std::vector<bool>(segments, false),
                                             std::vector<bool>(segments, false)};
    for (std::size_t at = spacing() / 2; at + kNicheSegments < segments; at += spacing()) {
      const std::size_t side = random_.index(2);
      for (std::size_t k = 0; k < kNicheSegments; ++k) open[side][at + k] = true;
      build_niche(-half_m_ + kSegment_m * static_cast<double>(at), side == 0 ? -1.0 : 1.0);
    }
    for (std::size_t i = 0; i < segments; ++i) build_lining(i, open[0][i], open[1][i]);
    for (const double end : {-half_m_, half_m_}) build_portal(end);
    const double first = random_.uniform(0.0, kLampEvery_m);
    for (double x = -half_m_ + first; x < half_m_; x += kLampEvery_m) build_lamp(x);
  }

 private:
  [[nodiscard]] double road(double x) const { return terrain_.height(x, 0.0); }
  [[nodiscard]] std::size_t spacing() { return 10 + random_.index(8); }  // 20 to 34 m

  void build_lining(std::size_t segment, bool open_left, bool open_right) {
    const std::vector<Eigen::Vector2d> section = profile();
    const double x = -half_m_ + kSegment_m * static_cast<double>(segment);
    const double next = std::min(half_m_, x + kSegment_m);
    const auto at = [&](double s, const Eigen::Vector2d& p) -> Eigen::Vector3d {
      return terrain_.frame() * Eigen::Vector3d(s, p.x(), road(s) + p.y());
    };
    for (std::size_t i = 0; i + 1 < section.size(); ++i) {
      if ((i == 0 && open_left) || (i + 2 == section.size() && open_right)) continue;
      builder_.quad(at(x, section[i]),
                    at(next, section[i]),
                    at(next, section[i + 1]),
                    at(x, section[i + 1]),
                    wall_);
    }
  }

  void build_niche(double x, double side) {
    const double inner = side * kHalfWidth_m;
    const double outer = side * (kHalfWidth_m + kNicheDepth_m);
    constexpr unsigned kWithoutMinusY = 4;
    constexpr unsigned kWithoutPlusY = 8;
    builder_.box(terrain_.frame(),
                 {x, std::min(inner, outer), road(x) - kFooting_m},
                 {x + kSegment_m * kNicheSegments, std::max(inner, outer), road(x) + kWall_m},
                 wall_,
                 side > 0.0 ? kWithoutMinusY : kWithoutPlusY);
  }

  void build_portal(double x) {
    for (const double side : {-1.0, 1.0}) {
      const double near_y = side * kHalfWidth_m;
      const double far_y = side * (kHalfWidth_m + 8.0);
      builder_.box(terrain_.frame(),
                   {x - 0.3, std::min(near_y, far_y), road(x) - kFooting_m},
                   {x + 0.3, std::max(near_y, far_y), road(x) + 7.0},
                   wall_);
    }
  }

  void build_lamp(double x) {
    const double top = road(x) + kWall_m + kVault_m;
    builder_.box(terrain_.frame(), {x - 0.7, -0.2, top - 0.4}, {x + 0.7, 0.2, top - 0.15}, metal_);
  }

  const Terrain& terrain_;
  double half_m_;
  Random random_;
  MeshBuilder& builder_;
  std::uint32_t wall_;
  std::uint32_t metal_;
};

}  // namespace

void build_tunnel(const Terrain& terrain,
                  double length_m,
                  float contrast,
                  std::uint64_t seed,
                  MeshBuilder& builder) {
  TunnelBuilder(terrain, length_m, contrast, seed, builder).build();
}

}  // namespace hybridfusion
