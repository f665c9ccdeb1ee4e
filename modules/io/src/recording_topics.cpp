#include "recording_topics.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] bool is_lidar(std::string_view type) {
  return is_point_cloud2(type) || is_compressed_cloud(type) || is_livox(type);
}

[[nodiscard]] std::string list_topics(const std::vector<RecordingTopic>& topics) {
  constexpr std::size_t kMaxListed = 40;
  std::string list;
  for (std::size_t i = 0; i < std::min(topics.size(), kMaxListed); ++i) {
    const RecordingTopic& topic = topics[i];
    list += fmt::format("{}{} ({}{})",
                        i == 0 ? "" : ", ",
                        printable(topic.name),
                        printable(topic.type),
                        topic.messages ? fmt::format(", {} messages", *topic.messages) : "");
  }
  if (topics.size() > kMaxListed) list += fmt::format(" and {} more", topics.size() - kMaxListed);
  return list.empty() ? "none at all" : list;
}

struct Role {
  std::string_view name;      ///< "LiDAR"
  std::string_view option;    ///< "lidar_topic"
  std::string_view expected;  ///< Message types, for a person.
  bool (*accepts)(std::string_view type);
};
constexpr Role kLidar = {
    "LiDAR", "lidar_topic", "sensor_msgs/PointCloud2 or livox_ros_driver/CustomMsg", is_lidar};
constexpr Role kImu = {"IMU", "imu_topic", "sensor_msgs/Imu", is_imu};
constexpr Role kGnss = {"GNSS", "gnss_topic", "sensor_msgs/NavSatFix", is_gnss};

Expected<std::string> asked_for(const std::filesystem::path& path,
                                const Role& role,
                                const std::string& topic,
                                const RecordingSummary& summary) {
  const auto found = std::ranges::find(summary.topics, topic, &RecordingTopic::name);
  if (found != summary.topics.end() && role.accepts(found->type)) return topic;
  return fail(
      ErrorCode::kNotFound,
      fmt::format("{}: the {} topic '{}' {}; topics: {}; correct {} or leave it out to detect "
                  "the topic",
                  path.string(),
                  role.name,
                  printable(topic),
                  found == summary.topics.end()
                      ? std::string("does not exist")
                      : fmt::format("has type {}, not {}", printable(found->type), role.expected),
                  list_topics(summary.topics),
                  role.option));
}

/// Best candidate by type; empty when there is none.
[[nodiscard]] std::string detected(const Role& role, RecordingSummary& summary) {
  std::vector<RecordingTopic> candidates;
  std::ranges::copy_if(
      summary.topics, std::back_inserter(candidates), [&role](const RecordingTopic& topic) {
        // A topic that was announced but never sent is no use.
        return role.accepts(topic.type) && topic.messages.value_or(1) > 0;
      });
  if (candidates.empty()) return {};
  std::ranges::stable_sort(candidates, [](const RecordingTopic& a, const RecordingTopic& b) {
    if (is_livox(a.type) != is_livox(b.type)) return is_livox(a.type);
    // A compressed cloud is a copy, which may be lossy.
    if (is_compressed_cloud(a.type) != is_compressed_cloud(b.type)) {
      return is_compressed_cloud(b.type);
    }
    return a.messages.value_or(1) > b.messages.value_or(1);
  });
  if (candidates.size() > 1) {
    std::string others;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      others += (i == 1 ? "" : ", ") + printable(candidates[i].name);
    }
    summary.warnings.push_back(
        fmt::format("several {} topics: {} is used, not {}; set {} to choose",
                    role.name,
                    candidates.front().name,
                    others,
                    role.option));
  }
  return candidates.front().name;
}

/// Types whose messages hold packets as the sensor sent them, and what makes points of them.
struct PacketType {
  std::string_view type;  ///< Without "msg/".
  std::string_view decoder;
};
constexpr std::array<PacketType, 11> kPacketTypes = {{
    {"velodyne_msgs/VelodyneScan", "velodyne_pointcloud"},
    {"ouster_ros/PacketMsg", "ouster_ros with the metadata of the recording (replay.launch)"},
    {"ouster_sensor_msgs/PacketMsg",
     "ouster_ros with the metadata of the recording (replay.launch)"},
    {"ouster_msgs/PacketMsg", "ros2_ouster_drivers"},
    {"pandar_msgs/PandarScan", "hesai_lidar / hesai_ros_driver (source: rosbag packets)"},
    {"hesai_lidar/PandarScan", "hesai_lidar"},
    {"hesai_ros_driver/UdpFrame", "hesai_ros_driver (source_type 3: packets of a rosbag)"},
    {"rslidar_msgs/rslidarScan", "ros_rslidar"},
    {"rslidar_msg/RslidarPacket", "rslidar_sdk (msg_source 2: packets of a rosbag)"},
    {"rslidar_msg/RslidarScan", "rslidar_sdk (msg_source 2: packets of a rosbag)"},
    {"nebula_msgs/NebulaPackets", "nebula_ros (launch_hw:=false)"},
}};

