#pragma once

#include "local_map.hpp"
#include "nav_state.hpp"

#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/lidar/filter_options.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< Unit.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
  double sigma_m = 0.0;                              ///< Of the neighbours about it.
};

/// Plane through neighbours by their centred covariance and its smallest eigenvector; nothing when
/// one is farther off it than `max_offset_m`, they lie along a line or are no thinner than broad.
[[nodiscard]] std::optional<Plane> fit_plane(const MapNeighbors& neighbors, double max_offset_m);

/// True for a ray that runs (nearly) within the plane. One scanning plane over rough ground (window
/// reveals, leaves) leaves points that lie in a plane, but it is the scanner's, not the world's: it
/// would hold the sensor to where it was. Real surfaces seen that flat say little anyway.
[[nodiscard]] bool contains_ray(const Plane& plane, const Eigen::Vector3d& ray);

/// Error rows that a point-to-plane residual touches: position, rotation, and the extrinsic.
inline constexpr int kPoseSize = 6;
inline constexpr int kMatchSize = 12;
using MatchVector = Eigen::Matrix<double, kMatchSize, 1>;
using MatchMatrix = Eigen::Matrix<double, kMatchSize, kMatchSize>;

/// Sum over matched points of H^T W H and -H^T W r, with H over [position; rotation; extrinsic
/// position; extrinsic rotation] and W the inverse variance times the robust weight.
struct MatchInformation {
  MatchMatrix information = MatchMatrix::Zero();
  MatchVector gradient = MatchVector::Zero();
  int num_matched = 0;
  double sum_abs_residual_m = 0.0;
  double sum_weights = 0.0;
};

/// Residual n.(R q + p - c) of a point q in the IMU frame and its row of H.
[[nodiscard]] double point_to_plane(const NavState& state,
                                    const Eigen::Vector3d& point_in_imu,
                                    const Plane& plane,
                                    MatchVector* row);

/// Directions in the map of which a scan says little: there noise of the plane normals looks like
/// information.
struct WeakDirections {
  std::array<Eigen::Vector3d, 3> directions = {};  ///< Unit.
  int count = 0;
};

/// Normal without its components along the weak directions that it is not clearly turned to (60
/// degrees or nearer): the strong contributions of Tuna et al. 2023 (X-ICP), III-B.
[[nodiscard]] Eigen::Vector3d trusted_normal(const Eigen::Vector3d& normal,
                                             const WeakDirections& weak);

/// Points of one scan with the planes they were matched to.
class ScanMatcher {
 public:
  ScanMatcher(const LocalMap& map, const LidarFilterOptions& options);

  /// Points in the IMU frame at scan end; forgets all planes.
  void set_points(std::vector<Eigen::Vector3f> points_in_imu);
  /// Finds the plane of each point at `state`.
  void match(const NavState& state);
  /// Replaces the points, planes stay (after another deskew of the same points).
  void update_points(const std::vector<Eigen::Vector3f>& points_in_imu);
  [[nodiscard]] MatchInformation linearize(const NavState& state,
                                           const WeakDirections& weak = {}) const;
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// Largest range of a matched point [m].
  [[nodiscard]] double reach_m() const { return reach_m_; }

 private:
  const LocalMap& map_;
  const LidarFilterOptions& options_;
  std::vector<Eigen::Vector3f> points_ = {};
  std::vector<Plane> planes_ = {};  // sigma < 0: none
  double reach_m_ = 0.0;
};

}  // namespace hybridfusion
