#include "simulated_drive.hpp"

#include "manifold.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hybridfusion::testing {
namespace {

// A block in the middle of the ellipse, houses and gaps around it, two lamp posts.
const std::vector<Box> kBoxes{{{-9, -4, 0}, {8, 5, 9}},
                              {{-30, -30, 0}, {-8, -20, 7}},
                              {{-4, -31, 0}, {12, -19, 12}},
                              {{15, -28, 0}, {30, -21, 6}},
                              {{27, -18, 0}, {40, 2, 8}},
                              {{26, 6, 0}, {38, 20, 11}},
                              {{4, 19, 0}, {22, 30, 8}},
                              {{-18, 21, 0}, {0, 29, 10}},
                              {{-40, -14, 0}, {-27, 16, 7}},
                              {{13.0, -7.0, 0}, {13.3, -6.7, 6}},
                              {{-14.0, 6.0, 0}, {-13.7, 6.3, 6}}};

constexpr double kGravity = 9.81;
constexpr double kRate_radps = 0.35;
constexpr double kRamp_s = 1.5;

double phase(double t) {
  const double u = (t - kStandstill_s) / kRamp_s;
  if (u <= 0.0) return 0.0;
  const double v = std::min(u, 1.0);
  // Integral of the quintic smooth step: acceleration and jerk start at zero.
  const double ramp = v * v * v * v * (v * v - 3.0 * v + 2.5);
  return kRate_radps * kRamp_s * (ramp + std::max(0.0, u - 1.0));
}

Rigid3 pose_at(double t) {
  constexpr double kA = 18.0;
  constexpr double kB = 12.0;
  const double f = phase(t);
  const double yaw = std::atan2(kB * std::sin(f), kA * std::cos(f));
  const Eigen::Quaterniond rotation =
      Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(0.01 + 0.015 * std::sin(5.0 * f), Eigen::Vector3d::UnitY()) *
      Eigen::AngleAxisd(-0.02 + 0.02 * std::sin(4.0 * f), Eigen::Vector3d::UnitX());
  return {.rotation = rotation,
          .translation = {kA * std::sin(f), -kB * std::cos(f), 1.2 + 0.03 * std::sin(6.0 * f)}};
}

double cast(const std::vector<Box>& boxes,
            const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  if (direction.z() < -1e-9) nearest = -origin.z() / direction.z();
  const Eigen::Array3d inverse = direction.array().inverse();
  for (const Box& box : boxes) {
    const Eigen::Array3d a = (box.min - origin).array() * inverse;
    const Eigen::Array3d b = (box.max - origin).array() * inverse;
    const double enter = a.min(b).maxCoeff();
    const double leave = a.max(b).minCoeff();
    if (enter > 0.0 && enter <= leave) nearest = std::min(nearest, enter);
  }
  return nearest;
}

ImuSample imu_at(const DriveWorld& world,
                 double t,
                 const Eigen::Vector3d& accel_walk_mps2,
                 Random& random) {
  constexpr double kSqrtRate = 14.142;  // sqrt(200 Hz)
  constexpr double kH = 1e-4;
  const Rigid3 now = world.pose(t);
  const Eigen::Matrix3d before = world.pose(t - kH).rotation.toRotationMatrix();
  const Eigen::Matrix3d after = world.pose(t + kH).rotation.toRotationMatrix();
  constexpr double kHa = 1e-3;
  const Eigen::Vector3d acceleration =
      (world.pose(t + kHa).translation - 2.0 * now.translation + world.pose(t - kHa).translation) /
      (kHa * kHa);
  const auto noise = [&](double sigma) {
    return Eigen::Vector3d(
        sigma * random.normal(), sigma * random.normal(), sigma * random.normal());
  };
  return {.time = from_seconds(kDriveStart_s + t),
          .angular_velocity_radps = so3_log(before.transpose() * after) / (2.0 * kH) +
                                    Eigen::Vector3d(0.002, -0.003, 0.001) +
                                    noise(2.4e-4 * kSqrtRate),
          .specific_force_mps2 =
              now.rotation.conjugate() * (acceleration + Eigen::Vector3d(0, 0, kGravity)) +
              Eigen::Vector3d(0.03, -0.02, 0.04) + accel_walk_mps2 + noise(1.7e-3 * kSqrtRate)};
}

LidarScan scan_at(const DriveWorld& world, double t, const Rigid3& imu_from_lidar, Random& random) {
  constexpr int kRings = 16;
  constexpr int kColumns = 180;
  constexpr double kDuration_s = 0.1;
  LidarScan scan{.stamp = from_seconds(kDriveStart_s + t)};
  std::vector<Box> boxes = world.boxes;
  for (int column = 0; column < kColumns; ++column) {
    const double offset_s = kDuration_s * column / kColumns;
    const Rigid3 world_from_lidar = world.pose(t + offset_s) * imu_from_lidar;
    boxes.resize(world.boxes.size());
    for (const MovingBox& moving : world.moving) {
      const Eigen::Vector3d shift = (t + offset_s) * moving.velocity_mps;
      boxes.push_back({.min = moving.at_zero.min + shift, .max = moving.at_zero.max + shift});
    }
    const double azimuth = 2.0 * std::numbers::pi * column / kColumns;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation = (-15.0 + 2.0 * ring) * std::numbers::pi / 180.0;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth),
                                std::sin(elevation));
      const double range =
          cast(boxes, world_from_lidar.translation, world_from_lidar.rotation * ray);
      if (!(range < world.max_range_m)) continue;
      const Eigen::Vector3d point = (range + 0.02 * random.normal()) * ray;
      scan.points.push_back({.point_in_lidar = point.cast<float>(),
                             .intensity = static_cast<float>(10 + ring),
                             .offset_ns = static_cast<std::int32_t>(offset_s * 1e9),
                             .ring = static_cast<std::uint16_t>(ring)});
    }
  }
  return scan;
}

}  // namespace

