#include "street_drive.hpp"

namespace hybridfusion::testing {
namespace {

using Determinism = StreetTest;

TEST_F(Determinism, MapWritesTheSameBytesAtAnyThreadCount) {
  const std::string bag = (street() / "street.bag").string();
  ASSERT_EQ(map(bag, "one", {"--threads", "1"}).exit_code, 0);
  for (const char* const threads : {"2", "4"}) {
    const std::string more = std::string("with_") + threads;
    ASSERT_EQ(map(bag, more, {"--threads", threads}).exit_code, 0);
    for (const char* const file : {"lidar/map.ply",
                                   "lidar/trajectory.tum",
                                   "lidar/quality.csv",
                                   "lidar/gnss.json",
                                   "config.yaml"}) {
      const std::string bytes = read_file(folder_ / "one" / file);
      EXPECT_GT(bytes.size(), 100U) << file;
      EXPECT_TRUE(read_file(folder_ / more / file) == bytes) << file << " with " << threads;
    }
  }
}

}  // namespace
}  // namespace hybridfusion::testing
