#include "dense_map.hpp"

#include "dense_tiles.hpp"
#include "street_world.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/spill_file.hpp>

#include <algorithm>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(DenseMap, MeansVoxelsAndDropsWhatOneScanAloneSaw) {
  DenseMap map({.voxel_m = 0.1, .min_scans = 2});
  map.add(0, {1.01F, 0.05F, 0.05F}, 10.0F, 0.0F);
  map.add(3, {1.03F, 0.05F, 0.05F}, 20.0F, 3.0F);
  map.add(3, {5.0F, 5.0F, 5.0F}, 1.0F, 3.0F);  // something that passed by
  map.add(3, {5.1F, 5.0F, 5.0F}, 1.0F, 3.0F);
  const PointCloud cloud = map.extract(from_seconds(100.0));
  ASSERT_EQ(cloud.size(), 1U);
  EXPECT_NEAR(cloud.points[0].x(), 1.02F, 1e-6F);
  EXPECT_FLOAT_EQ(cloud.intensities[0], 15.0F);
  EXPECT_EQ(cloud.times_s[0], 100.0);
  EXPECT_TRUE(validate(cloud));
}

TEST(DenseMap, CountsNeighboursOfAnotherScanAsSupport) {
  DenseMap map({.voxel_m = 0.1, .min_scans = 2});
  map.add(0, {1.05F, 0.05F, 0.05F}, 0.0F, 0.0F);
  map.add(1, {1.15F, 0.05F, 0.05F}, 0.0F, 0.1F);
  EXPECT_EQ(map.extract({}).size(), 2U);
}

TEST(DenseMap, KeepsThinlySampledSurfacesAndDropsLoneReturns) {
  DenseMap map({.voxel_m = 0.1, .min_scans = 2});
  // Lines of two scans on a far wall, 0.25 m apart, and a raindrop 0.5 m in front of it.
  for (int i = 0; i < 20; ++i) {
    map.add(0, {50.05F, 0.2F * static_cast<float>(i) + 0.05F, 2.05F}, 0.0F, 0.0F);
    map.add(1, {50.05F, 0.2F * static_cast<float>(i) + 0.05F, 2.30F}, 0.0F, 0.1F);
  }
  map.add(1, {49.55F, 2.05F, 2.15F}, 0.0F, 0.1F);
  const PointCloud cloud = map.extract({});
  EXPECT_EQ(cloud.size(), 40U);
  EXPECT_TRUE(std::ranges::all_of(cloud.points, [](const auto& p) { return p.x() > 50.0F; }));
}

TEST(DenseMap, TellsWhatWasHitBrieflyAboveTheGround) {
  DenseMap map({.voxel_m = 0.1, .min_scans = 1, .max_brief_s = 3.0});
  for (std::uint32_t scan = 0; scan < 50; ++scan) {
    const float time_s = 0.1F * static_cast<float>(scan);
    map.add(scan, {0.05F, 0.05F, 0.05F}, 0.0F, time_s);  // ground
    map.add(scan, {0.55F, 0.05F, 1.05F}, 0.0F, time_s);  // a post
  }
  map.add(7, {0.25F, 0.05F, 1.05F}, 0.0F, 0.7F);  // passed by
  map.add(8, {0.25F, 0.55F, 0.15F}, 0.0F, 0.8F);  // grass
  const auto brief = map.brief_voxels();
  ASSERT_EQ(brief.size(), 1U);
  EXPECT_FLOAT_EQ(map.mean(brief[0]).x(), 0.25F);
}

TEST(SpillFile, GivesBackWhatWasPutAside) {
  const auto folder = std::filesystem::temp_directory_path();
  auto on_disk = SpillFile::create(folder);
  ASSERT_TRUE(on_disk) << on_disk.error().message;
  SpillFile in_memory;
  for (SpillFile* file : {&*on_disk, &in_memory}) {
    std::vector<SpillFile::Block> blocks;
    for (int i = 0; i < 5; ++i) {
      const std::vector<std::byte> bytes(static_cast<std::size_t>(100 * i), std::byte(i));
      const auto block = file->append(bytes);
      ASSERT_TRUE(block);
      blocks.push_back(*block);
    }
    std::vector<std::byte> back;
    file->drop(blocks[2]);
    for (const int i : {4, 0, 3, 1}) {
      ASSERT_TRUE(file->read(blocks[static_cast<std::size_t>(i)], back));
      ASSERT_EQ(back.size(), static_cast<std::size_t>(100 * i));
      EXPECT_TRUE(std::ranges::all_of(back, [&](std::byte b) { return b == std::byte(i); }));
    }
  }
}

