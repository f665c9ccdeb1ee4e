#pragma once

#include <hybridfusion/io/rosbag1.hpp>
#include <hybridfusion/io/scan_source.hpp>

#include <filesystem>
#include <string_view>
#include <vector>

namespace hybridfusion {

[[nodiscard]] bool is_point_cloud2(std::string_view type);
/// As point_cloud_transport publishes them.
[[nodiscard]] bool is_compressed_cloud(std::string_view type);
[[nodiscard]] bool is_livox(std::string_view type);
[[nodiscard]] bool is_imu(std::string_view type);
[[nodiscard]] bool is_gnss(std::string_view type);

/// Topics of all connections, sorted by name; several connections of one topic are one.
[[nodiscard]] std::vector<RecordingTopic> recording_topics(
    const std::vector<BagConnection>& connections);

enum class Require : std::uint8_t { kNothing, kLidar };

/// Fills the three topics of `summary` from the options or by type. Of several candidates the one
/// with most messages is taken (a Livox message before a PointCloud2, which may be a copy of it)
/// and the others are named in a warning.
/// @returns kNotFound when a topic that was asked for, or a required one, does not exist.
[[nodiscard]] Expected<void> choose_topics(const std::filesystem::path& path,
                                           const RecordingOptions& options,
                                           Require require,
                                           RecordingSummary& summary);

}  // namespace hybridfusion
