#include "recorder.hpp"

#include "gnss_model.hpp"
#include "imu_model.hpp"
#include "jpeg_photo.hpp"
#include "render.hpp"
#include "ros_messages.hpp"
#include "sensor_faults.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hybridfusion {
namespace {

constexpr std::size_t kScansAtOnce = 32;
constexpr std::uint64_t kSecondImu = 1'000'000;  // noise of its own

/// The topics of one recording.
class Recorder {
 public:
  Recorder(const RecorderInputs& inputs, DriveRecord& record, BagWriter& bag, const RunContext& ctx)
      : in_(inputs),
        options_(inputs.options),
        record_(record),
        bag_(bag),
        ctx_(ctx),
        imu_(options_.imu, ctx.seed, inputs.index),
        second_imu_(options_.imu, ctx.seed, inputs.index + kSecondImu),
        gnss_(options_.gnss, ctx.seed, "gnss/vehicle", inputs.index) {
    imu_id_ = bag.add_connection("/imu/data", kImuMessage);
    gnss_id_ = bag.add_connection("/gnss/fix", kNavSatFixMessage);
    const std::string& kind = options_.lidar.message;
    const bool avia = options_.lidar.model == "avia";
    if (kind == "livox" || kind == "both" || (kind == "auto" && avia)) {
      livox_id_ = bag.add_connection("/livox/lidar", kLivoxMessage);
    }
    if (kind != "livox") {
      cloud_id_ =
          bag.add_connection(avia ? "/livox/points" : "/velodyne_points", kPointCloud2Message);
    }
    if (options_.drive.camera_hz > 0.0) {
      image_id_ = bag.add_connection("/camera/image/compressed", kCompressedImageMessage);
    }
  }

  /// Merges the sensors in the order of recording: a scan is recorded when it ends.
  [[nodiscard]] Expected<void> run() {
    const double period = 1.0 / options_.lidar.rate_hz;
    const double end = record_.motion.duration_s();
    const auto scans =
        static_cast<std::size_t>(std::max(0.0, (end - kFirstScan_s - period) / period));
    for (std::size_t first = 0; first < scans; first += kScansAtOnce) {
      const std::size_t count = std::min(kScansAtOnce, scans - first);
      const auto batch = scan_batch(first, count);
      if (ctx_.stopped()) return fail(ErrorCode::kCancelled, "stopped during the street drive");
      for (std::size_t k = 0; k < count; ++k) {
        const double begin_s = kFirstScan_s + static_cast<double>(first + k) * period;
        if (Expected<void> done = record_until(begin_s + period); !done) return done;
        if (Expected<void> done = record_scan(first + k, begin_s, period, batch[k]); !done) {
          return done;
        }
      }
      ctx_.report({.stage = "simulate/scans",
                   .done = static_cast<std::int64_t>(first + count),
                   .total = static_cast<std::int64_t>(scans)});
    }
    return record_until(end);
  }

 private:
  [[nodiscard]] Timestamp stamp(double time_s) const {
    return from_seconds(record_.start_s) + from_seconds(time_s);
  }

