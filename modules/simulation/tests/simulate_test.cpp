#include "imu_model.hpp"
#include "pinhole_camera.hpp"
#include "ray_tracer.hpp"
#include "world.hpp"

#include <hybridfusion/io/dataset_truth.hpp>
#include <hybridfusion/io/jpeg.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/simulation/simulate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 3;

/// A block small and coarse enough for a unit test.
SimulationOptions tiny_options() {
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

fs::path fresh_folder(const std::string& name) {
  // Tests run side by side, each in its own process.
  const fs::path path =
      fs::path(testing::TempDir()) / ("hf_simulate_" + std::to_string(getpid()) + "_" + name);
  fs::remove_all(path);
  return path;
}

std::map<std::string, std::string> contents(const fs::path& folder) {
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

  static fs::path folder_;
  static SimulationSummary summary_;
};
fs::path SimulatedBlock::folder_ = {};
SimulationSummary SimulatedBlock::summary_ = {};

TEST_F(SimulatedBlock, HasTheFilesOfADataSet) {
  for (const char* name : {"street.bag",
                           "sensors.yaml",
                           "truth/dataset.json",
                           "truth/cameras.csv",
                           "truth/trajectory_imu.tum",
                           "truth/trajectory_lidar.tum",
                           "truth/mesh.ply",
                           "truth/samples.ply",
                           "images/IMG_0001.JPG"}) {
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  }
  const auto truth = read_dataset_truth(folder_ / "truth/dataset.json");
  ASSERT_TRUE(truth) << truth.error().message;
  ASSERT_TRUE(truth->camera && truth->imu_from_lidar && truth->enu_from_imu_at_first_scan);
  EXPECT_EQ(truth->camera->width_px, 480);
  const auto sensors = read_sensors_yaml(folder_ / "sensors.yaml");
  ASSERT_TRUE(sensors) << sensors.error().message;
  EXPECT_LT((sensors->imu_from_lidar->translation - truth->imu_from_lidar->translation).norm(),
            1e-9);
  const auto mesh = read_ply_mesh(folder_ / "truth/mesh.ply");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->triangles.size(), summary_.triangles);
  std::array<bool, 4> labels{};
  for (const std::uint8_t label : mesh->labels) labels.at(label) = true;
  EXPECT_TRUE(std::ranges::all_of(labels, [](bool present) { return present; }));
}

TEST_F(SimulatedBlock, BagHasTheStatedRatesAndFields) {
  std::size_t scans = 0;
  std::size_t imu = 0;
  std::size_t gnss = 0;
  Timestamp last_imu{};
  for (const SensorMessage& message : messages()) {
    if (const auto* sample = std::get_if<ImuSample>(&message)) {
      if (imu++ > 0) {
        EXPECT_NEAR(to_seconds(sample->time - last_imu), 0.005, 1e-6);
      }
      last_imu = sample->time;
    } else if (const auto* fix = std::get_if<GnssFix>(&message)) {
      ++gnss;
      EXPECT_NEAR(fix->sigma_enu_m.x(), 1.5, 1e-9);
    } else {
      const auto& scan = std::get<LidarScan>(message);
      ++scans;
      ASSERT_FALSE(scan.points.empty());
      const auto [first, last] = std::ranges::minmax(scan.points, {}, &LidarPoint::offset_ns);
      EXPECT_GE(first.offset_ns, 0);
      EXPECT_LT(last.offset_ns, 100'000'000);
      EXPECT_GT(last.offset_ns, 90'000'000);
    }
  }
  EXPECT_EQ(scans, summary_.scans);
  EXPECT_NEAR(static_cast<double>(scans), 158.0, 2.0);
  EXPECT_EQ(imu, 3201U);
  EXPECT_EQ(gnss, 81U);
}

TEST_F(SimulatedBlock, LidarPointsLieOnTheWorldWithinTheirNoise) {
  const auto world = build_world(tiny_options().world, kSeed, {});
  ASSERT_TRUE(world);
  const RayTracer tracer(world->scene);
  const auto trajectory = read_tum(folder_ / "truth/trajectory_lidar.tum");
  ASSERT_TRUE(trajectory);
  std::size_t number = 0;
  std::size_t points = 0;
  std::size_t close = 0;
  double square = 0.0;
  for (const SensorMessage& message : messages()) {
    const auto* scan = std::get_if<LidarScan>(&message);
    if (scan == nullptr || number++ % 12 != 0) continue;
    for (const LidarPoint& point : scan->points) {
      const auto pose = interpolate(*trajectory, scan->stamp + Timestamp(point.offset_ns), 0.0);
      ASSERT_TRUE(pose);
      const Eigen::Vector3f origin = pose->translation.cast<float>();
      const Eigen::Vector3d at = *pose * point.point_in_lidar.cast<double>();
      const double range = point.point_in_lidar.cast<double>().norm();
      const RayHit hit =
          tracer.cast(origin, ((at - pose->translation) / range).cast<float>(), 0.2F, 200.0F);
      ++points;
      if (hit.face == kNoFace || std::abs(static_cast<double>(hit.distance_m) - range) > 0.1) {
        continue;
      }
      ++close;
      square += std::pow(static_cast<double>(hit.distance_m) - range, 2);
    }
  }
  ASSERT_GT(points, 10000U);
  // The rest are mixed returns at edges and rays that the 1/256 m grid moved past an edge.
  EXPECT_GT(static_cast<double>(close), 0.95 * static_cast<double>(points));
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(close)), 0.02, 0.004);
}

