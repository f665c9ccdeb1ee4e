#pragma once

#include "features.hpp"

#include <cstdint>
#include <vector>

namespace hybridfusion {

/// Indices into two feature sets.
struct Match {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Mutual nearest neighbours whose distance is below `ratio` times the second nearest one's, by
/// exact search: one matrix product of the unit descriptors, in blocks. Ascending in `first`.
[[nodiscard]] std::vector<Match> match_features(const FeatureSet& first,
                                                const FeatureSet& second,
                                                double ratio);

/// Keeps the linear algebra library from starting its own threads; pairs run in parallel instead.
void use_single_threaded_blas();

}  // namespace hybridfusion
