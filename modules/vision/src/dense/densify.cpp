#include "checked_depths.hpp"
#include "depth_fusion.hpp"

#include <hybridfusion/core/memory.hpp>
#include <hybridfusion/geometry/voxel_range.hpp>
#include <hybridfusion/vision/densify.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace hybridfusion {
namespace {

/// Twice the median ground sampling distance of the photos at full resolution: what the photos
/// resolve.
double default_voxel_m(const Reconstruction& reconstruction) {
  std::vector<double> gsd;
  for (const View& view : reconstruction.views) {
    if (!view.enu_from_camera) continue;
    const Rigid3 camera_from_enu = view.enu_from_camera->inverse();
    for (std::size_t i = 0; i < view.observations.size(); i += 5) {
      const ScenePoint& point = reconstruction.points[view.observations[i].point];
      const double z = (camera_from_enu * point.point_in_enu).z();
      if (z > 0.0) gsd.push_back(z / reconstruction.cameras[view.camera].focal_px);
    }
  }
  if (gsd.empty()) return 0.0;
  const auto middle = gsd.begin() + static_cast<std::ptrdiff_t>(gsd.size() / 2);
  std::ranges::nth_element(gsd, middle);
  return 2.0 * *middle;
}

/// The photos must lie where the keys of voxels, and 32-bit coordinates, still tell places apart.
Expected<void> check_reach(const Reconstruction& reconstruction, double voxel_m) {
  for (const View& view : reconstruction.views) {
    if (!view.enu_from_camera) continue;
    const Eigen::Vector3d& at = view.enu_from_camera->translation;
    if (in_voxel_key_reach(at, voxel_m)) continue;
    return fail(ErrorCode::kDegenerate,
                fmt::format("{} lies {:.0f} km from the origin of the result, voxels of {:.3f} m "
                            "reach {:.0f} km; check the origin, or whether the positions are those "
                            "of one block",
                            view.name,
                            at.norm() / 1000.0,
                            voxel_m,
                            voxel_key_reach_m(voxel_m) / 1000.0));
  }
  return {};
}

Expected<PointCloud> densify_registered(std::span<const Photo> photos,
                                        const Reconstruction& reconstruction,
                                        const DensifyOptions& options,
                                        const RunContext& ctx,
                                        const std::filesystem::path& scratch) {
  const double voxel_m = options.voxel_m > 0.0 ? options.voxel_m : default_voxel_m(reconstruction);
  if (!(voxel_m > 0.0)) {
    return fail(ErrorCode::kInsufficient, "no scene point lies in front of a registered photo");
  }
  if (auto near = check_reach(reconstruction, voxel_m); !near) {
    return std::unexpected(near.error());
  }
  return_freed_memory();  // features and matches are gone by now
  DepthFusion fusion(voxel_m);
  const auto done = checked_depths(
      photos, reconstruction, options, ctx, scratch, [&](const DepthMap& map) { fusion.add(map); });
  if (!done) return std::unexpected(done.error());
  return_freed_memory();  // and now photos and depth maps
  PointCloud cloud = fusion.finish(options.min_points_per_voxel, ctx);
  if (cloud.empty()) {
    return fail(ErrorCode::kInsufficient, "no depth is confirmed by a second photo");
  }
  return cloud;
}

}  // namespace

Expected<PointCloud> densify(std::span<const Photo> photos,
                             const Reconstruction& reconstruction,
                             const DensifyOptions& options,
                             const RunContext& ctx,
                             const std::filesystem::path& scratch_folder) {
  HF_CHECK(photos.size() == reconstruction.views.size());
  const auto registered = std::ranges::count_if(
      reconstruction.views, [](const View& v) { return v.enu_from_camera.has_value(); });
  if (registered < 2) {
    return fail(
        ErrorCode::kInsufficient,
        fmt::format("a dense cloud needs at least 2 registered photos, got {}", registered));
  }
  try {
    return densify_registered(photos, reconstruction, options, ctx, scratch_folder);
  } catch (const cv::Exception& e) {
    return fail(ErrorCode::kInsufficient, std::string("OpenCV failed on a photo: ") + e.what());
  }
}

}  // namespace hybridfusion
