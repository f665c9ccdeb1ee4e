#pragma once

#include "local_surface.hpp"

#include <hybridfusion/core/run_context.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A free place on the plane of a measured point; one is kept a cell, the one nearest to its point.
struct Place {
  std::uint64_t cell = 0;
  float step_m = 0.0F;
  Eigen::Vector3f at = Eigen::Vector3f::Zero();
};

/// Leaves the element of the smallest `badness` in each cell, in the order of the cells.
template <class T>
void keep_best_in_cell(std::vector<T>& all, float T::* badness) {
  std::ranges::sort(all, [&](const T& a, const T& b) {
    if (a.cell != b.cell) return a.cell < b.cell;
    return std::tuple(a.*badness, a.at.x(), a.at.y(), a.at.z()) <
           std::tuple(b.*badness, b.at.x(), b.at.y(), b.at.z());
  });
  const auto doubles = std::ranges::unique(all, {}, &T::cell);
  all.erase(doubles.begin(), doubles.end());
}

/// The elements of all parts in order, in hardly more memory than they took: each part is freed
/// once it is copied.
template <class T>
std::vector<T> joined(std::vector<std::vector<T>> parts) {
  std::size_t count = 0;
  for (const std::vector<T>& part : parts) count += part.size();
  std::vector<T> all;
  all.reserve(count);
  for (std::vector<T>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    std::vector<T>().swap(part);
  }
  return all;
}

/// One point in each cell of one and a half spacings, in the order of the cells: others there would
/// try the same places.
[[nodiscard]] std::vector<std::uint32_t> one_in_each_cell(const PointCloud& cloud,
                                                          double spacing_m);

/// The free places around the points `starts`, one in each cell of a spacing.
[[nodiscard]] std::vector<Place> free_places(const Measured& measured,
                                             std::span<const std::uint32_t> starts,
                                             const RunContext& ctx);

}  // namespace hybridfusion
