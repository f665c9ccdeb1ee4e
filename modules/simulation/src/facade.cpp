#include "building.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kFoundation_m = 1.6;  ///< Walls go below the ground so that slopes leave no gap.

struct Opening {
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  bool balcony = false;
};

/// Works in the wall's own frame: x along the wall from its left end, y into the building, z up.
class Facade {
 public:
  Facade(const BuildingStyle& style,
         const BuildingSurfaces& surfaces,
         const GroundFrame& frame,
         const WallPiece& wall,
         MeshBuilder& builder)
      : style_(style),
        surfaces_(surfaces),
        wall_(wall),
        builder_(builder),
        random_(style.seed, "world/facade", wall.index) {
    const Eigen::Vector2d along = wall.right - wall.left;
    length_ = along.norm();
    height_ = style.floors * style.floor_height_m;
    frame_ = frame.at({wall.left.x(), wall.left.y(), 0.0}, std::atan2(along.y(), along.x()));
  }

  void build() {
    place_openings();
    build_wall();
    for (const Opening& opening : openings_) build_opening(opening);
    if (wall_.narrow) return;
    build_trim();
    build_clutter();
  }

 private:
  [[nodiscard]] Eigen::Vector3d at(double u, double y, double v) const {
    return frame_ * Eigen::Vector3d(u, y, v);
  }

  void place_openings() {
    const double usable = length_ - (wall_.narrow ? 0.1 : 1.2);
    const int columns = wall_.narrow ? (wall_.index % 2 == 0 ? 1 : 0)
                                     : static_cast<int>(usable / style_.window_spacing_m);
    if (columns < 1) return;
    const double width = wall_.narrow ? std::min(0.45 * length_, 0.5) : style_.window_width_m;
    std::vector<bool> balconies(static_cast<std::size_t>(columns));
    for (int column = 0; column < columns; ++column) {
      balconies[column] = !wall_.narrow && random_.uniform() < style_.balcony_share;
    }
    for (int floor = 0; floor < style_.floors; ++floor) {
      for (int column = 0; column < columns; ++column) {
        const double center = length_ * (column + 0.5) / columns;
        const bool balcony = floor > 0 && balconies[column];
        const bool shop = floor == 0 && !wall_.narrow && random_.uniform() < 0.35;
        const double w = shop ? std::min(1.5 * width, 0.8 * length_ / columns) : width;
        const double sill = floor * style_.floor_height_m + (balcony || shop ? 0.25 : 0.95);
        const double head = std::min((floor + 1) * style_.floor_height_m - 0.35,
                                     floor * style_.floor_height_m + 0.95 + style_.window_height_m);
        openings_.push_back({.u0 = center - 0.5 * w,
                             .u1 = center + 0.5 * w,
                             .v0 = sill,
                             .v1 = head,
                             .balcony = balcony});
      }
    }
  }

  /// The wall around the openings, floor by floor in columns between the window edges.
  void build_wall() {
    wall_part(0.0, length_, -kFoundation_m, 0.0, surfaces_.base);
    for (int floor = 0; floor < style_.floors; ++floor) {
      const double low = floor * style_.floor_height_m;
      const double high = low + style_.floor_height_m;
      const std::uint32_t surface = floor == 0 ? surfaces_.base : surfaces_.wall;
      double u = 0.0;
      for (const Opening& opening : openings_) {
        if (opening.v0 < low || opening.v0 >= high) continue;
        wall_part(u, opening.u0, low, high, surface);
        wall_part(opening.u0, opening.u1, low, opening.v0, surface);
        wall_part(opening.u0, opening.u1, opening.v1, high, surface);
        u = opening.u1;
      }
      wall_part(u, length_, low, high, surface);
    }
  }
  void wall_part(double u0, double u1, double v0, double v1, std::uint32_t surface) {
    if (u1 - u0 < 1e-6 || v1 - v0 < 1e-6) return;
    builder_.quad(at(u0, 0, v0), at(u1, 0, v0), at(u1, 0, v1), at(u0, 0, v1), surface);
  }

