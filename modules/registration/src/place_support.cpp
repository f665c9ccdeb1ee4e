#include "place_support.hpp"

#include "fine_statistics.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr double kSearch_m = 0.5;     // for the plane that a facade point may lie on
constexpr double kTolerance_m = 0.1;  // right poses keep 2 to 5 cm, wrong ones lie at random

/// Where the surfaces lead from a place, and what they say there.
struct AlignedPlace {
  Rigid3 pose = {};
  double support = 0.0;
  double supply = 0.0;
};

Expected<AlignedPlace> align_place(FineInputs& inputs,
                                   const PreparedClouds& clouds,
                                   const OutlinePlace& place,
                                   const FineOptions& options,
                                   const RunContext& ctx) {
  FineOptions rigid = options;
  rigid.estimate_scale = false;
  const auto fine =
      align_fine(inputs, place.vision_from_leveled, clouds.lidar_centroid, rigid, ctx);
  if (!fine && fine.error().code == ErrorCode::kCancelled) return std::unexpected(fine.error());
  AlignedPlace aligned{.pose = place.vision_from_leveled};
  if (fine) {  // else no surface in common
    aligned.pose = fine->vision_from_lidar;
    aligned.support = facade_support(inputs, clouds, aligned.pose, options, ctx);
  }
  aligned.supply = facade_supply(inputs, clouds, aligned.pose, options, ctx);
  return aligned;
}

/// Where the facades among the samples are: their middle, and how far nine tenths of them reach.
struct Footprint {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double radius_m = 0.0;
};

Footprint footprint_of(const std::vector<FineSample>& samples) {
  Footprint footprint;
  std::vector<double> distances;
  for (const FineSample& sample : samples) {
    if (!sample.is_vertical) continue;
    footprint.middle += sample.point;
    distances.push_back(0.0);
  }
  if (distances.empty()) return footprint;
  footprint.middle /= static_cast<double>(distances.size());
  std::size_t k = 0;
  for (const FineSample& sample : samples) {
    if (!sample.is_vertical) continue;
    distances[k++] = (sample.point - footprint.middle).head<2>().norm();
  }
  footprint.radius_m = quantile(std::move(distances), 0.9);
  return footprint;
}

/// The chosen place against the others.
SurfaceChoice choice_among(const std::vector<AlignedPlace>& places,
                           const Eigen::Vector3d& centroid,
                           const VerdictOptions& options) {
  constexpr double kSame_m = 1.0;
  constexpr double kSame_rad = 2.0 * std::numbers::pi / 180.0;
  constexpr double kMinSupply = 0.5;
  std::size_t most = 0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (places[k].support > places[most].support) most = k;
  }
  if (places[most].support < options.min_facade_support) most = 0;
  const AlignedPlace& chosen = places[most];
  SurfaceChoice choice{.place = most, .is_compared = true, .support = chosen.support};
  for (const AlignedPlace& other : places) {
    if (are_near(other.pose, chosen.pose, centroid, kSame_m, kSame_rad)) continue;
    choice.rival_support = std::max(choice.rival_support, other.support);
    if (other.supply < kMinSupply * chosen.supply) choice.is_compared = false;
  }
  return choice;
}

}  // namespace

bool are_near(const Rigid3& a,
              const Rigid3& b,
              const Eigen::Vector3d& centroid,
              double max_shift_m,
              double max_turn_rad) {
  const Eigen::Vector3d shift = a * centroid - b * centroid;
  return shift.head<2>().norm() < max_shift_m && std::abs(shift.z()) < 0.5 &&
         rotation_distance_rad(a.rotation, b.rotation) < max_turn_rad;
}

