#include "scan_filter.hpp"

#include "deskew.hpp"
#include "iterated_update.hpp"
#include "scan_matching.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

// A plane takes five map points, a pose many planes: below this the map only grows.
constexpr std::size_t kMinMapPoints = 50;
// How far a given extrinsic may be off where it is to be refined.
constexpr double kExtrinsicSigma_m = 0.1;
constexpr double kExtrinsicSigma_rad = 0.1;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}

// How vehicles and people move: white acceleration and angular acceleration.
constexpr ImuNoise kMotionNoise = {.gyro_noise_density = 1e-3,
                                   .accel_noise_density = 2.0,
                                   .gyro_bias_walk = 1.0,
                                   .accel_bias_walk = 1e-6};
constexpr double kMaxCoastingStep_s = 0.02;

/// The first scan makes the map with the extrinsic as given. When that is off by [t; e], the LiDAR
/// still lies where the map has it; pose of the IMU and gravity are what is off with it:
/// R <- R Exp(-R_IL e), g <- Exp(-R R_IL e) g, p <- p - R t - R [t_IL]x R_IL e.
void loosen_extrinsic(StateEstimate& estimate) {
  const NavState& state = estimate.state;
  const Eigen::Matrix3d in_map = state.map_from_imu * state.imu_from_lidar;
  Eigen::Matrix<double, err::kSize, 6> by_extrinsic = Eigen::Matrix<double, err::kSize, 6>::Zero();
  by_extrinsic.block<3, 3>(err::kExtrinsicPosition, 0).setIdentity();
  by_extrinsic.block<3, 3>(err::kExtrinsicRotation, 3).setIdentity();
  by_extrinsic.block<3, 3>(err::kPosition, 0) = -state.map_from_imu;
  by_extrinsic.block<3, 3>(err::kPosition, 3) =
      -state.map_from_imu * skew(state.lidar_in_imu) * state.imu_from_lidar;
  by_extrinsic.block<3, 3>(err::kRotation, 3) = -state.imu_from_lidar;
  by_extrinsic.block<2, 3>(err::kGravity, 3) =
      s2_minus_jacobian(state.gravity_in_map) * skew(state.gravity_in_map) * in_map;
  by_extrinsic.leftCols<3>() *= kExtrinsicSigma_m;
  by_extrinsic.rightCols<3>() *= kExtrinsicSigma_rad;
  estimate.covariance += by_extrinsic * by_extrinsic.transpose();
}

std::vector<LidarPoint> pick(const std::vector<LidarPoint>& points,
                             const std::vector<std::size_t>& indices) {
  std::vector<LidarPoint> out;
  out.reserve(indices.size());
  for (const std::size_t i : indices) out.push_back(points[i]);
  return out;
}

std::vector<Eigen::Vector3f> positions(const std::vector<LidarPoint>& points) {
  std::vector<Eigen::Vector3f> out;
  out.reserve(points.size());
  for (const LidarPoint& point : points) out.push_back(point.point_in_lidar);
  return out;
}

}  // namespace

ScanFilter::ScanFilter(const OdometryOptions& options,
                       const LidarRig& rig,
                       const StateEstimate& initial,
                       Timestamp time,
                       MotionModel model)
    : options_(options),
      model_(model),
      noise_(model == MotionModel::kInertial ? rig.imu_noise : kMotionNoise),
      estimate_(initial),
      time_(time),
      map_(options.local_map) {
  if (options.filter.estimate_extrinsic) loosen_extrinsic(estimate_);
}

void ScanFilter::leave_imu() {
  if (model_ == MotionModel::kConstantVelocity) return;
  constexpr double kSpeedSigma_mps = 2.0;
  constexpr double kTurnSigma_radps = 0.3;
  model_ = MotionModel::kConstantVelocity;
  noise_ = kMotionNoise;
  estimate_.state.gyro_bias = -rate_radps_;
  const auto restart = [&](int at, double sigma) {
    estimate_.covariance.middleRows<3>(at).setZero();
    estimate_.covariance.middleCols<3>(at).setZero();
    estimate_.covariance.diagonal().segment<3>(at).setConstant(sigma * sigma);
  };
  restart(err::kVelocity, kSpeedSigma_mps);
  restart(err::kGyroBias, kTurnSigma_radps);
  restart(err::kAccelBias, 0.0);
}

ImuStep ScanFilter::bridged(ImuStep step) const {
  // Without an IMU, or with one that stands at its limit, the motion of the last scan goes on:
  // constant velocity and turn rate.
  if (step.held || step.saturated) {
    step.bridged = true;
    const NavState& state = estimate_.state;
    step.angular_velocity_radps = rate_radps_ + state.gyro_bias;
    step.specific_force_mps2 =
        state.accel_bias - state.map_from_imu.transpose() * state.gravity_in_map;
  }
  return step;
}

std::vector<ImuStep> ScanFilter::steps(const ImuBuffer& imu, Timestamp begin, Timestamp end) const {
  if (model_ == MotionModel::kInertial) return imu.steps(begin, end);
  const double duration_s = to_seconds(end - begin);
  const auto count =
      static_cast<std::size_t>(std::ceil(std::max(0.0, duration_s) / kMaxCoastingStep_s));
  return std::vector<ImuStep>(
      count, {.coasting = true, .dt_s = duration_s / static_cast<double>(count), .bridged = true});
}

