#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <cstdint>
#include <filesystem>

namespace hybridfusion {

enum class PcdFormat : std::uint8_t { kBinaryCompressed, kBinary, kAscii };

struct PcdWriteOptions {
  PcdFormat format = PcdFormat::kBinaryCompressed;
};

/// Reads PCD 0.6/0.7 (ascii, binary, binary_compressed). x y z are required; normal_x/y/z (also
/// nx ny nz), rgb or rgba, intensity, time (also timestamp), sigma, confidence and source fill the
/// channels. Points with NaN coordinates, which organised clouds use for "no return", are dropped.
/// @returns kNotFound for a missing file; kParse naming the file, the cause and the next step.
[[nodiscard]] Expected<PointCloud> read_pcd(const std::filesystem::path& path);

/// Writes the channels the cloud has. @pre validate(cloud)
[[nodiscard]] Expected<void> write_pcd(const std::filesystem::path& path,
                                       const PointCloud& cloud,
                                       const PcdWriteOptions& options = {});

}  // namespace hybridfusion
