#include "similarity_fit.hpp"

#include "robust_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr int kSamples = 500;

Eigen::Vector3d weighted_residual(const PositionPair& pair, const Sim3& enu_from_world) {
  return (enu_from_world * pair.in_world - pair.in_enu).cwiseQuotient(pair.sigma_m);
}

double median_squared(std::span<const PositionPair> pairs, const Sim3& candidate, int dimensions) {
  std::vector<double> squares;
  squares.reserve(pairs.size());
  for (const PositionPair& pair : pairs) {
    squares.push_back(weighted_residual(pair, candidate).head(dimensions).squaredNorm());
  }
  return median(std::move(squares));
}

template <std::size_t Size>
std::array<std::uint32_t, Size> sample_distinct(std::uint32_t count, Random& random) {
  std::array<std::uint32_t, Size> sample{};
  for (std::size_t k = 0; k < Size;) {
    sample[k] = random.index(count);
    const auto end = sample.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::find(sample.begin(), end, sample[k]) == end) ++k;
  }
  return sample;
}

Expected<void> check_count(std::span<const PositionPair> pairs) {
  if (pairs.size() >= 3) return {};
  return fail(ErrorCode::kInsufficient,
              fmt::format("{} registered photos have a GNSS position, 3 are needed to place the "
                          "model on the map",
                          pairs.size()));
}

/// Second largest over the largest spread of the positions: 0 on a line.
double planar_spread(std::span<const PositionPair> pairs) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const PositionPair& pair : pairs) mean += pair.in_world / static_cast<double>(pairs.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const PositionPair& pair : pairs) {
    scatter += (pair.in_world - mean) * (pair.in_world - mean).transpose();
  }
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues();
  return std::sqrt(std::max(0.0, values[1]) / std::max(values[2], 1e-300));
}

}  // namespace

Expected<Sim3> least_median_similarity(std::span<const PositionPair> pairs, Random random) {
  if (auto enough = check_count(pairs); !enough) return std::unexpected(enough.error());
  constexpr double kMinSpread = 0.01;
  if (planar_spread(pairs) < kMinSpread) {
    return fail(ErrorCode::kDegenerate,
                "the photos lie on one line: the rotation about it is free");
  }
  Expected<Sim3> best = fail(ErrorCode::kDegenerate, "no three photos determine a similarity");
  double best_median = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kSamples; ++k) {
    const auto sample = sample_distinct<3>(static_cast<std::uint32_t>(pairs.size()), random);
    std::array<Eigen::Vector3d, 3> target;
    std::array<Eigen::Vector3d, 3> source;
    for (std::size_t i = 0; i < 3; ++i) {
      target[i] = pairs[sample[i]].in_enu;
      source[i] = pairs[sample[i]].in_world;
    }
    const auto candidate = fit_sim3(target, source);
    if (!candidate || !(candidate->scale > 0.0)) continue;
    const double value = median_squared(pairs, *candidate, 3);
    if (value < best_median) {
      best_median = value;
      best = *candidate;
    }
  }
  return best;
}

Expected<Sim3> least_median_upright_similarity(std::span<const PositionPair> pairs,
                                               const Eigen::Vector3d& up_in_world,
                                               Random random) {
  if (auto enough = check_count(pairs); !enough) return std::unexpected(enough.error());
  const Eigen::Quaterniond upright =
      Eigen::Quaterniond::FromTwoVectors(up_in_world, Eigen::Vector3d::UnitZ());
  Expected<Sim3> best = fail(ErrorCode::kDegenerate, "all photos were taken at one place");
  double best_median = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kSamples; ++k) {
    const auto sample = sample_distinct<2>(static_cast<std::uint32_t>(pairs.size()), random);
    const PositionPair& a = pairs[sample[0]];
    const PositionPair& b = pairs[sample[1]];
    const Eigen::Vector2d from = (upright * (b.in_world - a.in_world)).head<2>();
    const Eigen::Vector2d to = (b.in_enu - a.in_enu).head<2>();
    if (!(from.norm() > 0.0) || !(to.norm() > 0.0)) continue;
    const double heading = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    Sim3 candidate;
    candidate.rotation =
        (Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * upright).normalized();
    candidate.scale = to.norm() / from.norm();
    candidate.translation = a.in_enu - candidate.scale * (candidate.rotation * a.in_world);
    const double value = median_squared(pairs, candidate, 2);
    if (value < best_median) {
      best_median = value;
      best = candidate;
    }
  }
  if (!best) return best;
  std::vector<double> heights;
  for (const PositionPair& pair : pairs) {
    heights.push_back(pair.in_enu.z() - (*best * pair.in_world).z());
  }
  best->translation.z() += median(std::move(heights));
  return best;
}

}  // namespace hybridfusion
