#include "given_camera.hpp"

#include "colmap_intrinsics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Eigen::Vector2d distorted(const GivenCamera& camera, const Eigen::Vector2d& n) {
  const auto& k = camera.k;
  const double x = n.x();
  const double y = n.y();
  const double r2 = n.squaredNorm();
  const double over = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[2]));
  const double under = 1.0 + r2 * (k[3] + r2 * (k[4] + r2 * k[5]));
  const double radial = over / under;
  return {x * radial + 2.0 * camera.p[0] * x * y + camera.p[1] * (r2 + 2.0 * x * x),
          y * radial + camera.p[0] * (r2 + 2.0 * y * y) + 2.0 * camera.p[1] * x * y};
}

/// Whether every pixel at the border of the target lies in the photo.
bool sees_border(const GivenCamera& camera, const CameraIntrinsics& target) {
  constexpr int kSteps = 64;
  const Eigen::Vector2d last(camera.width_px - 1, camera.height_px - 1);
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(share, 0.0),
                                          Eigen::Vector2d(share, 1.0),
                                          Eigen::Vector2d(0.0, share),
                                          Eigen::Vector2d(1.0, share)}) {
      const Eigen::Vector2d at = camera.pixel_of(unproject(target, last.cwiseProduct(corner)));
      const bool inside =
          at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= last.x() && at.y() <= last.y();
      if (!inside) return false;  // also where it is no number
    }
  }
  return true;
}

}  // namespace

Eigen::Vector2d GivenCamera::pixel_of(const Eigen::Vector2d& normalized) const {
  return focal_px * distorted(*this, normalized).array() + principal_point_px;
}

Eigen::Vector2d GivenCamera::normalized_of(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d wanted = (pixel.array() - principal_point_px) / focal_px;
  constexpr int kMaxIterations = 50;
  constexpr double kTolerance = 1e-12;
  Eigen::Vector2d normalized = wanted;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Vector2d step = wanted - distorted(*this, normalized);
    normalized += step;
    if (step.squaredNorm() < kTolerance * kTolerance) break;
  }
  return normalized;
}

Expected<GivenCamera> given_camera(const ColmapCamera& camera) {
  const bool full = camera.model == "FULL_OPENCV";
  const bool opencv = full || camera.model == "OPENCV";
  const std::vector<double>& params = camera.params;
  const std::size_t expected = full ? 12 : opencv ? 8 : 4;
  const bool finite =
      std::ranges::all_of(params, [](double value) { return std::isfinite(value); });
  if ((!opencv && camera.model != "PINHOLE") || params.size() != expected || !finite ||
      !(params[0] > 0.0) || !(params[1] > 0.0)) {
    return fail(ErrorCode::kParse,
                fmt::format("camera {} of model {} with {} parameters has no counterpart here",
                            camera.id,
                            camera.model,
                            params.size()));
  }
  GivenCamera result{
      .width_px = camera.width_px,
      .height_px = camera.height_px,
      .focal_px = {params[0], params[1]},
      .principal_point_px = {params[2] - kColmapShift_px, params[3] - kColmapShift_px}};
  if (opencv) {
    result.k = {params[4], params[5]};
    result.p = {params[6], params[7]};
  }
  if (full) std::copy_n(params.begin() + 8, 4, result.k.begin() + 2);
  return result;
}

CameraIntrinsics undistorted_intrinsics(const GivenCamera& camera) {
  CameraIntrinsics target{.width_px = camera.width_px,
                          .height_px = camera.height_px,
                          .focal_px = camera.focal_px.maxCoeff(),
                          .principal_point_px = camera.principal_point_px};
  constexpr double kStep = 1.01;
  constexpr int kMaxSteps = 70;  // twice the focal length
  for (int i = 0; i < kMaxSteps && !sees_border(camera, target); ++i) target.focal_px *= kStep;
  return target;
}

Image8 undistorted_image(const Image8& photo,
                         const GivenCamera& camera,
                         const CameraIntrinsics& target) {
  Image8 result = photo;
  const auto channels = static_cast<std::size_t>(photo.channels);
  const auto width = static_cast<std::size_t>(photo.width);
  for (int y = 0; y < photo.height; ++y) {
    for (int x = 0; x < photo.width; ++x) {
      const Eigen::Vector2d source = camera.pixel_of(unproject(target, {x, y}));
      const double u = std::clamp(source.x(), 0.0, photo.width - 1.0);
      const double v = std::clamp(source.y(), 0.0, photo.height - 1.0);
      const auto left = static_cast<std::size_t>(std::min(u, photo.width - 2.0));
      const auto top = static_cast<std::size_t>(std::min(v, photo.height - 2.0));
      const double s = u - static_cast<double>(left);
      const double t = v - static_cast<double>(top);
      const std::size_t at = (top * width + left) * channels;
      const std::size_t to =
          (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * channels;
      for (std::size_t c = 0; c < channels; ++c) {
        const auto value = [&](std::size_t offset) -> double {
          return photo.pixels[at + offset + c];
        };
        const double above = (1.0 - s) * value(0) + s * value(channels);
        const double below =
            (1.0 - s) * value(width * channels) + s * value((width + 1) * channels);
        result.pixels[to + c] =
            static_cast<std::uint8_t>(std::lround((1.0 - t) * above + t * below));
      }
    }
  }
  return result;
}

}  // namespace hybridfusion
