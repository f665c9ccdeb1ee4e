#include "mcap_file.hpp"
#include "mcap_records.hpp"

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
  return usable;
}

bool McapFile::add_chunk_info(Bytes content, std::uint64_t summary_start) {
  ByteReader reader(content);
  const auto start = reader.read<std::uint64_t>();
  reader.skip(sizeof(std::uint64_t));  // end time
  const auto position = reader.read<std::uint64_t>();
  if (reader.failed() || position < kMcapMagic.size() || position >= summary_start) return false;
  chunks_.push_back({.position = position, .start = mcap_time(start)});
  return true;
}

bool McapFile::read_statistics(Bytes content) {
  constexpr std::size_t kBeforeCounts = 8 + 2 + 4 + 4 + 4 + 4 + 8 + 8;
  ByteReader reader(content);
  reader.skip(kBeforeCounts);
  const auto map_bytes = reader.read<std::uint32_t>();
  ByteReader counts(reader.take(map_bytes));
  if (reader.failed()) return false;
  std::unordered_map<std::uint32_t, std::uint64_t> by_channel;
  while (counts.remaining() >= sizeof(std::uint16_t) + sizeof(std::uint64_t)) {
    const auto id = counts.read<std::uint16_t>();
    by_channel[id] = counts.read<std::uint64_t>();
  }
  for (BagConnection& connection : connections_) connection.messages = by_channel[connection.id];
  return true;
}

}  // namespace hybridfusion