TEST_F(SimulatedBlock, DeadReckoningStaysWithinWhatTheImuErrorsAllow) {
  const auto trajectory = read_tum(folder_ / "truth/trajectory_imu.tum");
  ASSERT_TRUE(trajectory);
  std::vector<ImuSample> imu;
  for (const SensorMessage& message : messages()) {
    if (const auto* sample = std::get_if<ImuSample>(&message)) imu.push_back(*sample);
  }
  const Eigen::Vector3d gravity(0, 0, -kGravity_mps2);
  for (const std::size_t start : {1000U, 1600U, 2200U}) {
    constexpr double kHalf_s = 0.01;
    const Timestamp time = imu[start].time;
    const auto pose_at = [&](Timestamp t) { return *interpolate(*trajectory, t, 0.01); };
    Rigid3 pose = pose_at(time);
    Eigen::Vector3d velocity = (pose_at(time + from_seconds(kHalf_s)).translation -
                                pose_at(time - from_seconds(kHalf_s)).translation) /
                               (2.0 * kHalf_s);
    constexpr std::size_t kSteps = 200;  // 1 s
    for (std::size_t i = start; i < start + kSteps; ++i) {
      const double dt = to_seconds(imu[i + 1].time - imu[i].time);
      const Eigen::Vector3d turn =
          0.5 * dt * (imu[i].angular_velocity_radps + imu[i + 1].angular_velocity_radps);
      const Eigen::Quaterniond next =
          pose.rotation * Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
      const Eigen::Vector3d acceleration = 0.5 * (pose.rotation * imu[i].specific_force_mps2 +
                                                  next * imu[i + 1].specific_force_mps2) +
                                           gravity;
      pose.translation += dt * velocity + 0.5 * dt * dt * acceleration;
      velocity += dt * acceleration;
      pose.rotation = next.normalized();
    }
    const Rigid3 truth = pose_at(imu[start + kSteps].time);
    // Biases of 4 sigma: a gyroscope bias b tilts gravity, g b t^3 / 6; an accelerometer bias gives
    // a t^2 / 2; the start velocity is good to a few mm/s.
    const double position_limit = 4.0 * std::sqrt(3.0) * (9.8 * 0.004 / 6.0 + 0.03 / 2.0) + 0.02;
    EXPECT_LE((pose.translation - truth.translation).norm(), position_limit);
    EXPECT_LE(rotation_distance_rad(pose.rotation, truth.rotation),
              4.0 * std::sqrt(3.0) * (0.004 + 2.4e-4));
  }
}

double grey(const Image8& image, const Eigen::Vector2d& pixel) {
  const auto x = static_cast<std::size_t>(std::lround(pixel.x()));
  const auto y = static_cast<std::size_t>(std::lround(pixel.y()));
  const auto* p = &image.pixels[3 * (y * static_cast<std::size_t>(image.width) + x)];
  return (p[0] + p[1] + p[2]) / 3.0;
}

