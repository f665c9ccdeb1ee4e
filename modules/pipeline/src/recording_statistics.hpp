#pragma once

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/core/time.hpp>

#include <cstdint>
#include <vector>

namespace hybridfusion {

/// Stamps of one sensor in the order of recording.
class StampStatistics {
 public:
  void add(Timestamp stamp);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::uint64_t backwards() const { return backwards_; }
  [[nodiscard]] Timestamp first() const { return first_; }
  [[nodiscard]] Timestamp last() const { return last_; }
  [[nodiscard]] double duration_s() const { return to_seconds(last_ - first_); }
  /// Median of the steps [s]; 0 for fewer than two stamps.
  [[nodiscard]] double period_s() const;
  struct Gaps {
    std::uint64_t count = 0;
    double longest_s = 0.0;
  };
  /// Steps longer than `limit_s`.
  [[nodiscard]] Gaps gaps(double limit_s) const;

 private:
  std::uint64_t count_ = 0;
  std::uint64_t backwards_ = 0;
  Timestamp first_{};
  Timestamp last_{};  ///< The latest so far.
  std::vector<float> steps_s_ = {};
};

/// Sums over the messages of a recording.
struct RecordingStatistics {
  StampStatistics imu = {};
  StampStatistics lidar = {};
  std::vector<double> force_mps2 = {};      ///< Norms of a sample of the specific forces.
  std::vector<double> rotation_radps = {};  ///< Norms of a sample of the angular velocities.
  std::vector<double> returns = {};         ///< Per scan.
  std::vector<double> ranges_m = {};        ///< Median range of a sample of the scans.
  std::vector<GeodeticPosition> fixes = {};

  void add(const SensorMessage& message);
};

/// 0 for no values. @param quantile  0 .. 1
[[nodiscard]] double quantile_of(std::vector<double> values, double quantile);

}  // namespace hybridfusion
