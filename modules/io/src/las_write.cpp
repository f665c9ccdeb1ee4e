#include "crs.hpp"
#include "las_output.hpp"

#include <hybridfusion/io/las.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Whole metres below all points.
Expected<Eigen::Vector3d> lowest_metre(const PointCloud& cloud, const LasWorld& to_world) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (const Eigen::Vector3f& point : cloud.points) {
    HF_TRY(const Eigen::Vector3d world, to_world(point));
    low = low.cwiseMin(world);
    high = high.cwiseMax(world);
  }
  // 2^31 steps of a millimetre; also false for NaN.
  constexpr double kMaxExtent_m = 2.1e6;
  if (!((high - low).maxCoeff() < kMaxExtent_m)) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("the cloud extends over {:g} m, more than LAS can hold in millimetres ({:g}); "
                    "remove far or non-finite points",
                    (high - low).maxCoeff(),
                    kMaxExtent_m));
  }
  return Eigen::Vector3d(low.array().floor());
}

}  // namespace

Expected<void> write_las(const std::filesystem::path& path,
                         const PointCloud& cloud,
                         const LasWriteOptions& options) {
  HF_CHECK(validate(cloud).has_value());
  if (cloud.empty()) {
    return fail(ErrorCode::kInsufficient, fmt::format("{}: no points to write", path.string()));
  }
  HF_CHECK(!options.georeference || (options.wkt.empty() && options.offset_m.isZero()));
  std::optional<EnuToProjected> projection;
  if (options.georeference) {
    HF_TRY(projection,
           EnuToProjected::create(options.georeference->origin, options.georeference->crs));
  }
  const LasWorld to_world = [&](const Eigen::Vector3f& point) -> Expected<Eigen::Vector3d> {
    if (!projection) return Eigen::Vector3d(point.cast<double>() + options.offset_m);
    return (*projection)(point.cast<double>());
  };
  const Eigen::Vector3d units_m =
      projection ? projection->units_m() : Eigen::Vector3d(Eigen::Vector3d::Ones());
  HF_TRY(const Eigen::Vector3d offset, lowest_metre(cloud, to_world));
  const float largest = cloud.intensities.empty() ? 0.0F : std::ranges::max(cloud.intensities);
  HF_TRY(LasPieceWriter file,
         LasPieceWriter::create(path,
                                {.offset = offset,
                                 .units_m = units_m,
                                 .intensity_factor = las_intensity_factor(largest),
                                 .wkt = projection ? projection->wkt() : options.wkt,
                                 .version = options.version}));
  // In pieces, so that a large cloud is not copied as a whole.
  constexpr std::size_t kPiecePoints = std::size_t{1} << 16U;
  std::vector<std::size_t> indices;
  for (std::size_t begin = 0; begin < cloud.size(); begin += kPiecePoints) {
    indices.resize(std::min(kPiecePoints, cloud.size() - begin));
    std::iota(indices.begin(), indices.end(), begin);
    CloudBatch piece;
    static_cast<PointCloud&>(piece) = select(cloud, indices);
    if (auto added = file.add(piece, to_world); !added) return added;
  }
  return file.commit();
}

}  // namespace hybridfusion
