#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/io/rosbag1.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// metadata.yaml of a ROS 2 bag, versions 1 to 9.
struct Ros2Metadata {
  std::vector<std::string> files = {};          ///< Names within the folder, in order.
  std::vector<BagConnection> connections = {};  ///< Topics of CDR messages; ids count from 0.
};

/// @returns kNotFound; kParse naming file and cause, also for a compression that is not zstd.
[[nodiscard]] Expected<Ros2Metadata> read_ros2_metadata(const std::filesystem::path& path);

}  // namespace hybridfusion
