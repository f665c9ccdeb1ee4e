#include "street_drive.hpp"

#include "flight.hpp"
#include "recorder.hpp"
#include "tunnel.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kDriveDelay_s = 5400.0;  ///< The drives follow the flight, hours apart.

/// Blocks that drive `index` of `drives` goes around: equal shares of the block columns.
std::array<std::size_t, 4> blocks_of_drive(const StreetPlan& plan, int index, int drives) {
  const std::size_t columns = plan.street_x.size() - 1;
  const std::size_t rows = plan.street_y.size() - 1;
  if (columns == 1 && rows == 1) return {0, 1, 0, 1};
  const auto share = static_cast<std::size_t>(drives);
  const auto i = static_cast<std::size_t>(index);
  std::size_t first = std::min(columns - 1, i * columns / share);
  const std::size_t last = std::max(first + 1, std::min(columns, (i + 1) * columns / share));
  return {first, last, 0, rows};
}

Expected<DrivePlan> plan_route(const StreetPlan& streets,
                               const SimulationOptions& options,
                               int index,
                               const RouteStart& start) {
  // A rolling drive never stops: laps enough for its time.
  const double rolling_m = options.drive.start_speed_mps > 0.0
                               ? options.drive.max_speed_mps * (options.drive.duration_s + 5.0)
                               : 0.0;
  if (options.world.variant == "tunnel") {
    return plan_straight(kTunnelDriveShare * options.world.size_m, kTunnelLane_m);
  }
  if (options.drive.route == "figure-eight") {
    if (streets.street_x.size() < 3) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("drive.route = figure-eight goes around two blocks, but "
                              "world.blocks_x = {} with variant '{}'",
                              options.world.blocks_x,
                              options.world.variant));
    }
    return plan_figure_eight(streets, rolling_m, start);
  }
  return plan_drive(streets,
                    blocks_of_drive(streets, index, options.drive.drives),
                    std::max(options.drive.loop_overlap_m, rolling_m),
                    start);
}

double path_length(const VehicleMotion& motion) {
  double length = 0.0;
  for (double time = 0.05; time <= motion.duration_s(); time += 0.05) {
    length += (motion.at(time).world_from_body.translation -
               motion.at(time - 0.05).world_from_body.translation)
                  .norm();
  }
  return length;
}

Eigen::Quaterniond small_turn(Random& random, double sd_rad) {
  const double roll = sd_rad * random.normal();
  const double pitch = sd_rad * random.normal();
  const double yaw = sd_rad * random.normal();
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

}  // namespace

MotionState VehicleSetup::imu_motion(MotionState body) const {
  body.world_from_body.rotation = (body.world_from_body.rotation * body_from_imu).normalized();
  body.angular_velocity_radps = body_from_imu.conjugate() * body.angular_velocity_radps;
  return body;
}

VehicleSetup make_vehicle(const LidarModelOptions& options, std::uint64_t seed) {
  Random random(seed, "vehicle/mounting");
  VehicleSetup vehicle;
  vehicle.body_from_imu = small_turn(random, 0.8 * kDegree);
  const bool avia = options.model == "avia";
  // A narrow LiDAR is mounted nose-up, to see facades rather than its own bonnet.
  const Eigen::Quaterniond nose_up(
      Eigen::AngleAxisd(avia ? -6.0 * kDegree : 0.0, Eigen::Vector3d::UnitY()));
  vehicle.imu_from_lidar.rotation = (small_turn(random, 1.3 * kDegree) * nose_up).normalized();
  vehicle.imu_from_lidar.translation = {
      0.1 + 0.02 * random.normal(), 0.03 * random.normal(), 0.34 + 0.03 * random.normal()};
  vehicle.antenna_in_imu = {
      -0.45 + 0.05 * random.normal(), 0.1 + 0.05 * random.normal(), 0.52 + 0.03 * random.normal()};
  return vehicle;
}

std::string lidar_topic(const LidarModelOptions& options) {
  if (options.message == "livox") return "/livox/lidar";
  return options.model == "avia" ? "/livox/points" : "/velodyne_points";
}

Expected<DriveRecord> record_drive(const World& world,
                                   const RayTracer& tracer,
                                   const VehicleSetup& vehicle,
                                   const SimulationOptions& options,
                                   const GeodeticOrigin& origin,
                                   int index,
                                   const std::filesystem::path& bag_path,
                                   const RunContext& ctx) {
  const auto number = static_cast<std::uint64_t>(index);
  const StreetPlan& streets = world.terrain.plan();
  Random random(ctx.seed, "vehicle/start", number);
  const RouteStart start{.share = random.uniform(0.05, 0.9), .place = options.drive.start_place};
  HF_TRY(DrivePlan plan, plan_route(streets, options, index, start));
  add_weave(options.drive.weave_m, options.drive.max_speed_mps, plan);
  HF_TRY(VehicleMotion motion, drive(plan, world.terrain, options.drive, ctx.seed, number));
  DriveRecord record{.motion = std::move(motion),
                     .start_s = kTakeOffTime_s + kDriveDelay_s * (index + 1),
                     .first_scan_s = kFirstScan_s};
  record.path_m = path_length(record.motion);
  HF_TRY(BagWriter bag, BagWriter::create(bag_path, options.drive.compression));
  const RecorderInputs inputs{.world = world,
                              .tracer = tracer,
                              .vehicle = vehicle,
                              .options = options,
                              .origin = origin,
                              .index = number};
  if (Expected<void> done = record_messages(inputs, record, bag, ctx); !done) {
    return std::unexpected(done.error());
  }
  if (Expected<void> done = bag.close(); !done) return std::unexpected(done.error());
  return record;
}

std::string sensors_yaml(const VehicleSetup& vehicle, const SimulationOptions& options) {
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = vehicle.imu_from_lidar.matrix();
  const std::span<const double> values(matrix.data(), 16);
  const Eigen::Vector3d& a = vehicle.antenna_in_imu;
  return fmt::format(
      "lidar_topic: {}\nimu_topic: /imu/data\ngnss_topic: /gnss/fix\n"
      "imu_from_lidar: [{:.12g}]\ngnss_antenna_in_imu: [{:.6g}, {:.6g}, {:.6g}]\n"
      "gyro_noise_density: {}\naccel_noise_density: {}\n"
      "gyro_bias_walk: {}\naccel_bias_walk: {}\n",
      lidar_topic(options.lidar),
      fmt::join(values, ", "),
      a.x(),
      a.y(),
      a.z(),
      options.imu.gyro_noise_density,
      options.imu.accel_noise_density,
      options.imu.gyro_bias_walk,
      options.imu.accel_bias_walk);
}

}  // namespace hybridfusion