  void build_opening(const Opening& o) {
    const double deep = wall_.narrow ? 0.12 : 0.18;
    const std::uint32_t reveal = surfaces_.trim;
    builder_.quad(
        at(o.u0, deep, o.v0), at(o.u0, 0, o.v0), at(o.u0, 0, o.v1), at(o.u0, deep, o.v1), reveal);
    builder_.quad(
        at(o.u1, 0, o.v0), at(o.u1, deep, o.v0), at(o.u1, deep, o.v1), at(o.u1, 0, o.v1), reveal);
    builder_.quad(
        at(o.u0, 0, o.v0), at(o.u0, deep, o.v0), at(o.u1, deep, o.v0), at(o.u1, 0, o.v0), reveal);
    builder_.quad(
        at(o.u0, deep, o.v1), at(o.u0, 0, o.v1), at(o.u1, 0, o.v1), at(o.u1, deep, o.v1), reveal);
    const auto pane = random_.index(static_cast<std::uint32_t>(surfaces_.panes.size()));
    builder_.quad(at(o.u0, deep, o.v0),
                  at(o.u1, deep, o.v0),
                  at(o.u1, deep, o.v1),
                  at(o.u0, deep, o.v1),
                  surfaces_.panes[pane]);
    build_window_frame(o, deep);
    if (o.balcony) {
      build_balcony(o);
    } else {
      builder_.box(
          frame_, {o.u0 - 0.08, -0.12, o.v0 - 0.1}, {o.u1 + 0.08, 0.05, o.v0}, surfaces_.trim);
    }
  }

  void build_window_frame(const Opening& o, double deep) {
    const double bar = wall_.narrow ? 0.04 : 0.07;
    const auto beam = [&](double u0, double u1, double v0, double v1) {
      builder_.box(frame_, {u0, deep - 0.06, v0}, {u1, deep, v1}, surfaces_.frame, 8);
    };
    beam(o.u0, o.u1, o.v0, o.v0 + bar);
    beam(o.u0, o.u1, o.v1 - bar, o.v1);
    beam(o.u0, o.u0 + bar, o.v0 + bar, o.v1 - bar);
    beam(o.u1 - bar, o.u1, o.v0 + bar, o.v1 - bar);
    if (wall_.narrow) return;
    const double middle = 0.5 * (o.u0 + o.u1);
    beam(middle - 0.5 * bar, middle + 0.5 * bar, o.v0 + bar, o.v1 - bar);
  }

  void build_balcony(const Opening& o) {
    const double out = random_.uniform(1.0, 1.4);
    const double u0 = std::max(0.1, o.u0 - 0.6);
    const double u1 = std::min(length_ - 0.1, o.u1 + 0.6);
    const double v = o.v0 - 0.2;
    builder_.box(frame_, {u0, -out, v - 0.16}, {u1, 0.0, v}, surfaces_.trim, 8);
    const std::uint32_t rail = surfaces_.balcony;
    builder_.box(frame_, {u0, -out, v}, {u1, -out + 0.08, v + 1.0}, rail, 16);
    builder_.box(frame_, {u0, -out + 0.08, v}, {u0 + 0.08, 0.0, v + 1.0}, rail, 8 | 16);
    builder_.box(frame_, {u1 - 0.08, -out + 0.08, v}, {u1, 0.0, v + 1.0}, rail, 8 | 16);
  }

  void build_trim() {
    if (!style_.string_courses) return;
    const int step = style_.floors > 3 ? 2 : 1;
    for (int floor = 1; floor < style_.floors; floor += step) {
      const double v = floor * style_.floor_height_m;
      builder_.box(
          frame_, {-0.07, -0.07, v - 0.12}, {length_ + 0.07, 0.0, v + 0.03}, surfaces_.trim, 8);
    }
  }

  /// Air conditioners and rain pipes between the windows.
  void build_clutter() {
    for (const Opening& o : openings_) {
      if (o.balcony || random_.uniform() > 0.09) continue;
      const double u = o.u1 + 0.15;
      if (u + 0.8 > length_ - 0.2) continue;
      builder_.box(frame_, {u, -0.4, o.v0 - 0.1}, {u + 0.75, -0.06, o.v0 + 0.45}, surfaces_.metal);
    }
    if (length_ > 6.0 && random_.uniform() < 0.6) {
      const double u = random_.uniform() < 0.5 ? 0.35 : length_ - 0.35;
      builder_.tube(at(u, -0.1, -0.2), at(u, -0.1, height_), 0.06, 0.06, 6, surfaces_.metal);
    }
  }

  const BuildingStyle& style_;
  const BuildingSurfaces& surfaces_;
  const WallPiece& wall_;
  MeshBuilder& builder_;
  Random random_;
  GroundFrame frame_ = {};
  double length_ = 0.0;
  double height_ = 0.0;
  std::vector<Opening> openings_ = {};
};

}  // namespace

void build_facade(const BuildingStyle& style,
                  const BuildingSurfaces& surfaces,
                  const GroundFrame& frame,
                  const WallPiece& wall,
                  MeshBuilder& builder) {
  Facade(style, surfaces, frame, wall, builder).build();
}

}  // namespace hybridfusion
