#include "rosbag_records.hpp"

#include "byte_reader.hpp"
#include "text.hpp"
#include "zstd_stream.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include <bzlib.h>
#include <fmt/format.h>
#include <lz4frame.h>

namespace hybridfusion {
namespace {

// rosbag closes a chunk at 768 KiB unless one message is larger; nobody records 1 GiB messages.
constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{1} << 30;
constexpr std::size_t kFirstOutputBytes = std::size_t{1} << 20;

template <class T>
[[nodiscard]] std::optional<T> number(std::optional<std::string_view> value) {
  if (!value || value->size() != sizeof(T)) return std::nullopt;
  return load<T>(reinterpret_cast<const std::byte*>(value->data()));
}

/// Grows `bytes` towards `limit`, so that memory follows what was really unpacked.
void grow(std::vector<std::byte>& bytes, std::uint64_t limit) {
  bytes.resize(std::min<std::uint64_t>(limit, std::max(bytes.size() * 2, kFirstOutputBytes)));
}

[[nodiscard]] Decompressed unpack_bz2(std::span<const std::byte> packed, std::uint64_t limit) {
  Decompressed result;
  bz_stream stream = {};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) {
    result.problem = "bz2 cannot be started (out of memory?)";
    return result;
  }
  // bzlib declares its input as non-const but does not write to it.
  stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(packed.data()));
  stream.avail_in = static_cast<unsigned>(packed.size());
  std::size_t produced = 0;
  int status = BZ_OK;
  while (status == BZ_OK && produced < limit) {
    if (produced == result.bytes.size()) grow(result.bytes, limit);
    stream.next_out = reinterpret_cast<char*>(result.bytes.data() + produced);
    const std::size_t room = result.bytes.size() - produced;
    stream.avail_out = static_cast<unsigned>(room);
    const unsigned input_before = stream.avail_in;
    status = BZ2_bzDecompress(&stream);
    const std::size_t step = room - stream.avail_out;
    produced += step;
    if (status == BZ_OK && step == 0 && stream.avail_in == input_before) break;  // starved
  }
  BZ2_bzDecompressEnd(&stream);
  result.bytes.resize(produced);
  if (produced < limit) {
    result.problem = status == BZ_OK || status == BZ_STREAM_END ? "its bz2 data end early"
                                                                : "its bz2 data are damaged";
  }
  return result;
}

[[nodiscard]] Decompressed unpack_lz4(std::span<const std::byte> packed, std::uint64_t limit) {
  Decompressed result;
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0U) {
    result.problem = "lz4 cannot be started (out of memory?)";
    return result;
  }
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      raw, &LZ4F_freeDecompressionContext);
  std::size_t produced = 0;
  std::size_t hint = 1;  // 0: the frame is complete
  bool damaged = false;
  while (hint != 0 && produced < limit) {
    if (produced == result.bytes.size()) grow(result.bytes, limit);
    std::size_t out = result.bytes.size() - produced;
    std::size_t in = packed.size();
    hint = LZ4F_decompress(
        context.get(), result.bytes.data() + produced, &out, packed.data(), &in, nullptr);
    if (LZ4F_isError(hint) != 0U) {
      damaged = true;
      break;
    }
    produced += out;
    packed = packed.subspan(in);
    if (out == 0 && in == 0) break;  // starved
  }
  result.bytes.resize(produced);
  if (produced < limit) {
    result.problem = damaged ? "its lz4 data are damaged" : "its lz4 data end early";
  }
  return result;
}

[[nodiscard]] Decompressed unpack_zstd(std::span<const std::byte> packed, std::uint64_t limit) {
  Decompressed result;
  ZstdStream stream;
  while ((!packed.empty() || stream.has_more()) && result.bytes.size() < limit) {
    const auto bytes = stream.unpack(packed);
    if (!stream.problem().empty()) break;
    const auto kept = bytes.first(std::min<std::size_t>(bytes.size(), limit - result.bytes.size()));
    result.bytes.insert(result.bytes.end(), kept.begin(), kept.end());
  }
  if (result.bytes.size() < limit) {
    result.problem = stream.problem().empty() ? "its zstd data end early" : stream.problem();
  }
  return result;
}

}  // namespace

std::optional<BagFields> BagFields::parse(std::span<const std::byte> header) {
  BagFields fields;
  ByteReader reader(header);
  while (reader.remaining() > 0) {
    const std::string_view entry = reader.read_string();
    const std::size_t equals = entry.find('=');
    if (reader.failed() || equals == std::string_view::npos) return std::nullopt;
    fields.entries_.push_back({entry.substr(0, equals), entry.substr(equals + 1)});
  }
  return fields;
}

std::optional<std::string_view> BagFields::text(std::string_view name) const {
  const auto found = std::ranges::find(entries_, name, &Entry::name);
  if (found == entries_.end()) return std::nullopt;
  return found->value;
}

std::optional<std::uint8_t> BagFields::u8(std::string_view name) const {
  return number<std::uint8_t>(text(name));
}

std::optional<std::uint32_t> BagFields::u32(std::string_view name) const {
  return number<std::uint32_t>(text(name));
}

std::optional<std::uint64_t> BagFields::u64(std::string_view name) const {
  return number<std::uint64_t>(text(name));
}

std::optional<Timestamp> BagFields::time(std::string_view name) const {
  const auto packed = u64(name);
  if (!packed) return std::nullopt;
  return std::chrono::seconds(*packed & 0xffffffffU) + std::chrono::nanoseconds(*packed >> 32U);
}

std::optional<BagOp> BagFields::op() const {
  const auto code = u8("op");
  if (!code) return std::nullopt;
  return static_cast<BagOp>(*code);
}

Decompressed decompress_chunk(std::string_view compression,
                              std::span<const std::byte> packed,
                              std::uint64_t declared_bytes) {
  if (declared_bytes > kMaxChunkBytes) {
    return {.problem =
                fmt::format("it announces {} bytes, more than {}", declared_bytes, kMaxChunkBytes)};
  }
  if (packed.size() > std::numeric_limits<unsigned>::max()) {
    return {.problem = "it is larger than 4 GiB"};
  }
  if (compression == "bz2") return unpack_bz2(packed, declared_bytes);
  if (compression == "lz4") return unpack_lz4(packed, declared_bytes);
  if (compression == "zstd") return unpack_zstd(packed, declared_bytes);
  if (compression == "none") {
    const auto whole = packed.first(std::min<std::size_t>(packed.size(), declared_bytes));
    Decompressed result = {.bytes = {whole.begin(), whole.end()}};
    if (whole.size() < declared_bytes) result.problem = "its data end early";
    return result;
  }
  return {.problem = fmt::format("its compression '{}' is unknown", printable(compression))};
}

}  // namespace hybridfusion
