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
                                                       CloudEncoding encoding,
                                                       const Viewpoint& viewpoint = kNoViewpoint);
  /// @pre validate(piece); every piece has the channels of the first.
  void add(const CloudBatch& piece);
  [[nodiscard]] Expected<void> commit();

 private:
  PcdPieceWriter(AtomicFile file,
                 std::uint64_t num_points,
                 CloudEncoding encoding,
                 const Viewpoint& viewpoint)
      : file_(std::move(file)),
        num_points_(num_points),
        encoding_(encoding),
        viewpoint_(viewpoint) {}
  void start(const CloudBatch& channels);

  AtomicFile file_;
  std::uint64_t num_points_;
  CloudEncoding encoding_;
  Viewpoint viewpoint_;
  std::optional<PcdFormat> format_ = {};  ///< Known with the channels of the first piece.
  CloudBatch whole_ = {};                 ///< Compressed files only.
};

}  // namespace hybridfusion
