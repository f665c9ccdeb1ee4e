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

}  // namespace

Expected<PointCloud> read_point_cloud(const std::filesystem::path& path) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return read_ply(path);
  if (extension == ".pcd") return read_pcd(path);
  if (is_text_cloud(extension)) return read_xyz(path);
  return fail(
      ErrorCode::kInvalidOptions,
      fmt::format("{}: clouds are read from .ply, .pcd, .xyz, .txt, .csv and .pts, not '{}'; "
                  "convert the cloud",
                  path.string(),
                  extension));
}

Expected<void> write_point_cloud(const std::filesystem::path& path,
                                 const PointCloud& cloud,
                                 const std::optional<GeodeticOrigin>& origin) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return write_ply(path, cloud);
  if (extension == ".pcd") return write_pcd(path, cloud);
  if (extension == ".xyz") return write_xyz(path, cloud);
  if (extension == ".las") {
    LasWriteOptions options;
    if (origin) options.georeference = LasGeoreference{.origin = *origin};
    return write_las(path, cloud, options);
  }
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("{}: clouds are written to .ply, .pcd, .xyz and .las, not '{}'",
                          path.string(),
                          extension));
}

}  // namespace hybridfusion
