#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/core/sensor_data.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

struct RecordingTopic {
  std::string name = {};
  std::string type = {};                       ///< "sensor_msgs/Imu"
  std::optional<std::uint64_t> messages = {};  ///< Absent when the file has no index.
};

/// What was wrong with the stamps of one sensor. Messages are counted.
struct StampFaults {
  std::uint64_t missing = 0;      ///< Stamp 0: replaced by the time of recording.
  std::uint64_t repeated = 0;     ///< The stamp of the one before: left out.
  std::uint64_t late = 0;         ///< Older than the one before: left out.
  std::uint64_t ahead = 0;        ///< Far ahead of its time: put where its stamp belongs.
  std::uint64_t dropped = 0;      ///< Of those ahead: left out, as their time did not come.
  std::uint64_t clock_steps = 0;  ///< Times that the clock was set; later stamps are shifted.
};

/// What the IMU's messages show of its dialect; complete at the end.
struct ImuDialect {
  std::uint64_t without_force = 0;  ///< Samples that say they have no acceleration: left out.
  std::uint64_t without_rate = 0;   ///< Samples that say they have no angular velocity: left out.
  double force_median = 0.0;     ///< Of the norm, in the unit of the message; 0 before 20 samples.
  double force_low = 0.0;        ///< Its lowest twentieth.
  bool in_g = false;             ///< The norm is 1 where 9.81 is right.
  bool gravity_removed = false;  ///< The driver took gravity out: 0 at rest.
};

/// What a recording holds, and how reading it went so far.
struct RecordingSummary {
  std::string format = {};                  ///< "ROS 1 bag 2.0"
  std::vector<RecordingTopic> topics = {};  ///< Sorted by name.
  std::string lidar_topic = {};             ///< As chosen; empty when there is none.
  std::string imu_topic = {};               ///< Empty when there is none, or it is not asked for.
  std::string gnss_topic = {};
  std::string point_time = {};  ///< How point times were found; empty before a scan.
  std::uint64_t num_scans = 0;  ///< Delivered so far, as are the next two.
  std::uint64_t num_imu_samples = 0;
  std::uint64_t num_gnss_fixes = 0;
  std::uint64_t num_damaged_messages = 0;  ///< Skipped because their bytes made no sense.
  StampFaults lidar_stamps = {};
  StampFaults imu_stamps = {};
  StampFaults gnss_stamps = {};
  ImuDialect imu_dialect = {};
  bool point_times_made_up = false;  ///< At least for some scans.
  /// Several sensors share a topic and none was chosen: next() refused.
  bool undecided_frames = false;
  bool truncated = false;  ///< The file ends or breaks before its data does.
  std::vector<std::string> warnings = {};
};

/// Choices that are otherwise made by looking at the recording; empty strings mean "detect".
struct RecordingOptions {
  std::string lidar_topic = {};
  std::string imu_topic = {};
  std::string gnss_topic = {};
  std::string lidar_frame = {};
  std::string imu_frame = {};
  std::string point_time_field = {};
  std::string point_time_unit = {};
  std::string scratch_folder = {};
};
template <>
struct OptionFields<RecordingOptions> {
  using T = RecordingOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::lidar_topic,
            {.key = "lidar_topic", .doc = "LiDAR topic; empty: detect by type.", .source = "ours"}},
      Field{&T::imu_topic,
            {.key = "imu_topic",
             .doc = "IMU topic; empty: detect by type; 'none': ignore it.",
             .source = "ours"}},
      Field{&T::gnss_topic,
            {.key = "gnss_topic",
             .doc = "GNSS topic; empty: detect by type; 'none': ignore GNSS.",
             .source = "ours"}},
      Field{&T::lidar_frame,
            {.key = "lidar_frame",
             .doc = "frame_id of the LiDAR when several send on its topic; empty: there is one.",
             .source = "ours"}},
      Field{&T::imu_frame,
            {.key = "imu_frame",
             .doc = "frame_id of the IMU when several send on its topic; empty: there is one.",
             .source = "ours"}},
      Field{&T::point_time_field,
            {.key = "point_time_field",
             .doc = "PointCloud2 field with the time of each point; empty: detect by name; 'none': "
                    "synthesise.",
             .source = "ours"}},
      Field{&T::point_time_unit,
            {.key = "point_time_unit",
             .choices = "|s|ms|us|ns",
             .doc = "Unit of that field; empty: detect by the span of a scan.",
             .source = "ours"}},
      Field{&T::scratch_folder,
            {.key = "scratch_folder",
             .doc = "Folder in which a recording that is compressed as a whole is unpacked for the "
                    "time of reading; empty: the workspace.",
             .source = "ours"}},
  };
};

/// A recording of a LiDAR, an IMU and perhaps a GNSS receiver, message by message. The one
/// interface of the library that others may implement: formats and live drivers plug in here.
class ScanSource {
 public:
  ScanSource() = default;
  ScanSource(const ScanSource&) = delete;
  ScanSource& operator=(const ScanSource&) = delete;
  virtual ~ScanSource() = default;

  /// The next message in the order of recording; nothing at the end. Damaged messages are skipped
  /// and counted. @returns kIo when the file can no longer be read; kNotFound when several sensors
  /// share a topic and none was chosen, or none is of the chosen frame.
  [[nodiscard]] virtual Expected<std::optional<SensorMessage>> next() = 0;
  /// What is known at this moment; complete after next() returned nothing.
  [[nodiscard]] virtual RecordingSummary summary() const = 0;
};

/// Opens a recording for streaming: a ROS 1 bag 2.0; a ROS 2 bag as a folder, a .db3 or an .mcap
/// file (MCAP of ROS 1 or CDR messages); one of these compressed with zstd as a whole; or a folder
/// of imu.csv and .pcd scans. The kind is told by the content, not by the name. What is compressed
/// as a whole is unpacked into a nameless file in options.scratch_folder (empty: beside the
/// recording), which is gone when the source is.
/// @returns kNotFound for a missing file or when it has no LiDAR topic or not one that was asked
/// for (the message lists the topics there are); kParse for an empty file or one of another format;
/// kInvalidOptions; kIo when unpacking finds no space; kCancelled.
[[nodiscard]] Expected<std::unique_ptr<ScanSource>> open_recording(
    const std::filesystem::path& path,
    const RecordingOptions& options = {},
    const RunContext& ctx = {});

/// The files that a recording consists of: itself, or those of its folder that are read.
/// @returns as open_recording for what is no recording.
[[nodiscard]] Expected<std::vector<std::filesystem::path>> recording_files(
    const std::filesystem::path& path);

/// What a recording holds without requiring anything of it: topics, and those that would be chosen.
[[nodiscard]] Expected<RecordingSummary> inspect_recording(const std::filesystem::path& path,
                                                           const RecordingOptions& options = {},
                                                           const RunContext& ctx = {});

}  // namespace hybridfusion
