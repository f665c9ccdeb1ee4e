#pragma once

#include "../json_text.hpp"
#include "../positions_csv.hpp"
#include "../run_record.hpp"
#include "../workspace_data.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/trajectory.hpp>
#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// A row of lidar/quality.csv.
struct QualityRow {
  double time_s = 0.0;
  double num_points = 0.0;
  double num_matched = 0.0;
  double mean_residual_m = 0.0;
  std::string flags = {};  ///< "imu_gap|saturated"; empty: nothing unusual.
};
[[nodiscard]] Expected<std::vector<QualityRow>> read_quality_csv(const std::filesystem::path& path);

/// Everything the figures are drawn from, read from the workspace once. What a stage that did not
/// run would have written is absent or empty.
struct ReportData {
  std::string name = {};  ///< Of the workspace folder.
  RunRecord record = {};
  Json reconstruct = {};  ///< Result of each stage; null when it did not run.
  Json map = {};
  Json registration = {};  ///< registration.json
  Json metrics = {};       ///< metrics.json
  Json gnss = {};          ///< gnss.json
  std::vector<PositionRow> positions = {};
  std::optional<ColmapModel> model = {};
  Trajectory trajectory = {};  ///< map_from_imu.
  std::vector<QualityRow> quality = {};
  std::optional<StoredRegistration> pose = {};
  PointCloud vision = {};  ///< Thinned, in the fused frame (that of G, rescaled where fused so).
  PointCloud lidar = {};   ///< Thinned, in the LiDAR map frame.

  /// Where the LiDAR map stands in the pictures: registered, or in its own frame.
  [[nodiscard]] Rigid3 shown_from_lidar() const;
  [[nodiscard]] bool registered() const { return pose && pose->ok; }
};

/// What a stage reported of itself in run.json; null when it did not run or wrote something else.
[[nodiscard]] Json stage_result(const RunRecord& record, std::string_view stage);

/// Reads what is there; a damaged file counts as absent, with a warning, so that the report tells
/// at least the rest.
[[nodiscard]] ReportData read_report_data(const Workspace& workspace, const RunContext& ctx);

/// One figure or table of the report.
struct Figure {
  std::string id = {};       ///< Anchor, e.g. "survey-map".
  std::string title = {};    ///< Plain text.
  std::string body = {};     ///< HTML or inline SVG, already escaped.
  std::string caption = {};  ///< Plain text: what is seen, and what would be a bad sign.
  std::vector<std::string_view> sources = {};  ///< Workspace files it is drawn from.
};

/// Each returns the figures that the data allow.
[[nodiscard]] std::vector<Figure> photo_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> camera_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> lidar_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> registration_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> patch_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> profile_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> section_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> fusion_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> metric_figures(const ReportData& data);
[[nodiscard]] std::vector<Figure> overlap_figures(const ReportData& data);

}  // namespace hybridfusion
