#pragma once

#include "byte_writer.hpp"
#include "output_file.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/time.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Type of a ROS 1 message as a bag declares it.
struct RosMessageType {
  std::string_view name = {};
  std::string_view md5 = {};
  std::string_view definition = {};
};

/// Writes a ROS 1 bag, format 2.0, with chunks of about 768 KiB and a complete index
/// (http://wiki.ros.org/Bags/Format/2.0).
class BagWriter {
 public:
  /// @param compression  "none", "bz2" or "lz4".
  [[nodiscard]] static Expected<BagWriter> create(const std::filesystem::path& path,
                                                  const std::string& compression);

  /// @returns the connection's id.
  std::uint32_t add_connection(std::string topic, const RosMessageType& type);
  /// Messages come in the order of recording.
  [[nodiscard]] Expected<void> write(std::uint32_t connection,
                                     Timestamp time,
                                     std::string_view message);
  /// Writes index and header; the bag is unreadable before.
  [[nodiscard]] Expected<void> close();

 private:
  struct Connection {
    std::string topic = {};
    RosMessageType type = {};
    bool announced = false;
  };
  struct IndexEntry {
    Timestamp time{};
    std::uint32_t offset = 0;
  };
  struct ChunkInfo {
    std::uint64_t position = 0;
    Timestamp first{};
    Timestamp last{};
    std::map<std::uint32_t, std::uint32_t> counts = {};
  };

  explicit BagWriter(OutputFile file, std::string compression)
      : file_(std::move(file)), compression_(std::move(compression)) {}
  [[nodiscard]] std::string connection_record(std::uint32_t id) const;
  [[nodiscard]] std::string bag_header(std::uint64_t index_position) const;
  [[nodiscard]] Expected<void> flush_chunk();

  OutputFile file_;
  std::string compression_;
  std::vector<Connection> connections_ = {};
  ByteWriter chunk_ = {};
  std::map<std::uint32_t, std::vector<IndexEntry>> chunk_index_ = {};
  std::vector<ChunkInfo> chunks_ = {};
};

}  // namespace hybridfusion
