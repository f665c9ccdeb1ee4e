#include "simulated_block.hpp"

namespace hybridfusion {
namespace {

/// Small enough to be made several times.
SimulationOptions smallest_options() {
  SimulationOptions options = tiny_options();
  options.camera.width_px = 96;
  options.camera.height_px = 72;
  options.drive.duration_s = 11.0;
  options.lidar.columns = 60;
  options.world.size_m = 44.0;
  options.world.ambient_rays = 4;
  options.samples_per_m2 = 0.5;
  return options;
}

TEST(Simulate, OneAndTwoThreadsGiveTheSameBytes) {
  const fs::path one = fresh_folder("one");
  const fs::path two = fresh_folder("two");
  ASSERT_TRUE(simulate(one, smallest_options(), {.num_threads = 1, .seed = 9}));
  ASSERT_TRUE(simulate(two, smallest_options(), {.num_threads = 2, .seed = 9}));
  EXPECT_EQ(contents(one), contents(two));
  fs::remove_all(one);
  fs::remove_all(two);
}

TEST(Simulate, SwitchingTheFlightOffDoesNotChangeTheRecording) {
  const fs::path with = fresh_folder("with");
  const fs::path without = fresh_folder("without");
  SimulationOptions options = smallest_options();
  ASSERT_TRUE(simulate(with, options, {.seed = 9}));
  options.flight.enabled = false;
  ASSERT_TRUE(simulate(without, options, {.seed = 9}));
  auto full = contents(with);
  auto part = contents(without);
  EXPECT_EQ(full["street.bag"], part["street.bag"]);
  EXPECT_EQ(full["truth/trajectory_imu.tum"], part["truth/trajectory_imu.tum"]);
  fs::remove_all(with);
  fs::remove_all(without);
}

TEST(Simulate, AviaWritesTheSamePointsAsCloudAndAsCustomMessage) {
  SimulationOptions options = smallest_options();
  options.flight.enabled = false;
  options.lidar.model = "avia";
  options.lidar.avia_rays = 600;
  options.drive.camera_hz = 0.25;
  const fs::path folder = fresh_folder("avia");
  const auto summary = simulate(folder, options, {.seed = 9});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->street_images, 3U);
  const auto scans_of = [&](const std::string& topic) {
    std::vector<LidarScan> scans;
    auto source = open_recording(folder / "street.bag", {.lidar_topic = topic});
    EXPECT_TRUE(source);
    while (source) {
      auto message = (*source)->next();
      if (!message || !message->has_value()) break;
      if (auto* scan = std::get_if<LidarScan>(&**message)) scans.push_back(*scan);
    }
    return scans;
  };
  const auto clouds = scans_of("/livox/points");
  const auto custom = scans_of("/livox/lidar");
  ASSERT_EQ(clouds.size(), custom.size());
  ASSERT_GT(clouds.size(), 50U);
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    EXPECT_EQ(clouds[i].stamp, custom[i].stamp);
    ASSERT_EQ(clouds[i].points.size(), custom[i].points.size());
    for (std::size_t k = 0; k < clouds[i].points.size(); ++k) {
      EXPECT_EQ(clouds[i].points[k].point_in_lidar, custom[i].points[k].point_in_lidar);
      EXPECT_EQ(clouds[i].points[k].offset_ns, custom[i].points[k].offset_ns);
    }
  }
  fs::remove_all(folder);
}

TEST(Simulate, EveryVariantAndACityGridCanBeMade) {
  for (const char* variant : {"dull", "repetitive", "flat", "other-site"}) {
    SimulationOptions options = smallest_options();
    options.world.variant = variant;
    options.flight.enabled = false;
    const fs::path folder = fresh_folder(variant);
    const auto summary = simulate(folder, options, {.seed = 4});
    ASSERT_TRUE(summary) << variant << ": " << summary.error().message;
    EXPECT_GT(summary->path_m, 5.0) << variant;
    fs::remove_all(folder);
  }
  SimulationOptions city = smallest_options();
  city.world.blocks_x = 2;
  city.drive.drives = 2;
  city.flight.enabled = false;
  const fs::path folder = fresh_folder("city");
  const auto summary = simulate(folder, city, {.seed = 4});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_EQ(summary->drives, 2U);
  EXPECT_TRUE(fs::exists(folder / "street_2.bag"));
  EXPECT_TRUE(fs::exists(folder / "truth/trajectory_lidar_2.tum"));
  fs::remove_all(folder);
}

TEST(Simulate, TheMeshOfOneRunCanBeTheWorldOfTheNext) {
  SimulationOptions options = smallest_options();
  options.flight.enabled = false;
  const fs::path first = fresh_folder("mesh_source");
  ASSERT_TRUE(simulate(first, options, {.seed = 4}));
  options.world.mesh = (first / "truth/mesh.ply").string();
  options.drive.max_speed_mps = 6.0;
  const fs::path second = fresh_folder("mesh_world");
  const auto summary = simulate(second, options, {.seed = 4});
  ASSERT_TRUE(summary) << summary.error().message;
  EXPECT_GT(summary->lidar_points, 1000U);
  fs::remove_all(first);
  fs::remove_all(second);
}

TEST(Simulate, AnExistingFolderIsRefusedAndLeftAlone) {
  const fs::path folder = fresh_folder("taken");
  fs::create_directories(folder);
  std::ofstream(folder / "precious.txt") << "mine";
  const auto result = simulate(folder, smallest_options(), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kInvalidOptions);
  EXPECT_EQ(contents(folder).at("precious.txt"), "mine");
  EXPECT_EQ(contents(folder).size(), 1U);
  fs::remove_all(folder);
}

TEST(Simulate, BadOptionsAreRefusedAndLeaveNothing) {
  const fs::path folder = fresh_folder("bad");
  SimulationOptions negative = smallest_options();
  negative.lidar.range_sd_m = -1.0;
  SimulationOptions nothing = smallest_options();
  nothing.flight.enabled = nothing.drive.enabled = false;
  SimulationOptions impatient = smallest_options();
  impatient.flight.enabled = false;
  impatient.drive.standstill_s = 9.0;
  for (const SimulationOptions& options : {negative, nothing, impatient}) {
    const auto result = simulate(folder, options, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kInvalidOptions) << result.error().message;
    EXPECT_FALSE(fs::exists(folder));
    EXPECT_FALSE(fs::exists(folder.string() + ".part"));
  }
}

TEST(Simulate, StoppingLeavesNothingBehind) {
  const fs::path folder = fresh_folder("stopped");
  std::stop_source stop;
  RunContext ctx{.stop = stop.get_token()};
  ctx.progress = [&](const ProgressEvent& event) {
    if (event.stage == "simulate/photos" && event.done == 1) stop.request_stop();
  };
  const auto result = simulate(folder, smallest_options(), ctx);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kCancelled);
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_FALSE(fs::exists(folder.string() + ".part"));
}

}  // namespace
}  // namespace hybridfusion
