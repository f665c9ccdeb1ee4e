#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/ply.hpp>

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::content_of;
using ::testing::HasSubstr;
using testing::TempFolder;

PointCloud part_of(const PointCloud& cloud, std::size_t begin, std::size_t end) {
  std::vector<std::size_t> indices;
  for (std::size_t i = begin; i < end; ++i) indices.push_back(i);
  return select(cloud, indices);
}

TEST(PlyPieces, TogetherAreTheCloud) {
  const TempFolder folder;
  const auto path = folder.path() / "map.ply";
  const PointCloud cloud = testing::sample_cloud(1234);  // the count gets digits as it grows
  auto writer = PlyPieceWriter::create(path);
  ASSERT_TRUE(writer);
  writer->add(part_of(cloud, 0, 1));
  writer->add(PointCloud{});  // an empty tile
  writer->add(part_of(cloud, 1, 700));
  writer->add(part_of(cloud, 700, 1234));
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(writer->commit());
  const auto back = read_ply(path);
  ASSERT_TRUE(back) << back.error().message;
  testing::expect_equal(*back, cloud);
}

TEST(PlyPieces, NoneAreAnEmptyCloud) {
  const TempFolder folder;
  const auto path = folder.path() / "map.ply";
  auto writer = PlyPieceWriter::create(path);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->commit());
  const auto back = read_ply(path);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_TRUE(back->empty());
}

TEST(PlyPieces, LeaveTheOldFileWhenTheyAreNotCommitted) {
  const TempFolder folder;
  const auto path = folder.file("map.ply", "old");
  {
    auto writer = PlyPieceWriter::create(path);
    ASSERT_TRUE(writer);
    writer->add(testing::sample_cloud(10));
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "map.ply.part"));
}

TEST(PlyPieces, NoRoomIsReportedAtTheEndAndLeavesNothing) {
  const TempFolder folder;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  // A limit on the size of files stands in for a full disk.
  const rlimit limit = {.rlim_cur = 300'000, .rlim_max = old_limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  Expected<void> committed;
  {
    auto writer = PlyPieceWriter::create(folder.path() / "map.ply");
    for (int i = 0; writer && i < 40; ++i) writer->add(testing::sample_cloud(1000));
    if (writer) committed = writer->commit();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(committed);
  EXPECT_EQ(committed.error().code, ErrorCode::kIo);
  EXPECT_THAT(committed.error().message, AllOf(HasSubstr("map.ply"), HasSubstr("300000 bytes")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace hybridfusion
