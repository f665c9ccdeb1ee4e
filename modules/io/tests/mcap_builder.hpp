#pragma once

/// @file
/// Makes MCAP files for tests, written from the description of the format, independent of the
/// reader.

#include "test_recording.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hybridfusion::testing {

/// MCAP version 0 (mcap.dev/spec).
class McapBuilder {
 public:
  enum class Wire { kRos1, kCdr };
  struct Layout {
    std::string compression = "";  ///< "", "lz4", "zstd".
    Wire wire = Wire::kCdr;
    bool chunked = true;
    bool summary = true;
    bool finished = true;              ///< With the records that close the file.
    std::size_t outside_above = 0;     ///< Larger messages stand between the chunks; 0: none.
    std::size_t unindexed_chunks = 0;  ///< The last ones are missing in the index.
    std::int64_t miscounted = 0;       ///< Added to the number of messages in the statistics.
    bool channel_counts = true;
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
    std::vector<std::string> chunk_indexes;
    std::string outside;
    std::map<std::uint16_t, std::uint64_t> counts;
    if (!layout.chunked || layout.outside_above > 0) file += declarations;
    std::string chunk;
    std::int64_t chunk_start = 0;
    std::int64_t chunk_end = 0;
    std::size_t in_chunk = 0;
    const auto end_chunk = [&] {
      const std::string after = std::exchange(outside, {});
      if (in_chunk == 0) {
        file += after;
        return;
      }
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
      chunk_indexes.push_back(record(8, index));
      file += whole + after;
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
      if (layout.outside_above > 0 && content.size() > layout.outside_above) {
        outside += record(5, content);
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
      std::string statistics = as_bytes(static_cast<std::uint64_t>(
          static_cast<std::int64_t>(recording.messages.size()) + layout.miscounted));
      if (!layout.channel_counts) counts.clear();
      put(statistics, static_cast<std::uint16_t>(recording.topics.size()));
      for (int i = 0; i < 4; ++i) put(statistics, std::uint32_t{0});
      for (int i = 0; i < 2; ++i) put(statistics, std::uint64_t{0});
      put(statistics, static_cast<std::uint32_t>(counts.size() * 10));
      for (const auto& [topic, count] : counts) statistics += as_bytes(topic) + as_bytes(count);
      file += declarations + record(11, statistics);
      chunk_indexes.resize(chunk_indexes.size() -
                           std::min(chunk_indexes.size(), layout.unindexed_chunks));
      for (const std::string& index : chunk_indexes) file += index;
    }
    return file + record(2, as_bytes(summary_start) + std::string(12, '\0')) + magic;
  }
};

}  // namespace hybridfusion::testing
