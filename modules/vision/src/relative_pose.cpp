#include "relative_pose.hpp"

#include "five_point.hpp"
#include "rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <opencv2/calib3d.hpp>

namespace hybridfusion {
namespace {

constexpr double kConfidence = 0.9999;
constexpr int kMinIterations = 20;
constexpr int kRefinements = 5;

struct Points {
  std::span<const Eigen::Vector2d> first;
  std::span<const Eigen::Vector2d> second;
  double max_error2;
};

/// First-order geometric error, squared.
inline double sampson2(const Eigen::Matrix3d& e,
                       const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b) {
  const double lx = e(0, 0) * a.x() + e(0, 1) * a.y() + e(0, 2);
  const double ly = e(1, 0) * a.x() + e(1, 1) * a.y() + e(1, 2);
  const double lz = e(2, 0) * a.x() + e(2, 1) * a.y() + e(2, 2);
  const double mx = e(0, 0) * b.x() + e(1, 0) * b.y() + e(2, 0);
  const double my = e(0, 1) * b.x() + e(1, 1) * b.y() + e(2, 1);
  const double error = b.x() * lx + b.y() * ly + lz;
  return error * error / (lx * lx + ly * ly + mx * mx + my * my + 1e-300);
}

/// Sum of truncated errors; gives up once above `bound`.
double score(const Eigen::Matrix3d& e, const Points& points, double bound) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points.first.size(); ++i) {
    sum += std::min(points.max_error2, sampson2(e, points.first[i], points.second[i]));
    if (sum > bound) break;
  }
  return sum;
}

std::vector<std::uint32_t> inliers_of(const Eigen::Matrix3d& e, const Points& points) {
  std::vector<std::uint32_t> inliers;
  for (std::uint32_t i = 0; i < points.first.size(); ++i) {
    if (sampson2(e, points.first[i], points.second[i]) < points.max_error2) inliers.push_back(i);
  }
  return inliers;
}

/// Points in front of both cameras, for the rays x1 and x2 = R x1 depth + t.
int count_in_front(const Rigid3& second_from_first,
                   const Points& points,
                   std::span<const std::uint32_t> members) {
  const Eigen::Matrix3d r = second_from_first.rotation.toRotationMatrix();
  const Eigen::Vector3d& t = second_from_first.translation;
  int count = 0;
  for (const std::uint32_t i : members) {
    const Eigen::Vector3d a = r * points.first[i].homogeneous();
    const Eigen::Vector3d b = points.second[i].homogeneous();
    // Least squares of d1 a + t = d2 b.
    const double aa = a.squaredNorm();
    const double bb = b.squaredNorm();
    const double ab = a.dot(b);
    const double determinant = aa * bb - ab * ab;
    const double d1 = (-a.dot(t) * bb + ab * b.dot(t)) / determinant;
    const double d2 = (aa * b.dot(t) - ab * a.dot(t)) / determinant;
    if (d1 > 0.0 && d2 > 0.0) ++count;
  }
  return count;
}

Rigid3 pose_from_essential(const Eigen::Matrix3d& e,
                           const Points& points,
                           std::span<const std::uint32_t> members) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(e, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  Eigen::Matrix3d v = svd.matrixV();
  if (u.determinant() < 0.0) u.col(2) *= -1.0;
  if (v.determinant() < 0.0) v.col(2) *= -1.0;
  Eigen::Matrix3d w;
  w << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  Rigid3 best;
  int best_count = -1;
  for (const Eigen::Matrix3d& rotation : {Eigen::Matrix3d(u * w * v.transpose()),
                                          Eigen::Matrix3d(u * w.transpose() * v.transpose())}) {
    for (const double sign : {1.0, -1.0}) {
      const Rigid3 pose{.rotation = Eigen::Quaterniond(rotation).normalized(),
                        .translation = sign * u.col(2)};
      const int count = count_in_front(pose, points, members);
      if (count > best_count) {
        best_count = count;
        best = pose;
      }
    }
  }
  return best;
}

/// Gauss-Newton on the Sampson errors of the members, its denominator held within a step. The five
/// parameters turn the rotation (right perturbation) and the direction of the translation.
Rigid3 refine(Rigid3 pose, const Points& points, std::span<const std::uint32_t> members) {
  for (int iteration = 0; iteration < kRefinements; ++iteration) {
    const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
    const Eigen::Matrix3d e = essential_of(pose);
    const Eigen::Vector3d t = pose.translation;
    const Eigen::Vector3d u = t.unitOrthogonal();
    const Eigen::Vector3d v = t.cross(u);
    std::array<Eigen::Matrix3d, 5> derivatives;
    for (int k = 0; k < 3; ++k) {
      derivatives[static_cast<std::size_t>(k)] = e * skew(Eigen::Vector3d::Unit(k));
    }
    derivatives[3] = skew(u) * rotation;
    derivatives[4] = skew(v) * rotation;
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 1> gradient = Eigen::Matrix<double, 5, 1>::Zero();
    for (const std::uint32_t i : members) {
      const Eigen::Vector3d a = points.first[i].homogeneous();
      const Eigen::Vector3d b = points.second[i].homogeneous();
      const double denominator =
          (e * a).head<2>().squaredNorm() + (e.transpose() * b).head<2>().squaredNorm();
      if (!(denominator > 0.0)) continue;
      Eigen::Matrix<double, 5, 1> jacobian;
      for (std::size_t k = 0; k < 5; ++k) {
        jacobian[static_cast<Eigen::Index>(k)] = b.dot(derivatives[k] * a);
      }
      normal += jacobian * jacobian.transpose() / denominator;
      gradient += jacobian * b.dot(e * a) / denominator;
    }
    const Eigen::Matrix<double, 5, 1> step = -normal.ldlt().solve(gradient);
    if (!step.allFinite()) break;
    pose.rotation = (pose.rotation * rotation_exp(step.head<3>())).normalized();
    pose.translation = (t + step[3] * u + step[4] * v).normalized();
    if (step.norm() < 1e-10) break;
  }
  return pose;
}

