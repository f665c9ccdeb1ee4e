#pragma once

#include "image_warp.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Photos at working size, decoded when first asked for and again when they were let go since:
/// those used last, up to `max_bytes`, stay in memory. May be used from several threads.
class WorkImages {
 public:
  using Handle = std::shared_ptr<const WorkImage>;

  WorkImages(std::span<const Photo> photos,
             const Reconstruction& reconstruction,
             int max_size_px,
             std::size_t max_bytes);

  /// Empty for a photo that cannot be decoded.
  [[nodiscard]] Handle get(std::uint32_t view);
  /// Why photos could not be decoded, by view; empty where they could.
  [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }

 private:
  struct Entry {
    Handle image = {};
    bool decoding = false;
    std::uint64_t last_use = 0;
  };
  [[nodiscard]] Handle decode(std::uint32_t view);
  void keep(std::uint32_t view, Handle image);

  std::span<const Photo> photos_;
  const Reconstruction& reconstruction_;
  int max_size_px_;
  std::size_t max_bytes_;
  std::mutex mutex_;
  std::condition_variable decoded_;
  std::vector<Entry> entries_;
  std::vector<std::string> failures_;
  std::size_t resident_bytes_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace hybridfusion
