/// @file
/// The two local maps of the LiDAR odometry against k-d trees and octrees of libraries, on a street
/// map of 200 thousand to a million points: what a scan costs. Times are CPU times.

#include "incremental_kd_tree.hpp"
#include "peer_maps.hpp"
#include "voxel_map.hpp"

#include <algorithm>

#include <benchmark/benchmark.h>
#include <malloc.h>

namespace hybridfusion::bench {
namespace {

constexpr std::size_t kScanSize = 3000;
constexpr int kNumNeighbors = 5;
constexpr float kRadius_m = 1.5F;

// Maps that take points as they come; the others are built anew for every change.
template <class Map>
constexpr bool kIsOurs = std::is_constructible_v<Map, double>;

template <class Map>
Map make_map() {
  if constexpr (kIsOurs<Map>) {
    return Map(0.5);
  } else {
    return Map();
  }
}

/// As odometry fills it: a scan at a time where the structure allows, else at once.
template <class Map>
void fill(const Points& points, Map& map) {
  if constexpr (kIsOurs<Map>) {
    for (std::size_t i = 0; i < points.size(); i += kScanSize) {
      map.insert(std::span(points).subspan(i, std::min(kScanSize, points.size() - i)));
    }
  } else {
    map.insert(points);
  }
}

std::size_t heap_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

template <class Map>
void insert_scan(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  Map map = make_map<Map>();
  fill(town_map(size), map);
  const Points places = stops(size, static_cast<int>(state.max_iterations));
  std::vector<Points> scans;
  for (const Eigen::Vector3f& place : places) {
    scans.push_back(scan_at(place, kScanSize, 2, scans.size()));
  }
  std::size_t next = 0;
  for (auto _ : state) map.insert(scans[next++]);
}

template <class Map>
void nearest_five(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  const Points points = town_map(size);
  const std::size_t before = heap_bytes();
  Map map = make_map<Map>();
  fill(points, map);
  const std::size_t bytes = heap_bytes() - before;
  constexpr int kStops = 50;
  Points queries;
  for (const Eigen::Vector3f& place : stops(size, kStops)) {
    for (const Eigen::Vector3f& point : scan_at(place, 1000, 10, queries.size())) {
      queries.push_back(point);
    }
  }
  MapNeighbors neighbors;
  std::size_t next = 0;
  for (auto _ : state) {
    map.nearest(queries[next], kNumNeighbors, kRadius_m, neighbors);
    benchmark::DoNotOptimize(neighbors);
    next = next + 1 == queries.size() ? 0 : next + 1;
  }
  // Against the exact neighbours among the same points: ours thin what they are given.
  NanoflannMap exact;
  if constexpr (kIsOurs<Map>) {
    exact.insert(map.points());
  } else {
    exact.insert(points);
  }
  std::size_t num_expected = 0;
  std::size_t num_found = 0;
  for (std::size_t i = 0; i < queries.size(); i += 10) {
    MapNeighbors expected;
    exact.nearest(queries[i], kNumNeighbors, kRadius_m, expected);
    map.nearest(queries[i], kNumNeighbors, kRadius_m, neighbors);
    num_expected += static_cast<std::size_t>(expected.count);
    for (int k = 0; k < neighbors.count; ++k) {
      const auto end = expected.points.begin() + expected.count;
      if (std::find(expected.points.begin(), end, neighbors.points[k]) != end) ++num_found;
    }
  }
  state.counters["recall"] = static_cast<double>(num_found) / static_cast<double>(num_expected);
  state.counters["bytes_per_point"] = static_cast<double>(bytes) / static_cast<double>(size);
}

template <class Map>
void erase_box(benchmark::State& state) {
  const auto size = static_cast<std::size_t>(state.range(0));
  Map map = make_map<Map>();
  fill(town_map(size), map);
  const Points places = stops(size, static_cast<int>(state.max_iterations));
  std::size_t next = 0;
  for (auto _ : state) {
    const Eigen::Vector3f half = Eigen::Vector3f::Constant(10.0F);
    map.erase_box({.min = places[next] - half, .max = places[next] + half});
    ++next;
  }
}

template <class Map>
void add_benchmarks(const std::string& name, int num_changes) {
  for (const std::int64_t size : {200'000, 500'000, 1'000'000}) {
    benchmark::RegisterBenchmark(("insert/" + name).c_str(), &insert_scan<Map>)
        ->Arg(size)
        ->Iterations(num_changes)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("nearest/" + name).c_str(), &nearest_five<Map>)
        ->Arg(size)
        ->Iterations(200'000)
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("erase/" + name).c_str(), &erase_box<Map>)
        ->Arg(size)
        ->Iterations(num_changes)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace hybridfusion::bench

int main(int argc, char** argv) {
  using namespace hybridfusion;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  bench::add_benchmarks<VoxelMap>("hash", 50);
  bench::add_benchmarks<IncrementalKdTree>("ikdtree", 50);
  bench::add_benchmarks<bench::NanoflannDynamicMap>("nanoflann dynamic", 5);
  bench::add_benchmarks<bench::NanoflannMap>("nanoflann rebuilt", 3);
  bench::add_benchmarks<bench::PclKdTreeMap>("PCL KdTreeFLANN rebuilt", 3);
  bench::add_benchmarks<bench::PclOctreeMap>("PCL octree rebuilt", 3);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
