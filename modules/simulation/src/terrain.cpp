#include "terrain.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {

Terrain::Terrain(StreetPlan plan, double relief_m, std::uint64_t seed) : plan_(std::move(plan)) {
  Random random(seed, "world/terrain");
  const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double size = 2.0 * plan_.core_half_m.maxCoeff();
  const double grade = random.uniform(0.7, 1.3) * relief_m / std::min(size, 120.0);
  slope_ = grade * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  wave_m_ = 0.35 * relief_m;
  hills_m_ = 4.0 * std::min(1.0, relief_m);
  phase_ = {random.uniform(0.0, 6.0), random.uniform(0.0, 6.0)};
}

double Terrain::height(double x, double y) const {
  const double waves = std::sin(x / 21.0 + phase_.x()) * std::cos(y / 17.0 + phase_.y()) +
                       0.5 * std::sin((x + y) / 33.0 + 2.0 * phase_.y());
  const Eigen::Vector2d beyond(std::max(0.0, std::abs(x) - plan_.core_half_m.x() - 4.0),
                               std::max(0.0, std::abs(y) - plan_.core_half_m.y() - 4.0));
  const double rise = beyond.squaredNorm() / (beyond.squaredNorm() + 80.0 * 80.0);
  const double hills = std::sin(x / 47.0 + phase_.y()) * std::cos(y / 53.0 + phase_.x());
  const Eigen::Vector2d inside(std::clamp(x, -150.0, 150.0), std::clamp(y, -150.0, 150.0));
  return slope_.dot(inside) + wave_m_ * waves + hills_m_ * rise * hills;
}

GroundKind Terrain::kind(double x, double y) const {
  const Eigen::Vector2d half = plan_.core_half_m;
  if (std::abs(x) > half.x() || std::abs(y) > half.y() || !plan_.streets) return GroundKind::kGrass;
  const double w = 0.5 * plan_.street_width_m;
  const bool within_x = x > plan_.street_x.front() - w && x < plan_.street_x.back() + w;
  const bool within_y = y > plan_.street_y.front() - w && y < plan_.street_y.back() + w;
  const auto nearest = [](const std::vector<double>& lines, double value) {
    double best = 1e9;
    for (const double line : lines) best = std::min(best, std::abs(value - line));
    return best;
  };
  const double from_x = nearest(plan_.street_x, x);
  const double from_y = nearest(plan_.street_y, y);
  if ((from_x < w && within_y) || (from_y < w && within_x)) return GroundKind::kRoad;
  const double p = plan_.pavement_width_m;
  const bool near_x =
      from_x < w + p && y > plan_.street_y.front() - w - p && y < plan_.street_y.back() + w + p;
  const bool near_y =
      from_y < w + p && x > plan_.street_x.front() - w - p && x < plan_.street_x.back() + w + p;
  return near_x || near_y ? GroundKind::kPavement : GroundKind::kYard;
}

double Terrain::surface_height(double x, double y) const {
  return height(x, y) - (kind(x, y) == GroundKind::kRoad ? kKerbHeight_m : 0.0);
}

}  // namespace hybridfusion
