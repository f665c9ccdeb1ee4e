#include "mcap_file.hpp"

#include "mcap_records.hpp"
#include "rosbag_records.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxConnections = 65536;
constexpr std::size_t kMaxWarnings = 50;

}  // namespace

Expected<McapFile> McapFile::open(const std::filesystem::path& path,
                                  const std::filesystem::path& name) {
  HF_TRY(InputFile file, InputFile::open(path, name));
  HF_TRY(const auto first, file.take(std::min<std::uint64_t>(file.size(), kMcapMagic.size())));
  if (std::string_view(reinterpret_cast<const char*>(first.data()), first.size()) != kMcapMagic) {
    return file.malformed("not an MCAP file of version 0", "give an .mcap recording");
  }
  McapFile mcap(std::move(file));
  if (auto summary = mcap.read_summary(); !summary) return std::unexpected(summary.error());
  mcap.rewind();
  return mcap;
}

void McapFile::warn(std::string text) {
  if (warnings_.size() < kMaxWarnings) warnings_.push_back(std::move(text));
  if (warnings_.size() == kMaxWarnings) warnings_.emplace_back("further warnings are left out");
}

void McapFile::mark_truncated(std::uint64_t position) {
  truncated_ = true;
  warn(fmt::format("{}: the recording breaks off at byte {} of {}; everything before is used",
                   file_.path().string(),
                   position,
                   file_.size()));
}

void McapFile::rewind() {
  warnings_.clear();
  truncated_ = false;
  ended_ = false;
  num_messages_ = 0;
  file_.seek(kMcapMagic.size());
}

void McapFile::add_schema(Bytes content) {
  ByteReader reader(content);
  const auto id = reader.read<std::uint16_t>();
  const std::string_view name = reader.read_string();
  if (!reader.failed() && schemas_.size() < kMaxConnections) schemas_.try_emplace(id, name);
}

void McapFile::add_channel(Bytes content) {
  ByteReader reader(content);
  const auto id = reader.read<std::uint16_t>();
  const auto schema = reader.read<std::uint16_t>();
  const std::string_view topic = reader.read_string();
  const std::string_view encoding = reader.read_string();
  const bool readable = encoding == "cdr" || encoding == "ros1";
  if (reader.failed() || !readable || connection_index_.contains(id)) return;
  const auto type = schemas_.find(schema);
  connection_index_.emplace(id, connections_.size());
  connections_.push_back({.id = id,
                          .topic = std::string(topic),
                          .type = type == schemas_.end() ? "unknown" : type->second,
                          .wire = encoding == "cdr" ? RosWire::kCdr : RosWire::kRos1});
}

void McapFile::add_message(Bytes content,
                           const Storage& storage,
                           std::vector<BagMessage>& messages) {
  ByteReader reader(content);
  const auto channel = reader.read<std::uint16_t>();
  reader.skip(sizeof(std::uint32_t));  // sequence number
  const auto log_time = reader.read<std::uint64_t>();
  reader.skip(sizeof(std::uint64_t));  // publish time
  ++num_messages_;
  if (reader.failed() || !connection_index_.contains(channel)) return;
  messages.push_back({.connection = channel,
                      .time = mcap_time(log_time),
                      .data = reader.take(reader.remaining()),
                      .storage = storage});
}

const BagConnection* McapFile::find_connection(std::uint32_t id) const {
  const auto found = connection_index_.find(id);
  return found == connection_index_.end() ? nullptr : &connections_[found->second];
}

void McapFile::parse_records(const Storage& storage,
                             std::uint64_t position,
                             std::vector<BagMessage>& messages) {
  ByteReader reader(*storage);
  while (reader.remaining() >= kMcapHeaderBytes) {
    const McapHeader header = mcap_header(reader.take(kMcapHeaderBytes));
    if (header.content_bytes > reader.remaining()) {
      warn(fmt::format("{}: a damaged record in the chunk at byte {}; the rest of it is skipped",
                       file_.path().string(),
                       position));
      return;
    }
    const auto content = reader.take(header.content_bytes);
    if (header.op == McapOp::kSchema) add_schema(content);
    if (header.op == McapOp::kChannel) add_channel(content);
    if (header.op == McapOp::kMessage) add_message(content, storage, messages);
  }
}

