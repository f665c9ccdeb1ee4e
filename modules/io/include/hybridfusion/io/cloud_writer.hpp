#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/cloud_stream.hpp>
#include <hybridfusion/io/las.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>

namespace hybridfusion {

/// How the points of a .ply or .pcd file are stored.
enum class CloudEncoding : std::uint8_t {
  kDefault,  ///< Binary; .pcd compressed as long as the points fit in 64 MiB.
  kAscii,
  kBinary,
  kCompressed  ///< .pcd only; needs memory for the whole cloud.
};

/// What a format leaves open.
struct CloudFormat {
  CloudEncoding encoding = CloudEncoding::kDefault;
  LasVersion las_version = LasVersion::k14;
  bool ply_scalar_prefix = false;  ///< "scalar_" before the names, for CloudCompare 2.11.
  bool text_in_crs_units = false;  ///< .xyz counts as the CRS does (feet), not in metres.
};

/// Writes a cloud that comes in batches, in memory for one of them but for a compressed .pcd. The
/// file appears when commit() is called.
class CloudWriter {
 public:
  /// @param path    .ply, .pcd, .xyz or .las. .las and .xyz get the coordinates with the offset
  ///                (and .las the CRS, when it is metric), .ply and .pcd those without.
  /// @param survey  Of the cloud that is written.
  /// @returns kInvalidOptions for another extension or an encoding that the file format does not
  /// have; kIo.
  [[nodiscard]] static Expected<CloudWriter> create(const std::filesystem::path& path,
                                                    const CloudSurvey& survey,
                                                    const CloudFormat& format);
  CloudWriter(CloudWriter&&) noexcept;
  CloudWriter& operator=(CloudWriter&&) noexcept;
  ~CloudWriter();

  /// @pre validate(batch); every batch has the channels of the first.
  /// @returns kDegenerate for a point that the format cannot hold.
  [[nodiscard]] Expected<void> add(const CloudBatch& batch);
  /// @returns kIo; kInsufficient when there were no points and the format needs some.
  [[nodiscard]] Expected<void> commit();
  /// Whether the coordinates in the file have the offset of the survey in them.
  [[nodiscard]] bool keeps_offset() const;

 private:
  struct State;
  explicit CloudWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion
