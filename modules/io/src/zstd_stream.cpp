#include "zstd_stream.hpp"

#include "byte_reader.hpp"

#include <hybridfusion/core/error.hpp>

#include <fmt/format.h>
#include <zstd.h>

namespace hybridfusion {

struct ZstdStream::Context {
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> zstd = {ZSTD_createDCtx(), &ZSTD_freeDCtx};
};

ZstdStream::ZstdStream() : context_(std::make_unique<Context>()), buffer_(ZSTD_DStreamOutSize()) {
  constexpr int kMaxWindowLog = 27;
  if (!context_->zstd) {
    problem_ = "zstd cannot be started (out of memory?)";
    return;
  }
  static_cast<void>(
      ZSTD_DCtx_setParameter(context_->zstd.get(), ZSTD_d_windowLogMax, kMaxWindowLog));
}
ZstdStream::ZstdStream(ZstdStream&&) noexcept = default;
ZstdStream& ZstdStream::operator=(ZstdStream&&) noexcept = default;
ZstdStream::~ZstdStream() = default;

std::span<const std::byte> ZstdStream::unpack(std::span<const std::byte>& packed) {
  if (!problem_.empty()) return {};
  ZSTD_inBuffer in = {.src = packed.data(), .size = packed.size(), .pos = 0};
  ZSTD_outBuffer out = {.dst = buffer_.data(), .size = buffer_.size(), .pos = 0};
  const std::size_t status = ZSTD_decompressStream(context_->zstd.get(), &out, &in);
  if (ZSTD_isError(status) != 0U) {
    problem_ = fmt::format("its zstd data are damaged ({})", ZSTD_getErrorName(status));
    return {};
  }
  packed = packed.subspan(in.pos);
  complete_ = status == 0;
  has_more_ = out.pos == out.size && !complete_;
  return std::span(buffer_).first(out.pos);
}

bool is_zstd(std::span<const std::byte> start) {
  constexpr std::uint32_t kMagic = 0xfd2fb528U;  // RFC 8878, 3.1.1
  return start.size() >= sizeof(kMagic) && load<std::uint32_t>(start.data()) == kMagic;
}

}  // namespace hybridfusion
