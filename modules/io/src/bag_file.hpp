#pragma once

#include "input_file.hpp"
#include "rosbag_records.hpp"

#include <hybridfusion/io/rosbag1.hpp>

#include <unordered_map>

namespace hybridfusion {

/// The records of a ROS 1 bag: its index if that is sound, and its chunks one at a time.
class BagFile {
 public:
  struct ChunkInfo {
    std::uint64_t position = 0;  ///< Byte offset of the chunk record.
    Timestamp start{};           ///< Earliest message.
  };

  [[nodiscard]] static Expected<BagFile> open(const std::filesystem::path& path,
                                              const std::filesystem::path& name);

  [[nodiscard]] bool has_index() const { return !chunks_.empty(); }
  /// From the index, in file order.
  [[nodiscard]] const std::vector<ChunkInfo>& chunks() const { return chunks_; }
  [[nodiscard]] const std::vector<BagConnection>& connections() const { return connections_; }
  [[nodiscard]] const BagConnection* find_connection(std::uint32_t id) const;
  [[nodiscard]] bool truncated() const { return truncated_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  /// Messages of the chunk at a byte offset, in file order. A damaged chunk gives what could be
  /// recovered and a warning.
  [[nodiscard]] Expected<std::vector<BagMessage>> read_chunk_at(std::uint64_t position);
  /// Messages of the next chunk in the file; nothing at the end or where the records break off.
  [[nodiscard]] Expected<std::optional<std::vector<BagMessage>>> read_next_chunk();
  /// Back to the first chunk; forgets warnings, which reading again repeats.
  void rewind();

 private:
  struct Record {
    BagFields fields = {};
    std::vector<std::byte> header = {};  ///< What `fields` points into.
    std::uint64_t position = 0;
    std::uint64_t data_bytes = 0;  ///< As declared; the file may end before.
  };

  explicit BagFile(InputFile file) : file_(std::move(file)) {}
  /// The record header at the current position; nothing when there is no sound one.
  [[nodiscard]] Expected<std::optional<Record>> read_record_header();
  [[nodiscard]] Expected<void> read_bag_header();
  [[nodiscard]] Expected<bool> read_index(std::uint64_t position, std::uint32_t num_chunks);
  [[nodiscard]] Expected<std::vector<BagMessage>> read_chunk_data(const Record& record);
  void parse_chunk(const std::shared_ptr<const std::vector<std::byte>>& storage,
                   std::uint64_t position,
                   std::vector<BagMessage>& messages);
  void add_connection(const BagFields& fields, std::span<const std::byte> data);
  void warn(std::string text);
  void mark_truncated(std::uint64_t position);

  InputFile file_;
  std::uint64_t first_record_ = 0;
  std::vector<BagConnection> connections_ = {};
  std::unordered_map<std::uint32_t, std::size_t> connection_index_ = {};
  std::vector<ChunkInfo> chunks_ = {};
  std::vector<std::string> warnings_ = {};
  bool truncated_ = false;
  bool index_lost_ = false;
  bool cut_before_index_ = false;
};

}  // namespace hybridfusion
