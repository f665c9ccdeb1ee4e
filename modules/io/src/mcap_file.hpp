#pragma once

#include "input_file.hpp"

#include <hybridfusion/io/rosbag1.hpp>

#include <functional>
#include <unordered_map>

namespace hybridfusion {

/// The records of an MCAP file (mcap.dev/spec, version 0): the summary if it is sound, and chunks
/// one at a time. Messages outside chunks are given in groups, as if they were chunks.
class McapFile {
 public:
  struct ChunkInfo {
    std::uint64_t position = 0;  ///< Byte offset of the chunk record.
    Timestamp start{};           ///< Earliest message.
    std::uint64_t end = 0;       ///< Behind the chunk and the message indexes that follow it.
  };

  /// @param name  What messages call the file; empty: its path.
  [[nodiscard]] static Expected<McapFile> open(const std::filesystem::path& path,
                                               const std::filesystem::path& name);

  [[nodiscard]] bool has_index() const { return !chunks_.empty(); }
  /// From the summary, in file order.
  [[nodiscard]] const std::vector<ChunkInfo>& chunks() const { return chunks_; }
  /// Channels of ROS 1 or CDR messages; others are left out.
  [[nodiscard]] const std::vector<BagConnection>& connections() const { return connections_; }
  [[nodiscard]] const BagConnection* find_connection(std::uint32_t id) const;
  [[nodiscard]] bool truncated() const { return truncated_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// As BagFile.
  [[nodiscard]] Expected<std::vector<BagMessage>> read_chunk_at(std::uint64_t position);
  [[nodiscard]] Expected<std::optional<std::vector<BagMessage>>> read_next_chunk();
  void rewind();
  /// Compares what was read with what the file says of itself; to be called at the end.
  void note_end();

 private:
  using Storage = std::shared_ptr<const std::vector<std::byte>>;
  using Bytes = std::span<const std::byte>;

  explicit McapFile(InputFile file) : file_(std::move(file)) {}
  /// False when there is none that is sound.
  [[nodiscard]] Expected<bool> read_summary();
  [[nodiscard]] bool read_statistics(Bytes content);
  /// Whether the index leaves out messages or chunks: some writers put large messages between the
  /// chunks, and an index may be older than the file.
  [[nodiscard]] Expected<bool> index_is_incomplete(std::uint64_t data_end);
  [[nodiscard]] Expected<bool> holds_messages(std::uint64_t begin, std::uint64_t end);
  [[nodiscard]] bool add_chunk_info(Bytes content, std::uint64_t summary_start);
  [[nodiscard]] Expected<std::vector<BagMessage>> read_chunk(std::uint64_t position,
                                                             std::uint64_t content_bytes);
  void parse_records(const Storage& storage,
                     std::uint64_t position,
                     std::vector<BagMessage>& messages);
  void add_schema(Bytes content);
  void add_channel(Bytes content);
  void add_message(Bytes content, const Storage& storage, std::vector<BagMessage>& messages);
  void warn(std::string text);
  void mark_truncated(std::uint64_t position);
  void forget_summary();

  InputFile file_;
  std::unordered_map<std::uint16_t, std::string> schemas_ = {};  ///< Names by id.
  std::vector<BagConnection> connections_ = {};
  std::unordered_map<std::uint32_t, std::size_t> connection_index_ = {};
  std::vector<ChunkInfo> chunks_ = {};
  std::optional<std::uint64_t> declared_messages_ = {};  ///< Of all channels, by the statistics.
  std::uint64_t num_messages_ = 0;                       ///< Read since the last rewind.
  std::vector<std::string> warnings_ = {};
  bool truncated_ = false;
  bool ended_ = false;  ///< The end was met, or its absence noted.
};

}  // namespace hybridfusion