int iterations_for(double inlier_share, int limit) {
  const double good = std::pow(inlier_share, 5.0);
  if (good >= 1.0 - 1e-12) return kMinIterations;
  if (good <= 1e-12) return limit;
  const double needed = std::ceil(std::log(1.0 - kConfidence) / std::log(1.0 - good));
  return std::clamp(static_cast<int>(std::min(needed, 1e9)), kMinIterations, limit);
}

std::array<std::uint32_t, 5> sample_five(std::uint32_t count, Random& random) {
  std::array<std::uint32_t, 5> sample{};
  for (std::size_t k = 0; k < sample.size();) {
    sample[k] = random.index(count);
    if (std::find(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(k), sample[k]) ==
        sample.begin() + static_cast<std::ptrdiff_t>(k)) {
      ++k;
    }
  }
  return sample;
}

}  // namespace

Eigen::Matrix3d essential_of(const Rigid3& second_from_first) {
  return skew(second_from_first.translation) * second_from_first.rotation.toRotationMatrix();
}

std::optional<RelativePose> estimate_relative_pose(std::span<const Eigen::Vector2d> first,
                                                   std::span<const Eigen::Vector2d> second,
                                                   const RelativePoseOptions& options,
                                                   Random random) {
  const auto count = static_cast<std::uint32_t>(first.size());
  if (count < 6 || static_cast<int>(count) < options.min_inliers) return std::nullopt;
  const Points points{first, second, options.max_error * options.max_error};
  double best_score = std::numeric_limits<double>::infinity();
  RelativePose best;
  int limit = options.max_iterations;
  for (int iteration = 0; iteration < limit; ++iteration) {
    const std::array<std::uint32_t, 5> sample = sample_five(count, random);
    std::array<Eigen::Vector2d, 5> a;
    std::array<Eigen::Vector2d, 5> b;
    for (std::size_t k = 0; k < 5; ++k) {
      a[k] = first[sample[k]];
      b[k] = second[sample[k]];
    }
    for (const Eigen::Matrix3d& e : essential_from_five_points(a, b)) {
      const double sampled = score(e, points, best_score);
      if (sampled >= best_score) continue;
      best_score = sampled;
      best.inliers = inliers_of(e, points);
      best.second_from_first = pose_from_essential(e, points, best.inliers);
      // Local optimisation on the inliers of the sample's model.
      const Rigid3 refined = refine(best.second_from_first, points, best.inliers);
      const Eigen::Matrix3d refined_e = essential_of(refined);
      const double refined_score = score(refined_e, points, best_score);
      if (refined_score < best_score) {
        best_score = refined_score;
        best.second_from_first = refined;
        best.inliers = inliers_of(refined_e, points);
      }
      limit = std::min(
          limit,
          iterations_for(static_cast<double>(best.inliers.size()) / count, options.max_iterations));
    }
  }
  if (static_cast<int>(best.inliers.size()) < options.min_inliers) return std::nullopt;
  const Rigid3 polished = refine(best.second_from_first, points, best.inliers);
  if (score(essential_of(polished), points, best_score) < best_score) {
    best.second_from_first = polished;
    best.inliers = inliers_of(essential_of(polished), points);
  }
  // The sample's own vote on the side of the baseline may have been taken with few inliers.
  best.second_from_first =
      pose_from_essential(essential_of(best.second_from_first), points, best.inliers);
  return best;
}

double homography_share(std::span<const Eigen::Vector2d> first,
                        std::span<const Eigen::Vector2d> second,
                        double max_error) {
  if (first.size() < 4) return 1.0;
  constexpr double kUnit = 1000.0;  // OpenCV's conditioning expects pixels
  constexpr int kMaxIterations = 200;
  std::vector<cv::Point2d> a;
  std::vector<cv::Point2d> b;
  for (std::size_t i = 0; i < first.size(); ++i) {
    a.emplace_back(kUnit * first[i].x(), kUnit * first[i].y());
    b.emplace_back(kUnit * second[i].x(), kUnit * second[i].y());
  }
  cv::Mat mask;
  // RANSAC (not USAC) seeds its own generator with a constant: the result is reproducible.
  const cv::Mat homography =
      cv::findHomography(a, b, cv::RANSAC, kUnit * max_error, mask, kMaxIterations, 0.999);
  if (homography.empty()) return 0.0;
  return cv::countNonZero(mask) / static_cast<double>(first.size());
}

}  // namespace hybridfusion