TEST(SpillFile, NamesTheFolderItCannotWriteTo) {
  const auto file = SpillFile::create("/nowhere/at/all");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kIo);
  EXPECT_NE(file.error().message.find("/nowhere/at/all"), std::string::npos);
}

TEST(DenseTiles, TogetherHoldThePointsOfOneMap) {
  // The map of all points at once against the tiles', both sides of the origin.
  const DenseMapOptions options{.voxel_m = 0.1, .min_scans = 2};
  DenseMap whole(options);
  DenseTiles tiles(options.voxel_m, {});
  Random random(3, "test/tiles");
  for (std::uint32_t i = 0; i < 60'000; ++i) {
    const TilePoint p{.x = static_cast<float>(random.uniform(-40.0, 40.0)),
                      .y = static_cast<float>(random.uniform(-1.5, 1.5)),
                      .z = static_cast<float>(random.uniform(0.0, 0.3)),
                      .intensity = 1.0F,
                      .time_s = 0.01F * static_cast<float>(i / 1000),
                      .scan = i / 1000};
    whole.add(p.scan, {p.x, p.y, p.z}, p.intensity, p.time_s);
    ASSERT_TRUE(tiles.add(p));
  }
  PointCloud joined;
  EXPECT_GT(tiles.tiles().size(), 6U);
  for (const auto& [index, tile] : tiles.tiles()) {
    DenseMap map(options);
    ASSERT_TRUE(tiles.for_each(tile, [&](const TilePoint& p) {
      map.add(p.scan, {p.x, p.y, p.z}, p.intensity, p.time_s);
    }));
    joined = concatenate(std::move(joined), map.extract({}, tiles.box_of(index)));
  }
  const auto sorted = [](const PointCloud& cloud) {
    std::vector<std::array<float, 3>> points;
    for (const Eigen::Vector3f& p : cloud.points) points.push_back({p.x(), p.y(), p.z()});
    std::ranges::sort(points);
    return points;
  };
  EXPECT_EQ(sorted(joined), sorted(whole.extract({})));
}

/// Static points kept and points of cars kept, as shares of what a map without the filter holds.
struct KeptShares {
  double fixed = 0.0;
  double moving = 0.0;
};

KeptShares kept_shares(const testing::DriveWorld& world, double duration_s) {
  const testing::SimulatedDrive drive = testing::simulate_drive(world, duration_s, 4);
  std::map<bool, std::array<std::size_t, 2>> counts;  // by filter: fixed, moving
  for (const bool filter : {false, true}) {
    OdometryOptions options{.max_range_m = 60.0};
    if (!filter) options.map.max_brief_s = 0.0;
    auto mapper = LidarMapper::create(options, drive.rig);
    for (SensorMessage& message : testing::messages_of(drive)) mapper->add(std::move(message));
    const auto result = mapper->finish({.num_threads = 1});
    EXPECT_TRUE(result);
    const StampedPose& last = result->trajectory.poses.back();
    const Rigid3 world_from_map =
        world.pose(to_seconds(last.time) - testing::kDriveStart_s) * last.map_from_body.inverse();
    for (const Eigen::Vector3f& point : result->map.points) {
      const Eigen::Vector3d p = world_from_map * point.cast<double>();
      // Above the ground and far from everything fixed: a car.
      ++counts[filter][testing::distance_to_boxes_m(world.boxes, p) > 0.3 ? 1 : 0];
    }
  }
  return {.fixed = static_cast<double>(counts[true][0]) / static_cast<double>(counts[false][0]),
          .moving = static_cast<double>(counts[true][1]) / static_cast<double>(counts[false][1])};
}

TEST(DropMoving, RemovesCarsThatPassAndKeepsHouses) {
  testing::DriveWorld world = testing::tunnel_round(5, 6.0).world;
  // One comes towards the vehicle, one overtakes it.
  world.moving = {{.at_zero = {.min = {80, 2.5, 0.2}, .max = {84.5, 4.3, 1.6}},
                   .velocity_mps = {-7.0, 0.0, 0.0}},
                  {.at_zero = {.min = {-40, 2.5, 0.2}, .max = {-35.5, 4.3, 1.6}},
                   .velocity_mps = {9.0, 0.0, 0.0}}};
  const KeptShares kept = kept_shares(world, 14.0);
  EXPECT_GT(kept.fixed, 0.97);
  EXPECT_LT(kept.moving, 0.4);
  ::testing::Test::RecordProperty("fixed_kept", std::to_string(kept.fixed));
  std::printf("kept: fixed %.4f moving %.4f\n", kept.fixed, kept.moving);
}

}  // namespace
}  // namespace hybridfusion
