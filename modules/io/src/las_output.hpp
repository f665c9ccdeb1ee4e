#pragma once

#include "las_attributes.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/las.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

inline constexpr double kLasScale_m = 0.001;

/// Where the point lies in the coordinates of the file [m].
using LasWorld = std::function<Expected<Eigen::Vector3d>(const Eigen::Vector3f&)>;

/// What the numbers of a LAS file are relative to.
struct LasScaling {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();   ///< Of the coordinates [m].
  Eigen::Vector3d units_m = Eigen::Vector3d::Ones();  ///< Of the coordinates of the file.
  float intensity_factor = 1.0F;
  std::string wkt = {};
  LasVersion version = LasVersion::k14;
};

/// Factor that brings intensities into 16 bits: 0..1 is stretched, larger ranges are compressed.
[[nodiscard]] float las_intensity_factor(float largest);

/// A field behind those that the point format has.
struct LasExtraOutput {
  std::string name = {};
  std::string description = {};
  ScalarType type = ScalarType::kUint8;
  std::function<double(const CloudBatch&, std::size_t)> value = {};
};

/// What the points of a file have, by the first of them.
struct LasChannels {
  bool colors = false;
  std::vector<std::pair<double LasAttributes::*, std::size_t>> attributes = {};  ///< And scalar.
  std::optional<std::size_t> gps_time = {};                                      ///< Scalar.
  std::vector<LasExtraOutput> extra = {};
};

/// A LAS file as write_las() makes it, that comes in pieces. It appears when commit() is called.
class LasPieceWriter {
 public:
  /// @returns kIo.
  [[nodiscard]] static Expected<LasPieceWriter> create(const std::filesystem::path& path,
                                                       LasScaling scaling);
  /// @pre validate(piece); every piece has the channels of the first. @returns errors of
  /// `to_world`; kDegenerate for a point too far from the offset and for more points than the
  /// version can count.
  [[nodiscard]] Expected<void> add(const CloudBatch& piece, const LasWorld& to_world);
  /// @returns kInsufficient when there were no points; kIo.
  [[nodiscard]] Expected<void> commit();

 private:
  LasPieceWriter(std::filesystem::path path, AtomicFile file, LasScaling scaling)
      : path_(std::move(path)), file_(std::move(file)), scaling_(std::move(scaling)) {}
  /// Header and variable length records; always of the same length.
  [[nodiscard]] std::string start() const;

  std::filesystem::path path_;
  AtomicFile file_;
  LasScaling scaling_;
  std::uint64_t num_points_ = 0;
  LasChannels channels_ = {};
  double largest_gps_time_s_ = 0.0;
  Eigen::Vector3i low_ = Eigen::Vector3i::Constant(std::numeric_limits<int>::max());
  Eigen::Vector3i high_ = Eigen::Vector3i::Constant(std::numeric_limits<int>::min());
};

}  // namespace hybridfusion
