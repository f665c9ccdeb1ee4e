#include "scan_store.hpp"
#include "simulated_drive.hpp"

#include <hybridfusion/lidar/mapper.hpp>

#include <csignal>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

/// A limit on the size of files stands in for a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit_), 0);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = old_limit_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_ = {};
  void (*old_handler_)(int);
};

class FullScratchFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Maps the standard drive while no file may have more than `bytes`.
  [[nodiscard]] Expected<MappingResult> map_with(rlim_t bytes) const {
    const FullDisk disk(bytes);
    auto mapper = LidarMapper::create({}, testing::standard_drive().rig, folder_);
    if (!mapper) return std::unexpected(mapper.error());
    for (SensorMessage& message : testing::messages_of(testing::standard_drive())) {
      mapper->add(std::move(message));
    }
    return mapper->finish({.num_threads = 2});
  }

  fs::path folder_ = {};
};

TEST_F(FullScratchFolder, EndsTheMappingWithItsNameAndLeavesNothing) {
  const rlim_t whole = 40'000'000;
  ASSERT_TRUE(map_with(whole));
  // From the first scan on, among the scans, and in what is put aside for planes and tiles.
  for (const rlim_t bytes : {rlim_t{1000}, rlim_t{700'000}, rlim_t{3'000'000}}) {
    const auto result = map_with(bytes);
    ASSERT_FALSE(result) << bytes;
    EXPECT_EQ(result.error().code, ErrorCode::kIo) << bytes;
    EXPECT_NE(result.error().message.find(folder_.string()), std::string::npos);
    EXPECT_NE(result.error().message.find("File too large"), std::string::npos);
    EXPECT_TRUE(fs::is_empty(folder_)) << bytes;
  }
}

TEST_F(FullScratchFolder, KeepsTheScansThatWereStored) {
  auto spill = SpillFile::create(folder_);
  ASSERT_TRUE(spill);
  ScanStore store(100, *std::move(spill));
  ScanEstimate scan;
  for (int i = 0; i < 50; ++i) {
    scan.deskewed.push_back({.point_in_lidar = {1.0F + static_cast<float>(i), 2.0F, 3.0F}});
  }
  ASSERT_TRUE(store.add(scan));
  {
    const FullDisk disk(700);  // one scan has 600 bytes
    const auto refused = store.add(scan);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kIo);
  }
  std::vector<PackedPoint> points;
  ASSERT_TRUE(store.read(store.scans().front(), points));
  ASSERT_EQ(points.size(), 50U);
  EXPECT_NEAR(unpack(points[49]).point_in_imu.x(), 50.0F, 0.001F);
  ASSERT_TRUE(store.add(scan));  // room again
  ASSERT_TRUE(store.read(store.scans().back(), points));
  EXPECT_EQ(points.size(), 50U);
}

}  // namespace
}  // namespace hybridfusion
