#include "scan_folder.hpp"

#include "scan_folder_files.hpp"

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
                   CsvRows imu,
                   std::optional<CsvRows> gnss,
                   RecordingSummary summary,
                   const RecordingOptions& options)
      : files_(std::move(files)),
        imu_(std::move(imu)),
        gnss_(std::move(gnss)),
        summary_(std::move(summary)),
        times_({.field = options.point_time_field, .unit = options.point_time_unit}) {}

  Expected<std::optional<SensorMessage>> next() override;
  RecordingSummary summary() const override;

 private:
  using RowOrEnd = std::optional<CsvRows::Row>;
  /// Skips and counts damaged rows.
  [[nodiscard]] Expected<RowOrEnd> next_row(CsvRows& rows);
  [[nodiscard]] Expected<std::optional<SensorMessage>> next_scan();
  void note_damage(const Error& error);

  std::vector<ScanFile> files_;
  CsvRows imu_;
  std::optional<CsvRows> gnss_;
  std::size_t next_file_ = 0;
  bool started_ = false;
  RowOrEnd imu_row_ = {};
  RowOrEnd gnss_row_ = {};
  RecordingSummary summary_;
  PointTimeReader times_;
};

void ScanFolderSource::note_damage(const Error& error) {
  if (summary_.num_damaged_messages++ == 0) {
    summary_.warnings.push_back(error.message + " (such entries are skipped and counted)");
  }
}

Expected<ScanFolderSource::RowOrEnd> ScanFolderSource::next_row(CsvRows& rows) {
  for (;;) {
    auto row = rows.next();
    if (row || row.error().code != ErrorCode::kParse) return row;
    note_damage(row.error());
  }
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
  if (!std::exchange(started_, true)) {
    HF_TRY(imu_row_, next_row(imu_));
    if (gnss_) {
      HF_TRY(gnss_row_, next_row(*gnss_));
    }
  }
  for (;;) {
    constexpr Timestamp kNever = Timestamp::max();
    const Timestamp imu_time = imu_row_ ? imu_row_->time : kNever;
    const Timestamp gnss_time = gnss_row_ ? gnss_row_->time : kNever;
    const bool scans_left = next_file_ < files_.size();
    const Timestamp scan_time = scans_left ? files_[next_file_].stamp : kNever;
    if (scans_left && scan_time <= std::min(imu_time, gnss_time)) {
      HF_TRY(std::optional<SensorMessage> scan, next_scan());
      if (scan) return scan;
      continue;
    }
    if (gnss_row_ && gnss_time <= imu_time) {
      const CsvRows::Row row = *gnss_row_;
      HF_TRY(gnss_row_, next_row(*gnss_));
      ++summary_.num_gnss_fixes;
      GnssFix fix = {.time = row.time,
                     .position = {.latitude_deg = row.values[0],
                                  .longitude_deg = row.values[1],
                                  .altitude_m = row.values[2]}};
      if (row.count >= 6) fix.sigma_enu_m = {row.values[3], row.values[4], row.values[5]};
      return fix;
    }
    if (!imu_row_) return std::nullopt;
    const CsvRows::Row row = *imu_row_;
    HF_TRY(imu_row_, next_row(imu_));
    ++summary_.num_imu_samples;
    return ImuSample{.time = row.time,
                     .angular_velocity_radps = {row.values[0], row.values[1], row.values[2]},
                     .specific_force_mps2 = {row.values[3], row.values[4], row.values[5]}};
  }
}

RecordingSummary ScanFolderSource::summary() const {
  RecordingSummary summary = summary_;
  summary.point_time = times_.description();
  return summary;
}

[[nodiscard]] RecordingSummary summarize(const std::vector<ScanFile>& files, bool has_gnss) {
  RecordingSummary summary = {.format = "folder of PCD scans"};
  if (has_gnss) summary.topics.push_back({std::string(kGnssFile), "CSV"});
  summary.topics.push_back({std::string(kImuFile), "CSV"});
  summary.topics.push_back({"scans", "PCD", files.size()});
  summary.lidar_topic = "scans";
  summary.imu_topic = kImuFile;
  if (has_gnss) summary.gnss_topic = kGnssFile;
  return summary;
}

[[nodiscard]] bool has_gnss(const std::filesystem::path& folder) {
  std::error_code code;
  return std::filesystem::exists(folder / kGnssFile, code);
}

}  // namespace

Expected<std::unique_ptr<ScanSource>> open_scan_folder(const std::filesystem::path& folder,
                                                       const RecordingOptions& options) {
  HF_TRY(std::vector<ScanFile> files, list_scan_files(folder));
  constexpr std::size_t kImuValues = 6;
  constexpr std::size_t kGnssValues = 3;
  HF_TRY(CsvRows imu, CsvRows::open(folder / kImuFile, kImuValues, kImuColumns));
  const bool use_gnss = options.gnss_topic != "none" && has_gnss(folder);
  std::optional<CsvRows> gnss;
  if (use_gnss) {
    HF_TRY(gnss, CsvRows::open(folder / kGnssFile, kGnssValues, kGnssColumns));
  }
  RecordingSummary summary = summarize(files, use_gnss);
  return std::make_unique<ScanFolderSource>(
      std::move(files), std::move(imu), std::move(gnss), std::move(summary), options);
}

Expected<std::vector<std::filesystem::path>> scan_folder_files(
    const std::filesystem::path& folder) {
  HF_TRY(const std::vector<ScanFile> scans, list_scan_files(folder));
  std::vector<std::filesystem::path> files = {folder / kImuFile};
  for (const std::string_view optional : {kGnssFile, kTimesFile}) {
    std::error_code code;
    if (std::filesystem::exists(folder / optional, code)) files.push_back(folder / optional);
  }
  for (const ScanFile& scan : scans) files.push_back(scan.path);
  return files;
}

Expected<RecordingSummary> inspect_scan_folder(const std::filesystem::path& folder) {
  HF_TRY(const std::vector<ScanFile> files, list_scan_files(folder));
  return summarize(files, has_gnss(folder));
}

}  // namespace hybridfusion
