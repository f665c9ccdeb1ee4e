#include "simulated_drive.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/lidar/mapper.hpp>

#include <algorithm>
#include <filesystem>
#include <stop_token>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::messages_of;
using testing::standard_drive;

Expected<MappingResult> map_drive(const OdometryOptions& options, const RunContext& ctx) {
  auto mapper = LidarMapper::create(options, standard_drive().rig);
  EXPECT_TRUE(mapper);
  for (SensorMessage& message : messages_of(standard_drive())) mapper->add(std::move(message));
  return mapper->finish(ctx);
}

TEST(LidarMapper, MapsADriveToCentimetres) {
  const auto result = map_drive({}, {.num_threads = 1});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->trajectory.poses.size(), standard_drive().scans.size());
  EXPECT_EQ(result->quality.size(), result->trajectory.poses.size());
  // Refinement takes the filter's centimetre to millimetres.
  EXPECT_LT(testing::trajectory_error_m(result->trajectory), 0.008);
  EXPECT_GT(result->refine_iterations, 0);

  // Level: the true up, seen through the attitudes, is the map's z.
  const StampedPose& last = result->trajectory.poses.back();
  const Rigid3 world_from_imu = testing::true_world_from_imu(last.time);
  const Rigid3 world_from_map = world_from_imu * last.map_from_body.inverse();
  EXPECT_GT((world_from_map.rotation * Eigen::Vector3d::UnitZ()).z(), std::cos(0.002));
  EXPECT_GT(result->level_sigma_rad, 0.0);
  EXPECT_LT(result->level_sigma_rad, 0.005);  // else gravity would not have been fitted

  ASSERT_TRUE(validate(result->map));
  ASSERT_GT(result->map.size(), 10'000U);
  std::vector<double> distances;
  for (const Eigen::Vector3f& point : result->map.points) {
    distances.push_back(testing::distance_to_world_m(world_from_map * point.cast<double>()));
  }
  std::ranges::sort(distances);
  EXPECT_LT(distances[distances.size() / 2], 0.015);  // range noise alone: 0.013
  EXPECT_LT(distances[distances.size() * 95 / 100], 0.06);
  EXPECT_GE(*std::ranges::min_element(result->map.times_s), testing::kDriveStart_s);
}

TEST(LidarMapper, GivesTheSameBytesAtAnyThreadCount) {
  const auto one = map_drive({}, {.num_threads = 1});
  ASSERT_TRUE(one);
  for (const int num_threads : {2, 4}) {
    const auto more = map_drive({}, {.num_threads = num_threads});
    ASSERT_TRUE(more);
    ASSERT_EQ(one->map.points, more->map.points);
    for (std::size_t i = 0; i < one->trajectory.poses.size(); ++i) {
      ASSERT_EQ(one->trajectory.poses[i].map_from_body.translation,
                more->trajectory.poses[i].map_from_body.translation);
    }
  }
}

TEST(LidarMapper, GivesTheSameMapThroughAScratchFolder) {
  const auto in_memory = map_drive({}, {.num_threads = 1});
  auto mapper =
      LidarMapper::create({}, standard_drive().rig, std::filesystem::temp_directory_path());
  ASSERT_TRUE(mapper);
  for (SensorMessage& message : messages_of(standard_drive())) mapper->add(std::move(message));
  std::size_t num_points = 0;
  const auto streamed = mapper->finish({}, [&](const PointCloud& piece) -> Expected<void> {
    num_points += piece.size();
    return {};
  });
  ASSERT_TRUE(in_memory && streamed);
  EXPECT_TRUE(streamed->map.empty());
  EXPECT_EQ(num_points, in_memory->map.size());
  EXPECT_EQ(streamed->num_map_points, num_points);
}

TEST(LidarMapper, PassesOnWhatItsSinkRefuses) {
  auto mapper = LidarMapper::create({}, standard_drive().rig);
  for (SensorMessage& message : messages_of(standard_drive())) mapper->add(std::move(message));
  const auto result = mapper->finish(
      {}, [](const PointCloud&) -> Expected<void> { return fail(ErrorCode::kIo, "disk full"); });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kIo);
}

TEST(LidarMapper, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const auto result = map_drive({}, {.stop = stop.get_token(), .num_threads = 1});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
}

TEST(LidarMapper, RefusesARecordingWithoutPoints) {
  auto mapper = LidarMapper::create({}, standard_drive().rig);
  for (SensorMessage message : messages_of(standard_drive())) {
    if (auto* scan = std::get_if<LidarScan>(&message)) scan->points.clear();
    mapper->add(std::move(message));
  }
  const auto result = mapper->finish({});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInsufficient);
}

TEST(QualityCsv, HasAsManyFieldsAsItsHeader) {
  const std::string row = quality_csv_row({.time = Timestamp(1'500'000'000'000'000'001),
                                           .num_points = 10,
                                           .num_matched = 5,
                                           .mean_residual_m = 0.0123,
                                           .min_information = 1234.5,
                                           .flags = 1});
  EXPECT_EQ(row, "1500000000.000000001,10,5,0.01230,1234.5,imu_gap");
  EXPECT_EQ(std::ranges::count(row, ','), std::ranges::count(quality_csv_header(), ','));
}

}  // namespace
}  // namespace hybridfusion
