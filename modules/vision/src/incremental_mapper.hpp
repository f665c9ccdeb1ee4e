#pragma once

#include "bundle_adjustment.hpp"
#include "sfm_model.hpp"
#include "tracks.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Grows models from seed pairs: resection of the next photo, triangulation, adjustment of its
/// neighbourhood, and of everything when the model grew enough.
class IncrementalMapper {
 public:
  IncrementalMapper(SfmModel& model,
                    std::span<const VerifiedPair> pairs,
                    const GnssIngest& gnss,
                    const ReconstructionOptions& options,
                    const RunContext& ctx);

  /// Registers what can be reached from the best seed among the views not registered yet.
  /// `model` must hold no registered view. Leaves it empty when no seed works.
  /// @param usable  Per view: false for views that may not be used.
  /// @returns kCancelled, or the error of an adjustment.
  [[nodiscard]] Expected<void> grow(const std::vector<bool>& usable);

  /// Registers the best of the usable views that the model as it is can register, and adjusts its
  /// neighbourhood. @returns false when there is none; errors as grow().
  [[nodiscard]] Expected<bool> register_next(const std::vector<bool>& usable);

  /// Adjusts all registered views with their calibration and triangulates again. Errors as grow().
  [[nodiscard]] Expected<void> adjust_all();

  /// Why each view is not registered; empty text where it is.
  [[nodiscard]] const std::vector<std::string>& reasons() const { return reasons_; }

 private:
  [[nodiscard]] std::vector<std::size_t> ranked_seeds(const std::vector<bool>& usable) const;
  [[nodiscard]] Expected<bool> start(const VerifiedPair& seed);
  [[nodiscard]] bool try_view(std::uint32_t view);
  [[nodiscard]] bool plausible(std::uint32_t view, const Eigen::Vector3d& centre) const;
  [[nodiscard]] Expected<void> adjust_around(std::uint32_t view);
  void extend(std::uint32_t view);
  void clear();

  SfmModel& model_;
  std::span<const VerifiedPair> pairs_;
  const GnssIngest& gnss_;
  const ReconstructionOptions& options_;
  const RunContext& ctx_;
  std::vector<std::string> reasons_;
  std::vector<std::size_t> tried_with_;  // per view: visible points at the last failed resection
};

/// Tracks for an adjustment: longest first until every view has `per_view` of them in each of its
/// parts (an 8 x 8 grid in all), ascending. 0: all tracks with a point.
[[nodiscard]] std::vector<std::uint32_t> select_tracks(const SfmModel& model, int per_view);

}  // namespace hybridfusion
