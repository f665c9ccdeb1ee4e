#include "cloud_rows.hpp"
#include "text.hpp"
#include "xyz.hpp"

#include <hybridfusion/io/cloud_stream.hpp>
#include <hybridfusion/io/cloud_writer.hpp>
#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/pcd.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] std::string extension_of(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

[[nodiscard]] bool is_text_cloud(std::string_view extension) {
  return extension == ".xyz" || extension == ".txt" || extension == ".csv" || extension == ".asc" ||
         extension == ".pts";
}

[[nodiscard]] std::unexpected<Error> not_read(const std::filesystem::path& path) {
  return fail(
      ErrorCode::kInvalidOptions,
      fmt::format("{}: clouds are read from .ply, .pcd, .las, .xyz, .txt, .csv, .asc and .pts, "
                  "not '{}'; convert the cloud",
                  path.string(),
                  extension_of(path)));
}

[[nodiscard]] std::unexpected<Error> not_written(const std::filesystem::path& path) {
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("{}: clouds are written to .ply, .pcd, .xyz and .las, not '{}'",
                          path.string(),
                          extension_of(path)));
}

Expected<CloudRowReader> reader_of(const std::filesystem::path& path,
                                   const std::vector<std::string>& columns = {}) {
  const std::string extension = extension_of(path);
  if (!columns.empty() && !is_text_cloud(extension)) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("{}: --columns is for text clouds (.xyz .txt .csv .asc .pts)", path.string()));
  }
  if (extension == ".ply") return CloudRowReader{read_ply_rows};
  if (extension == ".pcd") return CloudRowReader{read_pcd_cloud_rows};
  if (extension == ".las") return CloudRowReader{read_las_rows};
  if (is_text_cloud(extension)) {
    return CloudRowReader{[columns](const std::filesystem::path& file, const CloudRowSink& sink) {
      return read_text_rows(file, sink, columns);
    }};
  }
  return not_read(path);
}

}  // namespace

Expected<PointCloud> read_point_cloud(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return read_ply(path);
  if (extension == ".pcd") return read_pcd(path);
  if (is_text_cloud(extension)) return read_xyz(path);
  if (extension != ".las") return not_read(path);
  HF_TRY(PlacedCloud placed, read_las(path));
  if (placed.offset_m.isZero()) return std::move(placed.cloud);
  return fail(
      ErrorCode::kParse,
      fmt::format("{}: coordinates around ({:.0f}, {:.0f}, {:.0f}) m cannot be kept as they "
                  "are; subtract a common offset from the clouds first (hybridfusion "
                  "convert takes one off)",
                  path.string(),
                  placed.offset_m.x(),
                  placed.offset_m.y(),
                  placed.offset_m.z()));
}

Expected<PlacedCloud> read_placed_cloud(const std::filesystem::path& path) {
  HF_TRY(const CloudRowReader reader, reader_of(path));
  HF_TRY(const CloudSurvey survey, survey_rows(path, reader, {}));
  return collect_rows(path, survey, reader);
}

Expected<CloudSurvey> survey_cloud(const std::filesystem::path& path,
                                   const RunContext& ctx,
                                   const std::vector<std::string>& columns) {
  HF_TRY(const CloudRowReader reader, reader_of(path, columns));
  HF_TRY(CloudSurvey survey, survey_rows(path, reader, ctx));
  survey.columns = columns;
  return survey;
}

Expected<void> read_cloud_batches(const std::filesystem::path& path,
                                  const CloudSurvey& survey,
                                  std::size_t batch_points,
                                  const CloudBatchVisitor& visit,
                                  const RunContext& ctx) {
  HF_TRY(const CloudRowReader reader, reader_of(path, survey.columns));
  return visit_rows(path, survey, reader, {.points = batch_points, .visit = visit}, ctx);
}

Expected<void> write_point_cloud(const std::filesystem::path& path,
                                 const PointCloud& cloud,
                                 const std::optional<GeodeticOrigin>& origin) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return write_ply(path, cloud);
  if (extension == ".pcd") return write_pcd(path, cloud);
  if (extension == ".xyz") return write_xyz(path, cloud, Eigen::Vector3d::Zero());
  if (extension != ".las") return not_written(path);
  LasWriteOptions options;
  if (origin) options.georeference = LasGeoreference{.origin = *origin};
  return write_las(path, cloud, options);
}

Expected<bool> write_placed_cloud(const std::filesystem::path& path, const PlacedCloud& placed) {
  const std::vector<float>& intensities = placed.cloud.intensities;
  const CloudSurvey survey = {
      .num_points = placed.cloud.size(),
      .offset_m = placed.offset_m,
      .crs = placed.crs,
      .has_intensity = !intensities.empty(),
      .largest_intensity = intensities.empty() ? 0.0F : std::ranges::max(intensities)};
  HF_TRY(CloudWriter file, CloudWriter::create(path, survey, CloudFormat{}));
  CloudBatch batch;
  static_cast<PointCloud&>(batch) = placed.cloud;
  if (auto added = file.add(batch); !added) return std::unexpected(added.error());
  if (auto written = file.commit(); !written) return std::unexpected(written.error());
  return file.keeps_offset();
}

}  // namespace hybridfusion
