#include <hybridfusion/core/sim3.hpp>

#include <Eigen/SVD>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct Moments {
  Eigen::Vector3d target_mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d source_mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // target * source^T
  double source_variance = 0.0;
};

Moments moments_of(std::span<const Eigen::Vector3d> target,
                   std::span<const Eigen::Vector3d> source,
                   std::span<const double> weights) {
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  Moments m;
  double sum = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    m.target_mean += weight(i) * target[i];
    m.source_mean += weight(i) * source[i];
    sum += weight(i);
  }
  m.target_mean /= sum;
  m.source_mean /= sum;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Eigen::Vector3d s = source[i] - m.source_mean;
    m.covariance += weight(i) / sum * (target[i] - m.target_mean) * s.transpose();
    m.source_variance += weight(i) / sum * s.squaredNorm();
  }
  return m;
}

enum class Scale : bool { kFixed, kFree };

Expected<Sim3> fit(std::span<const Eigen::Vector3d> target,
                   std::span<const Eigen::Vector3d> source,
                   std::span<const double> weights,
                   Scale scale) {
  HF_CHECK(target.size() == source.size());
  HF_CHECK(weights.empty() || weights.size() == source.size());
  if (source.size() < 3) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("an alignment needs at least 3 point pairs, got {}", source.size()));
  }
  const Moments m = moments_of(target, source, weights);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(m.covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d& d = svd.singularValues();
  if (!(d[1] > 1e-9 * d[0]) || !(m.source_variance > 0.0)) {
    return fail(ErrorCode::kDegenerate, "the paired points lie on one line: the rotation is free");
  }
  // Reflection guard: flip the weakest direction (Umeyama, eq. 39-43).
  Eigen::Vector3d sign = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) sign[2] = -1.0;
  const Eigen::Matrix3d rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();

  Sim3 result;
  result.rotation = Eigen::Quaterniond(rotation).normalized();
  if (scale == Scale::kFree) result.scale = d.dot(sign) / m.source_variance;
  result.translation = m.target_mean - result.scale * (result.rotation * m.source_mean);
  return result;
}

}  // namespace

Sim3 Sim3::inverse() const {
  const Eigen::Quaterniond inverse_rotation = rotation.conjugate();
  return {.rotation = inverse_rotation,
          .translation = inverse_rotation * -translation / scale,
          .scale = 1.0 / scale};
}

Eigen::Matrix4d Sim3::matrix() const {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = scale * rotation.toRotationMatrix();
  result.topRightCorner<3, 1>() = translation;
  return result;
}

Rigid3 Sim3::map_pose(const Rigid3& source_from_body) const {
  return {.rotation = (rotation * source_from_body.rotation).normalized(),
          .translation = *this * source_from_body.translation};
}

Sim3 operator*(const Sim3& c_from_b, const Sim3& b_from_a) {
  return {.rotation = (c_from_b.rotation * b_from_a.rotation).normalized(),
          .translation = c_from_b * b_from_a.translation,
          .scale = c_from_b.scale * b_from_a.scale};
}

Expected<Sim3> fit_sim3(std::span<const Eigen::Vector3d> target,
                        std::span<const Eigen::Vector3d> source,
                        std::span<const double> weights) {
  return fit(target, source, weights, Scale::kFree);
}

Expected<Rigid3> fit_rigid3(std::span<const Eigen::Vector3d> target,
                            std::span<const Eigen::Vector3d> source,
                            std::span<const double> weights) {
  HF_TRY(const Sim3 similarity, fit(target, source, weights, Scale::kFixed));
  return Rigid3{.rotation = similarity.rotation, .translation = similarity.translation};
}

}  // namespace hybridfusion
