#pragma once

#include "path_aggregation.hpp"
#include "semi_global_matching.hpp"

namespace hybridfusion {

/// Best disparity of each pixel of row `y` from the summed path costs: unique, found from the right
/// image too (Hirschmueller 2008, 2.4), between pixels by a symmetric V. NaN where there is none.
class DisparitySelection {
 public:
  DisparitySelection(const RectifiedImages& images, const StereoOptions& options);
  void select(const CandidateRow& row, int y, float* disparity);

 private:
  const RectifiedImages& images_;
  const StereoOptions& options_;
  // Of right column c at index right.width - 1 - c, so that rising disparities read forwards.
  std::vector<std::int16_t> right_cost_;
  std::vector<std::int16_t> right_disparity_;
};

}  // namespace hybridfusion
