#include "cloud_truth.hpp"
#include "truth_alignments.hpp"

#include <hybridfusion/io/ply.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hybridfusion {

namespace {

/// Points by whether a sensor saw them; both empty where the cloud does not say.
struct PointsByOrigin {
  std::vector<std::size_t> measured = {};
  std::vector<std::size_t> interpolated = {};
};

PointsByOrigin points_by_origin(const PointCloud& cloud) {
  PointsByOrigin points;
  for (std::size_t i = 0; i < cloud.sources.size(); ++i) {
    const bool is_interpolated = cloud.sources[i] == PointSource::kInterpolated;
    (is_interpolated ? points.interpolated : points.measured).push_back(i);
  }
  return points;
}

/// Ways in which each cloud of the workspace is put on its true place.
struct AlignmentsOfClouds {
  std::vector<CloudAlignment> vision = {};
  std::vector<CloudAlignment> lidar = {};
  std::vector<CloudAlignment> fused = {};
};

AlignmentsOfClouds alignments_of_clouds(const TruthAlignments& known) {
  const auto sim = [](const Rigid3& rigid) {
    return Sim3{.rotation = rigid.rotation, .translation = rigid.translation};
  };
  AlignmentsOfClouds by;
  if (known.truth_from_vision) {
    const Sim3 vision_from_fused = known.fused_from_vision.value_or(Sim3{}).inverse();
    by.vision.push_back({"similarity", *known.truth_from_vision});
    by.fused.push_back({"similarity", *known.truth_from_vision * vision_from_fused});
  }
  if (known.truth_from_vision_rigid) {
    by.vision.push_back({"rigid", sim(*known.truth_from_vision_rigid)});
  }
  if (known.truth_from_vision_absolute) {
    by.vision.push_back({"absolute", sim(*known.truth_from_vision_absolute)});
    by.fused.push_back({"absolute", sim(*known.truth_from_vision_absolute)});
  }
  if (known.truth_from_map) by.lidar.push_back({"rigid", sim(*known.truth_from_map)});
  if (known.truth_from_map_absolute) {
    by.lidar.push_back({"absolute", sim(*known.truth_from_map_absolute)});
  }
  return by;
}

}  // namespace

Expected<void> compare_clouds(const Workspace& workspace,
                              const std::filesystem::path& truth_folder,
                              const TruthAlignments& known,
                              const EvaluationOptions& options,
                              const RunContext& ctx,
                              TruthMetrics& metrics) {
  HF_TRY(const CloudTruth truth, load_cloud_truth(truth_folder));
  const auto compare_cloud = [&](std::string_view name,
                                 const PointCloud& cloud,
                                 SampleView view,
                                 const std::vector<CloudAlignment>& alignments) -> Expected<void> {
    HF_TRY(Json json, cloud_truth_json(cloud, truth, view, alignments, options, ctx));
    metrics.summary.push_back(cloud_truth_line(name, json));
    metrics.json["clouds"][std::string(name)] = std::move(json);
    return {};
  };
  const auto compare = [&](std::string_view name,
                           std::string_view file,
                           SampleView view,
                           const std::vector<CloudAlignment>& alignments) -> Expected<void> {
    if (!workspace.has(file) || alignments.empty()) return {};
    HF_TRY(const PointCloud cloud, read_ply(workspace.path(file)));
    if (auto step = compare_cloud(name, cloud, view, alignments); !step) return step;
    const PointsByOrigin points = points_by_origin(cloud);
    if (points.measured.empty() || points.interpolated.empty()) return {};
    for (const auto& [suffix, part] : {std::pair("_measured", &points.measured),
                                       std::pair("_interpolated", &points.interpolated)}) {
      const std::string part_name = std::string(name).append(suffix);
      if (auto step = compare_cloud(part_name, select(cloud, *part), view, alignments); !step) {
        return step;
      }
    }
    return {};
  };
  const AlignmentsOfClouds by = alignments_of_clouds(known);
  if (auto step = compare("vision", workspace_file::kDense, SampleView::kDrone, by.vision); !step) {
    return step;
  }
  if (auto step = compare("lidar", workspace_file::kMap, SampleView::kVehicle, by.lidar); !step) {
    return step;
  }
  return compare("fused", workspace_file::kFusedPly, SampleView::kEither, by.fused);
}

}  // namespace hybridfusion
