#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/cloud_writer.hpp>
#include <hybridfusion/io/pcd.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace hybridfusion {

/// A PCD file that comes in pieces. It appears when commit() is called.
class PcdPieceWriter {
 public:
  /// @param num_points  Of all pieces together.
  /// @returns kIo.
  [[nodiscard]] static Expected<PcdPieceWriter> create(const std::filesystem::path& path,
                                                       std::uint64_t num_points,
                                                       CloudEncoding encoding);
  /// @pre validate(piece); every piece has the channels of the first.
  void add(const PointCloud& piece);
  [[nodiscard]] Expected<void> commit();

 private:
  PcdPieceWriter(AtomicFile file, std::uint64_t num_points, CloudEncoding encoding)
      : file_(std::move(file)), num_points_(num_points), encoding_(encoding) {}
  void start(const PointCloud& channels);

  AtomicFile file_;
  std::uint64_t num_points_;
  CloudEncoding encoding_;
  std::optional<PcdFormat> format_ = {};  ///< Known with the channels of the first piece.
  PointCloud whole_ = {};                 ///< Compressed files only.
};

}  // namespace hybridfusion
