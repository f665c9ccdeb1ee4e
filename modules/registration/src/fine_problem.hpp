#pragma once

#include "fine_statistics.hpp"

#include <vector>

namespace hybridfusion {

/// One alignment in progress: the clouds, the samples, the current similarity.
class FineProblem {
 public:
  FineProblem(FineInputs& inputs,
              const Rigid3& start,
              const FineOptions& options,
              const RunContext& ctx)
      : options_(options),
        ctx_(ctx),
        planes_(inputs.planes),
        samples_(inputs.samples),
        pose_{.rotation = start.rotation, .translation = start.translation} {}

  /// Pairs within `gate_m` of every `stride`-th sample; also counts the samples near the cloud.
  std::vector<FinePair> find_pairs(double gate_m, std::size_t stride);
  /// One Gauss-Newton step. @returns the length of the update, or a negative number when singular.
  double step(std::vector<FinePair>& pairs, double gate_m, bool free_scale);
  /// Steps until the pose rests, at most twelve.
  void converge(double gate_m, bool free_scale);

  Sim3& pose() { return pose_; }
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] bool horizontal_updated() const { return horizontal_updated_; }
  [[nodiscard]] double held_out_near() const { return held_out_near_; }
  [[nodiscard]] std::size_t num_samples() const { return samples_.size(); }

 private:
  const FineOptions& options_;
  const RunContext& ctx_;
  LazyPlanes& planes_;
  const std::vector<FineSample>& samples_;
  Sim3 pose_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  bool horizontal_updated_ = false;
  double held_out_near_ = 0.0;
};

}  // namespace hybridfusion
