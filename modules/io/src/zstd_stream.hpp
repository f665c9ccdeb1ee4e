#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Unpacks zstd frames piece by piece in bounded memory (windows of at most 128 MiB).
class ZstdStream {
 public:
  ZstdStream();
  ZstdStream(ZstdStream&&) noexcept;
  ZstdStream& operator=(ZstdStream&&) noexcept;
  ~ZstdStream();

  /// Consumes from the front of `packed`; to be repeated while packed is not empty or has_more().
  /// @returns bytes that are valid until the next call.
  [[nodiscard]] std::span<const std::byte> unpack(std::span<const std::byte>& packed);
  /// The output buffer was filled; there may be more without further input.
  [[nodiscard]] bool has_more() const { return has_more_; }
  /// At the end of a frame.
  [[nodiscard]] bool complete() const { return complete_; }
  /// Why the data cannot be unpacked; empty as long as they can.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  std::vector<std::byte> buffer_ = {};
  bool has_more_ = false;
  bool complete_ = false;
  std::string problem_ = {};
};

/// True for bytes that begin a zstd frame.
[[nodiscard]] bool is_zstd(std::span<const std::byte> start);

}  // namespace hybridfusion
