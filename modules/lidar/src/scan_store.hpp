#pragma once

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
  double gravity_sigma_rad = 0.0;
  ImuIncrement since_last = {};
  std::size_t block = 0;  ///< Of its points in the store.
  std::size_t num_points = 0;
  std::uint32_t flags = 0;
};

/// All located scans of a recording with their deskewed points, for what is done when it is over.
class ScanStore {
 public:
  /// Keeps every n-th point of scans with more than `max_points_per_scan`.
  explicit ScanStore(int max_points_per_scan);

  void add(const ScanEstimate& scan);
  [[nodiscard]] const std::vector<StoredScan>& scans() const { return scans_; }
  [[nodiscard]] std::vector<StoredScan>& scans() { return scans_; }
  [[nodiscard]] std::span<const PackedPoint> points_of(const StoredScan& scan) const;
  /// Gives the memory of a scan's points back.
  void drop_points(const StoredScan& scan);

 private:
  std::size_t max_points_per_scan_;
  std::vector<StoredScan> scans_ = {};
  // One block a scan: a single growing array would copy itself and double the peak.
  std::vector<std::vector<PackedPoint>> points_ = {};
};

}  // namespace hybridfusion
