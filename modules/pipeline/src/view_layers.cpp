#include "view_layers.hpp"

#include "thinned_cloud.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr std::size_t kBatchPoints = 262144;
constexpr double kDigestVoxel_m = 0.1;
constexpr double kLowShare = 0.02;  // intensities below and above these shares are cut off
constexpr double kHighShare = 0.98;

float quantile(std::vector<float>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Intensities to 0..1 and, for points without a colour, grey of that brightness.
void dress(PointCloud& batch, float low, float high) {
  for (float& value : batch.intensities) {
    value = std::isfinite(value) ? std::clamp((value - low) / (high - low), 0.0F, 1.0F) : 0.0F;
  }
  if (!batch.colors.empty()) return;
  batch.colors.assign(batch.size(), Rgb8{190, 190, 190});
  for (std::size_t i = 0; i < batch.intensities.size(); ++i) {
    constexpr float kDarkest = 40.0F;
    const auto grey =
        static_cast<std::uint8_t>(kDarkest + (255.0F - kDarkest) * batch.intensities[i]);
    batch.colors[i] = {grey, grey, grey};
  }
}

}  // namespace

ViewClouds::ViewClouds(std::filesystem::path vision,
                       std::filesystem::path lidar,
                       const Sim3& fused_from_vision,
                       const Rigid3& fused_from_lidar,
                       const RunContext& ctx)
    : vision_path_(std::move(vision)),
      lidar_path_(std::move(lidar)),
      fused_from_vision_(fused_from_vision),
      fused_from_lidar_{.rotation = fused_from_lidar.rotation,
                        .translation = fused_from_lidar.translation},
      ctx_(ctx) {}

Expected<ViewClouds::Digest> ViewClouds::make_digest(const std::filesystem::path& path,
                                                     const Sim3& fused_from_cloud) const {
  HF_TRY(PointCloud thinned, read_thinned(path, kDigestVoxel_m, fused_from_cloud, ctx_));
  Digest digest{.points = std::move(thinned.points)};
  std::vector<float>& intensities = thinned.intensities;
  std::erase_if(intensities, [](float value) { return !std::isfinite(value); });
  if (!intensities.empty()) {
    digest.low_intensity = quantile(intensities, kLowShare);
    digest.high_intensity = quantile(intensities, kHighShare);
  }
  // A cloud of one brightness still divides by something.
  digest.high_intensity = std::max(digest.high_intensity, digest.low_intensity + 1e-6F);
  return digest;
}

Expected<const ViewClouds::Digest*> ViewClouds::digest(ViewCloud cloud) {
  std::optional<Digest>& kept = cloud == ViewCloud::kLidar ? lidar_ : vision_;
  if (!kept) {
    HF_TRY(kept,
           cloud == ViewCloud::kLidar ? make_digest(lidar_path_, fused_from_lidar_)
                                      : make_digest(vision_path_, fused_from_vision_));
    kept->tree.emplace(kept->points);  // the points stay where they are from now on
  }
  return &*kept;
}

Expected<std::vector<float>> ViewClouds::distances(const PointCloud& batch, ViewCloud cloud) {
  HF_TRY(const Digest* vision, digest(ViewCloud::kVision));
  HF_TRY(const Digest* lidar, digest(ViewCloud::kLidar));
  const Sim3 fused_from_batch = cloud == ViewCloud::kVision  ? fused_from_vision_
                                : cloud == ViewCloud::kLidar ? fused_from_lidar_
                                                             : Sim3{};
  std::vector<float> distances_m(batch.size(), kMaxViewDistance_m);
  constexpr std::size_t kGrain = 4096;
  parallel_for(ctx_, batch.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool from_lidar =
          cloud == ViewCloud::kLidar || (cloud == ViewCloud::kFused && !batch.sources.empty() &&
                                         batch.sources[i] == PointSource::kLidar);
      const Digest& other = from_lidar ? *vision : *lidar;
      const Eigen::Vector3f at =
          (fused_from_batch * Eigen::Vector3d(batch.points[i].cast<double>())).cast<float>();
      const float squared_m2 = other.tree->nearest(at).squared_distance_m2;
      distances_m[i] = std::min(kMaxViewDistance_m, std::sqrt(squared_m2));
    }
  });
  return distances_m;
}

Expected<void> ViewClouds::visit(const std::filesystem::path& path,
                                 ViewCloud cloud,
                                 bool compares,
                                 const Visitor& visitor) {
  float low = 0.0F;
  float high = 1.0F;
  // Of the fused cloud only the LiDAR's part has intensities: it looks like the LiDAR's own cloud.
  if (cloud != ViewCloud::kVision && !lidar_path_.empty()) {
    HF_TRY(const Digest* lidar, digest(ViewCloud::kLidar));
    low = lidar->low_intensity;
    high = lidar->high_intensity;
  }
  return read_ply_batches(path, kBatchPoints, [&](PointCloud&& batch) -> Expected<void> {
    if (ctx_.stopped()) return fail(ErrorCode::kCancelled, "stopped while preparing the viewer");
    dress(batch, low, high);
    std::vector<float> distances_m;
    if (compares) {
      HF_TRY(distances_m, distances(batch, cloud));
    }
    return visitor(batch, distances_m);
  });
}

}  // namespace hybridfusion
