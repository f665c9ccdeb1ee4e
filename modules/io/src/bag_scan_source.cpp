#include "bag_scan_source.hpp"

#include "recording_topics.hpp"
#include "ros_message.hpp"
#include "zstd_stream.hpp"

#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Undoes the compression of single messages by ROS 2 recorders. What cannot be unpacked is left
/// for the decoder of the message to count as damaged.
void unpack(BagMessage& message) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 29;
  ZstdStream stream;
  std::vector<std::byte> bytes;
  std::span<const std::byte> packed = message.data;
  while ((!packed.empty() || stream.has_more()) && bytes.size() <= kMaxBytes) {
    const auto piece = stream.unpack(packed);
    if (!stream.problem().empty()) break;
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  }
  message.storage = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
  message.data = *message.storage;
}

/// frame_id, with the number of the unit where a Livox driver gives all units the same frame;
/// nothing for a message that ends early.
[[nodiscard]] std::optional<std::string> frame_of(std::span<const std::byte> message,
                                                  RosWire wire,
                                                  bool livox) {
  RosReader reader(message, wire);
  std::string frame(read_ros_header(reader).frame);
  if (livox) {
    reader.skip<std::uint64_t>();  // time base
    reader.skip<std::uint32_t>();  // number of points
    frame += fmt::format("#{}", reader.read<std::uint8_t>());
  }
  return reader.failed() ? std::nullopt : std::optional(std::move(frame));
}

// A run of stamps of this length is no delay of a driver. The IMU, which samples finer and knows a
// step of the clock better, is the first to tell.
constexpr std::chrono::milliseconds kConfirm{1000};
constexpr std::chrono::milliseconds kConfirmLater{1500};

}  // namespace

const std::vector<BagConnection>& connections_of(const RecordingReader& reader) {
  return std::visit(
      [](const auto& bag) -> const std::vector<BagConnection>& { return bag.connections(); },
      reader);
}

void add_reading_notes(const RecordingReader& reader, RecordingSummary& summary) {
  std::visit(
      [&summary](const auto& bag) {
        summary.truncated = bag.truncated();
        const std::vector<std::string> warnings = bag.warnings();
        summary.warnings.insert(summary.warnings.end(), warnings.begin(), warnings.end());
      },
      reader);
}

BagScanSource::BagScanSource(RecordingReader reader,
                             RecordingSummary summary,
                             const RecordingOptions& options)
    : reader_(std::move(reader)),
      summary_(std::move(summary)),
      decoder_({.field = options.point_time_field, .unit = options.point_time_unit}),
      lidar_frames_("LiDAR", "lidar_frame", options.lidar_frame),
      imu_frames_("IMU", "imu_frame", options.imu_frame),
      imu_gate_("IMU", kConfirm, clock_steps_),
      lidar_gate_("LiDAR", kConfirmLater, clock_steps_),
      gnss_gate_("GNSS", kConfirmLater, clock_steps_) {}

BagScanSource::Kind BagScanSource::kind_of(const BagConnection& connection) const {
  if (connection.topic == summary_.lidar_topic) {
    if (is_point_cloud2(connection.type)) return Kind::kPointCloud2;
    if (is_compressed_cloud(connection.type)) return Kind::kCompressed;
    return is_livox(connection.type) ? Kind::kLivox : Kind::kOther;
  }
  if (connection.topic == summary_.imu_topic && is_imu(connection.type)) return Kind::kImu;
  if (connection.topic == summary_.gnss_topic && is_gnss(connection.type)) return Kind::kGnss;
  return Kind::kOther;
}

const BagConnection* BagScanSource::connection_of(const BagMessage& message) const {
  for (const BagConnection& connection : connections_of(reader_)) {
    if (connection.id == message.connection) return &connection;
  }
  return nullptr;
}

Expected<std::optional<BagScanSource::Recorded>> BagScanSource::read() {
  for (;;) {
    HF_TRY(std::optional<BagMessage> message,
           std::visit([](auto& reader) { return reader.next(); }, reader_));
    if (!message) return std::nullopt;
    const BagConnection* const connection = connection_of(*message);
    if (connection == nullptr) continue;
    const Kind kind = kind_of(*connection);
    if (kind == Kind::kOther) continue;
    // CDR never begins with the mark of zstd: its first byte is 0.
    if (connection->wire == RosWire::kCdr && is_zstd(message->data)) unpack(*message);
    return Recorded{.kind = kind, .connection = connection, .message = *std::move(message)};
  }
}

bool BagScanSource::admit(const Recorded& recorded) {
  if (recorded.kind == Kind::kGnss) return true;
  const auto frame =
      frame_of(recorded.message.data, recorded.connection->wire, recorded.kind == Kind::kLivox);
  if (!frame) return true;  // to be counted as damaged
  FrameWatch& watch = recorded.kind == Kind::kImu ? imu_frames_ : lidar_frames_;
  return watch.admit(*frame, recorded.message.time);
}

std::unexpected<Error> BagScanSource::refuse_frames(const FrameWatch& watch,
                                                    const std::string& topic) {
  summary_.undecided_frames = true;
  // Enough to see every sensor, in seconds also of a long recording.
  constexpr int kMaxMessages = 20'000;
  constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 30;
  std::uint64_t bytes = 0;
  bool all = false;
  for (int i = 0; i < kMaxMessages && bytes < kMaxBytes; ++i) {
    const auto recorded = read();
    all = !recorded || !*recorded;
    if (all) break;
    bytes += (*recorded)->message.data.size();
    static_cast<void>(admit(**recorded));
  }
  return fail(ErrorCode::kNotFound,
              watch.describe(topic) + (all ? "" : " (counted in the first part only)"));
}

