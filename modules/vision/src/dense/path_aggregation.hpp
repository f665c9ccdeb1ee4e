#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hybridfusion {

/// Candidates are kept in whole vectors of this many disparities.
inline constexpr int kDisparityLanes = 16;
/// Path cost of what is no candidate. Eight of them add up within 15 bits, and valid path costs
/// (at most 62 + P2) stay below.
inline constexpr std::int16_t kUnreachable = 0x0fff;

/// Candidates of one image row, its matching costs and where to add path costs. Pixel x owns
/// `kDisparityLanes * blocks` entries from `kDisparityLanes * block[x]` on, the first `count[x]` of
/// which are candidates from disparity `low[x]` on.
struct CandidateRow {
  int width = 0;
  const std::int16_t* low = nullptr;
  const std::int16_t* count = nullptr;
  const std::uint32_t* block = nullptr;  ///< width + 1 entries.
  const std::uint8_t* costs = nullptr;
  std::int16_t* sums = nullptr;
  const std::uint8_t* grey = nullptr;
};

/// Penalties of disparity steps between two neighbours.
struct StepPenalties {
  std::int16_t small = 0;                ///< P1
  std::vector<std::int16_t> large = {};  ///< P2 by the grey step between them, 256 entries
};
[[nodiscard]] StepPenalties step_penalties(int smoothness_small, int smoothness_large);

/// Path costs of one row, kept for the paths that go on from it: each pixel's candidates between
/// two vectors of kUnreachable, so that shifted reads stay inside.
struct PathRow {
  std::vector<std::int16_t> costs = {};
  std::vector<std::int16_t> mins = {};
};

/// Adds the costs of the two paths along the row itself.
void aggregate_along(const CandidateRow& row, const StepPenalties& penalties);

/// Adds the costs of the paths that arrive from pixel x - dx of the neighbouring row `from`;
/// `state` holds that row's path costs and then this row's. An empty state starts new paths.
void aggregate_from(const CandidateRow& row,
                    const CandidateRow& from,
                    int dx,
                    const StepPenalties& penalties,
                    PathRow& state,
                    PathRow& scratch);

}  // namespace hybridfusion
