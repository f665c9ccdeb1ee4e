#include "temp_folder.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/viewer/octree.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hybridfusion {
namespace {

using Json = nlohmann::json;
using testing::content_of;
using testing::TempFolder;

PointCloud street(std::size_t count) {
  PointCloud cloud;
  Random random(7, "octree_test");
  for (std::size_t i = 0; i < count; ++i) {
    const bool on_wall = i % 3 == 0;
    cloud.points.emplace_back(static_cast<float>(500.0 + 60.0 * random.uniform()),
                              static_cast<float>(on_wall ? 12.0 : 40.0 * random.uniform()),
                              static_cast<float>(on_wall ? 9.0 * random.uniform() : 0.0));
    cloud.colors.push_back({static_cast<std::uint8_t>(i % 256), 7, 255});
    cloud.intensities.push_back(static_cast<float>(i % 100));
    cloud.sources.push_back(on_wall ? PointSource::kLidar : PointSource::kVision);
  }
  return cloud;
}

/// The cloud in batches of uneven size, with its index as distance.
PointBatches batches_of(const PointCloud& cloud) {
  return [&cloud](const PointBatchVisitor& visit) -> Expected<void> {
    constexpr std::size_t kBatch = 777;
    for (std::size_t begin = 0; begin < cloud.size(); begin += kBatch) {
      std::vector<std::size_t> indices;
      std::vector<float> distances_m;
      for (std::size_t i = begin; i < std::min(cloud.size(), begin + kBatch); ++i) {
        indices.push_back(i);
        distances_m.push_back(static_cast<float>(i));
      }
      if (auto visited = visit(select(cloud, indices), distances_m); !visited) return visited;
    }
    return {};
  };
}

template <class T>
T load(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

struct Stored {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  std::array<std::uint16_t, 3> rgb = {};
  std::uint16_t intensity = 0;
  std::uint8_t source = 0;
  float distance_m = 0.0F;
};
struct StoredNode {
  std::string name = {};
  Eigen::Vector3d min_m = Eigen::Vector3d::Zero();
  double side_m = 0.0;
  bool is_leaf = false;
  std::vector<Stored> points = {};
};

/// An independent reader of the format, as Potree's documentation describes it.
std::vector<StoredNode> read_octree(const std::filesystem::path& folder) {
  const Json metadata = Json::parse(content_of(folder / "metadata.json"));
  const std::string hierarchy = content_of(folder / "hierarchy.bin");
  const std::string bytes = content_of(folder / "octree.bin");
  const auto offset = metadata["offset"].get<std::array<double, 3>>();
  const auto scale = metadata["scale"].get<std::array<double, 3>>();
  const auto low = metadata["boundingBox"]["min"].get<std::array<double, 3>>();
  const auto high = metadata["boundingBox"]["max"].get<std::array<double, 3>>();
  EXPECT_EQ(hierarchy.size(), metadata["hierarchy"]["firstChunkSize"].get<std::size_t>());
  constexpr std::size_t kRecord = 22;
  constexpr std::size_t kPointBytes = 12 + 6 + 2 + 1 + 4;
  std::vector<StoredNode> nodes = {{"r", {low[0], low[1], low[2]}, high[0] - low[0], false, {}}};
  for (std::size_t n = 0; n * kRecord < hierarchy.size(); ++n) {
    StoredNode& node = nodes[n];
    node.is_leaf = load<std::uint8_t>(hierarchy, n * kRecord) == 1;
    const auto mask = load<std::uint8_t>(hierarchy, n * kRecord + 1);
    const auto count = load<std::uint32_t>(hierarchy, n * kRecord + 2);
    const auto begin = load<std::uint64_t>(hierarchy, n * kRecord + 6);
    EXPECT_EQ(load<std::uint64_t>(hierarchy, n * kRecord + 14), count * kPointBytes);
    EXPECT_EQ(node.is_leaf, mask == 0);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = begin + i * kPointBytes;
      Stored point{.rgb = load<std::array<std::uint16_t, 3>>(bytes, at + 12),
                   .intensity = load<std::uint16_t>(bytes, at + 18),
                   .source = load<std::uint8_t>(bytes, at + 20),
                   .distance_m = load<float>(bytes, at + 21)};
      const auto steps = load<std::array<std::int32_t, 3>>(bytes, at);
      for (int axis = 0; axis < 3; ++axis)
        point.point[axis] = steps[axis] * scale[axis] + offset[axis];
      node.points.push_back(point);
    }
    const StoredNode parent = node;  // the vector grows below
    for (unsigned octant = 0; octant < 8; ++octant) {
      if ((mask & (1U << octant)) == 0) continue;
      const double half = 0.5 * parent.side_m;
      const Eigen::Vector3d shift((octant & 4U) != 0 ? half : 0.0,
                                  (octant & 2U) != 0 ? half : 0.0,
                                  (octant & 1U) != 0 ? half : 0.0);
      nodes.push_back(
          {parent.name + std::to_string(octant), parent.min_m + shift, half, false, {}});
    }
  }
  return nodes;
}

void expect_each_point_once(const PointCloud& cloud, const std::vector<StoredNode>& nodes) {
  std::vector<int> times(cloud.size(), 0);
  for (const StoredNode& node : nodes) {
    for (const Stored& stored : node.points) {
      const auto i = static_cast<std::size_t>(stored.distance_m);  // the distance names the point
      ASSERT_LT(i, cloud.size());
      ++times[i];
      EXPECT_LT((stored.point - cloud.points[i].cast<double>()).norm(), 0.001);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(stored.point[axis], node.min_m[axis] - 0.002);
        EXPECT_LE(stored.point[axis], node.min_m[axis] + node.side_m + 0.002);
      }
      EXPECT_EQ(stored.rgb[0] / 257, cloud.colors[i][0]);
      EXPECT_EQ(stored.rgb[2], 65535);
      EXPECT_NEAR(stored.intensity, cloud.intensities[i] / 99.0 * 65535.0, 1.0);
      EXPECT_EQ(stored.source, static_cast<std::uint8_t>(cloud.sources[i]));
    }
  }
  for (const int count : times) ASSERT_EQ(count, 1);
}

