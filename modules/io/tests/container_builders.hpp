#pragma once

/// @file
/// One small recording in every container, for tests. Written from the formats' descriptions,
/// independent of the readers.

#include "cdr_messages.hpp"
#include "mcap_builder.hpp"
#include "test_recording.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sqlite3.h>

namespace hybridfusion::testing {

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