Expected<std::vector<BagMessage>> McapFile::read_chunk(std::uint64_t position,
                                                       std::uint64_t content_bytes) {
  if (content_bytes > kMaxMcapRecordBytes) {
    warn(fmt::format("{}: the chunk at byte {} announces {} bytes; it is skipped",
                     file_.path().string(),
                     position,
                     content_bytes));
    return std::vector<BagMessage>{};
  }
  const bool complete = content_bytes <= file_.remaining();
  HF_TRY(const auto content, file_.take(std::min(content_bytes, file_.remaining())));
  ByteReader reader(content);
  reader.skip(2 * sizeof(std::uint64_t));  // times
  const auto unpacked_bytes = reader.read<std::uint64_t>();
  reader.skip(sizeof(std::uint32_t));  // CRC
  const std::string_view compression = reader.read_string();
  const auto packed_bytes = reader.read<std::uint64_t>();
  if (reader.failed() || (complete && packed_bytes > reader.remaining())) {
    warn(fmt::format(
        "{}: the chunk at byte {} is damaged; it is skipped", file_.path().string(), position));
    return std::vector<BagMessage>{};
  }
  Decompressed unpacked =
      decompress_chunk(compression.empty() ? "none" : compression,
                       reader.take(std::min<std::uint64_t>(packed_bytes, reader.remaining())),
                       unpacked_bytes);
  if (!complete) {
    mark_truncated(position);
  } else if (!unpacked.problem.empty()) {
    warn(fmt::format("{}: the chunk at byte {} is damaged: {}; {} bytes of it are used",
                     file_.path().string(),
                     position,
                     unpacked.problem,
                     unpacked.bytes.size()));
  }
  std::vector<BagMessage> messages;
  parse_records(std::make_shared<const std::vector<std::byte>>(std::move(unpacked.bytes)),
                position,
                messages);
  return messages;
}

Expected<std::vector<BagMessage>> McapFile::read_chunk_at(std::uint64_t position) {
  file_.seek(position);
  HF_TRY(const auto bytes, file_.take(std::min(kMcapHeaderBytes, file_.remaining())));
  if (bytes.size() < kMcapHeaderBytes || mcap_header(bytes).op != McapOp::kChunk) {
    warn(fmt::format("{}: no chunk at byte {}, where the index has one; it is skipped",
                     file_.path().string(),
                     position));
    return std::vector<BagMessage>{};
  }
  return read_chunk(position, mcap_header(bytes).content_bytes);
}

Expected<std::optional<std::vector<BagMessage>>> McapFile::read_next_chunk() {
  constexpr std::size_t kGroupBytes = std::size_t{1} << 20;
  std::vector<BagMessage> group;
  std::size_t group_bytes = 0;
  while (file_.remaining() > 0 && group_bytes < kGroupBytes) {
    const std::uint64_t position = file_.position();
    HF_TRY(const auto bytes, file_.take(std::min(kMcapHeaderBytes, file_.remaining())));
    const bool whole = bytes.size() == kMcapHeaderBytes;
    const McapHeader header = whole ? mcap_header(bytes) : McapHeader{};
    if (whole && header.op == McapOp::kDataEnd) {
      ended_ = true;
      file_.seek(file_.size());
      break;
    }
    if (whole && header.op == McapOp::kChunk && header.content_bytes <= kMaxMcapRecordBytes) {
      if (!group.empty()) {
        file_.seek(position);
        break;
      }
      HF_TRY(auto messages, read_chunk(position, header.content_bytes));
      return messages;
    }
    if (!whole || header.content_bytes > file_.remaining() ||
        header.content_bytes > kMaxMcapRecordBytes) {
      mark_truncated(position);
      file_.seek(file_.size());
      break;
    }
    HF_TRY(const auto content, file_.take(header.content_bytes));
    if (header.op == McapOp::kSchema) add_schema(content);
    if (header.op == McapOp::kChannel) add_channel(content);
    if (header.op == McapOp::kMessage) {
      const auto storage =
          std::make_shared<const std::vector<std::byte>>(content.begin(), content.end());
      add_message(*storage, storage, group);
      group_bytes += content.size();
    }
  }
  if (file_.remaining() == 0 && !ended_) {
    if (!truncated_) mark_truncated(file_.size());  // as left by a recorder that was killed
    ended_ = true;
  }
  if (group.empty()) return std::nullopt;
  return group;
}

}  // namespace hybridfusion
