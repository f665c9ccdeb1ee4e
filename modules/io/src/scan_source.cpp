#include "recording_reader.hpp"
#include "recording_topics.hpp"
#include "ros_message.hpp"
#include "scan_folder.hpp"
#include "zstd_stream.hpp"

#include <hybridfusion/io/point_cloud2.hpp>
#include <hybridfusion/io/scan_source.hpp>

#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] const std::vector<BagConnection>& connections_of(const RecordingReader& reader) {
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

[[nodiscard]] RecordingSummary summarize(const RecordingReader& reader) {
  RecordingSummary summary;
  summary.format = std::visit([](const auto& bag) { return bag.format(); }, reader);
  summary.topics = recording_topics(connections_of(reader));
  return summary;
}

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

/// Messages of the chosen topics of a bag, decoded.
class BagScanSource final : public ScanSource {
 public:
  BagScanSource(RecordingReader reader, RecordingSummary summary, const RecordingOptions& options)
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
  [[nodiscard]] Expected<std::optional<SensorMessage>> decode(Kind kind,
                                                              RosWire wire,
                                                              const BagMessage& message);
  [[nodiscard]] Timestamp stamp_or_recorded(Timestamp stamp, Timestamp recorded);
  void count(const SensorMessage& message);
  void note_damage(const std::string& topic, const Error& error);

  RecordingReader reader_;
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
  for (const BagConnection& connection : connections_of(reader_)) {
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

Expected<std::optional<SensorMessage>> BagScanSource::decode(Kind kind,
                                                             RosWire wire,
                                                             const BagMessage& message) {
  if (kind == Kind::kImu) {
    HF_TRY(ImuSample sample, decode_imu(message.data, wire));
    sample.time = stamp_or_recorded(sample.time, message.time);
    return sample;
  }
  if (kind == Kind::kGnss) {
    HF_TRY(std::optional<GnssFix> fix, decode_nav_sat_fix(message.data, wire));
    if (!fix) return std::nullopt;
    fix->time = stamp_or_recorded(fix->time, message.time);
    return *fix;
  }
  HF_TRY(LidarScan scan,
         kind == Kind::kLivox ? decoder_.decode_livox(message.data, wire)
                              : decoder_.decode_point_cloud2(message.data, wire));
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
    HF_TRY(std::optional<BagMessage> message,
           std::visit([](auto& reader) { return reader.next(); }, reader_));
    if (!message) return std::nullopt;
    const BagConnection* const connection = connection_of(*message);
    if (connection == nullptr) continue;
    const Kind kind = kind_of(*connection);
    if (kind == Kind::kOther) continue;
    // CDR never begins with the mark of zstd: its first byte is 0.
    if (connection->wire == RosWire::kCdr && is_zstd(message->data)) unpack(*message);
    auto decoded = decode(kind, connection->wire, *message);
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
  add_reading_notes(reader_, summary);
  return summary;
}

[[nodiscard]] RecordingSetup setup_for(const std::filesystem::path& path,
                                       const RecordingOptions& options,
                                       const RunContext& ctx) {
  RecordingSetup setup = {.scratch_folder = options.scratch_folder, .context = ctx};
  if (setup.scratch_folder.empty()) {
    setup.scratch_folder = std::filesystem::absolute(path).parent_path();
  }
  return setup;
}

}  // namespace

Expected<std::unique_ptr<ScanSource>> open_recording(const std::filesystem::path& path,
                                                     const RecordingOptions& options,
                                                     const RunContext& ctx) {
  if (auto valid = validate(options, "recording"); !valid) return std::unexpected(valid.error());
  HF_TRY(const Container container, container_of(path));
  if (container == Container::kScanFolder) return open_scan_folder(path, options);
  HF_TRY(RecordingReader reader,
         open_recording_reader(path, container, setup_for(path, options, ctx)));
  RecordingSummary summary = summarize(reader);
  if (auto chosen = choose_topics(path, options, Require::kLidarAndImu, summary); !chosen) {
    return std::unexpected(chosen.error());
  }
  const std::vector<std::string> topics = {
      summary.lidar_topic, summary.imu_topic, summary.gnss_topic};
  std::visit([&topics](auto& bag) { bag.select_topics(topics); }, reader);
  return std::make_unique<BagScanSource>(std::move(reader), std::move(summary), options);
}

Expected<std::vector<std::filesystem::path>> recording_files(const std::filesystem::path& path) {
  HF_TRY(const Container container, container_of(path));
  if (container == Container::kScanFolder) return scan_folder_files(path);
  if (container == Container::kRos2Folder) return ros2_bag_files(path);
  return std::vector<std::filesystem::path>{path};
}

Expected<RecordingSummary> inspect_recording(const std::filesystem::path& path,
                                             const RecordingOptions& options,
                                             const RunContext& ctx) {
  HF_TRY(const Container container, container_of(path));
  if (container == Container::kScanFolder) return inspect_scan_folder(path);
  HF_TRY(const RecordingReader reader,
         open_recording_reader(path, container, setup_for(path, options, ctx)));
  RecordingSummary summary = summarize(reader);
  if (auto chosen = choose_topics(path, options, Require::kNothing, summary); !chosen) {
    return std::unexpected(chosen.error());
  }
  add_reading_notes(reader, summary);
  return summary;
}

}  // namespace hybridfusion
