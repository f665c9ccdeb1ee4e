#include "report_data.hpp"

#include "../thinned_cloud.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <array>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kVoxel_m = 0.1;  // finer than the pixels of the pictures
constexpr std::uint64_t kMaxCsvBytes = 512U << 20U;

/// The value, or an empty one with a warning.
template <class T>
T or_empty(Expected<T> value, const RunContext& ctx) {
  if (value) return *std::move(value);
  if (value.error().code != ErrorCode::kNotFound) {
    ctx.warn("the report goes on without it: " + value.error().message);
  }
  return {};
}

Expected<double> number(std::string_view text,
                        const std::filesystem::path& path,
                        std::size_t line) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return value;
  return fail(
      ErrorCode::kParse,
      fmt::format("{}:{}: not a number; run the stage that writes it again", path.string(), line));
}

}  // namespace

Json stage_result(const RunRecord& record, std::string_view stage) {
  const auto found = record.stages.find(std::string(stage));
  if (found == record.stages.end()) return nullptr;
  const Json stored = Json::parse(found->second.result_json, nullptr, /*allow_exceptions=*/false);
  return stored.is_object() && stored.contains("result") ? stored["result"] : Json();
}

Expected<std::vector<QualityRow>> read_quality_csv(const std::filesystem::path& path) {
  HF_TRY(const std::string text, read_text_file(path, kMaxCsvBytes));
  std::vector<QualityRow> rows;
  std::size_t begin = text.find('\n');  // behind the header
  for (std::size_t line = 2; begin != std::string::npos && begin + 1 < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', ++begin), text.size());
    std::string_view rest = std::string_view(text).substr(begin, end - begin);
    std::array<double, 5> values{};
    for (double& value : values) {
      const std::size_t comma = rest.find(',');
      if (comma == std::string_view::npos) {
        return fail(
            ErrorCode::kParse,
            fmt::format(
                "{}:{}: too few columns; run the stage that writes it again", path.string(), line));
      }
      HF_TRY(value, number(rest.substr(0, comma), path, line));
      rest.remove_prefix(comma + 1);
    }
    rows.push_back({.time_s = values[0],
                    .num_points = values[1],
                    .num_matched = values[2],
                    .mean_residual_m = values[3],
                    .flags = std::string(rest)});
    begin = end;
  }
  return rows;
}

Rigid3 ReportData::shown_from_lidar() const {
  return registered() ? pose->fused_from_lidar : Rigid3{};
}

ReportData read_report_data(const Workspace& workspace, const RunContext& ctx) {
  ReportData data{.record = RunRecord::load(workspace.path(workspace_file::kRun))};
  std::error_code code;
  data.name = std::filesystem::weakly_canonical(workspace.root(), code).filename().string();
  data.reconstruct = stage_result(data.record, "reconstruct");
  data.map = stage_result(data.record, "map");
  const auto has = [&](std::string_view file) { return workspace.has(file); };
  const auto json = [&](std::string_view file) {
    return has(file) ? or_empty(read_json(workspace.path(file)), ctx) : Json();
  };
  data.registration = json(workspace_file::kRegistration);
  data.metrics = json(workspace_file::kMetrics);
  data.gnss = json(workspace_file::kGnss);
  if (data.registration.is_object()) {
    auto pose = read_registration(workspace.path(workspace_file::kRegistration));
    if (pose) {
      data.pose = *std::move(pose);
    } else {
      ctx.warn("the report goes on without it: " + pose.error().message);
    }
  }
  if (has(workspace_file::kPositions)) {
    data.positions = or_empty(read_positions_csv(workspace.path(workspace_file::kPositions)), ctx);
  }
  if (has(workspace_file::kImages)) {
    auto model = read_colmap_model(workspace.path("vision"));
    if (model) {
      data.model = *std::move(model);
    } else {
      ctx.warn("the report goes on without it: " + model.error().message);
    }
  }
  if (has(workspace_file::kTrajectory)) {
    data.trajectory = or_empty(read_tum(workspace.path(workspace_file::kTrajectory)), ctx);
  }
  if (has(workspace_file::kQuality)) {
    data.quality = or_empty(read_quality_csv(workspace.path(workspace_file::kQuality)), ctx);
  }
  const Sim3 fused_from_vision = data.registered() ? data.pose->fused_from_vision : Sim3{};
  if (has(workspace_file::kDense)) {
    data.vision = or_empty(
        read_thinned(workspace.path(workspace_file::kDense), kVoxel_m, fused_from_vision, ctx),
        ctx);
  }
  if (has(workspace_file::kMap)) {
    data.lidar =
        or_empty(read_thinned(workspace.path(workspace_file::kMap), kVoxel_m, Sim3{}, ctx), ctx);
  }
  return data;
}

}  // namespace hybridfusion
