#include "scan_folder.hpp"

#include "imu_watch.hpp"
#include "scan_folder_files.hpp"
#include "stamp_gate.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kImuFile = "imu.csv";
constexpr std::string_view kGnssFile = "gnss.csv";
constexpr std::string_view kImuColumns =
    "time, gyro_x, gyro_y, gyro_z [rad/s], accel_x, accel_y, accel_z [m/s^2]";
constexpr std::string_view kGnssColumns =
    "time, latitude_deg, longitude_deg, altitude_m (and sigma_e, sigma_n, sigma_u [m])";

/// Three streams in the order of their times.
class ScanFolderSource final : public ScanSource {
 public:
  ScanFolderSource(std::vector<ScanFile> files,
                   std::optional<CsvRows> imu,
                   std::optional<CsvRows> gnss,
                   RecordingSummary summary,
                   const RecordingOptions& options);

  Expected<std::optional<SensorMessage>> next() override;
  RecordingSummary summary() const override;

 private:
  /// Rows of a table behind the gate of their sensor, the first of those that may pass in sight.
  struct Table {
    CsvRows rows;
    StampGate gate;
    std::optional<SensorMessage> first = {};
    bool ended = false;
  };
  using Convert = SensorMessage (*)(const CsvRows::Row&);

  [[nodiscard]] Expected<void> look_at(Table& table, Convert convert);
  [[nodiscard]] Expected<std::optional<SensorMessage>> next_scan();
  void note_damage(const Error& error);

  std::vector<ScanFile> files_;
  std::vector<ClockStep> clock_steps_ = {};
  std::optional<Table> imu_;
  std::optional<Table> gnss_;
  std::size_t next_file_ = 0;
  RecordingSummary summary_;
  PointTimeReader times_;
  ImuWatch imu_watch_ = {};
};

constexpr std::chrono::milliseconds kConfirm{1000};

[[nodiscard]] SensorMessage fix_of(const CsvRows::Row& row) {
  GnssFix fix = {.time = row.time,
                 .position = {.latitude_deg = row.values[0],
                              .longitude_deg = row.values[1],
                              .altitude_m = row.values[2]}};
  if (row.count >= 6) fix.sigma_enu_m = {row.values[3], row.values[4], row.values[5]};
  return fix;
}

[[nodiscard]] SensorMessage sample_of(const CsvRows::Row& row) {
  return ImuSample{.time = row.time,
                   .angular_velocity_radps = {row.values[0], row.values[1], row.values[2]},
                   .specific_force_mps2 = {row.values[3], row.values[4], row.values[5]}};
}

ScanFolderSource::ScanFolderSource(std::vector<ScanFile> files,
                                   std::optional<CsvRows> imu,
                                   std::optional<CsvRows> gnss,
                                   RecordingSummary summary,
                                   const RecordingOptions& options)
    : files_(std::move(files)),
      summary_(std::move(summary)),
      times_({.field = options.point_time_field, .unit = options.point_time_unit}) {
  if (imu) {
    imu_.emplace(Table{.rows = *std::move(imu), .gate = StampGate("IMU", kConfirm, clock_steps_)});
  }
  if (gnss) {
    gnss_.emplace(
        Table{.rows = *std::move(gnss), .gate = StampGate("GNSS", kConfirm, clock_steps_)});
  }
}

void ScanFolderSource::note_damage(const Error& error) {
  if (summary_.num_damaged_messages++ == 0) {
    summary_.warnings.push_back(error.message + " (such entries are skipped and counted)");
  }
}

/// Skips and counts damaged rows.
Expected<void> ScanFolderSource::look_at(Table& table, Convert convert) {
  while (!table.first) {
    table.first = table.gate.take();
    if (table.first || table.ended) return {};
    auto row = table.rows.next();
    if (!row) {
      if (row.error().code != ErrorCode::kParse) return std::unexpected(row.error());
      note_damage(row.error());
    } else if (*row) {
      table.gate.add(convert(**row), (*row)->time);
    } else {
      table.gate.finish();
      table.ended = true;
    }
  }
  return {};
}

Expected<std::optional<SensorMessage>> ScanFolderSource::next_scan() {
  auto scan = read_scan_file(files_[next_file_++], times_);
  if (!scan && scan.error().code == ErrorCode::kParse) {
    note_damage(scan.error());
    return std::nullopt;
  }
  if (!scan) return std::unexpected(scan.error());
  for (std::string& warning : times_.take_warnings()) {
    summary_.warnings.push_back(std::move(warning));
  }
  ++summary_.num_scans;
  return *std::move(scan);
}

