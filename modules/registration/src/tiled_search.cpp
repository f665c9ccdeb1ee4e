#include "tiled_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMargin_m = 20.0;  // around what L covers
/// A place may climb this far out of its tile before the neighbour is to have it.
constexpr double kSlack_m = 10.0;

/// The box of all but the outermost points, from at most a million of them.
Box2 extent_of(std::span<const Eigen::Vector3f> points, double cut_share) {
  constexpr std::size_t kMaxSample = 1000000;
  const std::size_t stride = 1 + points.size() / kMaxSample;
  std::vector<Eigen::Vector3f> sample;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (points[i].allFinite()) sample.push_back(points[i]);
  }
  return percentile_box(sample, cut_share);
}

/// A grid of equal tiles over a box.
struct TileGrid {
  Box2 box = {};
  Eigen::Vector2d tile_m = Eigen::Vector2d::Zero();
  int columns = 0;
  int rows = 0;

  [[nodiscard]] Box2 core(int column, int row) const {
    const Eigen::Vector2d low = box.low + tile_m.cwiseProduct(Eigen::Vector2d(column, row));
    return {.low = low, .high = low + tile_m};
  }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
};

Expected<TileGrid> lay_tiles(const Box2& box, const TileOptions& options) {
  const Eigen::Vector2d size = (box.high - box.low).cwiseMax(1.0);
  const Eigen::Vector2d counts = (size / options.tile_m).array().ceil();
  if (counts.prod() > static_cast<double>(options.max_tiles)) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("the vision cloud covers {:.0f} x {:.0f} m, at most {:.0f} km2 can be "
                            "searched; give a coarse pose or cut the cloud",
                            size.x(),
                            size.y(),
                            1e-6 * options.tile_m * options.tile_m *
                                static_cast<double>(options.max_tiles)));
  }
  return TileGrid{.box = box,
                  .tile_m = size.cwiseQuotient(counts),
                  .columns = static_cast<int>(counts.x()),
                  .rows = static_cast<int>(counts.y())};
}

/// Indices of the points of each tile with `margin_m` around it, ascending.
std::vector<std::vector<std::uint32_t>> sort_into_tiles(std::span<const Eigen::Vector3f> points,
                                                        const TileGrid& grid,
                                                        double margin_m) {
  std::vector<std::vector<std::uint32_t>> members(grid.size());
  const auto column_at = [&](double x) {
    return static_cast<int>(std::floor((x - grid.box.low.x()) / grid.tile_m.x()));
  };
  const auto row_at = [&](double y) {
    return static_cast<int>(std::floor((y - grid.box.low.y()) / grid.tile_m.y()));
  };
  const Eigen::Vector2d low = grid.box.low.array() - margin_m;
  const Eigen::Vector2d high = grid.box.high.array() + margin_m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p = points[i].head<2>().cast<double>();
    // Written so that NaN is left out.
    if (!((p.array() >= low.array()).all() && (p.array() <= high.array()).all())) continue;
    const int last_row = std::min(row_at(p.y() + margin_m), grid.rows - 1);
    const int last_column = std::min(column_at(p.x() + margin_m), grid.columns - 1);
    for (int row = std::max(row_at(p.y() - margin_m), 0); row <= last_row; ++row) {
      for (int column = std::max(column_at(p.x() - margin_m), 0); column <= last_column; ++column) {
        members[static_cast<std::size_t>(row * grid.columns + column)].push_back(
            static_cast<std::uint32_t>(i));
      }
    }
  }
  return members;
}

bool is_within(const Eigen::Vector2d& p, const Box2& box, double slack_m) {
  return ((p - box.low).array() >= -slack_m).all() && ((box.high - p).array() >= -slack_m).all();
}

/// Keeps the best score of each heading; every tile tries the same ones.
void merge_yaw_scores(const std::vector<YawScore>& tile, std::vector<YawScore>& all) {
  if (all.empty()) all = tile;
  for (std::size_t k = 0; k < std::min(tile.size(), all.size()); ++k) {
    all[k].score = std::max(all[k].score, tile[k].score);
  }
}

void drop_vision(PreparedClouds& clouds) {
  clouds.vision = {};
  clouds.vision_ground = {};
  clouds.search_maps = {};
  clouds.maps = {};
}