ImuNoise ScanFilter::noise(const ImuBuffer& imu) const {
  ImuNoise noise = noise_;
  if (model_ == MotionModel::kInertial) {
    noise.gyro_noise_density = std::max(noise.gyro_noise_density, imu.gyro_roughness());
    noise.accel_noise_density = std::max(noise.accel_noise_density, imu.accel_roughness());
  }
  return noise;
}

void ScanFilter::predict(const ImuBuffer& imu, ScanEstimate& scan) {
  const ImuNoise noise = this->noise(imu);
  for (const ImuStep& sample : steps(imu, time_, scan.time)) {
    const ImuStep step = bridged(sample);
    integrate(step, estimate_.state.gyro_bias, scan.since_last);
    propagate(step, noise, estimate_);
    if (sample.bridged && !sample.coasting) scan.quality.flags |= bit(ScanFlag::kImuGap);
    if (sample.saturated) scan.quality.flags |= bit(ScanFlag::kSaturated);
  }
  time_ = scan.time;
}

ScanEstimate ScanFilter::process(const PreparedScan& scan, const ImuBuffer& imu) {
  ScanEstimate out{.start = scan.stamp, .time = scan.end};
  out.quality = {
      .time = scan.end, .num_points = static_cast<int>(scan.points.size()), .flags = scan.flags};
  const Eigen::Matrix3d map_from_last = estimate_.state.map_from_imu;
  predict(imu, out);
  std::vector<ImuStep> path = steps(imu, scan.begin, scan.end);
  for (ImuStep& step : path) step = bridged(step);
  const std::int64_t end_ns = (scan.end - scan.stamp).count();
  const auto deskew_to = [&](const NavState& end,
                             const std::vector<LidarPoint>& points,
                             std::vector<LidarPoint>& moved) {
    deskew(points, path_before(end, path), end, end_ns, moved);
  };
  deskew_to(estimate_.state, scan.points, out.deskewed);
  bool usable = true;
  if (map_.size() >= kMinMapPoints) {
    const std::vector<std::size_t> chosen = thin(out.deskewed, options_.filter.scan_voxel_m);
    const std::vector<LidarPoint> measured = pick(scan.points, chosen);
    std::vector<LidarPoint> moved = pick(out.deskewed, chosen);
    ScanMatcher matcher(map_, options_.filter);
    matcher.set_points(positions(moved));
    const auto repeat_deskew = [&](const NavState& end, ScanMatcher& points) {
      deskew_to(end, measured, moved);
      points.update_points(positions(moved));
    };
    const UpdateReport report = iterated_update(options_.filter, repeat_deskew, matcher, estimate_);
    out.quality.num_thinned = static_cast<int>(chosen.size());
    out.quality.num_matched = report.num_matched;
    out.quality.mean_residual_m = report.mean_residual_m;
    out.quality.min_information = report.min_information;
    out.quality.turn_innovation = report.turn_innovation;
    out.quality.shift_innovation = report.shift_innovation;
    out.quality.flags |= report.flags;
    usable = (report.flags & (bit(ScanFlag::kUnmatched) | bit(ScanFlag::kDiverged))) == 0;
    deskew_to(estimate_.state, scan.points, out.deskewed);
  }
  if (usable) extend_map(out.deskewed);
  if (out.since_last.duration_s > 0.0) {
    rate_radps_ = so3_log(map_from_last.transpose() * estimate_.state.map_from_imu) /
                  out.since_last.duration_s;
  }

  const NavState& state = estimate_.state;
  out.map_from_imu = state.pose();
  out.velocity_in_map = state.velocity_in_map;
  out.gyro_bias_radps = state.gyro_bias;
  out.accel_bias_mps2 = state.accel_bias;
  out.gravity_in_map = state.gravity_in_map;
  if (model_ == MotionModel::kInertial) {
    out.gravity_sigma_rad =
        std::sqrt(estimate_.covariance.block<2, 2>(err::kGravity, err::kGravity).trace());
  }
  out.imu_from_lidar = {.rotation = Eigen::Quaterniond(state.imu_from_lidar),
                        .translation = state.lidar_in_imu};
  out.covariance = estimate_.covariance.topLeftCorner<6, 6>();
  return out;
}

void ScanFilter::extend_map(const std::vector<LidarPoint>& deskewed) {
  const Eigen::Matrix3f rotation = estimate_.state.map_from_imu.cast<float>();
  const Eigen::Vector3f position = estimate_.state.position_in_map.cast<float>();
  std::vector<Eigen::Vector3f> in_map;
  in_map.reserve(deskewed.size());
  for (const LidarPoint& point : deskewed) {
    in_map.push_back(rotation * point.point_in_lidar + position);
  }
  map_.insert(in_map);
  // HybridFusion III-B.2: when the sensing range touches the border of the cube, the cube follows.
  const double half_side_m = 0.5 * options_.local_map.cube_side_m;
  const Eigen::Vector3d offset = estimate_.state.position_in_map - cube_center_;
  if (offset.cwiseAbs().maxCoeff() > half_side_m - options_.max_range_m) {
    cube_center_ = estimate_.state.position_in_map;
    map_.erase_outside(cube_center_.cast<float>(), static_cast<float>(half_side_m));
  }
}

}  // namespace hybridfusion
