#include "incremental_mapper.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace hybridfusion {
namespace {

constexpr int kCells = 8;

std::size_t cell_of(const SfmModel& model, const TrackElement& element) {
  const CameraIntrinsics& camera = model.camera_of(element.view);
  const auto part = [](double at, int extent) {
    return std::clamp(static_cast<int>(at * kCells / extent), 0, kCells - 1);
  };
  return static_cast<std::size_t>(part(element.pixel.y(), camera.height_px) * kCells +
                                  part(element.pixel.x(), camera.width_px));
}

}  // namespace

std::vector<std::uint32_t> select_tracks(const SfmModel& model, int per_view) {
  std::vector<std::uint32_t> order;
  std::vector<std::size_t> length(model.tracks.size(), 0);
  for (std::uint32_t t = 0; t < model.tracks.size(); ++t) {
    if (!model.points[t]) continue;
    order.push_back(t);
    length[t] = static_cast<std::size_t>(
        std::ranges::count_if(model.tracks[t], [](const auto& e) { return e.active; }));
  }
  if (per_view <= 0) return order;
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::uint32_t t) { return length[t]; });
  const int per_cell = std::max(1, per_view / (kCells * kCells));
  std::vector<std::array<int, kCells * kCells>> filled(model.world_from_view.size());
  for (auto& cells : filled) cells.fill(0);
  std::vector<std::uint32_t> selected;
  for (const std::uint32_t t : order) {
    bool wanted = false;
    for (const TrackElement& e : model.tracks[t]) {
      wanted = wanted || (e.active && filled[e.view][cell_of(model, e)] < per_cell);
    }
    if (!wanted) continue;
    selected.push_back(t);
    for (const TrackElement& e : model.tracks[t]) {
      if (e.active) ++filled[e.view][cell_of(model, e)];
    }
  }
  std::ranges::sort(selected);
  return selected;
}

}  // namespace hybridfusion
