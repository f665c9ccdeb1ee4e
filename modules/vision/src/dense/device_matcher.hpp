#pragma once

#include "cuda/sgm_problem.hpp"
#include "path_aggregation.hpp"
#include "semi_global_matching.hpp"

#include <hybridfusion/core/run_context.hpp>

#include <atomic>
#include <memory>
#include <optional>
#include <string_view>

namespace hybridfusion {

/// The pair in bare arrays, which must outlive it.
[[nodiscard]] device::SgmProblem sgm_problem(const RectifiedImages& images,
                                             const DisparityRanges& ranges,
                                             const StepPenalties& penalties,
                                             const StereoOptions& options);

/// Semi-global matching on a CUDA device, with the disparities of match_semi_globally(). May be
/// used from several threads. The first failure is logged and ends its use.
class DeviceMatcher {
 public:
  /// The device that `stereo.backend` asks for; null: match on the CPU. Says so in the log when
  /// `cuda` was asked for and there is none.
  [[nodiscard]] static std::unique_ptr<DeviceMatcher> open(const StereoOptions& options,
                                                           const RunContext& ctx);

  /// @returns nothing when the device failed, now or before.
  [[nodiscard]] std::optional<ImagePlane<float>> match(const RectifiedImages& images,
                                                       const DisparityRanges& ranges,
                                                       const StereoOptions& options);

 private:
  explicit DeviceMatcher(const RunContext& ctx) : ctx_(ctx) {}

  RunContext ctx_;
  std::atomic<bool> failed_ = false;
};

}  // namespace hybridfusion
