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
  /// @returns false when the coordinates are not finite: the sink leaves the point out.
  std::function<Expected<bool>(std::span<const double>)> row = {};
};

/// What a file says beside its points.
struct CloudFileFacts {
  CrsDescription crs = {};
  std::vector<std::string> warnings = {};
  Viewpoint viewpoint = kNoViewpoint;
};

/// Each hands every point of its format to the sink. @returns kNotFound; kParse naming the file,
/// the cause and the next step; an error of the sink, which ends the reading.
[[nodiscard]] Expected<CloudFileFacts> read_ply_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);
[[nodiscard]] Expected<CloudFileFacts> read_pcd_cloud_rows(const std::filesystem::path& path,
                                                           const CloudRowSink& sink);
[[nodiscard]] Expected<CloudFileFacts> read_las_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);
[[nodiscard]] Expected<CloudFileFacts> read_xyz_rows(const std::filesystem::path& path,
                                                     const CloudRowSink& sink);

/// @param columns  Names of the columns; empty: from the heading or what they hold.
[[nodiscard]] Expected<CloudFileFacts> read_text_rows(const std::filesystem::path& path,
                                                      const CloudRowSink& sink,
                                                      const std::vector<std::string>& columns);

using CloudRowReader =
    std::function<Expected<CloudFileFacts>(const std::filesystem::path&, const CloudRowSink&)>;

/// The whole file in memory. @returns as the reader; kParse for coordinates that are too large.
[[nodiscard]] Expected<PointCloud> build_cloud(const std::filesystem::path& path,
                                               const CloudRowReader& read_rows);

/// As survey_cloud, read_cloud_batches and read_placed_cloud, with the reader of the format.
[[nodiscard]] Expected<CloudSurvey> survey_rows(const std::filesystem::path& path,
                                                const CloudRowReader& read_rows,
                                                const RunContext& ctx);
struct CloudBatches {
  std::size_t points = 0;
  CloudBatchVisitor visit = {};
};
[[nodiscard]] Expected<void> visit_rows(const std::filesystem::path& path,
                                        const CloudSurvey& survey,
                                        const CloudRowReader& read_rows,
                                        const CloudBatches& batches,
                                        const RunContext& ctx);
[[nodiscard]] Expected<PlacedCloud> collect_rows(const std::filesystem::path& path,
                                                 const CloudSurvey& survey,
                                                 const CloudRowReader& read_rows);

/// Words on points without a position ("no return" in organised clouds), which every format leaves
/// out; empty: there were none. @returns kParse when no point is left.
[[nodiscard]] Expected<std::string> told_of_dropped(const std::filesystem::path& path,
                                                    std::uint64_t num_dropped,
                                                    std::uint64_t num_left);

/// Adds the file to the error of a CloudBuilder.
[[nodiscard]] Expected<PointCloud> finished(const std::filesystem::path& path,
                                            Expected<PointCloud> cloud);

}  // namespace hybridfusion
