#include "ros2_metadata.hpp"

#include "text.hpp"

#include <hybridfusion/io/atomic_file.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 24;

[[nodiscard]] std::unexpected<Error> malformed(const std::filesystem::path& path,
                                               std::string_view cause) {
  return fail(ErrorCode::kParse,
              fmt::format("{}: {}; copy the bag again, or remove this file to read the bag "
                          "without it",
                          path.string(),
                          cause));
}

[[nodiscard]] std::vector<BagConnection> connections_of(const YAML::Node& bag) {
  std::vector<BagConnection> connections;
  for (const YAML::Node& entry : bag["topics_with_message_count"]) {
    const YAML::Node topic = entry["topic_metadata"];
    if (topic["serialization_format"].as<std::string>("cdr") != "cdr") continue;
    BagConnection connection = {.id = static_cast<std::uint32_t>(connections.size()),
                                .topic = topic["name"].as<std::string>(),
                                .type = topic["type"].as<std::string>(),
                                .wire = RosWire::kCdr};
    if (entry["message_count"]) connection.messages = entry["message_count"].as<std::uint64_t>();
    connections.push_back(std::move(connection));
  }
  // As a recorder leaves it that was killed: nothing counted yet.
  const bool counted = std::ranges::any_of(
      connections, [](const BagConnection& c) { return c.messages.value_or(0) > 0; });
  for (BagConnection& connection : connections) {
    if (!counted) connection.messages.reset();
  }
  return connections;
}

Expected<Ros2Metadata> parse(const std::filesystem::path& path, const std::string& text) {
  const YAML::Node bag = YAML::Load(text)["rosbag2_bagfile_information"];
  if (!bag || !bag.IsMap()) return malformed(path, "no rosbag2_bagfile_information");
  Ros2Metadata metadata;
  std::vector<std::string> listed;
  for (const YAML::Node& file : bag["relative_file_paths"]) {
    listed.push_back(file.as<std::string>());
  }
  if (listed.empty()) {  // version 5 on has both lists
    for (const YAML::Node& file : bag["files"]) listed.push_back(file["path"].as<std::string>());
  }
  for (const std::string& file : listed) {
    // Old recorders wrote "folder/file"; only what lies in the folder itself is read.
    const std::filesystem::path name = std::filesystem::path(file).filename();
    if (name.empty() || name == "." || name == "..") {
      return malformed(path, fmt::format("'{}' is no file", printable(file)));
    }
    metadata.files.push_back(name.string());
  }
  metadata.connections = connections_of(bag);
  const std::string compression = lower_case(bag["compression_format"].as<std::string>(""));
  if (!compression.empty() && compression != "zstd") {
    return malformed(path, fmt::format("its compression '{}' is unknown", printable(compression)));
  }
  return metadata;
}

}  // namespace

Expected<Ros2Metadata> read_ros2_metadata(const std::filesystem::path& path) {
  HF_TRY(const std::string text, read_text_file(path, kMaxBytes));
  try {
    return parse(path, text);
  } catch (const YAML::Exception& error) {
    return malformed(path, fmt::format("line {}: {}", error.mark.line + 1, error.msg));
  }
}

}  // namespace hybridfusion
