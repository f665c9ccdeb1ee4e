#pragma once

#include "dense/depth_map.hpp"
#include "dense/device_matcher.hpp"
#include "live/preview_cloud.hpp"

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/densify_options.hpp>
#include <hybridfusion/vision/reconstruction.hpp>
#include <hybridfusion/vision/streaming_options.hpp>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace hybridfusion {

/// Depths of photos as they get their poses, checked against those of the last ones.
class LiveDepth {
 public:
  LiveDepth(const DensifyOptions& densify, const StreamingOptions& live);

  /// Announces the next photo. @param reduced  RGB at preview size; null for an unreadable one.
  void add_photo(const PhotoMetadata& metadata, std::shared_ptr<const Image8> reduced);

  /// What other depths confirm of a photo's. Nothing when it has no partner or no depth of another
  /// photo lies beside its own yet: then its depths are kept for those to come.
  [[nodiscard]] std::optional<PhotoPoints> points_of(const Reconstruction& reconstruction,
                                                     std::uint32_t view,
                                                     const RunContext& ctx);
  /// Follows a model whose lengths changed by this factor.
  void scale(double factor);
  /// Twice what a preview pixel resolves at the median depth so far; 0: no depth yet.
  [[nodiscard]] double default_voxel_m() const;

 private:
  [[nodiscard]] PhotoPoints thinned(const DepthMap& map) const;

  DensifyOptions options_;
  std::size_t max_points_;
  std::vector<Photo> photos_ = {};
  std::deque<DepthMap> maps_ = {};
  std::vector<double> medians_m_ = {};  // of the depth maps
  double focal_px_ = 0.0;               // of the reduced photos
  bool device_sought_ = false;
  std::unique_ptr<DeviceMatcher> device_ = {};
};

}  // namespace hybridfusion
