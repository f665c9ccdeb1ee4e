#include "test_files.hpp"

#include <hybridfusion/io/kitti.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using testing::TempFolder;

TEST(Kitti, TrajectoryComesBackAsItWasWritten) {
  Trajectory trajectory;
  for (int i = 0; i < 20; ++i) {
    trajectory.poses.push_back(
        {.time = Timestamp(1'700'000'000'123'456'789 + i * 100'000'000LL),
         .map_from_body = {.rotation = Eigen::Quaterniond(
                               Eigen::AngleAxisd(0.3 * i, Eigen::Vector3d(1, i, 2).normalized())),
                           .translation = {1.5 * i, -0.25 * i, 1e4}}});
  }
  const TempFolder folder;
  const auto poses = folder.path() / "a.kitti";
  const auto times = folder.path() / "times.txt";
  ASSERT_TRUE(write_kitti(poses, trajectory));
  ASSERT_TRUE(write_kitti_times(times, trajectory));
  const auto back = read_kitti(poses, times);
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->poses.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(back->poses[i].time, trajectory.poses[i].time);
    const Rigid3& pose = back->poses[i].map_from_body;
    const Rigid3& wanted = trajectory.poses[i].map_from_body;
    EXPECT_LE((pose.translation - wanted.translation).norm(), 1e-6);
    EXPECT_LE(pose.rotation.angularDistance(wanted.rotation), 1e-7);
  }
}

TEST(Kitti, ReadsTheBenchmarksOwnNotation) {
  const TempFolder folder;
  // First line of pose file 00 of the benchmark, and a quarter turn about y.
  const auto poses = folder.file("00.txt",
                                 "1.000000e+00 9.043680e-12 2.326809e-11 5.551115e-17 9.043683e-12 "
                                 "1.000000e+00 2.392370e-10 3.330669e-16 2.326810e-11 2.392370e-10 "
                                 "9.999999e-01 -4.440892e-16\n0 0 1 2 0 1 0 3 -1 0 0 4\n");
  const auto times = folder.file("times.txt", "0.000000e+00\n1.036224e-01\n");
  const auto read = read_kitti(poses, times);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->poses[1].time.count(), 103622400);
  EXPECT_EQ(read->poses[1].map_from_body.translation, Eigen::Vector3d(2, 3, 4));
  EXPECT_LE(
      (read->poses[1].map_from_body.rotation * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitZ())
          .norm(),
      1e-9);
}

TEST(Kitti, WrongFilesAreNamedWithTheirLine) {
  const TempFolder folder;
  const auto message = [&](std::string_view poses, std::string_view times) {
    const auto read = read_kitti(folder.file("p.kitti", poses), folder.file("t.txt", times));
    EXPECT_FALSE(read);
    return read ? std::string() : read.error().message;
  };
  const std::string pose = "1 0 0 0 0 1 0 0 0 0 1 0\n";
  EXPECT_THAT(message("1 2 3\n", "1\n"), HasSubstr("p.kitti: line 1"));
  EXPECT_THAT(message("2 0 0 0 0 1 0 0 0 0 1 0\n", "1\n"), HasSubstr("no pose"));
  EXPECT_THAT(message("-1 0 0 0 0 1 0 0 0 0 1 0\n", "1\n"), HasSubstr("no pose"));
  EXPECT_THAT(message("nan 0 0 0 0 1 0 0 0 0 1 0\n", "1\n"), HasSubstr("no pose"));
  EXPECT_THAT(message(pose + pose, "1\n"), HasSubstr("more poses than the 1 times"));
  EXPECT_THAT(message(pose, "1\n2\n"), HasSubstr("1 poses, but 2 times"));
  EXPECT_THAT(message(pose + pose, "2\n1\n"), HasSubstr("do not ascend"));
  EXPECT_THAT(message(pose, "soon\n"), HasSubstr("t.txt: line 1"));
}

}  // namespace
}  // namespace hybridfusion
