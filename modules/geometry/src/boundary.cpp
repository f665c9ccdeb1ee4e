#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/boundary.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace hybridfusion {
namespace {

std::uint64_t key_of(std::int64_t x, std::int64_t y) {
  return (static_cast<std::uint64_t>(x + (std::int64_t{1} << 31)) << 32U) |
         (static_cast<std::uint64_t>(y + (std::int64_t{1} << 31)) & 0xffffffffU);
}

std::int64_t cell_of(double value, double cell_m) {
  return static_cast<std::int64_t>(std::clamp(std::floor(value / cell_m), -2.0e9, 2.0e9));
}

std::uint64_t key_of(const Eigen::Vector2f& p, double cell_m) {
  return key_of(cell_of(p.x(), cell_m), cell_of(p.y(), cell_m));
}

std::vector<Eigen::Vector2f> thinned(std::span<const Eigen::Vector2f> points, double cell_m) {
  struct Sum {
    std::uint64_t key;
    Eigen::Vector2d sum;
    double count;
  };
  std::unordered_map<std::uint64_t, std::size_t> slot_of;
  std::vector<Sum> sums;
  for (const Eigen::Vector2f& p : points) {
    if (!p.allFinite()) continue;
    const std::uint64_t key = key_of(p, cell_m);
    const auto [entry, is_new] = slot_of.try_emplace(key, sums.size());
    if (is_new) sums.push_back({key, Eigen::Vector2d::Zero(), 0.0});
    sums[entry->second].sum += p.cast<double>();
    sums[entry->second].count += 1.0;
  }
  std::ranges::sort(sums, {}, &Sum::key);
  std::vector<Eigen::Vector2f> means;
  means.reserve(sums.size());
  for (const Sum& s : sums) means.emplace_back((s.sum / s.count).cast<float>());
  return means;
}

/// Buckets of side `radius_m`: a neighbourhood lies in 3 x 3 of them.
class BucketGrid {
 public:
  BucketGrid(std::span<const Eigen::Vector2f> points, double radius_m)
      : points_(points), radius_m_(radius_m) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      buckets_[key_of(points[i], radius_m)].push_back(static_cast<std::uint32_t>(i));
    }
  }

  /// Directions [rad] from point `i` to its neighbours; coincident points have none.
  void directions(std::size_t i, std::vector<float>& out) const {
    out.clear();
    const Eigen::Vector2f centre = points_[i];
    const auto limit = static_cast<float>(radius_m_ * radius_m_);
    const std::int64_t x0 = cell_of(centre.x(), radius_m_);
    const std::int64_t y0 = cell_of(centre.y(), radius_m_);
    for (std::int64_t x = x0 - 1; x <= x0 + 1; ++x) {
      for (std::int64_t y = y0 - 1; y <= y0 + 1; ++y) {
        const auto bucket = buckets_.find(key_of(x, y));
        if (bucket == buckets_.end()) continue;
        for (const std::uint32_t j : bucket->second) {
          const Eigen::Vector2f d = points_[j] - centre;
          const float squared = d.squaredNorm();
          if (squared > 0.0F && squared < limit) out.push_back(std::atan2(d.y(), d.x()));
        }
      }
    }
  }

 private:
  std::span<const Eigen::Vector2f> points_;
  double radius_m_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> buckets_;
};

}  // namespace

float widest_gap_rad(std::vector<float>& directions) {
  std::ranges::sort(directions);
  float widest = directions.front() + 2.0F * std::numbers::pi_v<float> - directions.back();
  for (std::size_t k = 1; k < directions.size(); ++k) {
    widest = std::max(widest, directions[k] - directions[k - 1]);
  }
  return widest;
}

std::vector<Eigen::Vector2f> boundary_points(std::span<const Eigen::Vector2f> points,
                                             const BoundaryOptions& options,
                                             const RunContext& ctx) {
  HF_CHECK(options.radius_m > 0.0 && options.thin_m > 0.0);
  const std::vector<Eigen::Vector2f> cells = thinned(points, options.thin_m);
  const BucketGrid grid(cells, options.radius_m);
  std::vector<char> is_boundary(cells.size(), 0);
  parallel_for(ctx, cells.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<float> directions;
    for (std::size_t i = begin; i < end; ++i) {
      grid.directions(i, directions);
      const bool has_gap = directions.size() >= 2 &&
                           widest_gap_rad(directions) > static_cast<float>(options.min_gap_rad);
      is_boundary[i] = has_gap ? 1 : 0;
    }
  });
  std::vector<Eigen::Vector2f> boundary;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (is_boundary[i] != 0) boundary.push_back(cells[i]);
  }
  return boundary;
}

std::vector<Eigen::Vector2f> elevated_boundary(std::span<const Eigen::Vector3f> points,
                                               const GroundModel& ground,
                                               const BoundaryOptions& options,
                                               const RunContext& ctx) {
  const std::vector<float> heights = heights_above(ground, points, ctx);
  std::vector<Eigen::Vector2f> elevated;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (static_cast<double>(heights[i]) > options.min_height_m) {
      elevated.push_back(points[i].head<2>());
    }
  }
  return boundary_points(elevated, options, ctx);
}

}  // namespace hybridfusion
