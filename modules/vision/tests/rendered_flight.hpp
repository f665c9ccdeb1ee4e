#pragma once

#include "synthetic_flight.hpp"

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/photo.hpp>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace hybridfusion::testing {

inline constexpr int kWidth = 400;
inline constexpr int kHeight = 300;
inline constexpr double kFocal_px = 330.0;

/// Noise of a lattice point, 0..1.
inline double lattice(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U;
  h ^= h >> 15U;
  h *= 0x2C1B3C6DU;
  h ^= h >> 13U;
  return (h & 0xFFFFU) / 65535.0;
}

/// Smoothly interpolated lattice noise.
inline double noise(double x, double y) {
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = smooth(x - x0);
  const double v = smooth(y - y0);
  return (1 - v) * ((1 - u) * lattice(x0, y0) + u * lattice(x0 + 1, y0)) +
         v * ((1 - u) * lattice(x0, y0 + 1) + u * lattice(x0 + 1, y0 + 1));
}

inline double ground_height_m(double x, double y) {
  return 4.0 * std::sin(0.21 * x) * std::cos(0.17 * y);
}

/// Photo of rolling textured ground, by fixed-point intersection of each ray with the height field.
inline Image8 render(const Rigid3& enu_from_camera) {
  Image8 image{.width = kWidth, .height = kHeight, .channels = 3};
  image.pixels.reserve(static_cast<std::size_t>(kWidth) * kHeight * 3);
  const Eigen::Vector3d centre = enu_from_camera.translation;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray =
          enu_from_camera.rotation * Eigen::Vector3d((u - 0.5 * (kWidth - 1)) / kFocal_px,
                                                     (v - 0.5 * (kHeight - 1)) / kFocal_px,
                                                     1.0);
      double height = 0.0;
      Eigen::Vector3d point = centre;
      for (int k = 0; k < 8; ++k) {
        point = centre + ray * ((height - centre.z()) / ray.z());
        height = ground_height_m(point.x(), point.y());
      }
      const double gray = 0.5 * noise(1.3 * point.x(), 1.3 * point.y()) +
                          0.3 * noise(3.1 * point.x() + 50.0, 3.1 * point.y()) +
                          0.2 * noise(0.5 * point.x(), 0.5 * point.y() + 90.0);
      image.pixels.insert(image.pixels.end(), 3, static_cast<std::uint8_t>(20.0 + 215.0 * gray));
    }
  }
  return image;
}

struct RenderedFlight {
  std::vector<Photo> photos;
  std::vector<Rigid3> enu_from_camera;  // relative to `start`
  GeodeticOrigin start{.latitude_deg = 48.0, .longitude_deg = 11.0, .altitude_m = 500.0};
};

inline RenderedFlight render_flight() {
  RenderedFlight flight;
  for (int i = 0; i < 6; ++i) {
    const int row = i / 3;
    const int column = row == 0 ? i : 5 - i;
    const Rigid3 pose{.rotation = looking_down(row == 0 ? 0.05 : M_PI, i % 2 == 0 ? 0.12 : -0.1),
                      .translation = {8.0 * column, 8.0 * row, 30.0 + 0.5 * column}};
    const auto image = std::make_shared<const Image8>(render(pose));
    const GeodeticPosition at = geodetic_from_enu(flight.start, pose.translation);
    Photo photo;
    photo.metadata.name = "IMG_" + std::to_string(i) + ".JPG";
    photo.metadata.width = kWidth;
    photo.metadata.height = kHeight;
    photo.metadata.focal_35mm = 43.2666 * 1.01 * kFocal_px / std::hypot(kWidth, kHeight);
    photo.metadata.time = from_seconds(100.0 + 2.0 * i);
    photo.metadata.latitude_deg = at.latitude_deg;
    photo.metadata.longitude_deg = at.longitude_deg;
    photo.metadata.altitude_m = at.altitude_m;
    photo.metadata.gps_horizontal_error_m = 0.3;
    photo.load = [image]() -> Expected<Image8> { return *image; };
    flight.photos.push_back(std::move(photo));
    flight.enu_from_camera.push_back(pose);
  }
  return flight;
}

/// Two strips of three photos, 30 m above ground, GNSS exact; rendered once.
inline RenderedFlight fly() {
  static const RenderedFlight flight = render_flight();
  return flight;
}

}  // namespace hybridfusion::testing
