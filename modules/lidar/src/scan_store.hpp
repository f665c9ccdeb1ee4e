#pragma once

#include <hybridfusion/core/spill_file.hpp>
#include <hybridfusion/lidar/odometry.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hybridfusion {

/// A point in 12 bytes: coordinates on a 1 mm grid within +-1048 m, intensity with 8 significant
/// bits, time in 1/65535 of the scan.
struct PackedPoint {
  std::uint32_t xy_low = 0;
  std::uint32_t xy_high_z = 0;
  std::uint16_t intensity = 0;
  std::uint16_t time = 0;
};

struct UnpackedPoint {
  Eigen::Vector3f point_in_imu = Eigen::Vector3f::Zero();  ///< IMU frame at scan end [m].
  float intensity = 0.0F;
  float share = 1.0F;  ///< 0 at the scan's first point, 1 at its last.
};

[[nodiscard]] PackedPoint pack(const UnpackedPoint& point);
[[nodiscard]] UnpackedPoint unpack(const PackedPoint& point);

/// A located scan without its points.
struct StoredScan {
  Timestamp begin{};
  Timestamp time{};  ///< Scan end.
  Rigid3 map_from_imu = {};
  Eigen::Vector3d gravity_in_imu = Eigen::Vector3d::Zero();
  double gravity_sigma_rad = 0.0;  ///< 0: not measured.
  ImuIncrement since_last = {};
  Eigen::Vector3f lidar_in_imu = Eigen::Vector3f::Zero();  ///< [m]
  SpillFile::Block block = {};                             ///< Its points in the store.
  std::size_t num_points = 0;
  std::uint32_t flags = 0;
};

/// All located scans of a recording with their deskewed points, for what is done when it is over.
/// The points go to `spill`.
class ScanStore {
 public:
  /// Keeps every n-th point of scans with more than `max_points_per_scan`.
  explicit ScanStore(int max_points_per_scan, SpillFile spill = {});

  /// @returns kIo.
  [[nodiscard]] Expected<void> add(const ScanEstimate& scan);
  [[nodiscard]] const std::vector<StoredScan>& scans() const { return scans_; }
  [[nodiscard]] std::vector<StoredScan>& scans() { return scans_; }
  /// Reuses `out`. May run on several threads at once. @returns kIo.
  [[nodiscard]] Expected<void> read(const StoredScan& scan, std::vector<PackedPoint>& out) const;
  /// Another place of the same kind as that of the points. @returns kIo.
  [[nodiscard]] Expected<SpillFile> new_spill() const { return spill_.another(); }

 private:
  std::size_t max_points_per_scan_;
  std::vector<StoredScan> scans_ = {};
  SpillFile spill_;
};

}  // namespace hybridfusion
