#include "baselines.hpp"

#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>

namespace hybridfusion {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

PclCloud::Ptr to_pcl(const std::vector<Eigen::Vector3f>& points) {
  auto cloud = std::make_shared<PclCloud>();
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points) cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

}  // namespace

Expected<RegistrationResult> register_gicp(const PreparedClouds& clouds, const RunContext& ctx) {
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped before GICP");
  try {
    pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
    gicp.setInputSource(to_pcl(clouds.lidar));
    gicp.setInputTarget(to_pcl(clouds.vision));
    PclCloud aligned;
    const Eigen::Matrix4d start = height_aligned_initial(clouds).matrix();
    gicp.align(aligned, start.cast<float>());
    const Eigen::Matrix4d pose = gicp.getFinalTransformation().cast<double>();
    if (!pose.allFinite()) return fail(ErrorCode::kDegenerate, "GICP returned no finite pose");
    return baseline_result(clouds, Rigid3::from_matrix(pose), gicp.hasConverged());
  } catch (const std::exception& error) {
    return fail(ErrorCode::kDegenerate, fmt::format("GICP failed: {}", error.what()));
  }
}

}  // namespace hybridfusion
