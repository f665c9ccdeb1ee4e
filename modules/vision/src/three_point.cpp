#include "resection.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

/// Real positive roots of c[0] + c[1] x + ... + c[4] x^4.
std::vector<double> positive_quartic_roots(const std::array<double, 5>& c) {
  int degree = 4;
  const double largest = std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2]), std::abs(c[3])});
  while (degree > 0 && std::abs(c[static_cast<std::size_t>(degree)]) < 1e-14 * largest) --degree;
  if (degree == 0) return {};
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  for (int i = 1; i < degree; ++i) companion(i, i - 1) = 1.0;
  for (int i = 0; i < degree; ++i) {
    companion(i, degree - 1) =
        -c[static_cast<std::size_t>(i)] / c[static_cast<std::size_t>(degree)];
  }
  std::vector<double> roots;
  for (const std::complex<double>& root : companion.eigenvalues()) {
    // Double roots come out as close complex pairs: their real part is good to half the digits.
    if (std::abs(root.imag()) < 1e-6 * (1.0 + std::abs(root.real())) && root.real() > 0.0) {
      roots.push_back(root.real());
    }
  }
  return roots;
}

}  // namespace

std::vector<Rigid3> world_from_camera_by_three_points(
    std::span<const Eigen::Vector2d, 3> normalized, std::span<const Eigen::Vector3d, 3> points) {
  std::array<Eigen::Vector3d, 3> rays;
  for (std::size_t i = 0; i < 3; ++i) rays[i] = normalized[i].homogeneous().normalized();
  const double a2 = (points[1] - points[2]).squaredNorm();
  const double b2 = (points[0] - points[2]).squaredNorm();
  const double c2 = (points[0] - points[1]).squaredNorm();
  if (!(a2 > 0.0 && b2 > 0.0 && c2 > 0.0)) return {};
  const double cos_a = rays[1].dot(rays[2]);
  const double cos_b = rays[0].dot(rays[2]);
  const double cos_c = rays[0].dot(rays[1]);

  // s2 = u s1, s3 = v s1; eliminating u leaves Grunert's quartic in v (Haralick et al., eq. 9).
  const double p = (a2 - c2) / b2;
  const double q = (a2 + c2) / b2;
  const double r = (b2 - c2) / b2;
  const double s = (b2 - a2) / b2;
  const double ratio_c = c2 / b2;
  const double ratio_a = a2 / b2;
  const std::array<double, 5> quartic = {
      (1.0 + p) * (1.0 + p) - 4.0 * ratio_a * cos_c * cos_c,
      4.0 * (-p * (1.0 + p) * cos_b + 2.0 * ratio_a * cos_c * cos_c * cos_b -
             (1.0 - q) * cos_a * cos_c),
      2.0 * (p * p - 1.0 + 2.0 * p * p * cos_b * cos_b + 2.0 * r * cos_a * cos_a -
             4.0 * q * cos_a * cos_b * cos_c + 2.0 * s * cos_c * cos_c),
      4.0 * (p * (1.0 - p) * cos_b - (1.0 - q) * cos_a * cos_c +
             2.0 * ratio_c * cos_a * cos_a * cos_b),
      (p - 1.0) * (p - 1.0) - 4.0 * ratio_c * cos_a * cos_a};

  std::vector<Rigid3> poses;
  for (const double v : positive_quartic_roots(quartic)) {
    const double denominator = 2.0 * (cos_c - v * cos_a);
    if (std::abs(denominator) < 1e-12) continue;
    const double u = ((-1.0 + p) * v * v - 2.0 * p * cos_b * v + 1.0 + p) / denominator;
    const double scale2 = b2 / (1.0 + v * v - 2.0 * v * cos_b);
    if (!(u > 0.0) || !(scale2 > 0.0)) continue;
    const double depth = std::sqrt(scale2);
    const std::array<Eigen::Vector3d, 3> in_camera = {
        depth * rays[0], depth * u * rays[1], depth * v * rays[2]};
    const auto world_from_camera = fit_rigid3(points, in_camera);
    if (world_from_camera) poses.push_back(*world_from_camera);
  }
  return poses;
}

}  // namespace hybridfusion
