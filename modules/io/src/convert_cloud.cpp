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

  std::filesystem::path path_;
  CloudSurvey read_;  ///< Of the file.
  CloudSurvey survey_;
  std::optional<CloudProjector> projector_ = {};
};

Expected<PlacedBatches> PlacedBatches::open(const CloudConversion& conversion,
                                            const RunContext& ctx) {
  HF_TRY(CloudSurvey survey, survey_cloud(conversion.in, ctx));
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
  return batches;
}

Expected<void> PlacedBatches::read(const CloudBatchVisitor& visit, const RunContext& ctx) const {
  return read_cloud_batches(
      path_,
      read_,
      kBatchPoints,
      [&](PointCloud&& cloud) -> Expected<void> {
        if (!projector_) return visit(std::move(cloud));
        HF_TRY(PointCloud placed, (*projector_)(std::move(cloud)));
        return visit(std::move(placed));
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
      [&](PointCloud&& cloud) -> Expected<void> {
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
      [&](PointCloud&& cloud) -> Expected<void> {
        if (raster) raster->add(cloud, survey.offset_m);
        return writer ? writer->add(cloud) : Expected<void>();
      },
      ctx);
  if (!read) return std::unexpected(read.error());
  if (writer) {
    if (auto written = writer->commit(); !written) return std::unexpected(written.error());
  }
  if (raster) {
    auto written = write_rasters(conversion, std::move(*raster).finish(survey.crs.wkt));
    if (!written) return std::unexpected(written.error());
  }
  return ConvertedCloud{.num_points = survey.num_points,
                        .crs = survey.crs,
                        .offset_m = survey.offset_m,
                        .keeps_offset = !writer || writer->keeps_offset(),
                        .warnings = survey.warnings};
}

}  // namespace hybridfusion