/// How to make points of the packets that a recording holds instead; empty when it holds none.
[[nodiscard]] std::string packet_hint(const RecordingSummary& summary) {
  for (const RecordingTopic& topic : summary.topics) {
    std::string type = topic.type;
    if (const std::size_t at = type.find("/msg/"); at != std::string::npos) type.erase(at, 4);
    for (const PacketType& known : kPacketTypes) {
      if (type != known.type) continue;
      return fmt::format(
          " ({} holds undecoded packets: play the recording back through {} and record the points "
          "that it sends, with the IMU)",
          printable(topic.name),
          known.decoder);
    }
  }
  return {};
}

[[nodiscard]] std::unexpected<Error> missing(const std::filesystem::path& path,
                                             const Role& role,
                                             const RecordingSummary& summary) {
  return fail(ErrorCode::kNotFound,
              fmt::format("{}: no {} topic ({}){}; topics: {}; record the {} or give another bag",
                          path.string(),
                          role.name,
                          role.expected,
                          &role == &kLidar ? packet_hint(summary) : "",
                          list_topics(summary.topics),
                          role.name));
}

}  // namespace

bool is_point_cloud2(std::string_view type) {
  return type == "sensor_msgs/PointCloud2" || type == "sensor_msgs/msg/PointCloud2";
}

bool is_compressed_cloud(std::string_view type) {
  return type == "point_cloud_interfaces/msg/CompressedPointCloud2" ||
         type == "point_cloud_interfaces/CompressedPointCloud2";
}

bool is_livox(std::string_view type) {
  return type == "livox_ros_driver/CustomMsg" || type == "livox_ros_driver2/CustomMsg" ||
         type == "livox_ros_driver2/msg/CustomMsg" || type == "livox_interfaces/msg/CustomMsg";
}

bool is_imu(std::string_view type) {
  return type == "sensor_msgs/Imu" || type == "sensor_msgs/msg/Imu";
}

bool is_gnss(std::string_view type) {
  return type == "sensor_msgs/NavSatFix" || type == "sensor_msgs/msg/NavSatFix";
}

std::vector<RecordingTopic> recording_topics(const std::vector<BagConnection>& connections) {
  std::map<std::string, RecordingTopic> by_name;
  for (const BagConnection& connection : connections) {
    const auto [found, is_new] = by_name.try_emplace(
        connection.topic, RecordingTopic{connection.topic, connection.type, connection.messages});
    if (!is_new && connection.messages) {
      found->second.messages = found->second.messages.value_or(0) + *connection.messages;
    }
  }
  std::vector<RecordingTopic> topics;
  for (auto& [name, topic] : by_name) topics.push_back(std::move(topic));
  return topics;
}

Expected<void> choose_topics(const std::filesystem::path& path,
                             const RecordingOptions& options,
                             Require require,
                             RecordingSummary& summary) {
  struct Choice {
    const Role& role;
    const std::string& asked;
    std::string& chosen;
  };
  for (const Choice& choice : {Choice{kLidar, options.lidar_topic, summary.lidar_topic},
                               Choice{kImu, options.imu_topic, summary.imu_topic},
                               Choice{kGnss, options.gnss_topic, summary.gnss_topic}}) {
    const bool optional = &choice.role != &kLidar;
    if (optional && choice.asked == "none") continue;
    if (choice.asked.empty()) {
      choice.chosen = detected(choice.role, summary);
    } else {
      HF_TRY(choice.chosen, asked_for(path, choice.role, choice.asked, summary));
    }
    if (choice.chosen.empty() && require == Require::kLidar && !optional) {
      return missing(path, choice.role, summary);
    }
  }
  return {};
}

}  // namespace hybridfusion
