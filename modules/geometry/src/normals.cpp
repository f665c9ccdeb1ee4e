#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/normals.hpp>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
PointShape shape_of(std::span<const Eigen::Vector3f> points, std::span<const Neighbor> members) {
  if (members.size() < 3) return {};
  Eigen::Vector3d mean;
  const Eigen::Matrix3d covariance = covariance_of(points, members, mean);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
  const double sum = values.sum();
  if (!(sum > 0.0)) return {};
  return {.normal = solver.eigenvectors().col(0).cast<float>(),
          .curvature = static_cast<float>(values[0] / sum)};
}

Eigen::Matrix3d covariance_of(std::span<const Eigen::Vector3f> points,
                              std::span<const Neighbor> members,
                              Eigen::Vector3d& mean) {
  mean.setZero();
  for (const Neighbor& n : members) mean += points[n.index].cast<double>();
  mean /= static_cast<double>(members.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Neighbor& n : members) {
    const Eigen::Vector3d d = points[n.index].cast<double>() - mean;
    covariance += d * d.transpose();
  }
  return covariance / static_cast<double>(members.size());
}

std::vector<PointShape> estimate_shapes(std::span<const Eigen::Vector3f> points,
                                        const KdTree& tree,
                                        int num_neighbors,
                                        const RunContext& ctx) {
  HF_CHECK(num_neighbors >= 3);
  std::vector<PointShape> shapes(points.size());
  parallel_for(ctx, points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> members;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(points[i], static_cast<std::size_t>(num_neighbors), members);
      shapes[i] = shape_of(points, members);
    }
  });
  return shapes;
}

}  // namespace hybridfusion