double facade_support(FineInputs& inputs,
                      const PreparedClouds& clouds,
                      const Rigid3& vision_from_leveled,
                      const FineOptions& options,
                      const RunContext& ctx) {
  const std::vector<FineSample>& samples = inputs.samples;
  std::vector<Neighbor> nearest(samples.size(), {.squared_distance_m2 = kSearch_m * kSearch_m});
  parallel_for(ctx, samples.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (!samples[k].is_vertical) continue;
      const Eigen::Vector3d at = vision_from_leveled * samples[k].point;
      nearest[k] = inputs.planes.tree().nearest(at.cast<float>());
    }
  });
  const auto is_met = [&](std::size_t k) {
    return nearest[k].squared_distance_m2 < static_cast<float>(kSearch_m * kSearch_m);
  };
  std::vector<std::size_t> wanted;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (is_met(k)) wanted.push_back(nearest[k].index);
  }
  inputs.planes.prepare(std::move(wanted), ctx);
  double facades = 0.0;
  double supported = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!samples[k].is_vertical) continue;
    facades += 1.0;
    if (!is_met(k)) continue;
    const LazyPlanes::Plane& plane = inputs.planes.at(nearest[k].index);
    const Eigen::Vector3d normal = plane.normal.cast<double>();
    const Eigen::Vector3d gap = vision_from_leveled * samples[k].point - plane.mean.cast<double>();
    if (static_cast<double>(plane.curvature) <= options.max_curvature &&
        std::abs(normal.dot(vision_from_leveled.rotation * samples[k].normal)) >=
            options.min_normal_cosine &&
        std::abs(normal.dot(gap)) < kTolerance_m) {
      supported += 1.0;
    }
  }
  // Samples are drawn where the clouds meet; what lies outside has no support either.
  const PoseEvidence evidence =
      judge_pose(clouds.maps, clouds.lidar_maps, vision_from_leveled, 0.0);
  return evidence.facade_inside_share * supported / std::max(1.0, facades);
}

double facade_supply(FineInputs& inputs,
                     const PreparedClouds& clouds,
                     const Rigid3& vision_from_leveled,
                     const FineOptions& options,
                     const RunContext& ctx) {
  constexpr std::size_t kProbes = 4000;
  constexpr float kMaxRise = 0.3F;  // of a normal, as of the samples
  const Footprint footprint = footprint_of(inputs.samples);
  const Eigen::Vector2f middle = (vision_from_leveled * footprint.middle).head<2>().cast<float>();
  const auto limit = static_cast<float>(footprint.radius_m * footprint.radius_m);
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < clouds.vision.size(); ++i) {
    if ((clouds.vision[i].head<2>() - middle).squaredNorm() < limit) near.push_back(i);
  }
  const std::size_t stride = near.size() / kProbes + 1;
  std::vector<std::size_t> probes;
  for (std::size_t k = 0; k < near.size(); k += stride) probes.push_back(near[k]);
  inputs.planes.prepare(probes, ctx);
  const auto vertical = std::ranges::count_if(probes, [&](std::size_t i) {
    const LazyPlanes::Plane& plane = inputs.planes.at(i);
    return static_cast<double>(plane.curvature) <= options.max_curvature &&
           std::abs(plane.normal.z()) < kMaxRise;
  });
  return static_cast<double>(stride) * static_cast<double>(vertical);
}

Expected<SurfaceChoice> choose_by_surfaces(FineInputs& inputs,
                                           const PreparedClouds& clouds,
                                           const OutlinePlaces& found,
                                           const RegistrationOptions& options,
                                           const RunContext& ctx) {
  const double limit = options.verdict.doubtful_peak_ratio * found.places.front().score;
  const auto alike = static_cast<std::size_t>(std::ranges::count_if(
      found.places, [&](const OutlinePlace& place) { return place.score >= limit; }));
  if (alike < 2 || !found.is_vision_whole) return SurfaceChoice{};
  std::vector<AlignedPlace> aligned;
  for (std::size_t k = 0; k < alike; ++k) {
    HF_TRY(const AlignedPlace place,
           align_place(inputs, clouds, found.places[k], options.fine, ctx));
    aligned.push_back(place);
  }
  return choice_among(aligned, clouds.lidar_centroid, options.verdict);
}

}  // namespace hybridfusion
