#include "bag_file.hpp"

#include "byte_reader.hpp"
#include "text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::uint64_t kMaxHeaderBytes = 1U << 20;
constexpr std::size_t kMaxConnections = 65536;
constexpr std::size_t kMaxWarnings = 50;

/// What a file is that is not a ROS 1 bag 2.0, with the way out.
[[nodiscard]] std::pair<std::string_view, std::string_view> describe_other(std::string_view start) {
  if (start.starts_with("\x1f\x8b")) return {"compressed with gzip", "unpack it first (gunzip)"};
  if (start.starts_with("BZh")) return {"compressed with bzip2", "unpack it first (bunzip2)"};
  for (const std::string_view magic :
       {"\xd4\xc3\xb2\xa1", "\xa1\xb2\xc3\xd4", "\x4d\x3c\xb2\xa1", "\x0a\x0d\x0d\x0a"}) {
    if (start.starts_with(magic)) {
      return {"a capture of network packets (pcap)",
              "decode it with the driver of the LiDAR (velodyne_pointcloud, ouster_ros, "
              "hesai_ros_driver, rslidar_sdk: each replays pcap files) and record its points and "
              "the IMU"};
    }
  }
  if (start.starts_with("#ROSBAG") || start.starts_with("#ROSRECORD")) {
    return {"a bag of an older format than 2.0", "convert it with 'rosbag fix'"};
  }
  return {
      "not a ROS 1 bag (it does not start with '#ROSBAG V2.0'), nor a ROS 2 bag (.db3, .mcap), "
      "nor one of these compressed with zstd",
      "give a recording of LiDAR and IMU"};
}

/// Messages by connection id.
using Counts = std::unordered_map<std::uint32_t, std::uint64_t>;

void add_counts(std::span<const std::byte> chunk_info, Counts& counts) {
  ByteReader reader(chunk_info);
  while (reader.remaining() >= 2 * sizeof(std::uint32_t)) {
    const auto id = reader.read<std::uint32_t>();
    counts[id] += reader.read<std::uint32_t>();
  }
}

}  // namespace

Expected<BagFile> BagFile::open(const std::filesystem::path& path,
                                const std::filesystem::path& name) {
  HF_TRY(InputFile file, InputFile::open(path, name));
  constexpr std::uint64_t kLongestMagic = 16;
  HF_TRY(const auto first, file.take(std::min(file.size(), kLongestMagic)));
  const std::string_view start(reinterpret_cast<const char*>(first.data()), first.size());
  if (!start.starts_with(kMagic)) {
    const auto [cause, remedy] = describe_other(start);
    return file.malformed(cause, remedy);
  }
  file.seek(kMagic.size());
  BagFile bag(std::move(file));
  if (auto header = bag.read_bag_header(); !header) return std::unexpected(header.error());
  return bag;
}

void BagFile::warn(std::string text) {
  if (warnings_.size() < kMaxWarnings) warnings_.push_back(std::move(text));
  if (warnings_.size() == kMaxWarnings) warnings_.emplace_back("further warnings are left out");
}

void BagFile::mark_truncated(std::uint64_t position) {
  truncated_ = true;
  warn(fmt::format("{}: the recording breaks off at byte {} of {}; everything before is used",
                   file_.path().string(),
                   position,
                   file_.size()));
}

Expected<std::optional<BagFile::Record>> BagFile::read_record_header() {
  Record record = {.position = file_.position()};
  if (file_.remaining() < sizeof(std::uint32_t)) return std::nullopt;
  HF_TRY(const auto length_bytes, file_.take(sizeof(std::uint32_t)));
  const auto header_bytes = load<std::uint32_t>(length_bytes.data());
  if (header_bytes > kMaxHeaderBytes || file_.remaining() < header_bytes + sizeof(std::uint32_t)) {
    return std::nullopt;
  }
  HF_TRY(const auto header, file_.take(header_bytes));
  record.header.assign(header.begin(), header.end());
  HF_TRY(const auto data_length, file_.take(sizeof(std::uint32_t)));
  record.data_bytes = load<std::uint32_t>(data_length.data());
  auto fields = BagFields::parse(record.header);
  if (!fields || !fields->op()) return std::nullopt;
  record.fields = std::move(*fields);
  return record;
}

Expected<void> BagFile::read_bag_header() {
  HF_TRY(const auto record, read_record_header());
  if (!record || record->fields.op() != BagOp::kBagHeader) {
    return file_.malformed("the bag header is missing or damaged", "record or copy the bag again");
  }
  first_record_ = file_.position() + std::min(record->data_bytes, file_.remaining());
  const std::uint64_t index_position = record->fields.u64("index_pos").value_or(0);
  const std::uint32_t num_chunks = record->fields.u32("chunk_count").value_or(0);
  bool indexed = false;
  if (index_position >= first_record_ && index_position < file_.size()) {
    HF_TRY(indexed, read_index(index_position, num_chunks));
  }
  // A bag that was closed without a message has an index but no chunk; the records say it all.
  index_lost_ = !indexed;
  cut_before_index_ = index_position >= file_.size();
  rewind();
  return {};
}

void BagFile::rewind() {
  warnings_.clear();
  truncated_ = cut_before_index_;
  if (index_lost_) {
    warn(fmt::format("{}: the bag has no usable index ({}); reading it from the start",
                     file_.path().string(),
                     cut_before_index_ ? "the file was cut" : "recording not closed properly?"));
  }
  file_.seek(first_record_);
}

