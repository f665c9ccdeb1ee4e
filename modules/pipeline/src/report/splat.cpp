#include "splat.hpp"

#include <hybridfusion/io/jpeg.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hybridfusion {
namespace {

constexpr float kEmpty = std::numeric_limits<float>::infinity();
constexpr int kMaxSide_px = 2000;

/// Fits a rotated box into a picture of the given width.
ParallelView fit(const Eigen::Matrix3d& picture_from_world,
                 const Eigen::AlignedBox3d& box,
                 int width_px) {
  Eigen::AlignedBox3d seen;
  for (int corner = 0; corner < 8; ++corner) {
    seen.extend(picture_from_world *
                box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
  const Eigen::Vector3d size = seen.sizes().cwiseMax(1.0);
  const double px_per_m = std::min(width_px / size.x(), kMaxSide_px / size.y());
  ParallelView view{.width_px = static_cast<int>(std::ceil(size.x() * px_per_m)),
                    .height_px = static_cast<int>(std::ceil(size.y() * px_per_m))};
  const Eigen::Vector3d scale(px_per_m, px_per_m, 1.0);
  view.picture_from_world.linear() = scale.asDiagonal() * picture_from_world;
  view.picture_from_world.translation() = -scale.cwiseProduct(seen.min());
  return view;
}

}  // namespace

ParallelView view_from_above(const Eigen::AlignedBox2d& box, int width_px) {
  Eigen::Matrix3d down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  const Eigen::AlignedBox3d volume(Eigen::Vector3d(box.min().x(), box.min().y(), 0.0),
                                   Eigen::Vector3d(box.max().x(), box.max().y(), 0.0));
  return fit(down, volume, width_px);
}

ParallelView oblique_view(const Eigen::AlignedBox3d& box,
                          double azimuth_rad,
                          double elevation_rad,
                          int width_px) {
  const Eigen::Vector3d to_viewer(std::sin(azimuth_rad) * std::cos(elevation_rad),
                                  std::cos(azimuth_rad) * std::cos(elevation_rad),
                                  std::sin(elevation_rad));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(to_viewer).normalized();
  Eigen::Matrix3d turn;
  turn.row(0) = right;
  turn.row(1) = -to_viewer.cross(right);
  turn.row(2) = -to_viewer;
  return fit(turn, box, width_px);
}

Splatter::Splatter(const ParallelView& view)
    : view_(view),
      depth_m_(static_cast<std::size_t>(view.width_px) * view.height_px, kEmpty),
      color_(depth_m_.size(), Rgb8{}) {}

void Splatter::add(const Eigen::Vector3f& point_in_world, const Rgb8& color, int radius_px) {
  const Eigen::Vector3d at = view_.picture_from_world * point_in_world.cast<double>();
  if (!at.allFinite() || at.x() < -radius_px || at.y() < -radius_px ||
      at.x() > view_.width_px + radius_px || at.y() > view_.height_px + radius_px) {
    return;
  }
  const int cx = static_cast<int>(std::floor(at.x()));
  const int cy = static_cast<int>(std::floor(at.y()));
  const auto depth = static_cast<float>(at.z());
  for (int y = std::max(0, cy - radius_px); y <= std::min(view_.height_px - 1, cy + radius_px);
       ++y) {
    for (int x = std::max(0, cx - radius_px); x <= std::min(view_.width_px - 1, cx + radius_px);
         ++x) {
      if ((x - cx) * (x - cx) + (y - cy) * (y - cy) > radius_px * radius_px) continue;
      const std::size_t pixel = static_cast<std::size_t>(y) * view_.width_px + x;
      if (depth >= depth_m_[pixel]) continue;
      depth_m_[pixel] = depth;
      color_[pixel] = color;
    }
  }
}

Image8 Splatter::image(Rgb8 background) const {
  constexpr float kStrength_per_m = 0.12F;
  constexpr float kMaxStep_m = 4.0F;  // a deeper edge is not darker
  Image8 image{.width = view_.width_px, .height = view_.height_px, .channels = 3};
  image.pixels.assign(3 * depth_m_.size(), 0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * image.width + x;
      float shade = 1.0F;
      Rgb8 color = background;
      if (depth_m_[pixel] != kEmpty) {
        color = color_[pixel];
        float steps_m = 0.0F;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const int nx = std::clamp(x + dx, 0, image.width - 1);
          const int ny = std::clamp(y + dy, 0, image.height - 1);
          const float other = depth_m_[static_cast<std::size_t>(ny) * image.width + nx];
          if (other == kEmpty) continue;
          steps_m += std::clamp(depth_m_[pixel] - other, 0.0F, kMaxStep_m);
        }
        shade = std::exp(-kStrength_per_m * steps_m);
      }
      for (std::size_t c = 0; c < 3; ++c) {
        image.pixels[3 * pixel + c] =
            static_cast<std::uint8_t>(std::lround(shade * static_cast<float>(color[c])));
      }
    }
  }
  return image;
}

Image8 without_blank_rows(Image8 image, Rgb8 background) {
  constexpr int kMargin_px = 14;
  const int stray_px = image.width / 200;
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width);
  const auto is_blank = [&](int row) {
    int drawn = 0;
    const std::uint8_t* pixel = image.pixels.data() + static_cast<std::size_t>(row) * row_bytes;
    for (int x = 0; x < image.width && drawn <= stray_px; ++x, pixel += 3) {
      drawn += std::equal(background.begin(), background.end(), pixel) ? 0 : 1;
    }
    return drawn <= stray_px;
  };
  int first = 0;
  int end = image.height;
  while (first < end && is_blank(first)) ++first;
  while (end > first && is_blank(end - 1)) --end;
  if (first == end) return image;
  first = std::max(0, first - kMargin_px);
  end = std::min(image.height, end + kMargin_px);
  const auto at = [&](int row) {
    return image.pixels.begin() + static_cast<std::ptrdiff_t>(row_bytes) * row;
  };
  image.pixels.erase(at(end), image.pixels.end());
  image.pixels.erase(image.pixels.begin(), at(first));
  image.height = end - first;
  return image;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      group = (group << 8U) | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[(group >> (18U - 6U * k)) & 63U] : '=';
    }
  }
  return text;
}

Expected<std::string> data_uri(const Image8& image) {
  constexpr int kQuality = 82;
  HF_TRY(const std::string jpeg, encode_jpeg(image, kQuality));
  return "data:image/jpeg;base64," + base64(jpeg);
}

}  // namespace hybridfusion
