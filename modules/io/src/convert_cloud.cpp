#include "cloud_losses.hpp"

#include <hybridfusion/io/cloud_stream.hpp>
#include <hybridfusion/io/convert_cloud.hpp>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kBatchPoints = std::size_t{1} << 16U;

[[nodiscard]] bool is_placed(const CloudSurvey& survey) {
  return !survey.offset_m.isZero() || !survey.crs.name.empty();
}

/// The batches of the input in the coordinates of the output.
class PlacedBatches {
 public:
  [[nodiscard]] static Expected<PlacedBatches> open(const CloudConversion& conversion,
                                                    const RunContext& ctx);
  /// Of the output.
  [[nodiscard]] const CloudSurvey& survey() const { return survey_; }
  [[nodiscard]] Expected<void> read(const CloudBatchVisitor& visit, const RunContext& ctx) const;

 private:
  PlacedBatches(const CloudConversion& conversion, CloudSurvey survey)
      : path_(conversion.in), read_(survey), survey_(std::move(survey)) {}

  /// What has the axes of the local frame cannot follow into the grid.
  void forget_axes();

  std::filesystem::path path_;
  CloudSurvey read_;  ///< Of the file.
  CloudSurvey survey_;
  std::optional<CloudProjector> projector_ = {};
};

Expected<PlacedBatches> PlacedBatches::open(const CloudConversion& conversion,
                                            const RunContext& ctx) {
  HF_TRY(CloudSurvey survey, survey_cloud(conversion.in, ctx, conversion.columns));
  PlacedBatches batches(conversion, std::move(survey));
  if (!conversion.georeference) return batches;
  if (is_placed(batches.survey_)) {
    if (conversion.keep_placed) return batches;
    const std::string& name = batches.survey_.crs.name;
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("{}: the cloud is in a coordinate system already ({}); --origin and "
                            "--crs are for clouds in metres east, north, up",
                            conversion.in.string(),
                            name.empty() ? "large coordinates" : name));
  }
  HF_TRY(batches.projector_, CloudProjector::create(*conversion.georeference));
  batches.survey_.offset_m = batches.projector_->offset_m();
  batches.survey_.crs = batches.projector_->crs();
  batches.forget_axes();
  return batches;
}

void PlacedBatches::forget_axes() {
  std::vector<std::string>& warnings = survey_.warnings;
  if (!projector_->warning().empty()) warnings.push_back(projector_->warning());
  if (std::erase(survey_.channels, "normals") > 0) {
    warnings.emplace_back("normals are left out: their axes are not those of the system");
  }
  if (survey_.viewpoint != kNoViewpoint) {
    warnings.emplace_back("the viewpoint is left out: its axes are not those of the system");
    survey_.viewpoint = kNoViewpoint;
  }
}

Expected<void> PlacedBatches::read(const CloudBatchVisitor& visit, const RunContext& ctx) const {
  return read_cloud_batches(
      path_,
      read_,
      kBatchPoints,
      [&](CloudBatch&& cloud) -> Expected<void> {
        if (!projector_) return visit(std::move(cloud));
        PointCloud& points = cloud;
        HF_TRY(points, (*projector_)(std::move(points)));
        return visit(std::move(cloud));
      },
      ctx);
}

/// A raster that waits for the points, when one is wanted.
Expected<std::optional<SurfaceRasterBuilder>> begin_raster(const CloudConversion& conversion,
                                                           const PlacedBatches& batches,
                                                           const RunContext& ctx) {
  if (!conversion.dsm && !conversion.ortho) return std::nullopt;
  SurfaceExtent extent;
  auto read = batches.read(
      [&](CloudBatch&& cloud) -> Expected<void> {
        extent.add(cloud, batches.survey().offset_m);
        return {};
      },
      ctx);
  if (!read) return std::unexpected(read.error());
  HF_TRY(SurfaceRasterBuilder builder, SurfaceRasterBuilder::create(extent, conversion.raster));
  return builder;
}

Expected<void> write_rasters(const CloudConversion& conversion, const SurfaceRaster& raster) {
  if (conversion.dsm) {
    if (auto written = write_dsm(*conversion.dsm, raster); !written) return written;
  }
  if (!conversion.ortho) return {};
  return write_orthophoto(*conversion.ortho, raster);
}

}  // namespace

Expected<ConvertedCloud> convert_cloud(const CloudConversion& conversion, const RunContext& ctx) {
  HF_TRY(const PlacedBatches batches, PlacedBatches::open(conversion, ctx));
  const CloudSurvey& survey = batches.survey();
  HF_TRY(auto raster, begin_raster(conversion, batches, ctx));
  std::optional<CloudWriter> writer;
  if (conversion.out) {
    HF_TRY(writer, CloudWriter::create(*conversion.out, survey, conversion.format));
  }
  auto read = batches.read(
      [&](CloudBatch&& cloud) -> Expected<void> {
        if (raster) raster->add(cloud, survey.offset_m);
        return writer ? writer->add(cloud) : Expected<void>();
      },
      ctx);
  if (!read) return std::unexpected(read.error());
  if (writer) {
    if (auto written = writer->commit(); !written) return std::unexpected(written.error());
  }
  std::vector<std::string> warnings = survey.warnings;
  if (conversion.out) {
    for (std::string& loss : cloud_losses(survey, *conversion.out, conversion.format)) {
      warnings.push_back(std::move(loss));
    }
  }
  if (raster) {
    auto written = write_rasters(conversion, std::move(*raster).finish(survey.crs));
    if (!written) return std::unexpected(written.error());
  }
  return ConvertedCloud{.num_points = survey.num_points,
                        .crs = survey.crs,
                        .offset_m = survey.offset_m,
                        .keeps_offset = !writer || writer->keeps_offset(),
                        .warnings = std::move(warnings)};
}

}  // namespace hybridfusion
