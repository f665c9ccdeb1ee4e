#include "mcap_file.hpp"
#include "mcap_records.hpp"

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kFooterBytes = 20;

[[nodiscard]] bool is_summary_record(McapOp op) {
  return op == McapOp::kSchema || op == McapOp::kChannel || op == McapOp::kChunkIndex ||
         op == McapOp::kStatistics;
}

}  // namespace

void McapFile::forget_summary() {
  schemas_.clear();
  connections_.clear();
  connection_index_.clear();
  chunks_.clear();
  declared_messages_.reset();
}

Expected<bool> McapFile::read_summary() {
  const std::uint64_t end_bytes = kMcapHeaderBytes + kFooterBytes + kMcapMagic.size();
  if (file_.size() < kMcapMagic.size() + end_bytes) return false;
  const std::uint64_t footer = file_.size() - end_bytes;
  file_.seek(footer);
  HF_TRY(const auto tail, file_.take(end_bytes));
  const McapHeader footer_header = mcap_header(tail);
  const auto start = load<std::uint64_t>(tail.data() + kMcapHeaderBytes);
  const bool sound =
      footer_header.op == McapOp::kFooter && footer_header.content_bytes == kFooterBytes &&
      std::ranges::equal(tail.last(kMcapMagic.size()), std::as_bytes(std::span(kMcapMagic)));
  if (!sound || start < kMcapMagic.size() || start >= footer) return false;
  file_.seek(start);
  bool usable = true;
  while (usable && file_.position() + kMcapHeaderBytes <= footer) {
    HF_TRY(const auto bytes, file_.take(kMcapHeaderBytes));
    const McapHeader header = mcap_header(bytes);
    usable = header.content_bytes <= std::min(footer - file_.position(), kMaxMcapRecordBytes);
    if (!usable) break;
    if (!is_summary_record(header.op)) {
      if (auto skipped = file_.skip(header.content_bytes); !skipped) {
        return std::unexpected(skipped.error());
      }
      continue;
    }
    HF_TRY(const auto content, file_.take(header.content_bytes));
    if (header.op == McapOp::kSchema) add_schema(content);
    if (header.op == McapOp::kChannel) add_channel(content);
    if (header.op == McapOp::kChunkIndex) usable = add_chunk_info(content, start);
    if (header.op == McapOp::kStatistics) usable = read_statistics(content);
  }
  // Without chunks in the summary the records are read one after the other; they tell all again.
  if (!usable || connections_.empty()) forget_summary();
  std::ranges::stable_sort(chunks_, {}, &ChunkInfo::position);
  HF_TRY(const bool incomplete, index_is_incomplete(start));
  if (incomplete) chunks_.clear();
  return usable;
}

Expected<bool> McapFile::index_is_incomplete(std::uint64_t data_end) {
  std::uint64_t end = kMcapMagic.size();
  for (const ChunkInfo& chunk : chunks_) {
    if (chunk.position < end || chunk.end > data_end) return true;
    HF_TRY(const bool found, holds_messages(end, chunk.position));
    if (found) return true;
    end = chunk.end;
  }
  return holds_messages(end, data_end);
}

Expected<bool> McapFile::holds_messages(std::uint64_t begin, std::uint64_t end) {
  file_.seek(begin);
  while (file_.position() + kMcapHeaderBytes <= end) {
    HF_TRY(const auto bytes, file_.take(kMcapHeaderBytes));
    const McapHeader header = mcap_header(bytes);
    if (header.op == McapOp::kMessage || header.op == McapOp::kChunk) return true;
    if (header.content_bytes > end - file_.position()) return true;
    if (auto skipped = file_.skip(header.content_bytes); !skipped) {
      return std::unexpected(skipped.error());
    }
  }
  return false;
}

void McapFile::note_end() {
  if (!declared_messages_ || truncated_ || num_messages_ == *declared_messages_) return;
  warn(
      fmt::format("{}: its statistics count {} messages, {} were found; check that the copy is "
                  "complete",
                  file_.path().string(),
                  *declared_messages_,
                  num_messages_));
}

bool McapFile::add_chunk_info(Bytes content, std::uint64_t summary_start) {
  ByteReader reader(content);
  const auto start = reader.read<std::uint64_t>();
  reader.skip(sizeof(std::uint64_t));  // end time
  const auto position = reader.read<std::uint64_t>();
  const auto bytes = reader.read<std::uint64_t>();
  reader.skip(reader.read<std::uint32_t>());  // offsets of the message indexes
  const auto index_bytes = reader.read<std::uint64_t>();
  if (reader.failed() || position < kMcapMagic.size() || position >= summary_start) return false;
  if (bytes > summary_start - position || index_bytes > summary_start - position - bytes) {
    return false;
  }
  chunks_.push_back(
      {.position = position, .start = mcap_time(start), .end = position + bytes + index_bytes});
  return true;
}

bool McapFile::read_statistics(Bytes content) {
  constexpr std::size_t kBetween = 2 + 4 + 4 + 4 + 4 + 8 + 8;
  ByteReader reader(content);
  const auto total = reader.read<std::uint64_t>();
  reader.skip(kBetween);
  const auto map_bytes = reader.read<std::uint32_t>();
  ByteReader counts(reader.take(map_bytes));
  if (reader.failed()) return false;
  std::unordered_map<std::uint32_t, std::uint64_t> by_channel;
  while (counts.remaining() >= sizeof(std::uint16_t) + sizeof(std::uint64_t)) {
    const auto id = counts.read<std::uint16_t>();
    by_channel[id] = counts.read<std::uint64_t>();
  }
  declared_messages_ = total;
  std::uint64_t sum = 0;
  for (const auto& [id, count] : by_channel) sum += count;
  if (sum != total) return true;  // counts of channels are optional
  for (BagConnection& connection : connections_) connection.messages = by_channel[connection.id];
  return true;
}

}  // namespace hybridfusion
