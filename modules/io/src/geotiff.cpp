#include "crs_units.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/surface_raster.hpp>

#include <array>
#include <cmath>
#include <memory>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

namespace hybridfusion {
namespace {

constexpr float kNoData = -9999.0F;

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// A file in GDAL's memory, removed at the end.
class MemoryFile {
 public:
  explicit MemoryFile(const void* owner) : name_(fmt::format("/vsimem/hybridfusion-{}", owner)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { VSIUnlink(name_.c_str()); }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string_view bytes() const {
    vsi_l_offset size = 0;
    const GByte* const data = VSIGetMemFileBuffer(name_.c_str(), &size, 0);
    if (data == nullptr) return {};
    return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
  }

 private:
  std::string name_;
};

[[nodiscard]] std::unexpected<Error> refused(const std::filesystem::path& path) {
  return fail(ErrorCode::kIo,
              fmt::format("{}: GDAL cannot make the raster: {}; take larger cells",
                          path.string(),
                          CPLGetLastErrorMsg()));
}

[[nodiscard]] Dataset create(const SurfaceRaster& raster,
                             const std::string& name,
                             int bands,
                             GDALDataType type) {
  GDALRegister_GTiff();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr) return nullptr;
  const CPLStringList options(std::array<const char*, 5>{
      "COMPRESS=DEFLATE", "TILED=YES", "BIGTIFF=IF_SAFER", "INTERLEAVE=PIXEL", nullptr}
                                  .data());
  Dataset dataset(
      driver->Create(name.c_str(), raster.columns, raster.rows, bands, type, options.List()));
  if (!dataset) return nullptr;
  const double cell = raster.cell_m / raster.metres_per_unit;
  const Eigen::Vector2d corner = raster.north_west / raster.metres_per_unit;
  std::array<double, 6> transform = {corner.x(), cell, 0.0, corner.y(), 0.0, -cell};
  if (dataset->SetGeoTransform(transform.data()) != CE_None) return nullptr;
  OGRSpatialReference system;
  if (!raster.wkt.empty() && system.importFromWkt(raster.wkt.c_str()) == OGRERR_NONE &&
      dataset->SetSpatialRef(&system) != CE_None) {
    return nullptr;
  }
  return dataset;
}

/// Name of the unit of the heights. GDAL 3.6 drops one that the vertical system has too, and with
/// it readers that do not look there lose the unit; another spelling stays.
[[nodiscard]] std::string height_unit(const SurfaceRaster& raster) {
  const std::string name = unit_name(raster.vertical_metres_per_unit);
  OGRSpatialReference system;
  const bool compound = !raster.wkt.empty() &&
                        system.importFromWkt(raster.wkt.c_str()) == OGRERR_NONE &&
                        system.IsCompound() != 0;
  if (!compound) return name;
  if (name == "metre") return "m";
  if (name == "foot") return "ft";
  return name == "US survey foot" ? "ftUS" : name;
}

/// Row by row through `value_of(cell)`.
template <class Value, class ValueOf>
[[nodiscard]] bool write_band(GDALDataset& dataset,
                              int band,
                              const SurfaceRaster& raster,
                              GDALDataType type,
                              ValueOf&& value_of) {
  std::vector<Value> line(static_cast<std::size_t>(raster.columns));
  std::size_t cell = 0;
  for (int row = 0; row < raster.rows; ++row) {
    for (Value& value : line) value = value_of(cell++);
    if (dataset.GetRasterBand(band)->RasterIO(GF_Write,
                                              0,
                                              row,
                                              raster.columns,
                                              1,
                                              line.data(),
                                              raster.columns,
                                              1,
                                              type,
                                              0,
                                              0,
                                              nullptr) != CE_None) {
      return false;
    }
  }
  return true;
}

}  // namespace

Expected<void> write_dsm(const std::filesystem::path& path, const SurfaceRaster& raster) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  const MemoryFile memory(&raster);
  Dataset dataset = create(raster, memory.name(), 1, GDT_Float32);
  if (!dataset) return refused(path);
  dataset->GetRasterBand(1)->SetNoDataValue(kNoData);
  dataset->GetRasterBand(1)->SetUnitType(height_unit(raster).c_str());
  const bool written =
      write_band<float>(*dataset, 1, raster, GDT_Float32, [&raster](std::size_t cell) {
        const float height_m = raster.heights_m[cell];
        return std::isnan(height_m)
                   ? kNoData
                   : static_cast<float>(height_m / raster.vertical_metres_per_unit);
      });
  dataset.reset();  // flushes
  if (!written) return refused(path);
  return write_file_atomically(path, memory.bytes());
}

Expected<void> write_orthophoto(const std::filesystem::path& path, const SurfaceRaster& raster) {
  if (raster.colors.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: the cloud has no colours; give one that has", path.string()));
  }
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  const MemoryFile memory(&raster);
  Dataset dataset = create(raster, memory.name(), 4, GDT_Byte);
  if (!dataset) return refused(path);
  constexpr std::array<GDALColorInterp, 4> kMeaning = {
      GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand};
  bool written = true;
  for (int band = 0; band < 4 && written; ++band) {
    const auto k = static_cast<std::size_t>(band);
    dataset->GetRasterBand(band + 1)->SetColorInterpretation(kMeaning[k]);
    written = write_band<std::uint8_t>(
        *dataset, band + 1, raster, GDT_Byte, [&raster, k](std::size_t cell) -> std::uint8_t {
          const bool seen = !std::isnan(raster.heights_m[cell]);
          if (k == 3) return seen ? 255 : 0;
          return seen ? raster.colors[cell][k] : std::uint8_t{0};
        });
  }
  dataset.reset();
  if (!written) return refused(path);
  return write_file_atomically(path, memory.bytes());
}

}  // namespace hybridfusion