Expected<bool> BagFile::read_index(std::uint64_t position, std::uint32_t num_chunks) {
  file_.seek(position);
  std::vector<ChunkInfo> chunks;
  Counts counts;
  bool sound = true;
  while (sound && file_.remaining() > 0) {
    HF_TRY(const auto record, read_record_header());
    sound = record && record->data_bytes <= file_.remaining();
    if (!sound) break;
    HF_TRY(const auto data, file_.take(record->data_bytes));
    if (record->fields.op() == BagOp::kConnection) {
      add_connection(record->fields, data);
    } else if (record->fields.op() == BagOp::kChunkInfo) {
      const auto chunk = record->fields.u64("chunk_pos");
      const auto start = record->fields.time("start_time");
      sound = chunk && start && *chunk >= first_record_ && *chunk < position;
      if (sound) chunks.push_back({.position = *chunk, .start = *start});
      if (sound) add_counts(data, counts);
    }
  }
  if (!sound || chunks.size() != num_chunks) {
    connections_.clear();
    connection_index_.clear();
    return false;
  }
  for (BagConnection& connection : connections_) {
    connection.messages = counts[connection.id];
  }
  std::ranges::stable_sort(chunks, {}, &ChunkInfo::position);
  chunks_ = std::move(chunks);
  return true;
}

void BagFile::add_connection(const BagFields& fields, std::span<const std::byte> data) {
  const auto id = fields.u32("conn");
  const auto topic = fields.text("topic");
  const auto description = BagFields::parse(data);
  if (!id || !topic || !description || connections_.size() >= kMaxConnections ||
      connection_index_.contains(*id)) {
    return;
  }
  connection_index_.emplace(*id, connections_.size());
  connections_.push_back({.id = *id,
                          .topic = std::string(*topic),
                          .type = std::string(description->text("type").value_or("unknown"))});
}

const BagConnection* BagFile::find_connection(std::uint32_t id) const {
  const auto found = connection_index_.find(id);
  return found == connection_index_.end() ? nullptr : &connections_[found->second];
}

Expected<std::vector<BagMessage>> BagFile::read_chunk_at(std::uint64_t position) {
  file_.seek(position);
  HF_TRY(const auto record, read_record_header());
  if (!record || record->fields.op() != BagOp::kChunk) {
    warn(fmt::format("{}: no chunk at byte {}, where the index has one; it is skipped",
                     file_.path().string(),
                     position));
    return std::vector<BagMessage>{};
  }
  return read_chunk_data(*record);
}

Expected<std::optional<std::vector<BagMessage>>> BagFile::read_next_chunk() {
  while (file_.remaining() > 0) {
    const std::uint64_t position = file_.position();
    HF_TRY(const auto record, read_record_header());
    if (!record) {
      mark_truncated(position);
      file_.seek(file_.size());
      return std::nullopt;
    }
    if (record->fields.op() == BagOp::kChunk) {
      HF_TRY(auto messages, read_chunk_data(*record));
      return messages;
    }
    if (record->data_bytes > file_.remaining()) {
      mark_truncated(position);
      file_.seek(file_.size());
      return std::nullopt;
    }
    HF_TRY(const auto data, file_.take(record->data_bytes));
    if (record->fields.op() == BagOp::kConnection) add_connection(record->fields, data);
  }
  return std::nullopt;
}

Expected<std::vector<BagMessage>> BagFile::read_chunk_data(const Record& record) {
  const bool complete = record.data_bytes <= file_.remaining();
  HF_TRY(const auto packed, file_.take(std::min(record.data_bytes, file_.remaining())));
  Decompressed unpacked = decompress_chunk(record.fields.text("compression").value_or("none"),
                                           packed,
                                           record.fields.u32("size").value_or(0));
  if (!complete) {
    mark_truncated(record.position);
  } else if (!unpacked.problem.empty()) {
    warn(fmt::format("{}: the chunk at byte {} is damaged: {}; {} bytes of it are used",
                     file_.path().string(),
                     record.position,
                     unpacked.problem,
                     unpacked.bytes.size()));
  }
  const auto storage = std::make_shared<const std::vector<std::byte>>(std::move(unpacked.bytes));
  std::vector<BagMessage> messages;
  parse_chunk(storage, record.position, messages);
  return messages;
}

void BagFile::parse_chunk(const std::shared_ptr<const std::vector<std::byte>>& storage,
                          std::uint64_t position,
                          std::vector<BagMessage>& messages) {
  ByteReader reader(*storage);
  while (reader.remaining() > 0) {
    const auto header = reader.take(reader.read<std::uint32_t>());
    const auto data = reader.take(reader.read<std::uint32_t>());
    if (reader.failed()) return;  // the tail of a chunk that was cut; reported with its cause
    const auto fields = BagFields::parse(header);
    if (!fields || !fields->op()) {
      warn(fmt::format("{}: a damaged record in the chunk at byte {}; the rest of it is skipped",
                       file_.path().string(),
                       position));
      return;
    }
    if (fields->op() == BagOp::kConnection) add_connection(*fields, data);
    if (fields->op() != BagOp::kMessage) continue;
    const auto connection = fields->u32("conn");
    const auto time = fields->time("time");
    if (!connection || !time) continue;
    messages.push_back(
        {.connection = *connection, .time = *time, .data = data, .storage = storage});
  }
}

}  // namespace hybridfusion
