#include "similarity_fit.hpp"

#include "robust_statistics.hpp"
#include "rotation.hpp"

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
constexpr int kRefinements = 30;
constexpr double kCauchyWidth = 2.0;

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

SimilarityFit refine_similarity(std::span<const PositionPair> pairs,
                                const Sim3& start,
                                const std::optional<UpPrior>& up) {
  using Matrix7 = Eigen::Matrix<double, 7, 7>;
  using Vector7 = Eigen::Matrix<double, 7, 1>;
  SimilarityFit fit{.enu_from_world = start};
  Sim3& sim = fit.enu_from_world;
  Matrix7 gnss_normal = Matrix7::Zero();
  for (int iteration = 0; iteration < kRefinements; ++iteration) {
    std::vector<double> norms;
    for (const PositionPair& pair : pairs) norms.push_back(weighted_residual(pair, sim).norm());
    // Stated sigmas may be optimistic: the loss is at least as wide as what is found.
    const double width = kCauchyWidth * std::max(1.0, median(norms));
    gnss_normal.setZero();
    Vector7 gradient = Vector7::Zero();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Eigen::Vector3d turned = sim.rotation * pairs[i].in_world;
      Eigen::Matrix<double, 3, 7> jacobian;  // translation, rotation (left), log scale
      jacobian << Eigen::Matrix3d::Identity(), -skew(sim.scale * turned), sim.scale * turned;
      jacobian = pairs[i].sigma_m.cwiseInverse().asDiagonal() * jacobian;
      const double weight = 1.0 / (1.0 + std::pow(norms[i] / width, 2.0));
      gnss_normal += weight * jacobian.transpose() * jacobian;
      gradient += weight * jacobian.transpose() * weighted_residual(pairs[i], sim);
    }
    Matrix7 normal = gnss_normal;
    if (up) {
      // Horizontal components of the up direction; d (R u)/d turn = -[R u]x.
      const Eigen::Vector3d turned = sim.rotation * up->up_in_world;
      Eigen::Matrix<double, 3, 7> jacobian = Eigen::Matrix<double, 3, 7>::Zero();
      jacobian.middleCols<3>(3) = -skew(turned) / up->sigma_rad;
      const Eigen::Vector3d residual = (turned - Eigen::Vector3d::UnitZ()) / up->sigma_rad;
      normal += jacobian.transpose() * jacobian;
      gradient += jacobian.transpose() * residual;
    }
    const Vector7 step = -normal.ldlt().solve(gradient);
    if (!step.allFinite()) break;
    const Eigen::Quaterniond turn = rotation_exp(step.segment<3>(3));
    sim.rotation = (turn * sim.rotation).normalized();
    sim.translation += step.head<3>();
    sim.scale *= std::exp(step[6]);
    if (step.norm() < 1e-9) break;
  }
  const Matrix7 covariance =
      (gnss_normal + 1e-12 * gnss_normal.trace() * Matrix7::Identity()).inverse();
  fit.tilt_sigma_rad = std::sqrt(std::max(covariance(3, 3), covariance(4, 4)));
  std::vector<double> horizontal;
  std::vector<double> vertical;
  for (const PositionPair& pair : pairs) {
    const Eigen::Vector3d r = weighted_residual(pair, sim);
    horizontal.insert(horizontal.end(), {r.x(), r.y()});
    vertical.push_back(r.z());
  }
  fit.horizontal_ratio = robust_sigma_about_zero(std::move(horizontal));
  fit.vertical_ratio = robust_sigma_about_zero(std::move(vertical));
  return fit;
}

}  // namespace hybridfusion
