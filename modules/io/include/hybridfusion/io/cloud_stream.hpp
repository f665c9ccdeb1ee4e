#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/io/placed_cloud.hpp>
#include <hybridfusion/io/point_scalar.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A scalar of a file, with the range of its values.
struct SurveyedScalar {
  std::string name = {};
  ScalarType type = ScalarType::kFloat64;
  std::string description = {};
  double smallest = 0.0;
  double largest = 0.0;
};

/// What only the whole of a cloud file tells: with it the file can be read in alike batches.
struct CloudSurvey {
  std::uint64_t num_points = 0;
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< Position in the CRS = point + offset.
  CrsDescription crs = {};
  std::vector<std::string> warnings = {};
  double color_max = 0.0;  ///< Full scale of the file's colours; 0: it has none.
  bool has_intensity = false;
  float largest_intensity = 0.0F;
  float smallest_intensity = 0.0F;
  bool fractional_intensity = false;
  bool time_is_seconds = true;               ///< Else it is one of the scalars.
  std::vector<std::string> channels = {};    ///< Those of the points, for people.
  std::vector<SurveyedScalar> scalars = {};  ///< Those that say something.
  Viewpoint viewpoint = kNoViewpoint;
  std::vector<std::string> columns = {};  ///< Names given for the columns of a text cloud.
};

/// Reads the file once, in constant memory. The format is that of read_placed_cloud.
/// @param columns  Names of the columns of a text cloud; empty: from its heading or content.
/// @returns errors as read_placed_cloud; kInvalidOptions for columns of another format; kCancelled.
[[nodiscard]] Expected<CloudSurvey> survey_cloud(const std::filesystem::path& path,
                                                 const RunContext& ctx = {},
                                                 const std::vector<std::string>& columns = {});

using CloudBatchVisitor = std::function<Expected<void>(CloudBatch&&)>;

/// Reads the same points in the same order in clouds of at most `batch_points`, all with the
/// channels, the scalars and the offset of the survey. Points before an error have been visited.
/// @pre batch_points > 0. @returns errors as read_placed_cloud and those of `visit`, which ends the
/// reading; kIo when the file is no longer the surveyed one; kCancelled.
[[nodiscard]] Expected<void> read_cloud_batches(const std::filesystem::path& path,
                                                const CloudSurvey& survey,
                                                std::size_t batch_points,
                                                const CloudBatchVisitor& visit,
                                                const RunContext& ctx = {});

}  // namespace hybridfusion
