#include "moving_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxScans = 40;
// Farther away the rays are too far apart to hit the same place twice.
constexpr float kMaxRange_m = 25.0F;
constexpr double kMaxDistance_m = 43.0;
constexpr int kColumns = 360;
constexpr int kRows = 90;  // -45 .. 45 degrees
// A ray that ends this much behind a place went through it.
constexpr float kMinBehind_m = 0.5F;
constexpr float kMinBehindShare = 0.04F;

/// The rays of a scan by direction, one in each square degree.
class RayImage {
 public:
  RayImage(const StoredScan& scan, const StoredScan& before, const std::vector<PackedPoint>& points)
      : rays_(static_cast<std::size_t>(kColumns) * kRows) {
    // Where the LiDAR was while it turned: between the ends of this scan and the one before.
    const Eigen::Vector3f moved =
        (scan.map_from_imu.inverse() * before.map_from_imu).translation.cast<float>();
    const double period_s = to_seconds(scan.time - before.time);
    const double span_s = to_seconds(scan.time - scan.begin);
    const auto share = static_cast<float>(period_s > 0.0 ? std::min(1.0, span_s / period_s) : 0.0);
    center_ = scan.lidar_in_imu + 0.5F * share * moved;
    for (const PackedPoint& packed : points) {
      const UnpackedPoint point = unpack(packed);
      const Eigen::Vector3f origin = scan.lidar_in_imu + (1.0F - point.share) * share * moved;
      const Eigen::Vector3f ray = point.point_in_imu - origin;
      const int row = row_of(ray);
      if (row < 0 || row >= kRows) continue;
      Ray& stored = rays_[index(row, column_of(ray))];
      const float length = ray.norm();
      if (length > stored.length) {
        stored = {.origin = origin, .direction = ray / length, .length = length};
      }
    }
  }

  [[nodiscard]] bool sees_through(const Eigen::Vector3f& point_in_imu, float tolerance_m) const {
    const Eigen::Vector3f direction = point_in_imu - center_;
    if (direction.squaredNorm() > kMaxRange_m * kMaxRange_m) return false;
    const int row = row_of(direction);
    const int column = column_of(direction);
    for (int r = std::max(0, row - 1); r <= std::min(kRows - 1, row + 1); ++r) {
      for (const int turn : {kColumns - 1, 0, 1}) {
        const Ray& ray = rays_[index(r, (column + turn) % kColumns)];
        const Eigen::Vector3f d = point_in_imu - ray.origin;
        const float along = d.dot(ray.direction);
        if (along > 0.0F && ray.length > along + std::max(kMinBehind_m, kMinBehindShare * along) &&
            (d - along * ray.direction).norm() < tolerance_m) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  struct Ray {
    Eigen::Vector3f origin = Eigen::Vector3f::Zero();
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
    float length = 0.0F;  // 0: none
  };

  static constexpr float kDegrees = 180.0F / std::numbers::pi_v<float>;
  static int row_of(const Eigen::Vector3f& d) {
    const float elevation = std::atan2(d.z(), d.head<2>().norm()) * kDegrees;
    return static_cast<int>(std::floor(elevation)) + kRows / 2;
  }
  static int column_of(const Eigen::Vector3f& d) {
    const float azimuth = std::atan2(d.y(), d.x()) * kDegrees;
    return (static_cast<int>(std::floor(azimuth)) + kColumns) % kColumns;
  }
  static std::size_t index(int row, int column) {
    return static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
  }

  Eigen::Vector3f center_ = Eigen::Vector3f::Zero();
  std::vector<Ray> rays_;
};

std::vector<std::size_t> scans_near(const std::vector<StoredScan>& scans,
                                    const Eigen::Vector2d& center_m) {
  std::vector<std::size_t> near;
  for (std::size_t s = 1; s < scans.size(); ++s) {
    if ((scans[s].map_from_imu.translation.head<2>() - center_m).norm() < kMaxDistance_m) {
      near.push_back(s);
    }
  }
  if (near.size() <= kMaxScans) return near;
  std::vector<std::size_t> spread;
  for (std::size_t i = 0; i < kMaxScans; ++i) spread.push_back(near[i * near.size() / kMaxScans]);
  return spread;
}

}  // namespace

Expected<std::size_t> drop_moving(const DenseMapOptions& options,
                                  const ScanStore& store,
                                  const Eigen::Vector2d& center_m,
                                  DenseMap& map) {
  const std::vector<std::uint32_t> brief = map.brief_voxels();
  if (brief.empty()) return 0;
  const std::vector<StoredScan>& scans = store.scans();
  std::vector<int> through(brief.size(), 0);
  std::vector<PackedPoint> points;
  const auto tolerance_m = static_cast<float>(0.7 * options.voxel_m);
  for (const std::size_t s : scans_near(scans, center_m)) {
    if (auto read = store.read(scans[s], points); !read) return std::unexpected(read.error());
    const RayImage image(scans[s], scans[s - 1], points);
    const Rigid3 imu_from_map = scans[s].map_from_imu.inverse();
    const Eigen::Matrix3f rotation = imu_from_map.rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f translation = imu_from_map.translation.cast<float>();
    for (std::size_t i = 0; i < brief.size(); ++i) {
      if (through[i] >= options.min_rays_through) continue;
      if (image.sees_through(rotation * map.mean(brief[i]) + translation, tolerance_m)) {
        ++through[i];
      }
    }
  }
  std::size_t num_dropped = 0;
  for (std::size_t i = 0; i < brief.size(); ++i) {
    if (through[i] < options.min_rays_through) continue;
    map.drop(brief[i]);
    ++num_dropped;
  }
  return num_dropped;
}

}  // namespace hybridfusion
