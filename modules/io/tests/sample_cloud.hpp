#pragma once

#include <hybridfusion/core/point_cloud.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace hybridfusion::testing {

/// A cloud with every channel and values that do not survive careless rounding.
[[nodiscard]] inline PointCloud sample_cloud(std::size_t count) {
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<float>(i);
    cloud.points.emplace_back(0.1F * k, -1.0F / (k + 3.0F), 1234.567F + k);
    cloud.normals.emplace_back(0.0F, 0.6F, -0.8F);
    const auto byte = static_cast<std::uint8_t>(i % 256);
    cloud.colors.push_back({byte, static_cast<std::uint8_t>(255 - byte), 128});
    cloud.intensities.push_back(k / 7.0F);
    cloud.times_s.push_back(1'777'674'600.05 + 1e-6 * static_cast<double>(i));
    cloud.sigmas_m.push_back(0.01F * k);
    cloud.confidences.push_back(k);
    cloud.sources.push_back(static_cast<PointSource>((i + 1) % 3));
  }
  return cloud;
}

inline void expect_equal(const PointCloud& a, const PointCloud& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.intensities, b.intensities);
  EXPECT_EQ(a.times_s, b.times_s);
  EXPECT_EQ(a.sigmas_m, b.sigmas_m);
  EXPECT_EQ(a.confidences, b.confidences);
  EXPECT_EQ(a.sources, b.sources);
}

template <class T>
[[nodiscard]] std::string bytes_of(T value, std::endian order = std::endian::little) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (order == std::endian::big) std::reverse(bytes, bytes + sizeof(T));
  return {bytes, sizeof(T)};
}

}  // namespace hybridfusion::testing
