#pragma once

#include <hybridfusion/lidar/odometry.hpp>

#include <deque>
#include <optional>
#include <string>

namespace hybridfusion {

/// Watches whether what the IMU predicts is what the points then say: normalised innovations over a
/// window, and biases beyond what any IMU has. A few scans that contradict (a bump, a pedestrian
/// before the lens) say nothing; a window of them does.
class ImuWatch {
 public:
  /// What speaks against the IMU, in words; nothing while it is consistent. Scans that the points
  /// did not locate, or that the IMU did not cover, are not counted.
  [[nodiscard]] std::optional<std::string> add(const ScanEstimate& scan);

 private:
  struct Innovation {
    double turn = 0.0;
    double shift = 0.0;
  };
  std::deque<Innovation> recent_ = {};
};

}  // namespace hybridfusion