  [[nodiscard]] std::vector<std::vector<LidarReturn>> scan_batch(std::size_t first,
                                                                 std::size_t count) const {
    const LidarSetup setup{.options = options_.lidar,
                           .body_from_lidar = in_.vehicle.body_from_lidar(),
                           .seed = ctx_.seed,
                           .drive = in_.index};
    std::vector<std::vector<LidarReturn>> batch(count);
    parallel_for(ctx_, count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end && !ctx_.stopped(); ++k) {
        batch[k] =
            scan_scene(in_.world.scene,
                       in_.tracer,
                       record_.motion,
                       setup,
                       first + k,
                       kFirstScan_s + static_cast<double>(first + k) / options_.lidar.rate_hz);
      }
    });
    return batch;
  }

  /// Everything but scans that is due up to `to_s`.
  [[nodiscard]] Expected<void> record_until(double to_s) {
    while (true) {
      const double imu_s = static_cast<double>(record_.imu_samples) / options_.imu.rate_hz;
      const double gnss_s = static_cast<double>(record_.gnss_fixes) / options_.gnss.rate_hz;
      const double image_s =
          image_id_ ? static_cast<double>(record_.images) / options_.drive.camera_hz : 1e18;
      // Half a period after the first one.
      const double second_s =
          options_.faults.second_imu
              ? (static_cast<double>(second_samples_) + 0.5) / options_.imu.rate_hz
              : 1e18;
      const double next = std::min({imu_s, second_s, gnss_s, image_s});
      if (next > to_s) return {};
      Expected<void> written = next == imu_s      ? record_imu(imu_s)
                               : next == second_s ? record_second_imu(second_s)
                               : next == gnss_s   ? record_gnss(gnss_s)
                                                  : record_image(image_s);
      if (!written) return written;
    }
  }

  [[nodiscard]] Expected<void> record_imu(double time_s) {
    const MotionState state = in_.vehicle.imu_motion(record_.motion.at(time_s));
    const ImuSample sample =
        with_faults(imu_.measure(state, stamp(time_s)), state, options_.faults);
    const auto sequence = static_cast<std::uint32_t>(record_.imu_samples++);
    return write_imu(time_s, sample, sequence, "imu");
  }

  [[nodiscard]] Expected<void> record_second_imu(double time_s) {
    const MotionState state = in_.vehicle.imu_motion(record_.motion.at(time_s));
    const ImuSample sample = turned_about_z(second_imu_.measure(state, stamp(time_s)));
    return write_imu(time_s, sample, static_cast<std::uint32_t>(second_samples_++), "imu_rear");
  }

  [[nodiscard]] Expected<void> write_imu(double time_s,
                                         const ImuSample& sample,
                                         std::uint32_t sequence,
                                         const std::string& frame) {
    const double rate = options_.imu.rate_hz;
    return bag_.write(imu_id_,
                      stamp(time_s),
                      imu_message({.sequence = sequence, .stamp = sample.time, .frame = frame},
                                  sample,
                                  std::pow(options_.imu.gyro_noise_density, 2) * rate,
                                  std::pow(options_.imu.accel_noise_density, 2) * rate));
  }

  [[nodiscard]] Expected<void> record_gnss(double time_s) {
    const MotionState state = in_.vehicle.imu_motion(record_.motion.at(time_s));
    const Eigen::Vector3d antenna = state.world_from_body * in_.vehicle.antenna_in_imu;
    if (record_.gnss_fixes == 0) first_antenna_ = antenna;
    const Eigen::Vector3d stretched =
        antenna + (options_.faults.gnss_stretch - 1.0) * (antenna - first_antenna_);
    const GeodeticPosition fix = geodetic_from_enu(in_.origin, stretched + gnss_.at(time_s));
    const auto sequence = static_cast<std::uint32_t>(record_.gnss_fixes++);
    // Receivers report what they believe: the nominal sigma.
    return bag_.write(
        gnss_id_,
        stamp(time_s),
        nav_sat_fix_message({.sequence = sequence, .stamp = stamp(time_s), .frame = "gnss_antenna"},
                            fix,
                            gnss_.sigma_m(),
                            options_.gnss.rtk));
  }

  [[nodiscard]] Expected<void> record_image(double time_s) {
    const PinholeCamera camera(640, 480, 460.0, {319.5, 239.5}, 0.0, 0.0);
    Eigen::Matrix3d body_from_camera;
    body_from_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    const Rigid3 world_from_camera =
        record_.motion.at(time_s).world_from_body *
        Rigid3{.rotation = Eigen::Quaterniond(body_from_camera), .translation = {0.4, 0.0, 0.35}};
    const RenderSettings settings{.seed = ctx_.seed + 1,
                                  .index = (in_.index << 20U) + record_.images};
    HF_TRY(const Image8 image,
           render_photo(in_.world.scene, in_.tracer, camera, world_from_camera, settings, ctx_));
    HF_TRY(const std::string jpeg, encode_jpeg(image, 85, {}));
    const auto sequence = static_cast<std::uint32_t>(record_.images++);
    return bag_.write(*image_id_,
                      stamp(time_s),
                      compressed_image_message(
                          {.sequence = sequence, .stamp = stamp(time_s), .frame = "camera"}, jpeg));
  }

  [[nodiscard]] Expected<void> record_scan(std::size_t scan,
                                           double begin_s,
                                           double period_s,
                                           const std::vector<LidarReturn>& points) {
    const RosHeader header{
        .sequence = static_cast<std::uint32_t>(scan), .stamp = stamp(begin_s), .frame = "lidar"};
    ++record_.scans;
    record_.points += points.size();
    const bool avia = options_.lidar.model == "avia";
    if (livox_id_) {
      Expected<void> written =
          bag_.write(*livox_id_, stamp(begin_s + period_s), livox_message(header, points));
      if (!written) return written;
    }
    if (!cloud_id_) return {};
    return bag_.write(
        *cloud_id_, stamp(begin_s + period_s), point_cloud2_message(header, points, avia));
  }

  const RecorderInputs& in_;
  const SimulationOptions& options_;
  DriveRecord& record_;
  BagWriter& bag_;
  const RunContext& ctx_;
  ImuModel imu_;
  ImuModel second_imu_;
  std::size_t second_samples_ = 0;
  Eigen::Vector3d first_antenna_ = Eigen::Vector3d::Zero();
  GnssError gnss_;
  std::uint32_t imu_id_ = 0;
  std::uint32_t gnss_id_ = 0;
  std::optional<std::uint32_t> cloud_id_ = {};
  std::optional<std::uint32_t> livox_id_ = {};
  std::optional<std::uint32_t> image_id_ = {};
};

}  // namespace

Expected<void> record_messages(const RecorderInputs& inputs,
                               DriveRecord& record,
                               BagWriter& bag,
                               const RunContext& ctx) {
  return Recorder(inputs, record, bag, ctx).run();
}

}  // namespace hybridfusion
