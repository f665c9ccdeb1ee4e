#pragma once

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <string_view>

#include <Eigen/Core>

namespace hybridfusion {

/// Error of one GNSS receiver: constant offset + first-order Gauss-Markov walk + white noise, per
/// axis, in shares of the total sigma (0.85, 0.40, 0.35; their squares add up to 1).
class GnssError {
 public:
  /// @param receiver  Name of its random stream: every receiver has its own errors.
  GnssError(const GnssModelOptions& options,
            std::uint64_t seed,
            std::string_view receiver,
            std::uint64_t index);

  /// Error east, north, up [m] at a later (or the same) time. @pre times do not go back
  [[nodiscard]] Eigen::Vector3d at(double time_s);
  [[nodiscard]] const Eigen::Vector3d& constant_m() const { return constant_; }
  [[nodiscard]] const Eigen::Vector3d& sigma_m() const { return sigma_; }

 private:
  Random random_;
  double correlation_s_;
  Eigen::Vector3d sigma_;
  Eigen::Vector3d constant_;
  Eigen::Vector3d walk_;
  double time_s_ = 0.0;
  bool started_ = false;
};

}  // namespace hybridfusion
