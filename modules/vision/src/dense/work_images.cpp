#include "work_images.hpp"

#include <utility>

namespace hybridfusion {
namespace {

std::size_t bytes_of(const WorkImage& image) {
  return image.rgb.total() * image.rgb.elemSize() + image.grey.total() * image.grey.elemSize();
}

}  // namespace

WorkImages::WorkImages(std::span<const Photo> photos,
                       const Reconstruction& reconstruction,
                       int max_size_px,
                       std::size_t max_bytes)
    : photos_(photos),
      reconstruction_(reconstruction),
      max_size_px_(max_size_px),
      max_bytes_(max_bytes),
      entries_(photos.size()),
      failures_(photos.size()) {}

WorkImages::Handle WorkImages::decode(std::uint32_t view) {
  const Expected<Image8> photo = photos_[view].load();
  if (!photo) {
    failures_[view] = photo.error().message;
    return {};
  }
  const View& v = reconstruction_.views[view];
  return std::make_shared<const WorkImage>(
      reduce(*photo, reconstruction_.cameras[v.camera], max_size_px_));
}

void WorkImages::keep(std::uint32_t view, Handle image) {
  if (!image) return;
  resident_bytes_ += bytes_of(*image);
  entries_[view].image = std::move(image);
  while (resident_bytes_ > max_bytes_) {
    Entry* oldest = nullptr;
    for (Entry& e : entries_) {
      if (e.image && &e != &entries_[view] &&
          (oldest == nullptr || e.last_use < oldest->last_use)) {
        oldest = &e;
      }
    }
    if (oldest == nullptr) return;
    resident_bytes_ -= bytes_of(*oldest->image);
    oldest->image.reset();
  }
}

WorkImages::Handle WorkImages::get(std::uint32_t view) {
  std::unique_lock lock(mutex_);
  Entry& entry = entries_[view];
  decoded_.wait(lock, [&] { return !entry.decoding; });
  entry.last_use = ++clock_;
  if (entry.image || !failures_[view].empty()) return entry.image;
  entry.decoding = true;
  lock.unlock();
  Handle image;
  try {
    image = decode(view);
  } catch (...) {
    lock.lock();
    entry.decoding = false;
    decoded_.notify_all();
    throw;
  }
  lock.lock();
  entry.decoding = false;
  keep(view, image);
  decoded_.notify_all();
  return image;
}

}  // namespace hybridfusion
