#include "las_output.hpp"
#include "pcd_output.hpp"
#include "text.hpp"
#include "xyz.hpp"

#include <hybridfusion/io/cloud_writer.hpp>
#include <hybridfusion/io/ply.hpp>

#include <concepts>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace hybridfusion {

struct CloudWriter::State {
  std::variant<PlyPieceWriter, PcdPieceWriter, LasPieceWriter, XyzPieceWriter> file;
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
};

CloudWriter::CloudWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
CloudWriter::CloudWriter(CloudWriter&&) noexcept = default;
CloudWriter& CloudWriter::operator=(CloudWriter&&) noexcept = default;
CloudWriter::~CloudWriter() = default;

namespace {

[[nodiscard]] Eigen::Vector3d units_of(const CrsDescription& crs) {
  return {crs.metres_per_unit, crs.metres_per_unit, crs.vertical_metres_per_unit};
}

/// In the coordinates of the file, which have no offset.
[[nodiscard]] Viewpoint local_viewpoint(const CloudSurvey& survey) {
  Viewpoint viewpoint = survey.viewpoint;
  if (viewpoint == kNoViewpoint) return viewpoint;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    viewpoint[axis] -= survey.offset_m[static_cast<int>(axis)];
  }
  return viewpoint;
}

[[nodiscard]] std::unexpected<Error> no_such_encoding(const std::filesystem::path& path) {
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("{}: this format has no such encoding; ascii and binary are for .ply and "
                          ".pcd, compressed is for .pcd",
                          path.string()));
}

}  // namespace

Expected<CloudWriter> CloudWriter::create(const std::filesystem::path& path,
                                          const CloudSurvey& survey,
                                          const CloudFormat& format) {
  const CloudEncoding encoding = format.encoding;
  const std::string extension = lower_case(path.extension().string());
  const auto made = [&survey](auto file) {
    return CloudWriter(std::make_unique<State>(State{std::move(file), survey.offset_m}));
  };
  if (extension == ".pcd") {
    HF_TRY(PcdPieceWriter pcd,
           PcdPieceWriter::create(path, survey.num_points, encoding, local_viewpoint(survey)));
    return made(std::move(pcd));
  }
  if (extension == ".ply") {
    if (encoding == CloudEncoding::kCompressed) return no_such_encoding(path);
    const PlyFormat ply_format =
        encoding == CloudEncoding::kAscii ? PlyFormat::kAscii : PlyFormat::kBinaryLittleEndian;
    HF_TRY(PlyPieceWriter ply, PlyPieceWriter::create(path, ply_format, format.ply_scalar_prefix));
    return made(std::move(ply));
  }
  if (extension == ".xyz" || extension == ".las") {
    if (encoding != CloudEncoding::kDefault) return no_such_encoding(path);
    if (extension == ".xyz") {
      HF_TRY(XyzPieceWriter xyz,
             XyzPieceWriter::create(
                 path,
                 survey.offset_m,
                 format.text_in_crs_units ? units_of(survey.crs) : Eigen::Vector3d::Ones()));
      return made(std::move(xyz));
    }
    HF_TRY(LasPieceWriter las,
           LasPieceWriter::create(
               path,
               {.offset = survey.offset_m,
                .units_m = survey.crs.wkt.empty() ? Eigen::Vector3d::Ones() : units_of(survey.crs),
                .intensity_factor = las_intensity_factor(survey.largest_intensity),
                .wkt = survey.crs.wkt,
                .version = format.las_version}));
    return made(std::move(las));
  }
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("{}: clouds are written to .ply, .pcd, .xyz and .las, not '{}'",
                          path.string(),
                          extension));
}

Expected<void> CloudWriter::add(const CloudBatch& batch) {
  const auto to_world = [this](const Eigen::Vector3f& point) -> Expected<Eigen::Vector3d> {
    return Eigen::Vector3d(point.cast<double>() + state_->offset_m);
  };
  return std::visit(
      [&](auto& file) -> Expected<void> {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(file)>, LasPieceWriter>) {
          return file.add(batch, to_world);
        } else {
          file.add(batch);
          return {};
        }
      },
      state_->file);
}

Expected<void> CloudWriter::commit() {
  return std::visit([](auto& file) { return file.commit(); }, state_->file);
}

bool CloudWriter::keeps_offset() const {
  return state_->offset_m.isZero() || std::holds_alternative<LasPieceWriter>(state_->file) ||
         std::holds_alternative<XyzPieceWriter>(state_->file);
}

}  // namespace hybridfusion
