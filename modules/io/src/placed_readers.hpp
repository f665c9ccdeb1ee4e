#pragma once

#include "cloud_builder.hpp"

#include <hybridfusion/io/placed_cloud.hpp>

#include <filesystem>

namespace hybridfusion {

/// As read_ply, read_pcd and read_xyz, for coordinates of any size.
[[nodiscard]] Expected<PlacedCloud> read_placed_ply(const std::filesystem::path& path);
[[nodiscard]] Expected<PlacedCloud> read_placed_pcd(const std::filesystem::path& path);
[[nodiscard]] Expected<PlacedCloud> read_placed_xyz(const std::filesystem::path& path);

/// Adds the file to the error of a CloudBuilder.
template <class Cloud>
[[nodiscard]] Expected<Cloud> finished(const std::filesystem::path& path, Expected<Cloud> cloud) {
  if (!cloud) return std::unexpected(std::move(cloud.error()).with_context(path.string()));
  return cloud;
}

}  // namespace hybridfusion
