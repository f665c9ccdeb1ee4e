#pragma once

#include <hybridfusion/io/scan_source.hpp>

#include <filesystem>
#include <memory>

namespace hybridfusion {

/// Opens a folder with imu.csv, the scans as .pcd files in it or in its folder scans/, and
/// optionally times.txt and gnss.csv (docs/reference/datasets.md).
/// @returns kNotFound without scans; kParse for a scan without a time or a file that is damaged
/// from its first line on.
[[nodiscard]] Expected<std::unique_ptr<ScanSource>> open_scan_folder(
    const std::filesystem::path& folder, const RecordingOptions& options);

/// The files of such a folder that are read.
[[nodiscard]] Expected<std::vector<std::filesystem::path>> scan_folder_files(
    const std::filesystem::path& folder);

[[nodiscard]] Expected<RecordingSummary> inspect_scan_folder(const std::filesystem::path& folder);

}  // namespace hybridfusion
