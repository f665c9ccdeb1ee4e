#include "building_styles.hpp"
#include "street_lining.hpp"
#include "street_objects.hpp"
#include "tunnel.hpp"
#include "world.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

/// One generated town: lots are filled block by block, then the strips across the outer streets,
/// then the pavements.
class TownBuilder {
 public:
  TownBuilder(const WorldOptions& options, std::uint64_t seed, World& world)
      : options_(options), seed_(seed), world_(world), builder_(world.scene, 1.1) {
    contrast_ =
        static_cast<float>(options.texture_contrast * (options.variant == "dull" ? 0.22 : 1.0));
  }

  void build() {
    build_ground(world_.terrain, contrast_, seed_, builder_);
    if (options_.variant == "tunnel") {
      build_tunnel(world_.terrain, options_.size_m, contrast_, seed_, builder_);
    }
    if (!world_.terrain.plan().streets) return;
    const StreetPlan& plan = world_.terrain.plan();
    for (std::size_t j = 0; j + 1 < plan.street_y.size(); ++j) {
      for (std::size_t i = 0; i + 1 < plan.street_x.size(); ++i) fill_block(i, j);
    }
    for (int side = 0; side < 4; ++side) fill_outer_strip(side);
    line_streets(options_, world_.terrain, contrast_, seed_, builder_);
  }

 private:
  /// Its stream, so that one more car does not change the houses.
  [[nodiscard]] std::uint64_t next_seed() { return seed_ * 1000003U + 1 + count_++; }

  void place_building(BuildingStyle style, Eigen::Vector2d center, double turn) {
    if (options_.variant == "repetitive") {
      // The same house everywhere: only the floor plan's size follows the lot.
      const BuildingStyle model =
          random_building_style(FloorPlan::kBox, style.width_m, style.depth_m, contrast_, seed_);
      style = model;
      style.floors = 4;
      style.balcony_share = 0.0;
      style.window_spacing_m = 3.0;
      style.roof = RoofShape::kFlat;
    }
    const Terrain& terrain = world_.terrain;
    const double cosine = std::cos(turn);
    const double sine = std::sin(turn);
    double ground = -1e9;
    for (const double sx : {-0.5, 0.0, 0.5}) {
      for (const double sy : {-0.5, 0.0, 0.5}) {
        const double x = sx * style.width_m;
        const double y = sy * style.depth_m;
        ground = std::max(
            ground,
            terrain.height(center.x() + cosine * x - sine * y, center.y() + sine * x + cosine * y));
      }
    }
    const GroundFrame frame = terrain.frame().at({center.x(), center.y(), ground}, turn);
    build_building(style, frame, builder_);
  }

  void fill_block(std::size_t i, std::size_t j) {
    const StreetPlan& plan = world_.terrain.plan();
    const double margin = 0.5 * plan.street_width_m + plan.pavement_width_m + 0.6;
    const Eigen::Vector2d low(plan.street_x[i] + margin, plan.street_y[j] + margin);
    const Eigen::Vector2d high(plan.street_x[i + 1] - margin, plan.street_y[j + 1] - margin);
    if (options_.main_building > 0) {
      fill_with_main_building(low, high);
      return;
    }
    Random random(seed_, "world/block", 1000 * i + j);
    split_lot(low, high, random, 0);
  }

  void fill_with_main_building(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    static constexpr std::array kPlans = {
        FloorPlan::kBox, FloorPlan::kL, FloorPlan::kU, FloorPlan::kBox};
    const Eigen::Vector2d size = high - low;
    const Eigen::Vector2d center = 0.5 * (low + high);
    const auto number = static_cast<std::size_t>(options_.main_building);
    const bool tower = options_.main_building == 4;
    const double w = std::min((tower ? 0.7 : 0.8) * size.x(), 34.0);
    const double d = std::min((tower ? 0.7 : 0.78) * size.y(), 26.0);
    BuildingStyle style = random_building_style(kPlans[number - 1], w, d, contrast_, next_seed());
    style.floors = tower ? 2 : 3 + options_.main_building;
    if (options_.main_building != 1) style.roof = RoofShape::kFlat;
    place_building(style, center, 0.0);
    if (!tower) return;
    const double width = 0.55 * std::min(w, d);
    const BuildingStyle top =
        random_building_style(FloorPlan::kTower, width, width, contrast_, next_seed());
    place_building(top, center + Eigen::Vector2d(0.12 * w, 0.0), 0.0);
  }

  /// Cuts a lot in two until it has the size of a house.
  void split_lot(const Eigen::Vector2d& low,
                 const Eigen::Vector2d& high,
                 Random& random,
                 int depth) {
    const Eigen::Vector2d size = high - low;
    const int longer = size.x() >= size.y() ? 0 : 1;
    const double stop = random.uniform(13.0, 20.0);
    if (size[longer] > stop && (depth < 1 || size[longer] > 11.0) && size[longer] > 16.0) {
      const double cut = low[longer] + size[longer] * random.uniform(0.42, 0.58);
      const double gap = random.uniform(0.8, 2.6);
      Eigen::Vector2d first_high = high;
      Eigen::Vector2d second_low = low;
      first_high[longer] = cut - gap;
      second_low[longer] = cut + gap;
      split_lot(low, first_high, random, depth + 1);
      split_lot(second_low, high, random, depth + 1);
      return;
    }
    if (size.minCoeff() < 5.0) return;
    build_on_lot(low, high, random);
  }