Expected<std::optional<SensorMessage>> ScanFolderSource::next() {
  for (;;) {
    if (imu_) {
      if (auto looked = look_at(*imu_, &sample_of); !looked) return std::unexpected(looked.error());
    }
    if (gnss_) {
      if (auto looked = look_at(*gnss_, &fix_of); !looked) return std::unexpected(looked.error());
    }
    constexpr Timestamp kNever = Timestamp::max();
    const Timestamp imu_time = imu_ && imu_->first ? stamp_of(*imu_->first) : kNever;
    const Timestamp gnss_time = gnss_ && gnss_->first ? stamp_of(*gnss_->first) : kNever;
    const bool scans_left = next_file_ < files_.size();
    const Timestamp scan_time = scans_left ? files_[next_file_].stamp : kNever;
    if (scans_left && scan_time <= std::min(imu_time, gnss_time)) {
      HF_TRY(std::optional<SensorMessage> scan, next_scan());
      if (scan) return scan;
      continue;
    }
    if (gnss_ && gnss_->first && gnss_time <= imu_time) {
      ++summary_.num_gnss_fixes;
      return std::exchange(gnss_->first, std::nullopt);
    }
    if (!imu_ || !imu_->first) return std::nullopt;
    ++summary_.num_imu_samples;
    static_cast<void>(imu_watch_.complete({.sample = std::get<ImuSample>(*imu_->first)}));
    return std::exchange(imu_->first, std::nullopt);
  }
}

RecordingSummary ScanFolderSource::summary() const {
  RecordingSummary summary = summary_;
  summary.point_time = times_.description();
  summary.point_times_made_up = times_.made_up();
  summary.imu_dialect = imu_watch_.dialect();
  if (imu_) summary.imu_stamps = imu_->gate.faults();
  if (gnss_) summary.gnss_stamps = gnss_->gate.faults();
  add_stamp_warnings(summary);
  return summary;
}

[[nodiscard]] RecordingSummary summarize(const std::vector<ScanFile>& files,
                                         bool has_imu,
                                         bool has_gnss) {
  RecordingSummary summary = {.format = "folder of PCD scans"};
  if (has_gnss) summary.topics.push_back({std::string(kGnssFile), "CSV"});
  if (has_imu) summary.topics.push_back({std::string(kImuFile), "CSV"});
  summary.topics.push_back({"scans", "PCD", files.size()});
  summary.lidar_topic = "scans";
  if (has_imu) summary.imu_topic = kImuFile;
  if (has_gnss) summary.gnss_topic = kGnssFile;
  return summary;
}

[[nodiscard]] bool has(const std::filesystem::path& folder, std::string_view file) {
  std::error_code code;
  return std::filesystem::exists(folder / file, code);
}

}  // namespace

Expected<std::unique_ptr<ScanSource>> open_scan_folder(const std::filesystem::path& folder,
                                                       const RecordingOptions& options) {
  HF_TRY(std::vector<ScanFile> files, list_scan_files(folder));
  constexpr std::size_t kImuValues = 6;
  constexpr std::size_t kGnssValues = 3;
  const bool use_imu = options.imu_topic != "none" && has(folder, kImuFile);
  const bool use_gnss = options.gnss_topic != "none" && has(folder, kGnssFile);
  std::optional<CsvRows> imu;
  if (use_imu) {
    HF_TRY(imu, CsvRows::open(folder / kImuFile, kImuValues, kImuColumns));
  }
  std::optional<CsvRows> gnss;
  if (use_gnss) {
    HF_TRY(gnss, CsvRows::open(folder / kGnssFile, kGnssValues, kGnssColumns));
  }
  RecordingSummary summary = summarize(files, use_imu, use_gnss);
  return std::make_unique<ScanFolderSource>(
      std::move(files), std::move(imu), std::move(gnss), std::move(summary), options);
}

Expected<std::vector<std::filesystem::path>> scan_folder_files(
    const std::filesystem::path& folder) {
  HF_TRY(const std::vector<ScanFile> scans, list_scan_files(folder));
  std::vector<std::filesystem::path> files;
  for (const std::string_view optional : {kImuFile, kGnssFile, kTimesFile}) {
    if (has(folder, optional)) files.push_back(folder / optional);
  }
  for (const ScanFile& scan : scans) files.push_back(scan.path);
  return files;
}

Expected<RecordingSummary> inspect_scan_folder(const std::filesystem::path& folder) {
  HF_TRY(const std::vector<ScanFile> files, list_scan_files(folder));
  return summarize(files, has(folder, kImuFile), has(folder, kGnssFile));
}

}  // namespace hybridfusion
