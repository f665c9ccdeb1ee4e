#pragma once

#include <hybridfusion/viewer/octree.hpp>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace hybridfusion {

/// A point on its way into the tree.
struct OctreePoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  Rgb8 color = {};
  PointSource source = PointSource::kVision;
  float intensity = 0.0F;
  float distance_m = 0.0F;
};

/// Which channels the cloud has, and their ranges.
struct OctreeAttributes {
  bool has_intensity = false;
  bool has_source = false;
  bool has_distance = false;
  float max_intensity = 0.0F;
  float max_distance_m = 0.0F;

  [[nodiscard]] std::size_t bytes_per_point() const {
    return 12U + 6U + (has_intensity ? 2U : 0U) + (has_source ? 1U : 0U) + (has_distance ? 4U : 0U);
  }
};

/// Cube of a node.
struct OctreeCube {
  Eigen::Vector3d min_m = Eigen::Vector3d::Zero();
  double side_m = 1.0;

  [[nodiscard]] int octant_of(const Eigen::Vector3f& point) const;
  [[nodiscard]] OctreeCube child(int octant) const;
};

/// Remembers which cells of a node's grid hold a point.
class CellGrid {
 public:
  CellGrid(const OctreeCube& cube, int cells_per_side);
  /// True for the first point of its cell.
  [[nodiscard]] bool take(const Eigen::Vector3f& point);

 private:
  OctreeCube cube_;
  int cells_;
  std::vector<bool> taken_;
};

/// Points waiting on disk; the file has no name and vanishes with the object.
class PointSpill {
 public:
  [[nodiscard]] static Expected<PointSpill> create(const std::filesystem::path& folder);

  [[nodiscard]] Expected<void> add(const OctreePoint& point);
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Calls `visit` for each point, in the order of add().
  [[nodiscard]] Expected<void> for_each(
      const std::function<Expected<void>(const OctreePoint&)>& visit);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  explicit PointSpill(std::unique_ptr<std::FILE, Close> file) : file_(std::move(file)) {}
  [[nodiscard]] Expected<void> flush();

  std::unique_ptr<std::FILE, Close> file_;
  std::vector<OctreePoint> buffer_ = {};
  std::size_t size_ = 0;
};

}  // namespace hybridfusion