TEST(Octree, HoldsEveryPointExactlyOnceInsideItsNode) {
  const TempFolder folder;
  const PointCloud cloud = street(30000);
  const OctreeOptions options{.cells_per_side = 16, .max_leaf_points = 500};
  const auto summary = write_octree(folder.path(), batches_of(cloud), options, {});
  ASSERT_TRUE(summary) << summary.error().message;
  const auto nodes = read_octree(folder.path());
  EXPECT_EQ(nodes.size(), summary->num_nodes);
  EXPECT_EQ(summary->num_points, cloud.size());
  EXPECT_GE(summary->depth, 2);
  expect_each_point_once(cloud, nodes);
}

TEST(Octree, InnerNodesAreThinnedAndLeavesAreSmall) {
  const TempFolder folder;
  const PointCloud cloud = street(30000);
  const OctreeOptions options{.cells_per_side = 16, .max_leaf_points = 500};
  ASSERT_TRUE(write_octree(folder.path(), batches_of(cloud), options, {}));
  for (const StoredNode& node : read_octree(folder.path())) {
    EXPECT_FALSE(node.points.empty()) << node.name;
    if (node.is_leaf) {
      EXPECT_LE(node.points.size(), options.max_leaf_points) << node.name;
      continue;
    }
    std::map<std::array<int, 3>, int> cells;
    for (const Stored& stored : node.points) {
      // The cell is that of the point before rounding to millimetres.
      const Eigen::Vector3f& point = cloud.points[static_cast<std::size_t>(stored.distance_m)];
      const Eigen::Array3d cell =
          ((point.cast<double>() - node.min_m).array() * (16.0 / node.side_m)).floor();
      const std::array<int, 3> key = {
          static_cast<int>(cell[0]), static_cast<int>(cell[1]), static_cast<int>(cell[2])};
      EXPECT_EQ(++cells[key], 1) << node.name;
    }
  }
}

TEST(Octree, SplitOnDiskEqualsTheOneBuiltInMemory) {
  const TempFolder folder;
  const PointCloud cloud = street(20000);
  OctreeOptions options{.cells_per_side = 8, .max_leaf_points = 300};
  std::filesystem::create_directories(folder.path() / "memory");
  std::filesystem::create_directories(folder.path() / "disk");
  ASSERT_TRUE(write_octree(folder.path() / "memory", batches_of(cloud), options, {}));
  options.max_memory_points = 1000;
  ASSERT_TRUE(write_octree(folder.path() / "disk", batches_of(cloud), options, {}));
  for (const char* name : {"hierarchy.bin", "octree.bin"}) {
    EXPECT_EQ(content_of(folder.path() / "memory" / name),
              content_of(folder.path() / "disk" / name));
  }
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator(folder.path() / "disk")) {
    ++files;
  }
  EXPECT_EQ(files, 3U) << "spilled points must not stay behind";
}

TEST(Octree, EqualPointsEndInOneLeafInsteadOfRecursingForEver) {
  const TempFolder folder;
  PointCloud cloud;
  cloud.points.assign(3000, Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  cloud.points.emplace_back(50.0F, 2.0F, 3.0F);
  const OctreeOptions options{.cells_per_side = 4, .max_leaf_points = 100};
  const auto summary = write_octree(
      folder.path(), [&](const PointBatchVisitor& visit) { return visit(cloud, {}); }, options, {});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->num_points, cloud.size());
  const Json metadata = Json::parse(content_of(folder.path() / "metadata.json"));
  EXPECT_EQ(metadata["attributes"].size(), 2U) << "only position and colour";
}

TEST(Octree, DropsPointsThatAreNotFiniteAndRefusesACloudWithoutAnyOther) {
  const TempFolder folder;
  PointCloud cloud;
  cloud.points.emplace_back(NAN, 0.0F, 0.0F);
  const auto batches = [&](const PointBatchVisitor& visit) { return visit(cloud, {}); };
  EXPECT_EQ(write_octree(folder.path(), batches, {}, {}).error().code, ErrorCode::kInsufficient);
  cloud.points.emplace_back(1.0F, 0.0F, 0.0F);
  const auto summary = write_octree(folder.path(), batches, {}, {});
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->num_points, 1U);
}

TEST(Octree, StopsWhenAskedTo) {
  const TempFolder folder;
  const PointCloud cloud = street(5000);
  std::stop_source stop;
  stop.request_stop();
  RunContext ctx;
  ctx.stop = stop.get_token();
  EXPECT_EQ(write_octree(folder.path(), batches_of(cloud), {}, ctx).error().code,
            ErrorCode::kCancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace hybridfusion
