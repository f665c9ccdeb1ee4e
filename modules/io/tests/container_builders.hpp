#pragma once

/// @file
/// One small recording in every container, for tests. Written from the formats' descriptions,
/// independent of the readers.

#include "bag_builder.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sqlite3.h>
#include <zstd.h>

namespace hybridfusion::testing {

/// Serialises for ROS 2: CDR aligns each value to its size, behind a header of four bytes.
class CdrWriter {
 public:
  template <class T>
  void put_value(T value) {
    while (body_.size() % sizeof(T) != 0) body_ += '\0';
    put(body_, value);
  }
  void put_text(std::string_view text) {
    put_value(static_cast<std::uint32_t>(text.size() + 1));
    body_ += text;
    body_ += '\0';
  }
  void put_bytes(std::string_view bytes) { body_ += bytes; }
  void put_header(std::int64_t stamp_ns) {
    put_value(static_cast<std::int32_t>(stamp_ns / 1'000'000'000));
    put_value(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
    put_text("frame");
  }
  [[nodiscard]] std::string message() const { return std::string("\0\1\0\0", 4) + body_; }

 private:
  std::string body_ = {};
};

[[nodiscard]] inline std::string imu_cdr(std::int64_t stamp_ns, double gyro_x, double accel_z) {
  CdrWriter out;
  out.put_header(stamp_ns);
  for (int i = 0; i < 4 + 9; ++i) out.put_value(0.0);
  for (const double value : {gyro_x, 0.0, 0.0}) out.put_value(value);
  for (int i = 0; i < 9; ++i) out.put_value(0.0);
  for (const double value : {0.0, 0.0, accel_z}) out.put_value(value);
  for (int i = 0; i < 9; ++i) out.put_value(0.0);
  return out.message();
}

[[nodiscard]] inline std::string fix_cdr(std::int64_t stamp_ns,
                                         double latitude_deg,
                                         double variance) {
  CdrWriter out;
  out.put_header(stamp_ns);
  out.put_value(std::int8_t{0});
  out.put_value(std::uint16_t{1});
  for (const double value : {latitude_deg, 11.5, 520.0}) out.put_value(value);
  for (int i = 0; i < 9; ++i) out.put_value(i % 4 == 0 ? variance : 0.0);
  out.put_value(std::uint8_t{2});
  return out.message();
}

/// x, y, z, time as float32.
[[nodiscard]] inline std::string cloud_cdr(std::int64_t stamp_ns,
                                           const std::vector<std::vector<double>>& points) {
  CdrWriter out;
  out.put_header(stamp_ns);
  out.put_value(std::uint32_t{1});
  out.put_value(static_cast<std::uint32_t>(points.size()));
  out.put_value(std::uint32_t{4});
  std::uint32_t offset = 0;
  for (const char* const name : {"x", "y", "z", "time"}) {
    out.put_text(name);
    out.put_value(offset);
    out.put_value(std::uint8_t{7});
    out.put_value(std::uint32_t{1});
    offset += 4;
  }
  out.put_value(std::uint8_t{0});
  out.put_value(offset);
  out.put_value(static_cast<std::uint32_t>(offset * points.size()));
  std::string data;
  for (const std::vector<double>& point : points) {
    for (const double value : point) put(data, static_cast<float>(value));
  }
  out.put_value(static_cast<std::uint32_t>(data.size()));
  out.put_bytes(data);
  out.put_value(std::uint8_t{1});
  return out.message();
}

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

/// MCAP version 0 (mcap.dev/spec).
class McapBuilder {
 public:
  enum class Wire { kRos1, kCdr };
  struct Layout {
    std::string compression = "";  ///< "", "lz4", "zstd".
    Wire wire = Wire::kCdr;
    bool chunked = true;
    bool summary = true;
    bool finished = true;  ///< With the records that close the file.
  };

  [[nodiscard]] static std::string record(std::uint8_t op, std::string_view content) {
    std::string out = as_bytes(op) + as_bytes(static_cast<std::uint64_t>(content.size()));
    return out.append(content);
  }

  [[nodiscard]] static std::string build(const TestRecording& recording, const Layout& layout) {
    const std::string magic("\x89MCAP0\r\n", 8);
    const bool cdr = layout.wire == Wire::kCdr;
    std::string head;
    put_string(head, cdr ? "ros2" : "ros1");
    put_string(head, "test");
    std::string declarations;
    for (std::uint16_t i = 0; i < recording.topics.size(); ++i) {
      const TestTopic& topic = recording.topics[i];
      std::string schema = as_bytes(static_cast<std::uint16_t>(i + 1));
      put_string(schema, cdr ? topic.ros2_type() : topic.type);
      put_string(schema, cdr ? "ros2msg" : "ros1msg");
      put_string(schema, "...");
      std::string channel = as_bytes(i) + as_bytes(static_cast<std::uint16_t>(i + 1));
      put_string(channel, topic.name);
      put_string(channel, cdr ? "cdr" : "ros1");
      put(channel, std::uint32_t{0});
      declarations += record(3, schema) + record(4, channel);
    }
    std::string file = magic + record(1, head);
    std::string chunk_indexes;
    std::map<std::uint16_t, std::uint64_t> counts;
    if (!layout.chunked) file += declarations;
    std::string chunk;
    std::int64_t chunk_start = 0;
    std::int64_t chunk_end = 0;
    std::size_t in_chunk = 0;
    const auto end_chunk = [&] {
      if (in_chunk == 0) return;
      const std::string bytes = declarations + chunk;
      std::string content = as_bytes(chunk_start) + as_bytes(chunk_end);
      put(content, static_cast<std::uint64_t>(bytes.size()));
      put(content, std::uint32_t{0});
      put_string(content, layout.compression);
      const std::string stored =
          layout.compression == "zstd" ? zstd_packed(bytes) : packed(layout.compression, bytes);
      put(content, static_cast<std::uint64_t>(stored.size()));
      content += stored;
      std::string index = as_bytes(chunk_start) + as_bytes(chunk_end);
      put(index, static_cast<std::uint64_t>(file.size()));
      const std::string whole = record(6, content);
      put(index, static_cast<std::uint64_t>(whole.size()));
      put(index, std::uint32_t{0});  // no message index
      put(index, std::uint64_t{0});
      put_string(index, layout.compression);
      put(index, static_cast<std::uint64_t>(stored.size()));
      put(index, static_cast<std::uint64_t>(bytes.size()));
      chunk_indexes += record(8, index);
      file += whole;
      chunk.clear();
      in_chunk = 0;
    };
    for (const TestMessage& message : recording.messages) {
      std::string content = as_bytes(message.topic) + as_bytes(std::uint32_t{0});
      put(content, static_cast<std::uint64_t>(message.time_ns));
      put(content, static_cast<std::uint64_t>(message.time_ns));
      content += cdr ? message.cdr : message.ros1;
      ++counts[message.topic];
      if (!layout.chunked) {
        file += record(5, content);
        continue;
      }
      if (in_chunk == 0) chunk_start = message.time_ns;
      chunk_end = message.time_ns;
      chunk += record(5, content);
      if (++in_chunk == 40) end_chunk();
    }
    end_chunk();
    if (!layout.finished) return file;
    file += record(15, as_bytes(std::uint32_t{0}));
    const std::uint64_t summary_start = layout.summary ? file.size() : 0;
    if (layout.summary) {
      std::string statistics = as_bytes(std::uint64_t{recording.messages.size()});
      put(statistics, static_cast<std::uint16_t>(recording.topics.size()));
      for (int i = 0; i < 4; ++i) put(statistics, std::uint32_t{0});
      for (int i = 0; i < 2; ++i) put(statistics, std::uint64_t{0});
      put(statistics, static_cast<std::uint32_t>(counts.size() * 10));
      for (const auto& [topic, count] : counts) statistics += as_bytes(topic) + as_bytes(count);
      file += declarations + record(11, statistics) + chunk_indexes;
    }
    return file + record(2, as_bytes(summary_start) + std::string(12, '\0')) + magic;
  }
};

/// Writes a .db3 file. @param pack  Compresses each message (rosbag2's message mode).
inline void write_db3(const std::filesystem::path& path,
                      const TestRecording& recording,
                      std::size_t begin,
                      std::size_t end,
                      bool pack = false) {
  sqlite3* db = nullptr;
  sqlite3_open(path.c_str(), &db);
  const auto run = [db](const std::string& sql) {
    sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr);
  };
  run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
      "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
  run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER "
      "NOT NULL, data BLOB NOT NULL)");
  run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)");
  run("BEGIN");
  for (std::size_t i = 0; i < recording.topics.size(); ++i) {
    run(fmt::format("INSERT INTO topics VALUES({}, '{}', '{}', 'cdr', '')",
                    i + 1,
                    recording.topics[i].name,
                    recording.topics[i].ros2_type()));
  }
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(
      db, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", -1, &insert, nullptr);
  for (std::size_t i = begin; i < end; ++i) {
    const TestMessage& message = recording.messages[i];
    const std::string data = pack ? zstd_packed(message.cdr) : message.cdr;
    sqlite3_bind_int64(insert, 1, message.topic + 1);
    sqlite3_bind_int64(insert, 2, message.time_ns);
    sqlite3_bind_blob(insert, 3, data.data(), static_cast<int>(data.size()), SQLITE_TRANSIENT);
    sqlite3_step(insert);
    sqlite3_reset(insert);
  }
  sqlite3_finalize(insert);
  run("COMMIT");
  sqlite3_close(db);
}

[[nodiscard]] inline std::string metadata_yaml(const TestRecording& recording,
                                               const std::vector<std::string>& files,
                                               const std::string& mode) {
  std::string out = fmt::format(
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
      "  compression_format: \"{}\"\n  compression_mode: \"{}\"\n  relative_file_paths:\n",
      mode.empty() ? "" : "zstd",
      mode);
  for (const std::string& file : files) out += fmt::format("    - {}\n", file);
  out += "  topics_with_message_count:\n";
  for (std::size_t i = 0; i < recording.topics.size(); ++i) {
    const auto count = std::count_if(recording.messages.begin(),
                                     recording.messages.end(),
                                     [i](const TestMessage& m) { return m.topic == i; });
    out += fmt::format(
        "    - topic_metadata:\n        name: {}\n        type: {}\n        serialization_format: "
        "cdr\n        offered_qos_profiles: \"\"\n      message_count: {}\n",
        recording.topics[i].name,
        recording.topics[i].ros2_type(),
        count);
  }
  return out;
}

}  // namespace hybridfusion::testing