double correlation(const std::vector<std::pair<double, double>>& pairs) {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (const auto& [x, y] : pairs) {
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  const auto n = static_cast<double>(pairs.size());
  return (n * ab - a * b) / std::sqrt((n * aa - a * a) * (n * bb - b * b));
}

TEST_F(SimulatedBlock, TruthPointsHitTheSameTextureInTwoPhotos) {
  const auto truth = read_dataset_truth(folder_ / "truth/dataset.json");
  const auto poses = read_true_photo_poses(folder_ / "truth/cameras.csv");
  const auto samples = read_ply_columns(folder_ / "truth/samples.ply");
  ASSERT_TRUE(truth && poses && samples);
  const TrueCamera& c = *truth->camera;
  const PinholeCamera camera(c.width_px, c.height_px, c.focal_px, c.principal_point_px, c.k1, c.k2);
  std::vector<Image8> images;
  for (std::size_t i = 0; i < 2; ++i) {
    auto image = decode_jpeg(folder_ / "images" / (*poses)[i].name);
    ASSERT_TRUE(image);
    images.push_back(*std::move(image));
  }
  const auto column = [&](const char* name) -> const std::vector<double>& {
    return *samples->find(name);
  };
  // Grey values of the ground in both photos, the second read beside the true place as well.
  std::map<std::pair<int, int>, std::vector<std::pair<double, double>>> pairs;
  for (std::size_t i = 0; i < samples->size(); ++i) {
    if (column("label")[i] > 0.5 || column("drone")[i] < 3.5) continue;
    const Eigen::Vector3d point(column("x")[i], column("y")[i], column("z")[i]);
    Eigen::Vector2d first;
    Eigen::Vector2d second;
    if (!camera.project((*poses)[0].enu_from_camera.inverse() * point, first) ||
        !camera.project((*poses)[1].enu_from_camera.inverse() * point, second) ||
        std::min(second.x(), second.y()) < 4.0 || second.x() > c.width_px - 5 ||
        second.y() > c.height_px - 5) {
      continue;
    }
    for (const auto& [dx, dy] : {std::pair{0, 0}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}}) {
      pairs[{dx, dy}].emplace_back(grey(images[0], first),
                                   grey(images[1], second + Eigen::Vector2d(dx, dy)));
    }
  }
  const std::pair kExact{0, 0};
  ASSERT_GT(pairs[kExact].size(), 500U);
  const double exact = correlation(pairs[kExact]);
  // Edges, noise and moving highlights keep it below 1.
  EXPECT_GT(exact, 0.6);
  for (const auto& [shift, beside] : pairs) {
    if (shift != kExact) {
      EXPECT_LT(correlation(beside), exact);
    }
  }
}

TEST_F(SimulatedBlock, TruthSamplesLieOnTheMeshAndKnowWhoSeesThem) {
  const auto samples = read_ply_columns(folder_ / "truth/samples.ply");
  ASSERT_TRUE(samples);
  EXPECT_EQ(samples->size(), summary_.truth_samples);
  std::size_t both = 0;
  for (std::size_t i = 0; i < samples->size(); ++i) {
    if ((*samples->find("drone"))[i] > 1 && (*samples->find("vehicle"))[i] > 0) ++both;
  }
  EXPECT_GT(both, samples->size() / 10);
  EXPECT_LT(both, samples->size());
}

TEST_F(SimulatedBlock, OurReaderFindsCameraTimeAndPositionInTheExif) {
  const auto photos = open_photo_folder(folder_ / "images");
  const auto poses = read_true_photo_poses(folder_ / "truth/cameras.csv");
  const auto truth = read_dataset_truth(folder_ / "truth/dataset.json");
  ASSERT_TRUE(photos && poses && truth);
  EXPECT_TRUE(photos->quarantined.empty());
  ASSERT_EQ(photos->photos.size(), poses->size());
  for (std::size_t i = 0; i < poses->size(); ++i) {
    const PhotoMetadata& data = photos->photos[i].metadata;
    EXPECT_EQ(data.make, "CVSIM");
    EXPECT_EQ(data.focal_35mm, 28.0);
    ASSERT_TRUE(data.latitude_deg && data.longitude_deg && data.altitude_m && data.focal_mm);
    EXPECT_NEAR(*data.focal_mm, 5.177, 1e-3);
    EXPECT_EQ(data.gps_horizontal_error_m, 1.5);
    const Eigen::Vector3d fix = enu_from_geodetic(
        truth->origin, {*data.latitude_deg, *data.longitude_deg, *data.altitude_m});
    EXPECT_LT((fix - *(*poses)[i].gnss_in_enu).norm(), 2e-3);
    ASSERT_TRUE(data.time);
    EXPECT_NEAR(to_seconds(*data.time - from_seconds((*poses)[i].time_s)), 0.0, 1.0);
  }
}

TEST_F(SimulatedBlock, ExiftoolReadsTheSamePosition) {
  const std::string command =
      "exiftool -n -s3 -GPSLatitude -GPSAltitude -FocalLengthIn35mmFormat '" +
      (folder_ / "images/IMG_0001.JPG").string() + "' 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  double latitude = 0.0;
  double altitude = 0.0;
  double focal = 0.0;
  if (pipe == nullptr ||
      std::fscanf(pipe.get(), "%lf %lf %lf", &latitude, &altitude, &focal) != 3) {
    GTEST_SKIP() << "exiftool is not installed (package libimage-exiftool-perl)";
  }
  const auto poses = read_true_photo_poses(folder_ / "truth/cameras.csv");
  const auto truth = read_dataset_truth(folder_ / "truth/dataset.json");
  ASSERT_TRUE(poses && truth);
  const GeodeticPosition expected = geodetic_from_enu(truth->origin, *poses->front().gnss_in_enu);
  EXPECT_NEAR(latitude, expected.latitude_deg, 2e-9);
  EXPECT_NEAR(altitude, expected.altitude_m, 1e-3);
  EXPECT_EQ(focal, 28.0);
}

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