  void build_on_lot(const Eigen::Vector2d& low, const Eigen::Vector2d& high, Random& random) {
    const Eigen::Vector2d size = high - low;
    const Eigen::Vector2d center = 0.5 * (low + high);
    const double w = size.x() - random.uniform(0.3, 1.6);
    const double d = size.y() - random.uniform(0.3, 1.6);
    const double shape = random.uniform();
    const std::uint64_t seed = next_seed();
    if (shape < 0.18 && size.minCoeff() > 9.0) {
      const double width = std::min(w, d);
      place_building(
          random_building_style(FloorPlan::kTower, width, width, contrast_, seed), center, 0.0);
      return;
    }
    const FloorPlan plan = size.minCoeff() < 9.0 || shape < 0.5
                               ? FloorPlan::kBox
                               : (shape < 0.75 ? FloorPlan::kL : FloorPlan::kU);
    // A quarter turn puts the ridge along the longer side; L and U open to any side.
    const int quarter =
        plan == FloorPlan::kBox ? (d > w ? 1 : 0) : static_cast<int>(random.index(4));
    const bool swapped = quarter % 2 == 1;
    place_building(random_building_style(plan, swapped ? d : w, swapped ? w : d, contrast_, seed),
                   center,
                   0.5 * std::numbers::pi * quarter);
  }

  /// Houses across the outer streets; gaps show the grass.
  void fill_outer_strip(int side) {
    const StreetPlan& plan = world_.terrain.plan();
    Random random(seed_, "world/strip", static_cast<std::uint64_t>(side));
    const bool along_x = side < 2;
    const double sign = side % 2 == 0 ? -1.0 : 1.0;
    const auto& streets = along_x ? plan.street_y : plan.street_x;
    const double street = sign < 0 ? streets.front() : streets.back();
    const double from = street + sign * (0.5 * plan.street_width_m + plan.pavement_width_m);
    const double edge = sign * (along_x ? plan.core_half_m.y() : plan.core_half_m.x());
    const double half = along_x ? plan.core_half_m.x() : plan.core_half_m.y();
    const double deep = std::abs(edge - from);
    double s = -half + random.uniform(0.0, 4.0);
    while (true) {
      const double width = random.uniform(8.0, 15.0);
      if (s + width > half - 1.0) break;
      const double depth = std::clamp(deep + random.uniform(-1.2, 1.5), 5.5, 11.0);
      const double t = from + sign * (0.4 + 0.5 * depth);
      const Eigen::Vector2d center =
          along_x ? Eigen::Vector2d(s + 0.5 * width, t) : Eigen::Vector2d(t, s + 0.5 * width);
      if (random.uniform() < 0.85) {
        place_building(random_building_style(FloorPlan::kBox, width, depth, contrast_, next_seed()),
                       center,
                       along_x ? 0.0 : 0.5 * std::numbers::pi);
      } else if (options_.tree_spacing_m < 100.0) {
        build_tree(world_.terrain.frame().at(world_.terrain.on_ground(center.x(), center.y())),
                   random.uniform(5.5, 9.0),
                   next_seed(),
                   builder_);
      }
      s += width + random.uniform(0.6, 5.5);
    }
  }

  const WorldOptions& options_;
  std::uint64_t seed_;
  World& world_;
  MeshBuilder builder_;
  float contrast_ = 1.0F;
  std::uint64_t count_ = 0;
};

StreetPlan plan_streets(const WorldOptions& options, std::uint64_t seed) {
  Random random(seed, "world/plan");
  StreetPlan plan;
  plan.yaw_rad = random.uniform(-0.35, 0.35);
  plan.streets = options.variant != "flat" && options.variant != "tunnel";
  plan.street_width_m = std::clamp(0.1125 * options.size_m, 7.5, 10.0);
  const double strip = std::clamp(0.118 * options.size_m, 7.6, 13.0);
  const Eigen::Vector2d pitch(options.size_m - 2.0 * strip - plan.street_width_m,
                              0.9 * options.size_m - 2.0 * strip - plan.street_width_m);
  const auto lines = [](int blocks, double spacing) {
    std::vector<double> out;
    for (int i = 0; i <= blocks; ++i) out.push_back((i - 0.5 * blocks) * spacing);
    return out;
  };
  plan.street_x = lines(options.blocks_x, pitch.x());
  plan.street_y = lines(options.blocks_y, pitch.y());
  plan.core_half_m = {plan.street_x.back() + 0.5 * plan.street_width_m + strip,
                      plan.street_y.back() + 0.5 * plan.street_width_m + strip};
  return plan;
}

}  // namespace

World generate_town(const WorldOptions& options, std::uint64_t seed) {
  World world{.scene = {}, .terrain = Terrain(plan_streets(options, seed), options.relief_m, seed)};
  TownBuilder(options, seed, world).build();
  return world;
}

}  // namespace hybridfusion
