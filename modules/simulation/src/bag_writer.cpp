#include "bag_writer.hpp"

#include <algorithm>

#include <bzlib.h>
#include <lz4frame.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kChunkBytes = 768U * 1024U;
constexpr std::size_t kHeaderBytes = 4096;

enum class Op : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7,
};

/// Fields of a record header: "name=value" with a length each.
class RecordHeader {
 public:
  explicit RecordHeader(Op op) { field("op", std::string(1, static_cast<char>(op))); }
  RecordHeader& field(std::string_view name, std::string_view value) {
    bytes_.put(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    bytes_.put_bytes(name);
    bytes_.put_bytes("=");
    bytes_.put_bytes(value);
    return *this;
  }
  template <class T>
    requires std::is_arithmetic_v<T>
  RecordHeader& number(std::string_view name, T value) {
    ByteWriter raw;
    raw.put(value);
    return field(name, raw.bytes());
  }
  RecordHeader& time(std::string_view name, Timestamp value);
  [[nodiscard]] const std::string& bytes() const { return bytes_.bytes(); }

 private:
  ByteWriter bytes_ = {};
};

void put_time(ByteWriter& out, Timestamp time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  out.put(static_cast<std::uint32_t>(time.count() / kSecond));
  out.put(static_cast<std::uint32_t>(time.count() % kSecond));
}

RecordHeader& RecordHeader::time(std::string_view name, Timestamp value) {
  ByteWriter raw;
  put_time(raw, value);
  return field(name, raw.bytes());
}

std::string record(const RecordHeader& header, std::string_view data) {
  ByteWriter out;
  out.put_sized(header.bytes());
  out.put_sized(data);
  return out.take();
}

Expected<std::string> compressed(std::string_view data, const std::string& compression) {
  if (compression == "bz2") {
    auto size = static_cast<unsigned>(data.size() + data.size() / 100 + 700);
    std::string out(size, '\0');
    // bzlib's interface is not const-correct; it does not write to its input.
    const int status = BZ2_bzBuffToBuffCompress(out.data(),
                                                &size,
                                                const_cast<char*>(data.data()),
                                                static_cast<unsigned>(data.size()),
                                                9,
                                                0,
                                                30);
    if (status != BZ_OK) return fail(ErrorCode::kIo, "bz2 failed: " + std::to_string(status));
    out.resize(size);
    return out;
  }
  // roslz4 reads frames of independent blocks with a checksum of the content.
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.blockSizeID = LZ4F_max4MB;
  preferences.frameInfo.blockMode = LZ4F_blockIndependent;
  preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  std::string out(LZ4F_compressFrameBound(data.size(), &preferences), '\0');
  const std::size_t size =
      LZ4F_compressFrame(out.data(), out.size(), data.data(), data.size(), &preferences);
  if (LZ4F_isError(size) != 0) return fail(ErrorCode::kIo, LZ4F_getErrorName(size));
  out.resize(size);
  return out;
}

}  // namespace

Expected<BagWriter> BagWriter::create(const std::filesystem::path& path,
                                      const std::string& compression) {
  HF_TRY(OutputFile file, OutputFile::create(path));
  BagWriter writer(std::move(file), compression);
  writer.file_.write("#ROSBAG V2.0\n");
  writer.file_.write(writer.bag_header(0));
  return writer;
}

std::uint32_t BagWriter::add_connection(std::string topic, const RosMessageType& type) {
  connections_.push_back({.topic = std::move(topic), .type = type});
  return static_cast<std::uint32_t>(connections_.size() - 1);
}

std::string BagWriter::connection_record(std::uint32_t id) const {
  const Connection& connection = connections_[id];
  ByteWriter data;
  const auto field = [&data](std::string_view name, std::string_view value) {
    data.put(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    data.put_bytes(name);
    data.put_bytes("=");
    data.put_bytes(value);
  };
  field("topic", connection.topic);
  field("type", connection.type.name);
  field("md5sum", connection.type.md5);
  field("message_definition", connection.type.definition);
  return record(RecordHeader(Op::kConnection).number("conn", id).field("topic", connection.topic),
                data.bytes());
}

std::string BagWriter::bag_header(std::uint64_t index_position) const {
  RecordHeader header(Op::kBagHeader);
  header.number("index_pos", index_position)
      .number("conn_count", static_cast<std::uint32_t>(connections_.size()))
      .number("chunk_count", static_cast<std::uint32_t>(chunks_.size()));
  return record(header, std::string(kHeaderBytes - header.bytes().size(), ' '));
}

Expected<void> BagWriter::write(std::uint32_t connection,
                                Timestamp time,
                                std::string_view message) {
  HF_CHECK(connection < connections_.size());
  if (!connections_[connection].announced) {
    chunk_.put_bytes(connection_record(connection));
    connections_[connection].announced = true;
  }
  chunk_index_[connection].push_back(
      {.time = time, .offset = static_cast<std::uint32_t>(chunk_.size())});
  chunk_.put_bytes(
      record(RecordHeader(Op::kMessage).number("conn", connection).time("time", time), message));
  return chunk_.size() >= kChunkBytes ? flush_chunk() : Expected<void>{};
}

Expected<void> BagWriter::flush_chunk() {
  if (chunk_index_.empty()) return {};
  ChunkInfo info{.position = file_.position(), .first = Timestamp::max(), .last = Timestamp::min()};
  std::string indexes;
  for (const auto& [id, entries] : chunk_index_) {
    info.counts[id] = static_cast<std::uint32_t>(entries.size());
    ByteWriter data;
    for (const IndexEntry& entry : entries) {
      info.first = std::min(info.first, entry.time);
      info.last = std::max(info.last, entry.time);
      put_time(data, entry.time);
      data.put(entry.offset);
    }
    indexes += record(RecordHeader(Op::kIndex)
                          .number("ver", std::uint32_t{1})
                          .number("conn", id)
                          .number("count", static_cast<std::uint32_t>(entries.size())),
                      data.bytes());
  }
  const auto raw_size = static_cast<std::uint32_t>(chunk_.size());
  std::string data;
  if (compression_ == "none") {
    data = chunk_.bytes();
  } else {
    HF_TRY(data, compressed(chunk_.bytes(), compression_));
  }
  file_.write(record(
      RecordHeader(Op::kChunk).field("compression", compression_).number("size", raw_size), data));
  file_.write(indexes);
  chunks_.push_back(std::move(info));
  chunk_.clear();
  chunk_index_.clear();
  return {};
}

Expected<void> BagWriter::close() {
  if (Expected<void> flushed = flush_chunk(); !flushed) return flushed;
  const std::uint64_t index_position = file_.position();
  for (std::uint32_t id = 0; id < connections_.size(); ++id) file_.write(connection_record(id));
  for (const ChunkInfo& chunk : chunks_) {
    ByteWriter data;
    for (const auto& [id, count] : chunk.counts) {
      data.put(id);
      data.put(count);
    }
    file_.write(record(RecordHeader(Op::kChunkInfo)
                           .number("ver", std::uint32_t{1})
                           .number("chunk_pos", chunk.position)
                           .time("start_time", chunk.first)
                           .time("end_time", chunk.last)
                           .number("count", static_cast<std::uint32_t>(chunk.counts.size())),
                       data.bytes()));
  }
  constexpr std::uint64_t kMagicBytes = 13;
  file_.rewrite(kMagicBytes, bag_header(index_position));
  return file_.close();
}

}  // namespace hybridfusion
