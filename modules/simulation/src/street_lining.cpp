#include "street_lining.hpp"

#include "street_objects.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

class StreetLining {
 public:
  StreetLining(const WorldOptions& options,
               const Terrain& terrain,
               float contrast,
               std::uint64_t seed,
               MeshBuilder& builder)
      : options_(options), terrain_(terrain), contrast_(contrast), seed_(seed), builder_(builder) {}

  void line_street(bool along_x, std::size_t index) {
    const StreetPlan& plan = terrain_.plan();
    const double center = along_x ? plan.street_y[index] : plan.street_x[index];
    const auto& crossings = along_x ? plan.street_x : plan.street_y;
    const double half = 0.5 * plan.street_width_m;
    Random random(seed_, along_x ? "world/street-x" : "world/street-y", index);
    const auto frame_at = [&](double s, double t, double turn) {
      const Eigen::Vector3d p = along_x ? terrain_.on_ground(s, t) : terrain_.on_ground(t, s);
      return terrain_.frame().at(p, turn + (along_x ? 0.0 : 0.5 * std::numbers::pi));
    };
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      const double from = crossings[i] + half + 4.5;
      const double to = crossings[i + 1] - half - 4.5;
      for (const double side : {-1.0, 1.0}) {
        for (double s = from + random.uniform(0.0, 6.0); s < to;
             s += options_.tree_spacing_m * random.uniform(0.6, 1.5)) {
          const double t = center + side * (half + random.uniform(0.9, 1.4));
          const Eigen::Vector2d at = along_x ? Eigen::Vector2d(s, t) : Eigen::Vector2d(t, s);
          plant_tree(at, random.uniform(4.5, 8.0));
        }
        for (double s = from + random.uniform(2.0, 8.0); s < to; s += random.uniform(14.0, 20.0)) {
          const double turn = (side > 0) == along_x ? std::numbers::pi : 0.0;
          build_lamp_post(frame_at(s, center + side * (half + 0.5), turn), next_seed(), builder_);
        }
        for (double s = from; s < to; s += random.uniform(8.0, 18.0)) {
          build_street_furniture(
              frame_at(s, center + side * (half + 0.6), 0.0), next_seed(), contrast_, builder_);
        }
      }
      park_cars(frame_at, from + 2.0, to - 2.0, center, random);
    }
  }

 private:
  template <class FrameAt>
  void park_cars(const FrameAt& frame_at, double from, double to, double center, Random& random) {
    const double t = center + 0.5 * terrain_.plan().street_width_m - 1.2;
    for (double s = from + 2.6; s < to - 2.4; s += 6.0) {
      if (random.uniform() < 0.45) continue;
      build_car(
          frame_at(s + random.uniform(-0.3, 0.3),
                   t + random.uniform(-0.1, 0.1),
                   (random.uniform() < 0.5 ? std::numbers::pi : 0.0) + random.uniform(-0.03, 0.03)),
          next_seed(),
          contrast_,
          builder_);
    }
  }

  void plant_tree(const Eigen::Vector2d& at, double height) {
    const Eigen::Vector3d foot = terrain_.on_ground(at.x(), at.y());
    build_tree(terrain_.frame().at(foot), height, next_seed(), builder_);
  }

  /// Trees, lamps, furniture and parked cars along one street.

  [[nodiscard]] std::uint64_t next_seed() { return seed_ * 1000003U + 500000U + count_++; }

  const WorldOptions& options_;
  const Terrain& terrain_;
  float contrast_;
  std::uint64_t seed_;
  MeshBuilder& builder_;
  std::uint64_t count_ = 0;
};

}  // namespace

void line_streets(const WorldOptions& options,
                  const Terrain& terrain,
                  float contrast,
                  std::uint64_t seed,
                  MeshBuilder& builder) {
  StreetLining lining(options, terrain, contrast, seed, builder);
  for (std::size_t i = 0; i < terrain.plan().street_y.size(); ++i) lining.line_street(true, i);
  for (std::size_t i = 0; i < terrain.plan().street_x.size(); ++i) lining.line_street(false, i);
}

}  // namespace hybridfusion
