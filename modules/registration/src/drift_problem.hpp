#pragma once

#include "fine_samples.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/registration/drift.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// L bent along the drive onto the planes of G: one estimate in progress.
/// `at` is where each sample lies along the drive.
class DriftProblem {
 public:
  DriftProblem(FineInputs& inputs,
               const Sim3& vision_from_lidar,
               std::span<const double> at,
               const FineOptions& fine,
               const RunContext& ctx)
      : inputs_(inputs), pose_(vision_from_lidar), at_(at), fine_(fine), ctx_(ctx) {}

  /// Knots at equal distances, without any correction.
  void lay_knots(int intervals);
  /// One Gauss-Newton step on the pairs within `gate_m`.
  void solve(double gate_m, bool with_held_out);
  /// Mean cut distance of the held-out samples near G, facades and ground at equal weight.
  double judge();

  std::vector<DriftKnot>& knots() { return correction_.knots; }

 private:
  /// Normal equations of all knots.
  struct Equations {
    Eigen::MatrixXd normal;
    Eigen::VectorXd right;
  };
  /// A sample on its plane.
  struct Pair {
    std::size_t sample = 0;
    double residual_m = 0.0;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();  ///< d residual / d point, LiDAR frame.
  };
  [[nodiscard]] bool is_held_out(std::size_t sample) const;
  std::vector<Pair> find_pairs(double gate_m);
  void add_pair(const Pair& pair, double weight, Equations& sum) const;
  /// A direction that no surface holds follows the knots beside it.
  void add_priors(Equations& sum) const;
  [[nodiscard]] Eigen::Vector3d place(std::size_t sample) const {
    return corrected(correction_, inputs_.samples[sample].point, at_[sample]);
  }

  FineInputs& inputs_;
  Sim3 pose_;
  std::span<const double> at_;
  const FineOptions& fine_;
  const RunContext& ctx_;
  DriftCorrection correction_ = {};
  double first_ = 0.0;
  double interval_ = 1.0;
};

}  // namespace hybridfusion
