#include "truth_files.hpp"

#include "byte_writer.hpp"
#include "output_file.hpp"

#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hybridfusion {
namespace {

std::string matrix_json(const Rigid3& pose) {
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = pose.matrix();
  return fmt::format("[{:.12g}]", fmt::join(std::span<const double>(matrix.data(), 16), ", "));
}

std::string drive_json(const DriveRecord& drive, const VehicleSetup& vehicle) {
  const Rigid3 world_from_body = drive.motion.at(drive.first_scan_s).world_from_body;
  const Rigid3 enu_from_imu = world_from_body * Rigid3{.rotation = vehicle.body_from_imu};
  return fmt::format(
      " \"drive_seconds\": {:.6g}, \"drive_path_m\": {:.6g}, \"t_first_scan\": {:.6f},\n"
      " \"T_enu_imu_at_first_scan\": {},\n \"T_enu_lidar_at_first_scan\": {},\n",
      drive.motion.duration_s(),
      drive.path_m,
      drive.start_s + drive.first_scan_s,
      matrix_json(enu_from_imu),
      matrix_json(enu_from_imu * vehicle.imu_from_lidar));
}

}  // namespace

std::string cameras_csv(const std::vector<Shot>& shots) {
  std::string out = "name,time,x,y,z,qw,qx,qy,qz,gnss_e,gnss_n,gnss_u\n";
  for (const Shot& shot : shots) {
    const Eigen::Vector3d& t = shot.world_from_camera.translation;
    const Eigen::Quaterniond& q = shot.world_from_camera.rotation;
    const Eigen::Vector3d& g = shot.gnss_in_enu;
    out += fmt::format(
        "{},{:.3f},{:.6f},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f},{:.9f},{:.4f},{:.4f},"
        "{:.4f}\n",
        shot.name,
        kTakeOffTime_s + shot.time_s,
        t.x(),
        t.y(),
        t.z(),
        q.w(),
        q.x(),
        q.y(),
        q.z(),
        g.x(),
        g.y(),
        g.z());
  }
  return out;
}

std::string trajectory_tum(const DriveRecord& drive, const Rigid3& body_from_sensor) {
  std::string out = "# timestamp tx ty tz qx qy qz qw   (ENU frame of truth/dataset.json)\n";
  const auto count = static_cast<std::size_t>(drive.motion.duration_s() * 100.0 + 1e-6);
  for (std::size_t i = 0; i <= count; ++i) {
    const double time_s = 0.01 * static_cast<double>(i);
    const Rigid3 pose = drive.motion.at(time_s).world_from_body * body_from_sensor;
    const Eigen::Vector3d& t = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    out += fmt::format("{:.6f} {:.6f} {:.6f} {:.6f} {:.9f} {:.9f} {:.9f} {:.9f}\n",
                       drive.start_s + time_s,
                       t.x(),
                       t.y(),
                       t.z(),
                       q.x(),
                       q.y(),
                       q.z(),
                       q.w());
  }
  return out;
}

std::string dataset_json(const SimulationOptions& options,
                         std::uint64_t seed,
                         const GeodeticOrigin& origin,
                         const PinholeCamera& camera,
                         std::size_t photos,
                         const VehicleSetup& vehicle,
                         const std::vector<DriveRecord>& drives) {
  std::string out = fmt::format(
      "{{\n \"seed\": {}, \"size\": {}, \"variant\": \"{}\", \"blocks\": [{}, {}], "
      "\"main_building\": {},\n"
      " \"origin\": {{\"lat\": {:.9f}, \"lon\": {:.9f}, \"h\": {:.4f}}},\n"
      " \"camera\": {{\"width\": {}, \"height\": {}, \"f\": {:.12g}, \"cx\": {:.12g}, "
      "\"cy\": {:.12g}, \"k1\": {}, \"k2\": {}, \"convention\": \"OpenCV: first pixel centre is "
      "(0,0); add 0.5 to cx, cy for COLMAP\"}},\n",
      seed,
      options.world.size_m,
      options.world.variant,
      options.world.blocks_x,
      options.world.blocks_y,
      options.world.main_building,
      origin.latitude_deg,
      origin.longitude_deg,
      origin.altitude_m,
      camera.width_px,
      camera.height_px,
      camera.focal_px,
      camera.principal_px.x(),
      camera.principal_px.y(),
      camera.k1,
      camera.k2);
  out += fmt::format(
      " \"gnss\": {{\"sigma_h\": {}, \"sigma_v\": {}, \"tau\": {}}},\n \"photos\": {},\n"
      " \"lidar\": \"{}\", \"drives\": {},\n",
      options.gnss.rtk ? 0.03 : options.gnss.sigma_horizontal_m,
      options.gnss.rtk ? 0.03 : options.gnss.sigma_vertical_m,
      options.gnss.correlation_s,
      photos,
      options.lidar.model,
      drives.size());
  if (!drives.empty()) out += drive_json(drives.front(), vehicle);
  out += fmt::format(" \"T_imu_lidar\": {}\n}}\n", matrix_json(vehicle.imu_from_lidar));
  return out;
}

Expected<void> write_truth_mesh(const std::filesystem::path& path, const Scene& scene) {
  HF_TRY(OutputFile file, OutputFile::create(path));
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\n"
                  "comment label 0 ground 1 building 2 vegetation 3 other\n"
                  "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
                  "element face {}\nproperty list uchar int vertex_indices\n"
                  "property uchar label\nend_header\n",
                  scene.vertices.size(),
                  scene.faces.size()));
  ByteWriter out;
  for (const Eigen::Vector3f& vertex : scene.vertices) {
    for (int i = 0; i < 3; ++i) out.put(vertex[i]);
  }
  for (std::size_t face = 0; face < scene.faces.size(); ++face) {
    out.put(std::uint8_t{3});
    for (const std::uint32_t index : scene.faces[face]) out.put(static_cast<std::int32_t>(index));
    out.put(static_cast<std::uint8_t>(scene.surfaces[scene.face_surface[face]].label));
  }
  file.write(out.bytes());
  return file.close();
}

Expected<void> write_truth_samples(const std::filesystem::path& path,
                                   const std::vector<TruthSample>& samples) {
  HF_TRY(OutputFile file, OutputFile::create(path));
  file.write(fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment label 0 ground 1 building 2 vegetation 3 other; drone = number of photos seeing it; "
      "vehicle = 1 when seen by the lidar\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar label\nproperty uchar drone\nproperty uchar vehicle\nend_header\n",
      samples.size()));
  ByteWriter out;
  for (const TruthSample& sample : samples) {
    for (int i = 0; i < 3; ++i) out.put(sample.point[i]);
    for (int i = 0; i < 3; ++i) out.put(sample.normal[i]);
    out.put(sample.label);
    out.put(sample.drone);
    out.put(sample.vehicle);
  }
  file.write(out.bytes());
  return file.close();
}

}  // namespace hybridfusion
