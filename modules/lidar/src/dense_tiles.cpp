#include "dense_tiles.hpp"

#include "moving_objects.hpp"

#include <cmath>
#include <cstring>

namespace hybridfusion {
namespace {

constexpr int kTileVoxels = 256;
constexpr std::size_t kBlockPoints = 512;
// Points that wait in memory: 6 MB.
constexpr std::size_t kMaxOpen = 250'000;

int tile_of(int voxel) {
  return voxel >= 0 ? voxel / kTileVoxels : -((-voxel + kTileVoxels - 1) / kTileVoxels);
}

}  // namespace

DenseTiles::DenseTiles(double voxel_m, SpillFile spill)
    : voxel_m_(voxel_m), spill_(std::move(spill)) {}

Expected<void> DenseTiles::put_aside(Tile& tile) {
  HF_TRY(const SpillFile::Block block, spill_.append(std::as_bytes(std::span(tile.open))));
  num_open_ -= tile.open.size();
  std::vector<TilePoint>().swap(tile.open);
  tile.blocks.push_back(block);
  return {};
}

Expected<void> DenseTiles::add(const TilePoint& point) {
  const VoxelIndex voxel = voxel_of({point.x, point.y, point.z}, voxel_m_);
  for (int x = tile_of(voxel.x() - kSupportReach); x <= tile_of(voxel.x() + kSupportReach); ++x) {
    for (int y = tile_of(voxel.y() - kSupportReach); y <= tile_of(voxel.y() + kSupportReach); ++y) {
      Tile& tile = tiles_[{x, y}];
      tile.open.push_back(point);
      ++num_open_;
      if (tile.open.size() < kBlockPoints) continue;
      if (auto done = put_aside(tile); !done) return done;
    }
  }
  if (num_open_ < kMaxOpen) return {};
  for (auto& [index, tile] : tiles_) {
    if (tile.open.empty()) continue;
    if (auto done = put_aside(tile); !done) return done;
  }
  return {};
}

Expected<std::vector<TilePoint>> DenseTiles::read(const SpillFile::Block& block) const {
  std::vector<std::byte> bytes;
  if (auto done = spill_.read(block, bytes); !done) return std::unexpected(done.error());
  std::vector<TilePoint> points(bytes.size() / sizeof(TilePoint));
  if (!points.empty()) std::memcpy(points.data(), bytes.data(), bytes.size());
  return points;
}

PlanBox DenseTiles::box_of(const std::pair<int, int>& tile) const {
  const Eigen::Vector2i low(tile.first * kTileVoxels, tile.second * kTileVoxels);
  return {.low = low, .high = low + Eigen::Vector2i::Constant(kTileVoxels)};
}

Eigen::Vector2d DenseTiles::center_of(const std::pair<int, int>& tile) const {
  return (Eigen::Vector2d(tile.first, tile.second) + Eigen::Vector2d::Constant(0.5)) *
         (kTileVoxels * voxel_m_);
}

namespace {

Expected<void> fill_tiles(const DenseMapOptions& options,
                          const RunContext& ctx,
                          const ScanStore& store,
                          DenseTiles& tiles) {
  const std::vector<StoredScan>& scans = store.scans();
  const auto max_range2 = static_cast<float>(options.max_range_m * options.max_range_m);
  constexpr std::uint32_t kUnusable = static_cast<std::uint32_t>(ScanFlag::kUnmatched) |
                                      static_cast<std::uint32_t>(ScanFlag::kDiverged);
  std::vector<PackedPoint> points;
  for (std::size_t s = 0; s < scans.size(); ++s) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    ctx.report({.stage = "lidar/dense_map",
                .done = static_cast<std::int64_t>(s),
                .total = static_cast<std::int64_t>(scans.size())});
    const StoredScan& scan = scans[s];
    if ((scan.flags & kUnusable) != 0) continue;
    const Eigen::Matrix3f rotation = scan.map_from_imu.rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f position = scan.map_from_imu.translation.cast<float>();
    const auto begin_s = static_cast<float>(to_seconds(scan.begin - scans.front().begin));
    const auto span_s = static_cast<float>(to_seconds(scan.time - scan.begin));
    if (auto read = store.read(scan, points); !read) return read;
    for (const PackedPoint& packed : points) {
      const UnpackedPoint point = unpack(packed);
      if (!(point.point_in_imu.squaredNorm() <= max_range2)) continue;
      const Eigen::Vector3f p = rotation * point.point_in_imu + position;
      auto added = tiles.add({.x = p.x(),
                              .y = p.y(),
                              .z = p.z(),
                              .intensity = point.intensity,
                              .time_s = begin_s + point.share * span_s,
                              .scan = static_cast<std::uint32_t>(s)});
      if (!added) return added;
    }
  }
  return {};
}

}  // namespace

Expected<void> build_dense_map(const DenseMapOptions& options,
                               const RunContext& ctx,
                               const ScanStore& store,
                               const MapSink& sink) {
  if (store.scans().empty()) return {};
  HF_TRY(SpillFile spill, store.new_spill());
  DenseTiles tiles(options.voxel_m, std::move(spill));
  if (auto filled = fill_tiles(options, ctx, store, tiles); !filled) return filled;
  const Timestamp origin = store.scans().front().begin;
  std::int64_t done = 0;
  for (const auto& [index, tile] : tiles.tiles()) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    ctx.report({.stage = "lidar/dense_tiles",
                .done = done++,
                .total = static_cast<std::int64_t>(tiles.tiles().size())});
    DenseMap map(options);
    auto visited = tiles.for_each(tile, [&](const TilePoint& point) {
      map.add(point.scan, {point.x, point.y, point.z}, point.intensity, point.time_s);
    });
    if (!visited) return visited;
    if (options.max_brief_s > 0.0) {
      auto dropped = drop_moving(options, store, tiles.center_of(index), map);
      if (!dropped) return std::unexpected(dropped.error());
    }
    const PointCloud cloud = map.extract(origin, tiles.box_of(index));
    if (cloud.empty()) continue;
    if (auto taken = sink(cloud); !taken) return taken;
  }
  return {};
}

}  // namespace hybridfusion
