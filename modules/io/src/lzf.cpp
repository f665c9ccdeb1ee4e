#include "lzf.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxLiteral = 32;
constexpr std::size_t kMaxRepeat = 264;
constexpr std::size_t kMaxDistance = 8192;
constexpr std::size_t kHashBits = 14;

void put_literals(std::string& out, std::string_view literals) {
  while (!literals.empty()) {
    const std::size_t count = std::min(literals.size(), kMaxLiteral);
    out += static_cast<char>(count - 1);
    out += literals.substr(0, count);
    literals.remove_prefix(count);
  }
}

/// @pre 3 <= length <= kMaxRepeat, 1 <= distance <= kMaxDistance
void put_repeat(std::string& out, std::size_t length, std::size_t distance) {
  const std::size_t code = length - 2;
  const std::size_t offset = distance - 1;
  if (code < 7) {
    out += static_cast<char>((code << 5U) | (offset >> 8U));
  } else {
    out += static_cast<char>((7U << 5U) | (offset >> 8U));
    out += static_cast<char>(code - 7);
  }
  out += static_cast<char>(offset & 0xffU);
}

[[nodiscard]] std::size_t hash_of(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i]));
  };
  const std::uint32_t key = byte(0) | byte(1) << 8U | byte(2) << 16U;
  return (key * 2654435761U) >> (32U - kHashBits);
}

}  // namespace

std::unexpected<Error> LzfReader::damaged() const {
  return file_.malformed("the compressed data are damaged", "copy or export the file again");
}

Expected<std::size_t> LzfReader::packed_byte() {
  if (packed_left_ == 0) return damaged();
  HF_TRY(const auto byte, file_.take(1));
  --packed_left_;
  return static_cast<std::size_t>(byte[0]);
}

Expected<void> LzfReader::unpack_once() {
  HF_TRY(const std::size_t control, packed_byte());
  if (control < kMaxLiteral) {
    const std::size_t count = control + 1;
    if (count > packed_left_) return damaged();
    HF_TRY(const auto literals, file_.take(count));
    packed_left_ -= count;
    out_.insert(out_.end(), literals.begin(), literals.end());
    return {};
  }
  std::size_t length = control >> 5U;
  if (length == 7) {
    HF_TRY(const std::size_t more, packed_byte());
    length += more;
  }
  length += 2;
  HF_TRY(const std::size_t low, packed_byte());
  const std::size_t distance = ((control & 0x1fU) << 8U) + low + 1;
  if (distance > out_.size()) return damaged();
  // Byte by byte: the repeat may overlap its own output.
  for (std::size_t i = 0; i < length; ++i) out_.push_back(out_[out_.size() - distance]);
  return {};
}

Expected<std::span<const std::byte>> LzfReader::take(std::size_t count) {
  constexpr std::size_t kTooOld = 1U << 16U;
  if (next_ > kTooOld) {
    out_.erase(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(next_ - kMaxDistance));
    next_ = kMaxDistance;
  }
  while (out_.size() - next_ < count) {
    if (auto unpacked = unpack_once(); !unpacked) return std::unexpected(unpacked.error());
  }
  const std::span<const std::byte> bytes(out_.data() + next_, count);
  next_ += count;
  return bytes;
}

Expected<void> LzfReader::skip(std::uint64_t count) {
  constexpr std::uint64_t kStep = 1U << 16U;
  while (count > 0) {
    const std::uint64_t step = std::min(count, kStep);
    if (auto taken = take(step); !taken) return std::unexpected(taken.error());
    count -= step;
  }
  return {};
}

std::string lzf_pack(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size() / 2);
  std::vector<std::size_t> last_at(std::size_t{1} << kHashBits, bytes.size());  // size: never
  std::size_t literals_from = 0;
  std::size_t at = 0;
  while (at + 3 <= bytes.size()) {
    std::size_t& slot = last_at[hash_of(bytes, at)];
    const std::size_t candidate = slot;
    slot = at;
    std::size_t length = 0;
    if (candidate < at && at - candidate <= kMaxDistance) {
      const std::size_t limit = std::min(bytes.size() - at, kMaxRepeat);
      while (length < limit && bytes[candidate + length] == bytes[at + length]) ++length;
    }
    if (length < 3) {
      ++at;
      continue;
    }
    put_literals(out, bytes.substr(literals_from, at - literals_from));
    put_repeat(out, length, at - candidate);
    at += length;
    literals_from = at;
  }
  put_literals(out, bytes.substr(literals_from));
  return out;
}

}  // namespace hybridfusion
