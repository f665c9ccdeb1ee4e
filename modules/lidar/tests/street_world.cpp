#include "street_world.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace hybridfusion::testing {
namespace {

/// Houses, gaps and posts of random size along a line, `side_m` from it on both sides.
void line_street(const Eigen::Vector2d& from,
                 const Eigen::Vector2d& to,
                 double side_m,
                 Random& random,
                 std::vector<Box>& boxes) {
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d left(-along.y(), along.x());
  for (const double side : {-1.0, 1.0}) {
    double at = 0.0;
    while (at < (to - from).norm()) {
      const double width = random.uniform(4.0, 14.0);
      const double setback = side_m + random.uniform(0.0, 2.5);
      const Eigen::Vector2d a = from + at * along + side * setback * left;
      const Eigen::Vector2d b = a + width * along + side * random.uniform(4.0, 8.0) * left;
      const Eigen::Vector2d low = a.cwiseMin(b);
      const Eigen::Vector2d high = a.cwiseMax(b);
      boxes.push_back(
          {.min = {low.x(), low.y(), 0.0}, .max = {high.x(), high.y(), random.uniform(4.0, 11.0)}});
      const Eigen::Vector2d post = from + (at + width + 1.0) * along + side * (side_m - 1.5) * left;
      boxes.push_back({.min = {post.x() - 0.15, post.y() - 0.15, 0.0},
                       .max = {post.x() + 0.15, post.y() + 0.15, 5.0}});
      at += width + random.uniform(1.5, 6.0);
    }
  }
}

}  // namespace

RoundedPath::RoundedPath(const std::vector<Eigen::Vector2d>& corners, double radius_m) {
  Eigen::Vector2d at = corners.front();
  const auto add = [&](double heading, double curvature, double length) {
    pieces_.push_back({.start = at,
                       .heading_rad = heading,
                       .curvature = curvature,
                       .begin_m = length_m_,
                       .length_m = length});
    length_m_ += length;
  };
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d d = corners[i] - at;
    const double heading = std::atan2(d.y(), d.x());
    if (i + 1 == corners.size()) {
      add(heading, 0.0, d.norm());
      break;
    }
    const Eigen::Vector2d n = corners[i + 1] - corners[i];
    const double turn = std::remainder(std::atan2(n.y(), n.x()) - heading, 2.0 * M_PI);
    const double cut = radius_m * std::tan(0.5 * std::abs(turn));
    add(heading, 0.0, d.norm() - cut);
    at = corners[i] - cut * d.normalized();
    add(heading, std::copysign(1.0 / radius_m, turn), radius_m * std::abs(turn));
    at = corners[i] + cut * n.normalized();
  }
}

Rigid3 RoundedPath::pose_at(double distance_m) const {
  auto piece = std::ranges::find_if(pieces_, [&](const Piece& candidate) {
    return distance_m < candidate.begin_m + candidate.length_m;
  });
  if (piece == pieces_.end()) --piece;
  const double along = distance_m - piece->begin_m;
  const double yaw = piece->heading_rad + piece->curvature * along;
  Eigen::Vector2d at = piece->start;
  if (piece->curvature == 0.0) {
    at += along * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
  } else {
    at += Eigen::Vector2d(std::sin(yaw) - std::sin(piece->heading_rad),
                          std::cos(piece->heading_rad) - std::cos(yaw)) /
          piece->curvature;
  }
  return {
      .rotation =
          Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(0.01 + 0.012 * std::sin(0.31 * distance_m), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(0.015 * std::sin(0.23 * distance_m), Eigen::Vector3d::UnitX()),
      .translation = {at.x(), at.y(), 1.2 + 0.02 * std::sin(0.4 * distance_m)}};
}

double driven_m(double t, double speed_mps) {
  constexpr double kRamp_s = 3.0;
  const double u = (t - kStandstill_s) / kRamp_s;
  if (u <= 0.0) return 0.0;
  const double v = std::min(u, 1.0);
  const double ramp = v * v * v * v * (v * v - 3.0 * v + 2.5);
  return speed_mps * kRamp_s * (ramp + std::max(0.0, u - 1.0));
}

std::function<Rigid3(double)> drive_along(const std::vector<Eigen::Vector2d>& corners,
                                          double speed_mps) {
  const auto path = std::make_shared<RoundedPath>(corners, 8.0);
  return [path, speed_mps](double t) { return path->pose_at(driven_m(t, speed_mps)); };
}

TunnelRound tunnel_round(std::uint64_t seed, double speed_mps) {
  TunnelRound round;
  Random random(seed, "test/street_world");
  line_street({-75, 0}, {132, 0}, 7.0, random, round.world.boxes);
  line_street({140, 10}, {140, 50}, 7.0, random, round.world.boxes);
  line_street({-80, 10}, {-80, 50}, 7.0, random, round.world.boxes);
  round.world.boxes.push_back({.min = {-60, 64, 0}, .max = {120, 66, 6}});
  round.world.boxes.push_back({.min = {-60, 54, 0}, .max = {120, 56, 6}});
  round.world.boxes.push_back({.min = {-60, 54, 6}, .max = {120, 66, 7}});
  round.world.max_range_m = 50.0;
  std::vector<Eigen::Vector2d> corners{{0, 0}};
  constexpr int kMaxLaps = 12;
  for (int lap = 0; lap < kMaxLaps; ++lap) {
    corners.insert(corners.end(), {{140, 0}, {140, 60}, {-80, 60}, {-80, 0}});
  }
  corners.emplace_back(140, 0);
  round.world.pose = drive_along(corners, speed_mps);
  const RoundedPath lap({{0, 0}, {140, 0}, {140, 60}, {-80, 60}, {-80, 0}, {0, 0}}, 8.0);
  round.lap_s = kStandstill_s + 1.5 + lap.length_m() / speed_mps;
  return round;
}

DriveWorld rolling_street(std::uint64_t seed, double speed_mps) {
  Random random(seed, "test/rolling_street");
  // Whoever is fast goes straight on for the time of the tests; others turn at 2 m/s^2 at most.
  constexpr double kLateralAcceleration_mps2 = 2.0;
  const double radius_m = std::max(12.0, speed_mps * speed_mps / kLateralAcceleration_mps2);
  const double corner_m = 45.0 + radius_m;
  const Eigen::Vector2d corner(corner_m, 0.0);
  const Eigen::Vector2d end(corner_m, 200.0 + radius_m);
  DriveWorld world{.max_range_m = 60.0};
  line_street({-60.0, 0.0}, {corner_m - 8.0, 0.0}, 7.0, random, world.boxes);
  line_street({corner_m, 14.0}, end, 7.0, random, world.boxes);
  const RoundedPath path({Eigen::Vector2d(0.0, 0.0), corner, end}, radius_m);
  world.pose = [path, speed_mps](double t) { return path.pose_at(5.0 + speed_mps * t); };
  return world;
}

DriveWorld lookalike_street(double speed_mps) {
  DriveWorld world;
  for (double x = -60.0; x < 400.0; x += 30.0) {
    world.boxes.push_back({.min = {x, 7, 0}, .max = {x + 9, 14, 7}});
    world.boxes.push_back({.min = {x + 14, 8.5, 0}, .max = {x + 25, 15, 5}});
    world.boxes.push_back({.min = {x + 3, -13, 0}, .max = {x + 19, -8, 9}});
  }
  world.max_range_m = 40.0;
  world.pose = drive_along({{0, 0}, {350, 0}}, speed_mps);
  return world;
}

}  // namespace hybridfusion::testing
