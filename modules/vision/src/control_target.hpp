#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A surveyed point and where views show it, as the adjustment holds the model by it.
struct ControlTarget {
  struct Mark {
    std::uint32_t view = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< In the photo as stored.
  };
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< East-north-up [m].
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();
  std::vector<Mark> marks = {};
};

}  // namespace hybridfusion