std::vector<Eigen::Vector3f> points_at(std::span<const Eigen::Vector3f> points,
                                       std::span<const std::uint32_t> indices) {
  std::vector<Eigen::Vector3f> selected;
  selected.reserve(indices.size());
  for (const std::uint32_t i : indices) selected.push_back(points[i]);
  return selected;
}

}  // namespace

bool needs_tiles(std::span<const Eigen::Vector3f> vision,
                 const OutlineOptions& options,
                 const TileOptions& tiles) {
  const Box2 box = extent_of(vision, options.cut_share);
  return (box.high - box.low).prod() > tiles.max_area_m2;
}

Expected<OutlinePlaces> find_places_in_tiles(std::span<const Eigen::Vector3f> vision,
                                             const RegistrationInput& input,
                                             const RegistrationOptions& options,
                                             const TileOptions& tiles,
                                             const RunContext& ctx,
                                             PreparedClouds& clouds) {
  RegistrationOptions coarse = options;
  if (tiles.halvings > 0) coarse.outline.num_peaks *= 2;  // coarse scores rank less well
  const double reach_m =
      make_pattern(clouds.lidar_maps, Eigen::Matrix3d::Identity()).reach_m + kMargin_m;
  HF_TRY(const TileGrid grid, lay_tiles(extent_of(vision, options.outline.cut_share), tiles));
  auto members = sort_into_tiles(vision, grid, reach_m);
  OutlinePlaces all;
  std::string reason = "no tile of the vision cloud holds enough points";
  for (std::size_t t = 0; t < grid.size(); ++t) {
    ctx.report({.stage = "registration/outlines/tiles",
                .done = static_cast<std::int64_t>(t),
                .total = static_cast<std::int64_t>(grid.size())});
    const std::vector<std::uint32_t> indices = std::exchange(members[t], {});
    auto prepared = prepare_vision(points_at(vision, indices), coarse, ctx, clouds);
    auto found = prepared ? find_places(clouds, input, coarse, ctx, tiles.halvings)
                          : Expected<OutlinePlaces>(std::unexpected(prepared.error()));
    drop_vision(clouds);
    if (!found && found.error().code != ErrorCode::kDegenerate) return found;
    if (!found) {
      reason = found.error().message;  // water, fields: another tile may hold the place
      continue;
    }
    const Box2 core =
        grid.core(static_cast<int>(t) % grid.columns, static_cast<int>(t) / grid.columns);
    merge_yaw_scores(found->yaw_scores, all.yaw_scores);
    std::ranges::copy_if(found->places, std::back_inserter(all.places), [&](const auto& place) {
      return is_within(place.planar.position, core, kSlack_m);
    });
  }
  if (all.places.empty()) return fail(ErrorCode::kDegenerate, reason);
  all.places = distinct_places(std::move(all.places), options.outline);
  const auto count = static_cast<std::size_t>(options.outline.num_peaks);
  if (all.places.size() > count) all.places.resize(count);
  return all;
}

Expected<RegistrationResult> register_in_tiles(std::span<const Eigen::Vector3f> vision,
                                               PreparedClouds clouds,
                                               const PointCloud& lidar,
                                               const RegistrationInput& input,
                                               const RegistrationOptions& options,
                                               const RunContext& ctx,
                                               const TileOptions& tiles) {
  HF_TRY(OutlinePlaces found, find_places_in_tiles(vision, input, options, tiles, ctx, clouds));
  prefer_by_prior(clouds, input, options.verdict.max_peak_ratio, found);
  found.is_vision_whole = false;
  const Eigen::Vector2d middle = found.places.front().planar.position;
  const double reach_m =
      make_pattern(clouds.lidar_maps, Eigen::Matrix3d::Identity()).reach_m + 2.0 * kMargin_m;
  std::vector<Eigen::Vector3f> near;
  for (const Eigen::Vector3f& p : vision) {
    const Eigen::Vector2d gap = p.head<2>().cast<double>() - middle;
    if (gap.squaredNorm() < reach_m * reach_m) near.push_back(p);
  }
  if (auto prepared = prepare_vision(std::move(near), options, ctx, clouds); !prepared) {
    return std::unexpected(prepared.error());
  }
  return register_at_places(std::move(found), clouds, lidar, input, options, ctx);
}

}  // namespace hybridfusion
