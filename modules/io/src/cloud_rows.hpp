#pragma once

#include "cloud_builder.hpp"
#include "input_file.hpp"

#include <hybridfusion/io/cloud_stream.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Takes the points of a file one after the other.
struct CloudRowSink {
  /// Called once before the points, with their number as far as the file announces it (else 0).
  std::function<void(const InputFile&, std::span<const CloudColumn>, std::uint64_t)> begin = {};
  /// @returns false when the coordinates are not finite; each format has its own opinion of that.
  std::function<Expected<bool>(std::span<const double>)> row = {};
};

/// What a file says beside its points.
struct CloudFileFacts {
  CrsDescription crs = {};
  std::vector<std::string> warnings = {};
};

/// Each hands every point of its format to the sink. @returns kNotFound; kParse naming the file,
/// the cause and the next step; an error of the sink, which ends the reading.
[[nodiscard]] Expected<CloudFileFacts> read_ply_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);
[[nodiscard]] Expected<CloudFileFacts> read_pcd_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);
[[nodiscard]] Expected<CloudFileFacts> read_las_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);
[[nodiscard]] Expected<CloudFileFacts> read_xyz_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);

using CloudRowReader = Expected<CloudFileFacts> (*)(const std::filesystem::path&,
                                                    const CloudRowSink&);

/// The whole file in memory. @returns as the reader; kParse for coordinates that are too large.
[[nodiscard]] Expected<PointCloud> build_cloud(const std::filesystem::path& path,
                                               CloudRowReader read_rows);

/// As survey_cloud, read_cloud_batches and read_placed_cloud, with the reader of the format.
[[nodiscard]] Expected<CloudSurvey> survey_rows(const std::filesystem::path& path,
                                                CloudRowReader read_rows,
                                                const RunContext& ctx);
struct CloudBatches {
  std::size_t points = 0;
  CloudBatchVisitor visit = {};
};
[[nodiscard]] Expected<void> visit_rows(const std::filesystem::path& path,
                                        const CloudSurvey& survey,
                                        CloudRowReader read_rows,
                                        const CloudBatches& batches,
                                        const RunContext& ctx);
[[nodiscard]] Expected<PlacedCloud> collect_rows(const std::filesystem::path& path,
                                                 const CloudSurvey& survey,
                                                 CloudRowReader read_rows);

/// Adds the file to the error of a CloudBuilder.
[[nodiscard]] Expected<PointCloud> finished(const std::filesystem::path& path,
                                            Expected<PointCloud> cloud);

}  // namespace hybridfusion
