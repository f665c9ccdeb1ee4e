#include "fine_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Cholesky>

namespace hybridfusion {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

void fill_statistics(std::span<const FinePair> pairs, double held_out_near, FineResult& result) {
  std::vector<double> held_out;
  std::array<double, 2> squares{};
  std::array<double, 2> counts{};
  for (const FinePair& pair : pairs) {
    const auto c = static_cast<std::size_t>(pair.is_vertical);
    squares[c] += pair.residual_m * pair.residual_m;
    counts[c] += 1.0;
    if (pair.is_held_out) held_out.push_back(std::abs(pair.residual_m));
  }
  result.num_horizontal = static_cast<std::size_t>(counts[0]);
  result.num_vertical = static_cast<std::size_t>(counts[1]);
  result.horizontal_rms_m = std::sqrt(squares[0] / std::max(1.0, counts[0]));
  result.vertical_rms_m = std::sqrt(squares[1] / std::max(1.0, counts[1]));
  result.held_out_share = static_cast<double>(held_out.size()) / std::max(1.0, held_out_near);
  result.held_out_median_m = quantile(std::move(held_out), 0.5);
}

Matrix7d jackknife_covariance(std::span<const FinePair> pairs, bool free_scale) {
  constexpr double kBlocksAcross = 6.0;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = -low;
  for (const FinePair& pair : pairs) {
    low = low.cwiseMin(pair.point.head<2>());
    high = high.cwiseMax(pair.point.head<2>());
  }
  const double side_m = std::max(2.0, (high - low).maxCoeff() / kBlocksAcross);
  std::map<std::pair<int, int>, std::pair<Matrix7d, Vector7d>> blocks;
  Matrix7d normal = Matrix7d::Identity() * 1e-6;
  Vector7d right = Vector7d::Zero();
  for (const FinePair& pair : pairs) {
    const Eigen::Vector2d cell = (pair.point.head<2>() - low) / side_m;
    auto& [block_normal, block_right] =
        blocks
            .try_emplace({static_cast<int>(cell.x()), static_cast<int>(cell.y())},
                         Matrix7d::Zero(),
                         Vector7d::Zero())
            .first->second;
    block_normal += pair.weight * pair.jacobian * pair.jacobian.transpose();
    block_right -= pair.weight * pair.residual_m * pair.jacobian;
  }
  for (const auto& [cell, block] : blocks) {
    normal += block.first;
    right += block.second;
  }
  const auto count = static_cast<double>(blocks.size());
  const Eigen::Index free = free_scale ? 7 : 6;
  std::vector<Vector7d> updates;
  Vector7d mean = Vector7d::Zero();
  for (const auto& [cell, block] : blocks) {
    Vector7d update = Vector7d::Zero();
    update.head(free) = (normal - block.first)
                            .topLeftCorner(free, free)
                            .ldlt()
                            .solve((right - block.second).head(free));
    updates.push_back(update);
    mean += update / count;
  }
  Matrix7d covariance = Matrix7d::Zero();
  for (const Vector7d& update : updates) {
    covariance += (count - 1.0) / count * (update - mean) * (update - mean).transpose();
  }
  return covariance;
}

Matrix6d tangent_covariance(const Matrix7d& centred,
                            const Rigid3& pose,
                            const Eigen::Vector3d& centre) {
  // [v; w] about the centre to the right perturbation: rho = R^T (v + (c - t) x w), phi = R^T w.
  const Eigen::Matrix3d back = pose.rotation.toRotationMatrix().transpose();
  const Eigen::Vector3d arm = centre - pose.translation;
  Eigen::Matrix3d cross;
  cross << 0.0, -arm.z(), arm.y(), arm.z(), 0.0, -arm.x(), -arm.y(), arm.x(), 0.0;
  Matrix6d map = Matrix6d::Zero();
  map.topLeftCorner<3, 3>() = back;
  map.topRightCorner<3, 3>() = back * cross;
  map.bottomRightCorner<3, 3>() = back;
  return map * centred.topLeftCorner<6, 6>() * map.transpose();
}

double systematic_scale_sigma(std::span<const FinePair> pairs) {
  constexpr double kFacadeBias_m = 0.01;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double squares = 0.0;
  double count = 0.0;
  for (const FinePair& pair : pairs) {
    if (!pair.is_vertical) continue;
    mean += pair.point.head<2>();
    squares += pair.point.head<2>().squaredNorm();
    count += 1.0;
  }
  if (count < 1.0) return kFacadeBias_m;
  const double variance = squares / count - (mean / count).squaredNorm();
  return kFacadeBias_m / std::max(1.0, std::sqrt(std::max(0.0, variance)));
}

}  // namespace hybridfusion
