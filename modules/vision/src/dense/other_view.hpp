#pragma once

#include "depth_map.hpp"
#include "footprint.hpp"

#include <hybridfusion/vision/densify_options.hpp>

#include <limits>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace hybridfusion {

constexpr int kCorrelationReach_px = 2;  ///< Of the window: 5 x 5 pixels.

/// Another depth map as the reference sees it.
struct OtherView {
  const DepthMap* map;
  Eigen::Matrix3f rotation;  // other from reference
  Eigen::Vector3f translation;
  bool is_partner;
};

/// What another photo shows at a depth of the reference: (u, v) is the point's pixel there, NaN
/// outside the photo; `depth_m` is the other's depth carried over to the reference's own ray, NaN
/// where it does not support the depth.
struct Seen {
  float u = std::numeric_limits<float>::quiet_NaN();
  float v = std::numeric_limits<float>::quiet_NaN();
  float depth_m = std::numeric_limits<float>::quiet_NaN();
  float sigma_m = 0.0F;
  bool looks_through = false;
  bool has_depth = false;  // of its own, whether it supports or not
};

/// Rows of a photo as another one shows them: each photo is sampled once a pixel, in bands that fit
/// the cache.
class OtherViewBand {
 public:
  OtherViewBand(const DepthMap& reference, const DepthCheckOptions& options)
      : reference_(reference), options_(options) {}

  /// @param tiles  Of these rows.
  void look(const OtherView& other, std::span<const DepthTile> tiles, int first_row, int end_row);
  [[nodiscard]] const Seen& at(int x, int y) const { return seen_.at(x, y - first_row_); }
  [[nodiscard]] const OtherView& other() const { return *other_; }
  [[nodiscard]] std::optional<float> correlation(int x, int y) const;

 private:
  /// @param ray_in_other  Of the pixel, one metre deep in the reference.
  [[nodiscard]] Seen look_at(int x, int y, const Eigen::Vector3f& ray_in_other) const;

  const DepthMap& reference_;
  const DepthCheckOptions& options_;
  const OtherView* other_ = nullptr;
  int first_row_ = 0;
  ImagePlane<Seen> seen_;
};

}  // namespace hybridfusion
