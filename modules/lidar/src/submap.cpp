#include "submap.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <unordered_map>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr double kSurfelCell_m = 1.0;
constexpr std::size_t kMaxPointsPerScan = 3000;
constexpr float kMinSurfelPoints = 8.0F;
constexpr float kMaxSurfelSigma_m = 0.06F;
// Faces are at least this wide against their thickness and this full against their length.
constexpr float kMinFlatness = 9.0F;
constexpr float kMinAspect = 0.03F;
constexpr float kMinWallHeight_m = 0.8F;
constexpr int kMinWallPoints = 4;

struct Moments {
  float count = 0.0F;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();  // about the cell's corner
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
};

struct Column {
  VoxelIndex cell = VoxelIndex::Zero();
  float lowest = 0.0F;
  float highest = 0.0F;
  int count = 0;
};

/// Items by grid cell, in the order of their first hit.
template <class T>
struct Grid {
  std::unordered_map<std::uint64_t, std::size_t> slots = {};
  std::vector<T> items = {};

  T& at(const VoxelIndex& cell, const T& fresh) {
    const auto [found, added] = slots.try_emplace(voxel_key(cell), items.size());
    if (added) items.push_back(fresh);
    return items[found->second];
  }
};

void add_surfel(const Moments& cell, std::vector<Surfel>& surfels) {
  if (cell.count < kMinSurfelPoints) return;
  const Eigen::Vector3f mean = cell.sum / cell.count;
  const Eigen::Matrix3f covariance = cell.squares / cell.count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3f& spread = solver.eigenvalues();
  if (!(spread[0] <= kMaxSurfelSigma_m * kMaxSurfelSigma_m) ||
      !(spread[1] >= kMinFlatness * spread[0]) || !(spread[1] >= kMinAspect * spread[2])) {
    return;
  }
  surfels.push_back({.mean = mean + cell.corner, .normal = solver.eigenvectors().col(0)});
}

}  // namespace

Expected<Submap> build_submap(const ScanStore& store,
                              std::size_t first,
                              std::size_t last,
                              std::size_t middle,
                              float radius_m) {
  const std::vector<StoredScan>& scans = store.scans();
  const Eigen::Vector3d origin = scans[middle].map_from_imu.translation;
  Grid<Moments> cells;
  Grid<Column> columns;
  std::vector<PackedPoint> points;
  for (std::size_t s = first; s < last; ++s) {
    const Eigen::Matrix3f rotation =
        scans[s].map_from_imu.rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f position = (scans[s].map_from_imu.translation - origin).cast<float>();
    if (auto read = store.read(scans[s], points); !read) return std::unexpected(read.error());
    const std::size_t stride = points.size() / kMaxPointsPerScan + 1;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      const Eigen::Vector3f p = rotation * unpack(points[i]).point_in_imu + position;
      if (!(p.squaredNorm() <= radius_m * radius_m)) continue;
      const VoxelIndex cell = voxel_of(p, kSurfelCell_m);
      const Eigen::Vector3f corner = cell.cast<float>() * static_cast<float>(kSurfelCell_m);
      Moments& moments = cells.at(cell, {.corner = corner});
      const Eigen::Vector3f q = p - corner;
      moments.count += 1.0F;
      moments.sum += q;
      moments.squares += q * q.transpose();
      VoxelIndex plan = voxel_of(p, kPlanCell_m);
      plan.z() = 0;
      Column& column = columns.at(plan, {.cell = plan, .lowest = p.z(), .highest = p.z()});
      column.lowest = std::min(column.lowest, p.z());
      column.highest = std::max(column.highest, p.z());
      ++column.count;
    }
  }
  Submap submap;
  for (const Moments& cell : cells.items) add_surfel(cell, submap.surfels);
  for (const Column& column : columns.items) {
    const Eigen::Vector2f center =
        (column.cell.head<2>().cast<float>() + Eigen::Vector2f::Constant(0.5F)) * kPlanCell_m;
    submap.ground.emplace_back(center.x(), center.y(), column.lowest);
    if (column.count >= kMinWallPoints && column.highest - column.lowest >= kMinWallHeight_m) {
      submap.walls.push_back(center);
    }
  }
  return submap;
}

}  // namespace hybridfusion
