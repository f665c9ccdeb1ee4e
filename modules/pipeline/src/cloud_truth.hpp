#pragma once

#include "json_text.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/evaluation/surface_distance.hpp>
#include <hybridfusion/pipeline/evaluation_options.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// True surface of a data set and samples of it that say who could see them.
struct CloudTruth {
  std::optional<SurfaceDistance> surface = {};
  std::vector<std::uint8_t> triangle_labels = {};
  std::vector<Eigen::Vector3f> samples = {};
  std::vector<Eigen::Vector3f> normals = {};  ///< Of the samples; empty when the file has none.
  std::vector<bool> seen_by_drone = {};       ///< By two photos: one alone cannot place a point.
  std::vector<bool> seen_by_vehicle = {};
};

/// Reads mesh.ply and samples.ply of a truth folder, as far as they exist.
[[nodiscard]] Expected<CloudTruth> load_cloud_truth(const std::filesystem::path& truth_folder);

enum class SampleView : std::uint8_t { kDrone, kVehicle, kEither };

/// One way of laying a cloud over the truth.
struct CloudAlignment {
  std::string_view name = {};
  Sim3 truth_from_cloud = {};
};

/// Accuracy and completeness under each alignment.
[[nodiscard]] Expected<Json> cloud_truth_json(const PointCloud& cloud,
                                              const CloudTruth& truth,
                                              SampleView view,
                                              const std::vector<CloudAlignment>& alignments,
                                              const EvaluationOptions& options,
                                              const RunContext& ctx);

/// The first alignment of that JSON in one line for a person.
[[nodiscard]] std::string cloud_truth_line(std::string_view cloud, const Json& json);

}  // namespace hybridfusion