Rigid3 true_world_from_imu(Timestamp time) {
  return pose_at(to_seconds(time - from_seconds(kDriveStart_s)));
}

SimulatedDrive simulate_drive(const DriveWorld& world, double duration_s, std::uint64_t seed) {
  SimulatedDrive drive;
  drive.rig.imu_from_lidar = {.rotation = Eigen::Quaterniond(
                                  Eigen::AngleAxisd(0.05, Eigen::Vector3d(1, -2, 3).normalized())),
                              .translation = {0.1, -0.05, 0.3}};
  drive.rig.imu_noise = {.gyro_noise_density = 2.4e-4, .accel_noise_density = 1.7e-3};
  Random imu_noise(seed, "test/imu");
  Random range_noise(seed, "test/lidar");
  Random walk(seed, "test/bias_walk");
  Eigen::Vector3d accel_walk_mps2 = Eigen::Vector3d::Zero();
  for (int i = 0; i * 0.005 <= duration_s; ++i) {
    drive.imu.push_back(imu_at(world, i * 0.005, accel_walk_mps2, imu_noise));
    for (int axis = 0; axis < 3; ++axis) {
      accel_walk_mps2[axis] += world.accel_bias_walk * std::sqrt(0.005) * walk.normal();
    }
  }
  for (int i = 0; (i + 1) * 0.1 < duration_s; ++i) {
    drive.scans.push_back(scan_at(world, i * 0.1 + 0.02, drive.rig.imu_from_lidar, range_noise));
  }
  return drive;
}

SimulatedDrive simulate_drive(double duration_s, std::uint64_t seed) {
  return simulate_drive({.boxes = kBoxes, .pose = pose_at}, duration_s, seed);
}

const SimulatedDrive& standard_drive() {
  static const SimulatedDrive drive = simulate_drive(12.0, 1);
  return drive;
}

std::vector<SensorMessage> messages_of(const SimulatedDrive& drive) {
  std::vector<SensorMessage> messages;
  std::size_t imu = 0;
  for (const LidarScan& scan : drive.scans) {
    for (; imu < drive.imu.size() && drive.imu[imu].time < scan.stamp + from_seconds(0.1); ++imu) {
      messages.emplace_back(drive.imu[imu]);
    }
    messages.emplace_back(scan);
  }
  for (; imu < drive.imu.size(); ++imu) messages.emplace_back(drive.imu[imu]);
  return messages;
}

double trajectory_error_m(const Trajectory& trajectory) {
  return trajectory_error_m(trajectory, true_world_from_imu);
}

double trajectory_error_m(const Trajectory& trajectory,
                          const std::function<Rigid3(Timestamp)>& world_from_imu) {
  std::vector<Eigen::Vector3d> estimated;
  std::vector<Eigen::Vector3d> truth;
  for (const StampedPose& pose : trajectory.poses) {
    estimated.push_back(pose.map_from_body.translation);
    truth.push_back(world_from_imu(pose.time).translation);
  }
  const auto fit = fit_rigid3(truth, estimated);
  if (!fit) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    sum += (*fit * estimated[i] - truth[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

double distance_to_world_m(const Eigen::Vector3d& point_in_world) {
  return distance_to_boxes_m(kBoxes, point_in_world);
}

double distance_to_boxes_m(const std::vector<Box>& boxes, const Eigen::Vector3d& point_in_world) {
  double nearest = std::abs(point_in_world.z());
  for (const Box& box : boxes) {
    const Eigen::Vector3d outside = (box.min - point_in_world).cwiseMax(point_in_world - box.max);
    const double signed_distance =
        outside.maxCoeff() > 0.0 ? outside.cwiseMax(0.0).norm() : -outside.maxCoeff();
    nearest = std::min(nearest, signed_distance);
  }
  return nearest;
}

}  // namespace hybridfusion::testing
