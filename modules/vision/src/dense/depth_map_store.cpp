#include "depth_map_store.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace hybridfusion {
namespace {

/// Calls `visit` with each plane of a map, always in the same order.
template <class Map, class Visit>
void for_each_plane(Map& map, Visit&& visit) {
  visit(map.depth_m);
  visit(map.sigma_m);
  visit(map.num_pairs);
  visit(map.rgb);
  visit(map.grey);
  visit(map.mask);
}

std::size_t bytes_of(const DepthMap& map) {
  std::size_t bytes = 0;
  for_each_plane(
      map, [&](const auto& plane) { bytes += plane.values.size() * sizeof(plane.values.front()); });
  return bytes;
}

std::vector<std::byte> packed(const DepthMap& map) {
  std::vector<std::byte> bytes(bytes_of(map));
  std::size_t at = 0;
  for_each_plane(map, [&](const auto& plane) {
    const std::size_t size = plane.values.size() * sizeof(plane.values.front());
    if (size > 0) std::memcpy(bytes.data() + at, plane.values.data(), size);
    at += size;
  });
  return bytes;
}

/// The map's planes emptied, their sizes kept.
DepthMap without_pixels(const DepthMap& map) {
  DepthMap frame;
  frame.view = map.view;
  frame.grid = map.grid;
  frame.enu_from_camera = map.enu_from_camera;
  frame.disparity_sigma_px = map.disparity_sigma_px;
  frame.partners = map.partners;
  frame.overlapping = map.overlapping;
  return frame;
}

DepthMap unpacked(const DepthMap& frame, const std::vector<std::byte>& bytes) {
  DepthMap map = frame;
  std::size_t at = 0;
  for_each_plane(map, [&](auto& plane) {
    plane = {frame.grid.width_px, frame.grid.height_px};
    const std::size_t size = plane.values.size() * sizeof(plane.values.front());
    if (size > 0) std::memcpy(plane.values.data(), bytes.data() + at, size);
    at += size;
  });
  return map;
}

}  // namespace

DepthMapStore::DepthMapStore(std::size_t num_views,
                             std::size_t max_bytes,
                             SpillFile file,
                             bool on_disk)
    : entries_(num_views), file_(std::move(file)), on_disk_(on_disk), max_bytes_(max_bytes) {}

Expected<std::unique_ptr<DepthMapStore>> DepthMapStore::create(
    std::size_t num_views, std::size_t max_bytes, const std::filesystem::path& scratch_folder) {
  SpillFile file;
  const bool on_disk = !scratch_folder.empty();
  if (on_disk) {
    HF_TRY(file, SpillFile::create(scratch_folder));
  }
  return std::unique_ptr<DepthMapStore>(
      new DepthMapStore(num_views, max_bytes, std::move(file), on_disk));
}

/// Holds the map in memory and lets go of those used longest ago.
void DepthMapStore::keep(Entry& entry, Handle map) {
  resident_bytes_ += bytes_of(*map);
  entry.map = std::move(map);
  entry.last_use = ++clock_;
  while (on_disk_ && resident_bytes_ > max_bytes_) {
    Entry* oldest = nullptr;
    for (Entry& e : entries_) {
      if (e.map && &e != &entry && (oldest == nullptr || e.last_use < oldest->last_use)) {
        oldest = &e;
      }
    }
    if (oldest == nullptr) return;
    resident_bytes_ -= bytes_of(*oldest->map);
    oldest->map.reset();
  }
}

Expected<void> DepthMapStore::put(std::uint32_t view, DepthMap map) {
  const std::scoped_lock lock(mutex_);
  Entry& entry = entries_[view];
  HF_CHECK(!entry.stored);
  if (on_disk_) {
    entry.frame = without_pixels(map);
    HF_TRY(entry.block, file_.append(packed(map)));
  }
  entry.stored = true;
  keep(entry, std::make_shared<const DepthMap>(std::move(map)));
  return {};
}

Expected<DepthMapStore::Handle> DepthMapStore::get(std::uint32_t view) {
  const std::scoped_lock lock(mutex_);
  Entry& entry = entries_[view];
  if (!entry.stored) return Handle();
  entry.last_use = ++clock_;
  if (entry.map) return entry.map;
  std::vector<std::byte> bytes;
  if (auto read = file_.read(entry.block, bytes); !read) return std::unexpected(read.error());
  keep(entry, std::make_shared<const DepthMap>(unpacked(entry.frame, bytes)));
  return entry.map;
}

std::size_t DepthMapStore::resident_bytes() const {
  const std::scoped_lock lock(mutex_);
  return resident_bytes_;
}

}  // namespace hybridfusion
