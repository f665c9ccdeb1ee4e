#include "simulated_block.hpp"

#include "imu_model.hpp"
#include "pinhole_camera.hpp"
#include "ray_tracer.hpp"
#include "world.hpp"

#include <hybridfusion/io/dataset_truth.hpp>
#include <hybridfusion/io/jpeg.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>
#include <hybridfusion/io/tum.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

namespace hybridfusion {
namespace {

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

}  // namespace
}  // namespace hybridfusion
