#include "sample_workspace.hpp"

#include "sample_results.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/tum.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace hybridfusion::testing {
namespace {

constexpr double kStreetHalf_m = 6.0;
constexpr double kRoof_m = 8.0;
constexpr double kYaw_rad = 0.4;

void must(const Expected<void>& written) {
  if (!written) throw std::runtime_error(written.error().message);
}

Rigid3 vision_from_lidar() {
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(kYaw_rad, Eigen::Vector3d::UnitZ())),
          .translation = {-20.0, -9.0, 1.8}};
}

/// Along the street, in the frame of the vision cloud.
Eigen::Vector3d street(double along_m, double across_m, double up_m) {
  const Eigen::AngleAxisd turn(kYaw_rad, Eigen::Vector3d::UnitZ());
  return Eigen::Vector3d(-20.0, -9.0, 0.0) + turn * Eigen::Vector3d(along_m, across_m, up_m);
}

PointCloud vision_cloud(Random& random) {
  PointCloud cloud;
  const auto add = [&](const Eigen::Vector3d& point, Rgb8 color) {
    cloud.points.push_back(point.cast<float>());
    cloud.colors.push_back(color);
    cloud.normals.emplace_back(0.0F, 0.0F, 1.0F);
  };
  for (int i = 0; i < 40000; ++i) {
    const double along = random.uniform(-10.0, 50.0);
    const double across = random.uniform(-18.0, 18.0);
    const bool roof = std::abs(across) > kStreetHalf_m;
    add(street(along, across, roof ? kRoof_m : 0.0), roof ? Rgb8{190, 70, 50} : Rgb8{90, 150, 90});
  }
  for (int i = 0; i < 3000; ++i) {  // what a drone sees of facades
    const double side = i % 2 == 0 ? kStreetHalf_m : -kStreetHalf_m;
    add(street(random.uniform(0.0, 40.0), side, random.uniform(3.0, kRoof_m)), {200, 190, 150});
  }
  return cloud;
}

PointCloud lidar_cloud(Random& random) {
  PointCloud cloud;
  const Rigid3 lidar_from_vision = vision_from_lidar().inverse();
  for (int i = 0; i < 25000; ++i) {
    const bool wall = i % 2 == 0;
    const double across =
        wall ? (i % 4 == 0 ? kStreetHalf_m : -kStreetHalf_m) : random.uniform(-6.0, 6.0);
    const Eigen::Vector3d point =
        street(random.uniform(-2.0, 42.0), across, wall ? random.uniform(0.0, kRoof_m) : 0.0);
    cloud.points.push_back((lidar_from_vision * point).cast<float>());
    cloud.intensities.push_back(static_cast<float>(wall ? 80.0 : 10.0 + 5.0 * random.uniform()));
    cloud.times_s.push_back(1.7e9 + 1e-3 * i);
  }
  return cloud;
}

PointCloud fused_cloud(const PointCloud& vision, const PointCloud& lidar) {
  PointCloud g{.points = vision.points, .colors = vision.colors};
  g.intensities.assign(g.size(), 0.0F);
  g.sources.assign(g.size(), PointSource::kVision);
  PointCloud l{.points =
                   transformed(vision_from_lidar(), PointCloud{.points = lidar.points}).points};
  l.colors.assign(l.size(), Rgb8{160, 160, 165});
  l.intensities = lidar.intensities;
  l.sources.assign(l.size(), PointSource::kLidar);
  return concatenate(std::move(g), l);
}