Expected<std::optional<SensorMessage>> BagScanSource::decode(const Recorded& recorded) {
  const BagMessage& message = recorded.message;
  const RosWire wire = recorded.connection->wire;
  if (recorded.kind == Kind::kImu) {
    HF_TRY(const DecodedImu imu, decode_imu(message.data, wire));
    const std::optional<ImuSample> sample = imu_watch_.complete(imu);
    if (!sample) return std::nullopt;
    return *sample;
  }
  if (recorded.kind == Kind::kGnss) {
    HF_TRY(const std::optional<GnssFix> fix, decode_nav_sat_fix(message.data, wire));
    if (!fix) return std::nullopt;
    return *fix;
  }
  if (recorded.kind == Kind::kLivox) return decoder_.decode_livox(message.data, wire);
  if (recorded.kind == Kind::kCompressed) return decoder_.decode_compressed(message.data, wire);
  return decoder_.decode_point_cloud2(message.data, wire);
}

void BagScanSource::count(const SensorMessage& message) {
  if (std::holds_alternative<LidarScan>(message)) ++summary_.num_scans;
  if (std::holds_alternative<ImuSample>(message)) ++summary_.num_imu_samples;
  if (std::holds_alternative<GnssFix>(message)) ++summary_.num_gnss_fixes;
}

void BagScanSource::note_damage(const std::string& topic, const Error& error) {
  if (summary_.num_damaged_messages++ == 0) {
    summary_.warnings.push_back(
        fmt::format("{}: {} (such messages are skipped and counted)", topic, error.message));
  }
}

StampGate& BagScanSource::gate_of(const SensorMessage& message) {
  if (std::holds_alternative<LidarScan>(message)) return lidar_gate_;
  return std::holds_alternative<ImuSample>(message) ? imu_gate_ : gnss_gate_;
}

std::optional<SensorMessage> BagScanSource::take_ready() {
  for (StampGate* const gate : {&imu_gate_, &lidar_gate_, &gnss_gate_}) {
    if (auto message = gate->take()) {
      count(*message);
      return message;
    }
  }
  return std::nullopt;
}

Expected<void> BagScanSource::take_in(const Recorded& recorded) {
  const std::string& topic = recorded.connection->topic;
  auto decoded = decode(recorded);
  if (!decoded && decoded.error().code == ErrorCode::kNotFound) {
    return std::unexpected(std::move(decoded.error()).with_context(topic));
  }
  if (!decoded) {
    note_damage(topic, decoded.error());
    return {};
  }
  if (!*decoded) return {};
  for (std::string& warning : decoder_.take_warnings()) {
    summary_.warnings.push_back(fmt::format("{}: {}", topic, warning));
  }
  StampGate& gate = gate_of(**decoded);
  gate.add(**std::move(decoded), recorded.message.time);
  for (std::string& warning : gate.take_warnings()) summary_.warnings.push_back(std::move(warning));
  return {};
}

Expected<void> BagScanSource::end() {
  ended_ = true;
  for (StampGate* const gate : {&imu_gate_, &lidar_gate_, &gnss_gate_}) gate->finish();
  if (lidar_frames_.missed()) {
    return fail(ErrorCode::kNotFound, lidar_frames_.describe(summary_.lidar_topic));
  }
  if (imu_frames_.missed()) {
    return fail(ErrorCode::kNotFound, imu_frames_.describe(summary_.imu_topic));
  }
  const ImuDialect imu = imu_watch_.dialect();
  if (summary_.num_imu_samples == 0 && imu.without_force > 0) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: none of the {} IMU samples has an acceleration (NaN, or 0 with a "
                            "covariance of -1); set imu_topic to one that has both",
                            summary_.imu_topic,
                            imu.without_force));
  }
  return {};
}

Expected<std::optional<SensorMessage>> BagScanSource::next() {
  for (;;) {
    if (auto ready = take_ready()) return ready;
    if (ended_) return std::nullopt;
    HF_TRY(const std::optional<Recorded> recorded, read());
    if (!recorded) {
      if (auto ended = end(); !ended) return std::unexpected(ended.error());
      continue;
    }
    if (!admit(*recorded)) continue;
    if (lidar_frames_.undecided()) return refuse_frames(lidar_frames_, summary_.lidar_topic);
    if (imu_frames_.undecided()) return refuse_frames(imu_frames_, summary_.imu_topic);
    if (auto taken = take_in(*recorded); !taken) return std::unexpected(taken.error());
  }
}

RecordingSummary BagScanSource::summary() const {
  RecordingSummary summary = summary_;
  summary.point_time = decoder_.point_time();
  for (const auto& [watch, topic] : {std::pair(&lidar_frames_, &summary_.lidar_topic),
                                     std::pair(&imu_frames_, &summary_.imu_topic)}) {
    if (watch->changed() && !watch->undecided()) {
      summary.warnings.push_back(watch->describe(*topic));
    }
  }
  summary.imu_stamps = imu_gate_.faults();
  summary.lidar_stamps = lidar_gate_.faults();
  summary.gnss_stamps = gnss_gate_.faults();
  summary.point_times_made_up = decoder_.made_up();
  summary.imu_dialect = imu_watch_.dialect();
  if (const ImuDialect& imu = summary.imu_dialect; imu.without_force + imu.without_rate > 0) {
    summary.warnings.push_back(
        fmt::format("{}: {} samples without acceleration and {} without angular velocity; rates "
                    "take the last acceleration along, others are left out",
                    summary_.imu_topic,
                    imu.without_force,
                    imu.without_rate));
  }
  add_stamp_warnings(summary);
  add_reading_notes(reader_, summary);
  return summary;
}

}  // namespace hybridfusion
