#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/triangle_mesh.hpp>
#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/point_scalar.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hybridfusion {

enum class PlyFormat : std::uint8_t { kBinaryLittleEndian, kAscii };

struct PlyWriteOptions {
  PlyFormat format = PlyFormat::kBinaryLittleEndian;
  std::vector<std::string> comments = {};  ///< One header line each; line breaks become spaces.
  /// Names of scalars begin with "scalar_"; CloudCompare 2.11 drops all others.
  bool scalar_prefix = false;
};

/// Scalar vertex columns by name, e.g. label, drone and vehicle of truth/samples.ply.
struct PlyTable {
  std::vector<std::string> names = {};
  std::vector<std::vector<double>> columns = {};  ///< One per name, all of the same length.

  /// nullptr when there is no such column.
  [[nodiscard]] const std::vector<double>* find(std::string_view name) const;
  [[nodiscard]] std::size_t size() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Reads a PLY cloud: ascii or binary of either byte order, properties of any order and type, other
/// elements skipped. x y z are required; nx ny nz, red green blue (also diffuse_*, r g b),
/// intensity (also scalar_intensity, any case), time, sigma, confidence and source fill the
/// channels of that name.
/// @returns kNotFound for a missing file; kParse, naming the file, the cause and the next step, for
/// an empty, truncated or non-PLY file and for one without a finite point; others are dropped.
[[nodiscard]] Expected<PointCloud> read_ply(const std::filesystem::path& path);

/// Reads the same points in the same order in clouds of at most `batch_points`, so that a file
/// larger than memory can be worked through. Points before an error have been visited.
/// @pre batch_points > 0. @returns errors as read_ply, and those of `visit`, which ends the
/// reading.
[[nodiscard]] Expected<void> read_ply_batches(
    const std::filesystem::path& path,
    std::size_t batch_points,
    const std::function<Expected<void>(PointCloud&&)>& visit);

/// Vertices and faces; polygons become fans; a scalar face property `label` fills the labels.
[[nodiscard]] Expected<TriangleMesh> read_ply_mesh(const std::filesystem::path& path);

/// Every scalar property of the vertex element.
[[nodiscard]] Expected<PlyTable> read_ply_columns(const std::filesystem::path& path);

/// Writes the channels the cloud has. @pre validate(cloud)
[[nodiscard]] Expected<void> write_ply(const std::filesystem::path& path,
                                       const PointCloud& cloud,
                                       const PlyWriteOptions& options = {});

/// A PLY cloud that comes in pieces: like write_ply of their concatenation, without holding
/// it. The file appears when commit() is called.
class PlyPieceWriter {
 public:
  /// @returns kIo.
  [[nodiscard]] static Expected<PlyPieceWriter> create(
      const std::filesystem::path& path,
      PlyFormat format = PlyFormat::kBinaryLittleEndian,
      bool scalar_prefix = false);
  /// @pre validate(piece); every piece has the channels of the first.
  void add(const PointCloud& piece);
  void add(const CloudBatch& piece);
  [[nodiscard]] std::size_t size() const { return num_points_; }
  /// @returns kIo.
  [[nodiscard]] Expected<void> commit();

 private:
  PlyPieceWriter(AtomicFile file, PlyWriteOptions options)
      : file_(std::move(file)), options_(std::move(options)) {}
  void add_rows(const PointCloud& piece, std::span<const PointScalar> scalars);

  AtomicFile file_;
  PlyWriteOptions options_;
  std::size_t num_points_ = 0;
  CloudBatch channels_ = {};  // one point with the channels of all
};

}  // namespace hybridfusion