void write_vision(const std::filesystem::path& root, Random& random) {
  ColmapModel model;
  model.cameras.push_back(
      {1, "OPENCV", 1000, 750, {800.0, 800.0, 501.0, 374.0, -0.05, 0.01, 0.0002, -0.0001}});
  std::string positions =
      "name,registered,x,y,z,gnss_x,gnss_y,gnss_z,residual_h,residual_v,reason\n";
  for (std::uint32_t i = 0; i < 12; ++i) {
    const Eigen::Vector3d at(-25.0 + 15.0 * (i % 4), -12.0 + 12.0 * (i / 4), 60.0);
    const Eigen::Quaterniond down(0.0, 1.0, 0.0, 0.0);  // x east, y south, looking down
    ColmapImage image{.id = i + 1,
                      .camera = 1,
                      .name = i == 0 ? kHostilePhoto : "photo " + std::to_string(i) + ".jpg",
                      .camera_from_world = down,
                      .camera_from_world_translation = -(down * at)};
    const Eigen::Vector3d gnss =
        at + Eigen::Vector3d(random.normal(), random.normal(), 2.0 * random.normal());
    std::string quoted = image.name;
    for (std::size_t q = 0; (q = quoted.find('"', q)) != std::string::npos; q += 2)
      quoted.insert(q, 1, '"');
    positions.append("\"").append(quoted).append("\",1");
    for (const auto& p : {at, gnss}) {
      for (const double value : p) positions.append(",").append(std::to_string(value));
    }
    positions += ",1.0,1.0,\n";
    model.images.push_back(image);
  }
  for (std::uint64_t i = 0; i < 600; ++i) {
    const Eigen::Vector3d point(
        random.uniform(-30.0, 30.0), random.uniform(-15.0, 20.0), random.uniform(0.0, 1.0));
    ColmapPoint3D stored{
        .id = i + 1, .point_in_world = point, .color = {120, 120, 120}, .error_px = 0.4};
    for (ColmapImage& image : model.images) {
      const Eigen::Vector3d seen =
          image.camera_from_world * point + image.camera_from_world_translation;
      const Eigen::Vector2d pixel(800.0 * seen.x() / seen.z() + 501.0 + 0.4 * random.normal(),
                                  800.0 * seen.y() / seen.z() + 374.0 + 0.4 * random.normal());
      if (pixel.x() < 0.0 || pixel.y() < 0.0 || pixel.x() > 1000.0 || pixel.y() > 750.0) continue;
      stored.track.push_back({image.id, static_cast<std::uint32_t>(image.points.size())});
      image.points.push_back({pixel, stored.id});
    }
    model.points.push_back(std::move(stored));
  }
  must(write_colmap_model(root / "vision", model));
  positions += "lost.jpg,0,,,,3.0,4.0,60.0,,,too blurred\n";
  write_text(root / "vision/positions.csv", positions);
}

void write_lidar(const std::filesystem::path& root, Random& random) {
  Trajectory trajectory;
  std::string quality = "time,points,matched,mean_residual_m,min_information,flags\n";
  Json residuals = Json::array();
  for (int i = 0; i < 200; ++i) {
    const double time_s = 1.7e9 + 0.1 * i;
    StampedPose pose;
    pose.time = Timestamp(std::chrono::nanoseconds(1'700'000'000'000'000'000 + 100'000'000LL * i));
    pose.map_from_body.translation = {0.2 * i, 0.1 * std::sin(0.05 * i), 0.0};
    trajectory.poses.push_back(pose);
    quality += std::to_string(time_s) + ",9000,2000," +
               std::to_string(0.02 + 0.01 * random.uniform()) + ",4000.0," +
               (i == 50 ? "imu_gap|saturated" : "") + "\n";
    residuals.push_back({{"time", time_s}, {"enu_m", {0.3, -0.2, 0.5}}, {"used", i % 9 != 0}});
  }
  must(write_tum(root / "lidar/trajectory.tum", trajectory));
  write_text(root / "lidar/quality.csv", quality);
  write_text(root / "lidar/gnss.json",
             Json{{"enu_from_map", matrix({})},
                  {"horizontal_rms_m", 0.36},
                  {"vertical_rms_m", 0.5},
                  {"num_used", 177},
                  {"num_outliers", 23},
                  {"heading_sigma_deg", 0.3},
                  {"residuals", residuals}}
                 .dump());
}

}  // namespace

void write_sample_workspace(const std::filesystem::path& root) {
  Random random(3, "sample_workspace");
  for (const char* folder : {"vision", "lidar", "fused"})
    std::filesystem::create_directories(root / folder);
  const PointCloud vision = vision_cloud(random);
  const PointCloud lidar = lidar_cloud(random);
  must(write_ply(root / "vision/dense.ply", vision));
  must(write_ply(root / "lidar/map.ply", lidar));
  must(write_ply(root / "fused/fused.ply", fused_cloud(vision, lidar)));
  write_vision(root, random);
  write_lidar(root, random);
  write_sample_results(root, vision_from_lidar(), kYaw_rad);
}

}  // namespace hybridfusion::testing
