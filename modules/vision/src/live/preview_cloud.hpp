#pragma once

#include "dense/voxel_table.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Points that one photo saw, in its own frame: they follow it when its pose changes.
struct PhotoPoints {
  std::vector<Eigen::Vector3f> in_camera = {};
  std::vector<Rgb8> colors = {};
};

/// A cloud of voxels that grows by photos and stays below a number of points.
class PreviewCloud {
 public:
  /// @pre max_points > 0
  explicit PreviewCloud(std::size_t max_points) : max_points_(max_points) {}

  /// Spacing before it was doubled. Nothing may be added before it is set. @pre voxel_m > 0
  void set_voxel(double voxel_m) { voxel_m_ = voxel_m; }
  [[nodiscard]] bool has_voxel() const { return voxel_m_ > 0.0; }
  void add(PhotoPoints points, const Rigid3& enu_from_camera);
  /// Makes the cloud anew with other poses. @param poses  One per photo, in the order of add().
  /// @param scale  Of lengths, by which the poses moved.
  void move(const std::vector<Rigid3>& poses, double scale);

  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  [[nodiscard]] std::size_t num_photos() const { return photos_.size(); }
  [[nodiscard]] double voxel_m() const { return voxel_m_; }
  /// Mean position and colour of each voxel, `confidences` = points merged; ascending voxel order.
  [[nodiscard]] PointCloud cloud() const;

 private:
  void merge(const PhotoPoints& points, const Rigid3& enu_from_camera);
  void rebuild();

  std::size_t max_points_;
  double voxel_m_ = 0.0;
  std::vector<PhotoPoints> photos_ = {};
  std::vector<Rigid3> poses_ = {};
  VoxelTable voxels_ = {};
};

}  // namespace hybridfusion
