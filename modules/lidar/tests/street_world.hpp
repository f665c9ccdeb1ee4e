#pragma once

#include "simulated_drive.hpp"

#include <functional>
#include <vector>

namespace hybridfusion::testing {

/// A way on level ground along straight lines with rounded corners.
class RoundedPath {
 public:
  RoundedPath(const std::vector<Eigen::Vector2d>& corners, double radius_m);

  [[nodiscard]] double length_m() const { return length_m_; }
  /// x forward, 1.2 m above the ground, with a little roll, pitch and heave; the last line goes on.
  [[nodiscard]] Rigid3 pose_at(double distance_m) const;

 private:
  struct Piece {
    Eigen::Vector2d start = Eigen::Vector2d::Zero();
    double heading_rad = 0.0;
    double curvature = 0.0;  // [1/m], positive to the left
    double begin_m = 0.0;
    double length_m = 0.0;
  };
  std::vector<Piece> pieces_ = {};
  double length_m_ = 0.0;
};

/// Distance driven after `t` seconds: 2 s of standstill, then a smooth start up to `speed_mps`.
[[nodiscard]] double driven_m(double t, double speed_mps);

/// The pose by seconds along corners rounded by 8 m, standing for the first 2 s.
[[nodiscard]] std::function<Rigid3(double)> drive_along(const std::vector<Eigen::Vector2d>& corners,
                                                        double speed_mps);

/// A round of 680 m that starts in a street of irregular houses, turns twice, comes back through a
/// straight tunnel of 180 m without any mark along its walls and ends in the first street. Rays
/// reach 50 m.
struct TunnelRound {
  DriveWorld world = {};
  double lap_s = 0.0;  ///< When the start is passed again.
};
[[nodiscard]] TunnelRound tunnel_round(std::uint64_t seed, double speed_mps);

/// A street of irregular houses with one corner, driven at constant speed from the first moment on.
[[nodiscard]] DriveWorld rolling_street(std::uint64_t seed, double speed_mps);

/// A straight street on which the same three houses stand every 30 m.
[[nodiscard]] DriveWorld lookalike_street(double speed_mps);

}  // namespace hybridfusion::testing
