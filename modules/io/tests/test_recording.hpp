#pragma once

/// @file
/// One small recording in both serialisations, and as a ROS 1 bag.

#include "bag_builder.hpp"

#include <string>
#include <vector>

#include <zstd.h>

namespace hybridfusion::testing {

struct TestTopic {
  std::string name;
  std::string type;  ///< ROS 1 name, "sensor_msgs/Imu".
  [[nodiscard]] std::string ros2_type() const {
    const std::size_t slash = type.find('/');
    return type.substr(0, slash) + "/msg" + type.substr(slash);
  }
};

/// A message in both serialisations.
struct TestMessage {
  std::uint16_t topic = 0;
  std::int64_t time_ns = 0;
  std::string ros1 = {};
  std::string cdr = {};
};

struct TestRecording {
  std::vector<TestTopic> topics = {{"/points", "sensor_msgs/PointCloud2"},
                                   {"/imu", "sensor_msgs/Imu"},
                                   {"/fix", "sensor_msgs/NavSatFix"}};
  std::vector<TestMessage> messages = {};
};

[[nodiscard]] inline std::string zstd_packed(const std::string& data) {
  std::string out(ZSTD_compressBound(data.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), data.data(), data.size(), 3));
  return out;
}

[[nodiscard]] inline std::string rosbag1_of(const TestRecording& recording) {
  BagBuilder bag("lz4");
  for (const TestTopic& topic : recording.topics) {
    static_cast<void>(bag.add_topic(topic.name, topic.type));
  }
  std::size_t count = 0;
  for (const TestMessage& message : recording.messages) {
    bag.add_message(message.topic, message.time_ns, message.ros1);
    if (++count % 50 == 0) bag.end_chunk();
  }
  return bag.finish();
}

}  // namespace hybridfusion::testing
