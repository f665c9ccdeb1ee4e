#include "colmap_intrinsics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Where each parameter of a camera model goes; nullptr where it has to be 0.
struct ModelLayout {
  std::string_view name;
  bool two_focals;
  std::vector<double CameraIntrinsics::*> distortion;
};

[[nodiscard]] const ModelLayout* find_layout(std::string_view model) {
  using C = CameraIntrinsics;
  static const std::vector<ModelLayout> kLayouts = {
      {"SIMPLE_PINHOLE", false, {}},
      {"PINHOLE", true, {}},
      {"SIMPLE_RADIAL", false, {&C::k1}},
      {"RADIAL", false, {&C::k1, &C::k2}},
      {"OPENCV", true, {&C::k1, &C::k2, &C::p1, &C::p2}},
      {"FULL_OPENCV", true, {&C::k1, &C::k2, &C::p1, &C::p2, &C::k3, nullptr, nullptr, nullptr}}};
  const auto found = std::ranges::find(kLayouts, model, &ModelLayout::name);
  return found == kLayouts.end() ? nullptr : &*found;
}

}  // namespace

Expected<CameraIntrinsics> intrinsics_of(const ColmapCamera& camera) {
  const ModelLayout* const layout = find_layout(camera.model);
  const auto refuse = [&camera](std::string_view cause) {
    return fail(ErrorCode::kParse,
                fmt::format("camera {} of model {} {}; give poses of one of "
                            "SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV",
                            camera.id,
                            camera.model,
                            cause));
  };
  if (layout == nullptr) return refuse("cannot be used");
  const std::size_t focals = layout->two_focals ? 2 : 1;
  const std::vector<double>& params = camera.params;
  if (params.size() != focals + 2 + layout->distortion.size()) {
    return refuse(fmt::format("has {} parameters", params.size()));
  }
  if (!std::ranges::all_of(params, [](double value) { return std::isfinite(value); }) ||
      !(params[0] > 0.0)) {
    return refuse("has parameters that are not numbers");
  }
  // One focal length is kept; a difference of 1e-4 moves the corner of a photo by a tenth pixel.
  constexpr double kMaxFocalDifference = 1e-4;
  if (layout->two_focals && std::abs(params[1] / params[0] - 1.0) > kMaxFocalDifference) {
    return refuse(fmt::format("has two focal lengths, {} and {} px", params[0], params[1]));
  }
  CameraIntrinsics result = {
      .width_px = camera.width_px,
      .height_px = camera.height_px,
      .focal_px = layout->two_focals ? 0.5 * (params[0] + params[1]) : params[0]};
  result.principal_point_px = {params[focals] - kColmapShift_px,
                               params[focals + 1] - kColmapShift_px};
  for (std::size_t i = 0; i < layout->distortion.size(); ++i) {
    const double value = params[focals + 2 + i];
    if (layout->distortion[i] != nullptr) {
      result.*layout->distortion[i] = value;
    } else if (value != 0.0) {
      return refuse("has a rational distortion");
    }
  }
  return result;
}

}  // namespace hybridfusion
