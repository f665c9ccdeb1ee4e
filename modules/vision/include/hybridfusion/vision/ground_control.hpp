#pragma once

#include <hybridfusion/core/geodetic.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A surveyed point that is marked in photos.
struct ControlPoint {
  struct Mark {
    std::size_t photo = 0;                            ///< Index of the photo.
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< In the photo as stored.
  };
  std::string name = {};
  GeodeticPosition position = {};
  Eigen::Vector3d sigma_m = {0.02, 0.02, 0.03};  ///< East, north, up.
  bool check = false;                            ///< Only compared with the result, not used.
  std::vector<Mark> marks = {};
};

/// What the result makes of a surveyed point.
struct ControlResidual {
  std::string name = {};
  bool used = false;          ///< In the adjustment; else it is independent of it.
  std::size_t num_marks = 0;  ///< In registered photos.
  /// By vision less surveyed, east-north-up [m]; not finite with fewer than two marks.
  Eigen::Vector3d residual_m = Eigen::Vector3d::Zero();
  /// The same when all used points but this one place the model by a similarity.
  Eigen::Vector3d held_out_m = Eigen::Vector3d::Zero();
};

}  // namespace hybridfusion
