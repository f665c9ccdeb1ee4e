#include "placed_readers.hpp"
#include "text.hpp"
#include "xyz.hpp"

#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/pcd.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] std::string extension_of(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

[[nodiscard]] bool is_text_cloud(std::string_view extension) {
  return extension == ".xyz" || extension == ".txt" || extension == ".csv" || extension == ".pts";
}

[[nodiscard]] std::unexpected<Error> not_read(const std::filesystem::path& path) {
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("{}: clouds are read from .ply, .pcd, .las, .xyz, .txt, .csv and .pts, "
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
  const std::string extension = extension_of(path);
  if (extension == ".ply") return read_placed_ply(path);
  if (extension == ".pcd") return read_placed_pcd(path);
  if (extension == ".las") return read_las(path);
  if (is_text_cloud(extension)) return read_placed_xyz(path);
  return not_read(path);
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
  const std::string extension = extension_of(path);
  Expected<void> written;
  const bool keeps_offset = extension == ".xyz" || extension == ".las";
  if (extension == ".xyz") {
    written = write_xyz(path, placed.cloud, placed.offset_m);
  } else if (extension == ".las") {
    written = write_las(path, placed.cloud, {.offset_m = placed.offset_m, .wkt = placed.crs.wkt});
  } else {
    written = write_point_cloud(path, placed.cloud);
  }
  if (!written) return std::unexpected(written.error());
  return keeps_offset || placed.offset_m.isZero();
}

}  // namespace hybridfusion
