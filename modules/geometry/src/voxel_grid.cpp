#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/geometry/voxel_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hybridfusion {
namespace {

/// Indices on the three axes: for clouds that reach farther than voxel_key() does.
using WideKey = std::array<double, 3>;

template <class Key>
struct Entry {
  Key key;
  std::uint32_t index;
};

template <class Key>
Key key_of(const Eigen::Vector3f& point, double voxel_m) {
  if constexpr (std::is_same_v<Key, std::uint64_t>) {
    return voxel_key(voxel_of(point, voxel_m));
  } else {
    const Eigen::Vector3d at = (point.template cast<double>() / voxel_m).array().floor();
    return {at.x(), at.y(), at.z()};
  }
}

template <class Key>
std::vector<Entry<Key>> sorted_entries(const PointCloud& cloud, double voxel_m) {
  std::vector<Entry<Key>> entries;
  entries.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.points[i].allFinite()) continue;
    entries.push_back({key_of<Key>(cloud.points[i], voxel_m), static_cast<std::uint32_t>(i)});
  }
  std::ranges::sort(entries, [](const Entry<Key>& a, const Entry<Key>& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
  return entries;
}

template <class Value, class Wide, class Key>
Value mean_of(const std::vector<Value>& channel, std::span<const Entry<Key>> voxel, Wide sum) {
  for (const Entry<Key>& e : voxel) sum += static_cast<Wide>(channel[e.index]);
  return static_cast<Value>(sum / static_cast<double>(voxel.size()));
}

template <class Key>
Eigen::Vector3d vector_sum(const std::vector<Eigen::Vector3f>& channel,
                           std::span<const Entry<Key>> voxel) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Entry<Key>& e : voxel) sum += channel[e.index].template cast<double>();
  return sum;
}

template <class Key>
Rgb8 mean_color(const std::vector<Rgb8>& colors, std::span<const Entry<Key>> voxel) {
  Rgb8 result{};
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t sum = 0;
    for (const Entry<Key>& e : voxel) sum += colors[e.index][c];
    result[c] = static_cast<std::uint8_t>((sum + voxel.size() / 2) / voxel.size());
  }
  return result;
}

template <class Key>
void append_mean(PointCloud& out, const PointCloud& in, std::span<const Entry<Key>> voxel) {
  const auto count = static_cast<double>(voxel.size());
  out.points.emplace_back((vector_sum(in.points, voxel) / count).template cast<float>());
  if (!in.normals.empty()) {
    out.normals.emplace_back(
        vector_sum(in.normals, voxel).stableNormalized().template cast<float>());
  }
  if (!in.colors.empty()) out.colors.push_back(mean_color(in.colors, voxel));
  if (!in.intensities.empty()) out.intensities.push_back(mean_of(in.intensities, voxel, 0.0));
  if (!in.times_s.empty()) {
    // Epochs are large: average the differences to keep microseconds.
    const double first = in.times_s[voxel.front().index];
    double sum = 0.0;
    for (const Entry<Key>& e : voxel) sum += in.times_s[e.index] - first;
    out.times_s.push_back(first + sum / count);
  }
  if (!in.sigmas_m.empty()) out.sigmas_m.push_back(mean_of(in.sigmas_m, voxel, 0.0));
  if (!in.confidences.empty()) out.confidences.push_back(mean_of(in.confidences, voxel, 0.0));
  if (!in.sources.empty()) out.sources.push_back(in.sources[voxel.front().index]);
}

template <class Key>
PointCloud mean_by(const PointCloud& cloud, double voxel_m) {
  const std::vector<Entry<Key>> entries = sorted_entries<Key>(cloud, voxel_m);
  PointCloud result;
  for (auto first = entries.begin(); first != entries.end();) {
    const auto last = std::find_if(
        first, entries.end(), [key = first->key](const Entry<Key>& e) { return e.key != key; });
    append_mean<Key>(result, cloud, {first, last});
    first = last;
  }
  return result;
}

}  // namespace

PointCloud voxel_mean(const PointCloud& cloud, double voxel_m) {
  HF_CHECK(voxel_m > 0.0);
  const bool near = std::ranges::all_of(cloud.points, [voxel_m](const Eigen::Vector3f& point) {
    return !point.allFinite() || in_voxel_key_reach(point.template cast<double>(), voxel_m);
  });
  return near ? mean_by<std::uint64_t>(cloud, voxel_m) : mean_by<WideKey>(cloud, voxel_m);
}

}  // namespace hybridfusion
