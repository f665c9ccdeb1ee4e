#include "statistics.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/evaluation/sheet_error.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxPatches = 3000;
constexpr float kRadius_m = 0.5F;
constexpr float kFlat_m = 0.005F;
constexpr float kSameNormal = 0.999F;
constexpr float kReach_m = 0.3F;
constexpr std::size_t kMinSamples = 3;  // beside the middle one
constexpr std::size_t kMinPoints = 10;

struct Patch {
  float thickness_m = 0.0F;
  float height_m = 0.0F;
};

class Patches {
 public:
  Patches(std::span<const Eigen::Vector3f> samples,
          std::span<const Eigen::Vector3f> normals,
          std::span<const Eigen::Vector3f> points)
      : samples_(samples),
        normals_(normals),
        points_(points),
        sample_tree_(samples),
        point_tree_(points) {}

  /// Nothing where the surface is not flat or the cloud is empty.
  [[nodiscard]] std::optional<Patch> at(std::size_t index, std::vector<Neighbor>& found) const {
    const Eigen::Vector3f& middle = samples_[index];
    const Eigen::Vector3f& normal = normals_[index];
    sample_tree_.within(middle, kRadius_m, found);
    const bool flat = std::ranges::all_of(found, [&](const Neighbor& n) {
      return normals_[n.index].dot(normal) > kSameNormal &&
             std::abs(normal.dot(samples_[n.index] - middle)) < kFlat_m;
    });
    if (!flat || found.size() <= kMinSamples) return std::nullopt;
    point_tree_.within(middle, std::hypot(kRadius_m, kReach_m), found);
    std::vector<float> heights;
    for (const Neighbor& n : found) {
      const Eigen::Vector3f d = points_[n.index] - middle;
      const float height = normal.dot(d);
      const bool beside = (d - height * normal).norm() < kRadius_m;
      if (beside && std::abs(height) < kReach_m) heights.push_back(height);
    }
    if (heights.size() < kMinPoints) return std::nullopt;
    return Patch{
        .thickness_m = static_cast<float>(quantile(heights, 0.95) - quantile(heights, 0.05)),
        .height_m = static_cast<float>(quantile(heights, 0.5))};
  }

 private:
  std::span<const Eigen::Vector3f> samples_;
  std::span<const Eigen::Vector3f> normals_;
  std::span<const Eigen::Vector3f> points_;
  KdTree sample_tree_;
  KdTree point_tree_;
};

}  // namespace

Expected<SheetError> sheet_error(std::span<const Eigen::Vector3f> samples_in_truth,
                                 std::span<const Eigen::Vector3f> normals,
                                 std::span<const Eigen::Vector3f> points_in_truth,
                                 const RunContext& ctx) {
  if (normals.size() != samples_in_truth.size()) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("{} normals for {} samples", normals.size(), samples_in_truth.size()));
  }
  const Patches patches(samples_in_truth, normals, points_in_truth);
  const std::size_t stride = std::max<std::size_t>(1, samples_in_truth.size() / kMaxPatches);
  const std::size_t count = (samples_in_truth.size() + stride - 1) / stride;
  std::vector<std::optional<Patch>> found(count);
  parallel_for(ctx, count, 16, [&](std::size_t begin, std::size_t end) {
    if (ctx.stopped()) return;
    std::vector<Neighbor> neighbors;
    for (std::size_t i = begin; i < end; ++i) found[i] = patches.at(i * stride, neighbors);
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while measuring the sheet");
  std::vector<float> thickness;
  std::vector<float> bias;
  for (const auto& patch : found) {
    if (!patch) continue;
    thickness.push_back(patch->thickness_m);
    bias.push_back(std::abs(patch->height_m));
  }
  if (thickness.empty()) {
    return fail(ErrorCode::kInsufficient, "no flat piece of the surface is covered by the cloud");
  }
  return SheetError{.num_patches = thickness.size(),
                    .thickness_m = quantile(thickness, 0.5),
                    .bias_m = quantile(bias, 0.5)};
}

SigmaCalibration sigma_calibration(std::span<const Eigen::Vector3f> points_in_truth,
                                   std::span<const float> sigmas_m,
                                   const SurfaceDistance& surface,
                                   std::span<const std::uint8_t> triangle_labels,
                                   const RunContext& ctx) {
  HF_CHECK(points_in_truth.size() == sigmas_m.size());
  std::vector<SurfacePoint> nearest(points_in_truth.size());
  parallel_for(ctx, nearest.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nearest[i] = surface.nearest(points_in_truth[i]);
  });
  std::vector<float> hard;
  std::array<std::vector<float>, kNumSurfaceLabels> by_label;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (!(sigmas_m[i] > 0.0F)) continue;
    const std::uint8_t label = triangle_labels[nearest[i].triangle];
    const float ratio = nearest[i].distance_m / sigmas_m[i];
    by_label[label].push_back(ratio);
    if (label <= std::to_underlying(SurfaceLabel::kBuilding)) hard.push_back(ratio);
  }
  SigmaCalibration result{.hard = quantile(hard, 0.5)};
  std::ranges::transform(
      by_label, result.by_label.begin(), [](const auto& ratios) { return quantile(ratios, 0.5); });
  return result;
}

}  // namespace hybridfusion
