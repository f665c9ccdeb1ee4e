#pragma once

#include "depth_map.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/spill_file.hpp>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace hybridfusion {

/// Depth maps of all views. With a scratch folder each is written to a nameless file there and only
/// those used last, up to `max_bytes`, stay in memory; without one all do. All members may be
/// called from several threads.
class DepthMapStore {
 public:
  using Handle = std::shared_ptr<const DepthMap>;  ///< Empty for a view without a map.

  /// @returns kIo when no file can be made in `scratch_folder` (empty: none wanted).
  [[nodiscard]] static Expected<std::unique_ptr<DepthMapStore>> create(
      std::size_t num_views, std::size_t max_bytes, const std::filesystem::path& scratch_folder);

  /// @returns kIo, e.g. when the disk is full.
  [[nodiscard]] Expected<void> put(std::uint32_t view, DepthMap map);
  [[nodiscard]] Expected<Handle> get(std::uint32_t view);
  /// Bytes of the maps in memory.
  [[nodiscard]] std::size_t resident_bytes() const;

 private:
  struct Entry {
    Handle map = {};
    SpillFile::Block block = {};
    DepthMap frame = {};  // the map without its planes
    bool stored = false;
    std::uint64_t last_use = 0;
  };
  explicit DepthMapStore(std::size_t num_views,
                         std::size_t max_bytes,
                         SpillFile file,
                         bool on_disk);
  void keep(Entry& entry, Handle map);

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  SpillFile file_;
  bool on_disk_ = false;
  std::size_t max_bytes_ = 0;
  std::size_t resident_bytes_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace hybridfusion
