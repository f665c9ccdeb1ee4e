#include "recording_topics.hpp"
#include "ros_message.hpp"

#include <hybridfusion/io/point_cloud2.hpp>
#include <hybridfusion/io/rosbag1.hpp>
#include <hybridfusion/io/scan_source.hpp>

#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Messages of the chosen topics of a ROS 1 bag, decoded.
class BagScanSource final : public ScanSource {
 public:
  BagScanSource(Rosbag1Reader reader, RecordingSummary summary, const RecordingOptions& options)
      : reader_(std::move(reader)),
        summary_(std::move(summary)),
        decoder_({.field = options.point_time_field, .unit = options.point_time_unit}) {}

  Expected<std::optional<SensorMessage>> next() override;
  RecordingSummary summary() const override;

 private:
  enum class Kind : std::uint8_t { kPointCloud2, kLivox, kImu, kGnss, kOther };

  [[nodiscard]] Kind kind_of(const BagConnection& connection) const;
  [[nodiscard]] const BagConnection* connection_of(const BagMessage& message) const;
  /// Nothing for a message that says nothing, such as a GNSS message without a fix.
  [[nodiscard]] Expected<std::optional<SensorMessage>> decode(Kind kind, const BagMessage& message);
  [[nodiscard]] Timestamp stamp_or_recorded(Timestamp stamp, Timestamp recorded);
  void count(const SensorMessage& message);
  void note_damage(const std::string& topic, const Error& error);

  Rosbag1Reader reader_;
  RecordingSummary summary_;
  ScanDecoder decoder_;
  bool told_missing_stamps_ = false;
};

BagScanSource::Kind BagScanSource::kind_of(const BagConnection& connection) const {
  if (connection.topic == summary_.lidar_topic) {
    if (is_point_cloud2(connection.type)) return Kind::kPointCloud2;
    return is_livox(connection.type) ? Kind::kLivox : Kind::kOther;
  }
  if (connection.topic == summary_.imu_topic && is_imu(connection.type)) return Kind::kImu;
  if (connection.topic == summary_.gnss_topic && is_gnss(connection.type)) return Kind::kGnss;
  return Kind::kOther;
}

const BagConnection* BagScanSource::connection_of(const BagMessage& message) const {
  for (const BagConnection& connection : reader_.connections()) {
    if (connection.id == message.connection) return &connection;
  }
  return nullptr;
}

Timestamp BagScanSource::stamp_or_recorded(Timestamp stamp, Timestamp recorded) {
  if (stamp != Timestamp{}) return stamp;
  if (!std::exchange(told_missing_stamps_, true)) {
    summary_.warnings.emplace_back("messages without a stamp get the time of their recording");
  }
  return recorded;
}

Expected<std::optional<SensorMessage>> BagScanSource::decode(Kind kind, const BagMessage& message) {
  if (kind == Kind::kImu) {
    HF_TRY(ImuSample sample, decode_imu(message.data));
    sample.time = stamp_or_recorded(sample.time, message.time);
    return sample;
  }
  if (kind == Kind::kGnss) {
    HF_TRY(std::optional<GnssFix> fix, decode_nav_sat_fix(message.data));
    if (!fix) return std::nullopt;
    fix->time = stamp_or_recorded(fix->time, message.time);
    return *fix;
  }
  HF_TRY(LidarScan scan,
         kind == Kind::kLivox ? decoder_.decode_livox(message.data)
                              : decoder_.decode_point_cloud2(message.data));
  scan.stamp = stamp_or_recorded(scan.stamp, message.time);
  return scan;
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

Expected<std::optional<SensorMessage>> BagScanSource::next() {
  for (;;) {
    HF_TRY(const std::optional<BagMessage> message, reader_.next());
    if (!message) return std::nullopt;
    const BagConnection* const connection = connection_of(*message);
    if (connection == nullptr) continue;
    const Kind kind = kind_of(*connection);
    if (kind == Kind::kOther) continue;
    auto decoded = decode(kind, *message);
    if (!decoded && decoded.error().code == ErrorCode::kNotFound) {
      return std::unexpected(std::move(decoded.error()).with_context(connection->topic));
    }
    if (!decoded) {
      note_damage(connection->topic, decoded.error());
      continue;
    }
    if (!*decoded) continue;
    for (std::string& warning : decoder_.take_warnings()) {
      summary_.warnings.push_back(fmt::format("{}: {}", connection->topic, warning));
    }
    count(**decoded);
    return decoded;
  }
}

RecordingSummary BagScanSource::summary() const {
  RecordingSummary summary = summary_;
  summary.point_time = decoder_.point_time();
  summary.truncated = reader_.truncated();
  summary.warnings.insert(
      summary.warnings.end(), reader_.warnings().begin(), reader_.warnings().end());
  return summary;
}

[[nodiscard]] RecordingSummary summarize(const Rosbag1Reader& reader) {
  RecordingSummary summary = {.format = "ROS 1 bag 2.0"};
  summary.topics = recording_topics(reader.connections());
  return summary;
}

}  // namespace

Expected<std::unique_ptr<ScanSource>> open_recording(const std::filesystem::path& path,
                                                     const RecordingOptions& options) {
  if (auto valid = validate(options, "recording"); !valid) return std::unexpected(valid.error());
  HF_TRY(Rosbag1Reader reader, Rosbag1Reader::open(path));
  RecordingSummary summary = summarize(reader);
  if (auto chosen = choose_topics(path, options, Require::kLidarAndImu, summary); !chosen) {
    return std::unexpected(chosen.error());
  }
  reader.select_topics({summary.lidar_topic, summary.imu_topic, summary.gnss_topic});
  return std::make_unique<BagScanSource>(std::move(reader), std::move(summary), options);
}

Expected<RecordingSummary> inspect_recording(const std::filesystem::path& path) {
  HF_TRY(const Rosbag1Reader reader, Rosbag1Reader::open(path));
  RecordingSummary summary = summarize(reader);
  if (auto chosen = choose_topics(path, {}, Require::kNothing, summary); !chosen) {
    return std::unexpected(chosen.error());
  }
  summary.truncated = reader.truncated();
  summary.warnings.insert(
      summary.warnings.end(), reader.warnings().begin(), reader.warnings().end());
  return summary;
}

}  // namespace hybridfusion
