#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace hybridfusion {
namespace {

struct Entry {
  std::uint64_t key;
  std::uint32_t index;
};

std::vector<Entry> sorted_entries(const PointCloud& cloud, double voxel_m) {
  std::vector<Entry> entries;
  entries.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.points[i].allFinite()) continue;
    entries.push_back(
        {voxel_key(voxel_of(cloud.points[i], voxel_m)), static_cast<std::uint32_t>(i)});
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
  return entries;
}

template <class Value, class Wide>
Value mean_of(const std::vector<Value>& channel, std::span<const Entry> voxel, Wide sum) {
  for (const Entry& e : voxel) sum += static_cast<Wide>(channel[e.index]);
  return static_cast<Value>(sum / static_cast<double>(voxel.size()));
}

Eigen::Vector3d vector_sum(const std::vector<Eigen::Vector3f>& channel,
                           std::span<const Entry> voxel) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Entry& e : voxel) sum += channel[e.index].cast<double>();
  return sum;
}

Rgb8 mean_color(const std::vector<Rgb8>& colors, std::span<const Entry> voxel) {
  Rgb8 result{};
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t sum = 0;
    for (const Entry& e : voxel) sum += colors[e.index][c];
    result[c] = static_cast<std::uint8_t>((sum + voxel.size() / 2) / voxel.size());
  }
  return result;
}

void append_mean(PointCloud& out, const PointCloud& in, std::span<const Entry> voxel) {
  const auto count = static_cast<double>(voxel.size());
  out.points.emplace_back((vector_sum(in.points, voxel) / count).cast<float>());
  if (!in.normals.empty()) {
    out.normals.emplace_back(vector_sum(in.normals, voxel).stableNormalized().cast<float>());
  }
  if (!in.colors.empty()) out.colors.push_back(mean_color(in.colors, voxel));
  if (!in.intensities.empty()) out.intensities.push_back(mean_of(in.intensities, voxel, 0.0));
  if (!in.times_s.empty()) {
    // Epochs are large: average the differences to keep microseconds.
    const double first = in.times_s[voxel.front().index];
    double sum = 0.0;
    for (const Entry& e : voxel) sum += in.times_s[e.index] - first;
    out.times_s.push_back(first + sum / count);
  }
  if (!in.sigmas_m.empty()) out.sigmas_m.push_back(mean_of(in.sigmas_m, voxel, 0.0));
  if (!in.confidences.empty()) out.confidences.push_back(mean_of(in.confidences, voxel, 0.0));
  if (!in.sources.empty()) out.sources.push_back(in.sources[voxel.front().index]);
}

}  // namespace

PointCloud voxel_mean(const PointCloud& cloud, double voxel_m) {
  HF_CHECK(voxel_m > 0.0);
  const std::vector<Entry> entries = sorted_entries(cloud, voxel_m);
  PointCloud result;
  for (auto first = entries.begin(); first != entries.end();) {
    const auto last = std::find_if(
        first, entries.end(), [key = first->key](const Entry& e) { return e.key != key; });
    append_mean(result, cloud, {first, last});
    first = last;
  }
  return result;
}

}  // namespace hybridfusion
