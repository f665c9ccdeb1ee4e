#include "pair_choice.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinSharedPoints = 40;
constexpr double kFullyShared = 150.0;  // More shared points do not make a pair better.

std::map<std::uint32_t, std::vector<std::uint32_t>> shared_points(
    const Reconstruction& reconstruction, std::uint32_t reference) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> shared;
  for (const Observation& o : reconstruction.views[reference].observations) {
    for (const ViewObservation& seen : reconstruction.points[o.point].track) {
      if (seen.view == reference) continue;
      if (!reconstruction.views[seen.view].enu_from_camera) continue;
      shared[seen.view].push_back(o.point);
    }
  }
  return shared;
}

double median_angle_rad(const Reconstruction& reconstruction,
                        const std::vector<std::uint32_t>& points,
                        const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b) {
  std::vector<double> angles;
  angles.reserve(points.size());
  for (const std::uint32_t index : points) {
    const Eigen::Vector3d p = reconstruction.points[index].point_in_enu;
    const Eigen::Vector3d u = (p - a).normalized();
    const Eigen::Vector3d v = (p - b).normalized();
    angles.push_back(std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::ranges::nth_element(angles, middle);
  return *middle;
}

struct Scored {
  StereoPartner partner;
  double score = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // Of the baseline.
};

}  // namespace

std::vector<StereoPartner> choose_partners(const Reconstruction& reconstruction,
                                           std::uint32_t reference,
                                           const DensifyOptions& options) {
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  const View& view = reconstruction.views[reference];
  const Eigen::Vector3d centre = view.enu_from_camera->translation;
  std::vector<Scored> scored;
  for (auto& [other, points] : shared_points(reconstruction, reference)) {
    if (points.size() < kMinSharedPoints) continue;
    const Eigen::Vector3d other_centre = reconstruction.views[other].enu_from_camera->translation;
    const double angle = median_angle_rad(reconstruction, points, centre, other_centre);
    if (angle < options.min_angle_deg * kRadPerDeg || angle > options.max_angle_deg * kRadPerDeg) {
      continue;
    }
    const double octaves = std::log2(angle / (options.best_angle_deg * kRadPerDeg));
    const double share = std::min(1.0, static_cast<double>(points.size()) / kFullyShared);
    scored.push_back({.partner = {other, std::move(points), angle},
                      .score = share * std::exp(-octaves * octaves),
                      .direction = (other_centre - centre).normalized()});
  }
  std::vector<StereoPartner> chosen;
  std::vector<Eigen::Vector3d> directions;
  while (!scored.empty() && chosen.size() < static_cast<std::size_t>(options.num_neighbors)) {
    // A second baseline along the same line sees the same edges occluded: halve its score.
    const auto gain = [&](const Scored& s) {
      double worst = 1.0;
      for (const Eigen::Vector3d& d : directions) {
        worst = std::min(worst, 1.0 - 0.5 * std::max(0.0, d.dot(s.direction)));
      }
      return s.score * worst;
    };
    const auto best = std::ranges::max_element(scored, {}, gain);
    directions.push_back(best->direction);
    chosen.push_back(std::move(best->partner));
    scored.erase(best);
  }
  return chosen;
}

std::vector<std::uint32_t> overlapping_views(const Reconstruction& reconstruction,
                                             std::uint32_t reference,
                                             std::size_t max_count) {
  std::vector<std::pair<std::size_t, std::uint32_t>> counts;
  for (const auto& [view, points] : shared_points(reconstruction, reference)) {
    counts.emplace_back(points.size(), view);
  }
  std::ranges::sort(counts, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  counts.resize(std::min(counts.size(), max_count));
  std::vector<std::uint32_t> views;
  for (const auto& [count, view] : counts) views.push_back(view);
  return views;
}

}  // namespace hybridfusion
