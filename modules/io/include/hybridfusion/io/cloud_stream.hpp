#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// What only the whole of a cloud file tells: with it the file can be read in alike batches.
struct CloudSurvey {
  std::uint64_t num_points = 0;
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< Position in the CRS = point + offset.
  CrsDescription crs = {};
  std::vector<std::string> warnings = {};
  double color_max = 0.0;  ///< Full scale of the file's colours; 0: it has none.
  bool has_intensity = false;
  float largest_intensity = 0.0F;
};

/// Reads the file once, in constant memory. The format is that of read_placed_cloud.
/// @returns errors as read_placed_cloud; kCancelled.
[[nodiscard]] Expected<CloudSurvey> survey_cloud(const std::filesystem::path& path,
                                                 const RunContext& ctx = {});

using CloudBatchVisitor = std::function<Expected<void>(PointCloud&&)>;

/// Reads the same points in the same order in clouds of at most `batch_points`, all with the
/// channels and the offset of the survey. Points before an error have been visited.
/// @pre batch_points > 0. @returns errors as read_placed_cloud and those of `visit`, which ends the
/// reading; kIo when the file is no longer the surveyed one; kCancelled.
[[nodiscard]] Expected<void> read_cloud_batches(const std::filesystem::path& path,
                                                const CloudSurvey& survey,
                                                std::size_t batch_points,
                                                const CloudBatchVisitor& visit,
                                                const RunContext& ctx = {});

}  // namespace hybridfusion
