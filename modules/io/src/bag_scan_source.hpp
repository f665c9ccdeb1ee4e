#pragma once

#include "frame_watch.hpp"
#include "imu_watch.hpp"
#include "recording_reader.hpp"
#include "stamp_gate.hpp"

#include <hybridfusion/io/point_cloud2.hpp>
#include <hybridfusion/io/scan_source.hpp>

namespace hybridfusion {

[[nodiscard]] const std::vector<BagConnection>& connections_of(const RecordingReader& reader);

/// What the reader met on its way so far: truncation and warnings.
void add_reading_notes(const RecordingReader& reader, RecordingSummary& summary);

/// Messages of the chosen topics of a bag, decoded.
class BagScanSource final : public ScanSource {
 public:
  /// @param summary  Format and topics, as chosen.
  BagScanSource(RecordingReader reader, RecordingSummary summary, const RecordingOptions& options);

  Expected<std::optional<SensorMessage>> next() override;
  RecordingSummary summary() const override;

 private:
  enum class Kind : std::uint8_t { kPointCloud2, kCompressed, kLivox, kImu, kGnss, kOther };
  struct Recorded {
    Kind kind = Kind::kOther;
    const BagConnection* connection = nullptr;
    BagMessage message = {};
  };

  [[nodiscard]] Kind kind_of(const BagConnection& connection) const;
  [[nodiscard]] const BagConnection* connection_of(const BagMessage& message) const;
  /// The next message of a chosen topic, of whatever frame; nothing at the end.
  [[nodiscard]] Expected<std::optional<Recorded>> read();
  [[nodiscard]] bool admit(const Recorded& recorded);
  /// Reads on for a while, so that the refusal can tell how many messages each frame has.
  [[nodiscard]] std::unexpected<Error> refuse_frames(const FrameWatch& watch,
                                                     const std::string& topic);
  /// Nothing for a message that says nothing, such as a GNSS message without a fix.
  [[nodiscard]] Expected<std::optional<SensorMessage>> decode(const Recorded& recorded);
  /// Decodes a message into the gate of its sensor.
  [[nodiscard]] Expected<void> take_in(const Recorded& recorded);
  [[nodiscard]] StampGate& gate_of(const SensorMessage& message);
  [[nodiscard]] std::optional<SensorMessage> take_ready();
  [[nodiscard]] Expected<void> end();
  void count(const SensorMessage& message);
  void note_damage(const std::string& topic, const Error& error);

  RecordingReader reader_;
  RecordingSummary summary_;
  ScanDecoder decoder_;
  ImuWatch imu_watch_ = {};
  FrameWatch lidar_frames_;
  FrameWatch imu_frames_;
  std::vector<ClockStep> clock_steps_ = {};
  StampGate imu_gate_;
  StampGate lidar_gate_;
  StampGate gnss_gate_;
  bool ended_ = false;
};

}  // namespace hybridfusion
