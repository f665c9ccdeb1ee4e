#include "second_round.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace hybridfusion {
namespace {

constexpr double kMinOverlap = 0.3;
constexpr std::size_t kSamples = 200;  // points of a view that are projected into the other

PhotoPair pair_of(std::uint32_t a, std::uint32_t b) {
  return {.first = std::min(a, b), .second = std::max(a, b)};
}

/// Groups of views that verified pairs connect: a representative per view.
std::vector<std::uint32_t> groups(std::size_t views, std::span<const VerifiedPair> verified) {
  std::vector<std::uint32_t> parent(views);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const VerifiedPair& pair : verified) {
    parent[root(pair.views.first)] = root(pair.views.second);
  }
  for (std::uint32_t v = 0; v < views; ++v) parent[v] = root(v);
  return parent;
}

/// Share of the points of view `a` that lie inside the image of view `b`.
double overlap(const SfmModel& model, std::uint32_t a, std::uint32_t b) {
  const Rigid3 camera_from_world = model.world_from_view[b]->inverse();
  const CameraIntrinsics& camera = model.camera_of(b);
  const auto& references = model.tracks_of_view[a];
  const std::size_t step = std::max<std::size_t>(1, references.size() / kSamples);
  double seen = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < references.size(); k += step) {
    const auto& point = model.points[references[k].track];
    if (!point || !model.tracks[references[k].track][references[k].element].active) continue;
    count += 1.0;
    const Eigen::Vector3d in_camera = camera_from_world * *point;
    if (!(in_camera.z() > 0.0)) continue;
    // Without distortion, which far outside the image folds points back into it.
    const Eigen::Vector2d pixel =
        camera.focal_px * in_camera.hnormalized() + camera.principal_point_px;
    if (pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < camera.width_px &&
        pixel.y() < camera.height_px) {
      seen += 1.0;
    }
  }
  return count > 0.0 ? seen / count : 0.0;
}

}  // namespace

std::vector<PhotoPair> second_round_pairs(const SfmModel& model,
                                          std::span<const VerifiedPair> verified,
                                          const GnssIngest& gnss,
                                          const PairOptions& options) {
  std::set<PhotoPair> known;
  for (const VerifiedPair& pair : verified) known.insert(pair.views);
  const std::vector<std::uint32_t> registered = model.registered();
  const std::vector<std::uint32_t> group = groups(model.world_from_view.size(), verified);
  std::set<PhotoPair> pairs;
  for (const std::uint32_t a : registered) {
    for (const std::uint32_t b : registered) {
      if (a >= b || group[a] == group[b]) continue;
      if (overlap(model, a, b) >= kMinOverlap || overlap(model, b, a) >= kMinOverlap) {
        pairs.insert(pair_of(a, b));
      }
    }
  }
  for (std::uint32_t left = 0; left < model.world_from_view.size(); ++left) {
    const auto& position = gnss.fixes[left].position_in_enu;
    if (model.world_from_view[left] || !position) continue;
    std::vector<std::pair<double, std::uint32_t>> others;
    for (const std::uint32_t view : registered) {
      const Eigen::Vector3d gap = model.world_from_view[view]->translation - *position;
      others.emplace_back(gap.head<2>().squaredNorm(), view);
    }
    const auto kept =
        std::min(others.size(), static_cast<std::size_t>(2 * options.spatial_neighbors));
    std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(kept));
    for (std::size_t k = 0; k < kept; ++k) {
      const PhotoPair pair = pair_of(left, others[k].second);
      if (!known.contains(pair)) pairs.insert(pair);
    }
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace hybridfusion
