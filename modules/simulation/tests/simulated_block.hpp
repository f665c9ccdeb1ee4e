#pragma once

#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/simulation/simulate.hpp>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {

namespace fs = std::filesystem;

inline constexpr std::uint64_t kSeed = 3;

/// A block small and coarse enough for a unit test.
inline SimulationOptions tiny_options() {
  SimulationOptions options;
  options.world.size_m = 50.0;
  options.world.ambient_rays = 8;
  options.camera.width_px = 480;
  options.camera.height_px = 360;
  options.flight.oblique_photos = 3;
  options.drive.duration_s = 16.0;
  options.lidar.beams = 16;
  options.lidar.columns = 180;
  options.samples_per_m2 = 2.0;
  return options;
}

inline fs::path fresh_folder(const std::string& name) {
  // Tests run side by side, each in its own process.
  const fs::path path =
      fs::path(testing::TempDir()) / ("hf_simulate_" + std::to_string(getpid()) + "_" + name);
  fs::remove_all(path);
  return path;
}

inline std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    std::stringstream bytes;
    bytes << in.rdbuf();
    files[fs::relative(entry.path(), folder)] = bytes.str();
  }
  return files;
}

/// One data set for all tests that only look at it.
class SimulatedBlock : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fresh_folder("block");
    const auto result = simulate(folder_, tiny_options(), {.num_threads = 2, .seed = kSeed});
    ASSERT_TRUE(result) << result.error().message;
    summary_ = *result;
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static std::vector<SensorMessage> messages() {
    auto source = open_recording(folder_ / "street.bag");
    EXPECT_TRUE(source);
    std::vector<SensorMessage> out;
    while (source) {
      auto message = (*source)->next();
      EXPECT_TRUE(message);
      if (!message || !message->has_value()) break;
      out.push_back(**message);
    }
    return out;
  }

  static inline fs::path folder_ = {};
  static inline SimulationSummary summary_ = {};
};

}  // namespace hybridfusion
