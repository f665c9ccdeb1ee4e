#pragma once

#include "ros_message.hpp"

#include <hybridfusion/io/scan_source.hpp>

#include <optional>
#include <vector>

namespace hybridfusion {

/// Completes samples of which a part was not measured, and finds out in which dialect an IMU
/// speaks.
class ImuWatch {
 public:
  /// The sample, its missing part as another message said it shortly before; nothing without one,
  /// and for an acceleration that comes alone (the next rate takes it along).
  [[nodiscard]] std::optional<ImuSample> complete(const DecodedImu& imu);

  [[nodiscard]] ImuDialect dialect() const;

 private:
  std::optional<ImuSample> last_force_ = {};
  ImuDialect counts_ = {};
  std::vector<float> norms_ = {};  ///< Of a sample of the accelerations.
  std::size_t num_forces_ = 0;
  std::size_t stride_ = 1;
};

}  // namespace hybridfusion
