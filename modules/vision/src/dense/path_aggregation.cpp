#include "path_aggregation.hpp"

#include "disparity_lanes.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace hybridfusion {
namespace {

/// The pixel that a path comes from.
struct Source {
  const std::int16_t* costs = nullptr;  // of candidate `low`
  int low = 0;
  int count = 0;
  std::int16_t min = 0;
};

/// Where a step reads the source's costs from candidate low - 1 on: in place when the vectors of
/// kUnreachable around the source's cover all reads, else from a copy.
[[gnu::always_inline]] inline const std::int16_t* shifted_costs(const Source& from,
                                                                int low,
                                                                int count,
                                                                std::int16_t* copy) {
  const int slots = (count + kDisparityLanes - 1) / kDisparityLanes * kDisparityLanes;
  if (from.count == 0) {
    std::fill_n(copy, slots + 2, std::int16_t{0});
    return copy;
  }
  const int from_slots = (from.count + kDisparityLanes - 1) / kDisparityLanes * kDisparityLanes;
  const int first = low - 1 - from.low;
  if (first >= -kDisparityLanes && first + slots + 2 <= from_slots + kDisparityLanes) {
    return from.costs + first;
  }
  std::fill_n(copy, slots + 2, kUnreachable);
  const int begin = std::max(0, first);
  const int end = std::min(from.count, first + slots + 2);
  if (begin < end) std::copy(from.costs + begin, from.costs + end, copy + (begin - first));
  return copy;
}

/// L(p, d) = C(p, d) + min(L(q, d), L(q, d +- 1) + P1, min L(q) + P2) - min L(q)
/// (Hirschmueller 2008, Eq. 13). Adds L to `sums`. @returns min over d of L(p, d).
[[gnu::always_inline]] inline std::int16_t advance_path(const std::uint8_t* costs,
                                                        const std::int16_t* before,
                                                        std::int16_t before_min,
                                                        std::int16_t small_penalty,
                                                        std::int16_t large_penalty,
                                                        int count,
                                                        std::int16_t* out,
                                                        std::int16_t* sums) {
  const Lanes small = splat(small_penalty);
  const Lanes least_before = splat(before_min);
  const Lanes jump = splat(static_cast<std::int16_t>(before_min + large_penalty));
  Lanes best = splat(kUnreachable);
  for (int k = 0; k < count; k += kDisparityLanes) {
    const Lanes step = smaller(load(before + k), load(before + k + 2)) + small;
    const Lanes least = smaller(step, smaller(load(before + k + 1), jump));
    Lanes value = load_bytes(costs + k) + (least - least_before);
    if (k + kDisparityLanes > count) value |= lanes_from(count - k) & splat(kUnreachable);
    store(out + k, value);
    store(sums + k, load(sums + k) + value);
    best = smaller(best, value);
  }
  return smallest(best);
}

/// Largest number of entries that one pixel has, with room for shifted reads.
std::size_t slot_size(const CandidateRow& row) {
  std::uint32_t blocks = 0;
  for (int x = 0; x < row.width; ++x) blocks = std::max(blocks, row.block[x + 1] - row.block[x]);
  return (static_cast<std::size_t>(blocks) + 3) * kDisparityLanes;
}

std::size_t path_offset(const CandidateRow& row, int x) {
  return (static_cast<std::size_t>(row.block[x]) + static_cast<std::size_t>(x) + 1) *
         kDisparityLanes;
}

/// A path along a row: what it comes from, and room for the costs of two pixels and a copy.
struct Walk {
  Source from;
  std::int16_t* current;
  std::int16_t* next;
  std::int16_t* copy;

  Walk(std::int16_t* scratch, std::size_t slot)
      : from{.costs = scratch + kDisparityLanes},
        current(scratch + kDisparityLanes),
        next(current + slot),
        copy(next + slot) {}
};

[[gnu::always_inline]] inline void walk_to(
    const CandidateRow& row, int x, int before_x, const StepPenalties& penalties, Walk& walk) {
  const int count = row.count[x];
  if (count == 0) {
    walk.from.count = 0;
    return;
  }
  const std::size_t at = static_cast<std::size_t>(row.block[x]) * kDisparityLanes;
  const std::int16_t min = advance_path(
      row.costs + at,
      shifted_costs(walk.from, row.low[x], count, walk.copy),
      walk.from.count == 0 ? std::int16_t{0} : walk.from.min,
      penalties.small,
      penalties.large[static_cast<std::size_t>(std::abs(row.grey[x] - row.grey[before_x]))],
      count,
      walk.next,
      row.sums + at);
  const std::size_t slots =
      static_cast<std::size_t>(row.block[x + 1] - row.block[x]) * kDisparityLanes;
  store(walk.next + slots, splat(kUnreachable));
  walk.from = {.costs = walk.next, .low = row.low[x], .count = count, .min = min};
  std::swap(walk.current, walk.next);
}

/// Each pixel waits for the one before it: two paths at a time use the waits of one another.
__attribute__((target_clones("avx2", "default"))) void along_row(const CandidateRow& row,
                                                                 const StepPenalties& penalties,
                                                                 Walk rightwards,
                                                                 Walk leftwards) {
  const int last = row.width - 1;
  for (int i = 0; i <= last; ++i) {
    walk_to(row, i, std::max(i - 1, 0), penalties, rightwards);
    walk_to(row, last - i, std::min(last - i + 1, last), penalties, leftwards);
  }
}

__attribute__((target_clones("avx2", "default"))) void from_row(const CandidateRow& row,
                                                                const CandidateRow& source_row,
                                                                int dx,
                                                                const StepPenalties& penalties,
                                                                const PathRow& before,
                                                                PathRow& after,
                                                                std::int16_t* copy) {
  for (int x = 0; x < row.width; ++x) {
    const std::size_t out = path_offset(row, x);
    const std::size_t slots =
        static_cast<std::size_t>(row.block[x + 1] - row.block[x]) * kDisparityLanes;
    store(after.costs.data() + out + slots, splat(kUnreachable));
    const int count = row.count[x];
    if (count == 0) continue;
    const int u = x - dx;
    Source source;
    if (u >= 0 && u < row.width && !before.mins.empty()) {
      source = {.costs = before.costs.data() + path_offset(source_row, u),
                .low = source_row.low[u],
                .count = source_row.count[u],
                .min = before.mins[static_cast<std::size_t>(u)]};
    }
    const int grey_step = source.count == 0 ? 0 : std::abs(row.grey[x] - source_row.grey[u]);
    const std::size_t at = static_cast<std::size_t>(row.block[x]) * kDisparityLanes;
    after.mins[static_cast<std::size_t>(x)] =
        advance_path(row.costs + at,
                     shifted_costs(source, row.low[x], count, copy),
                     source.count == 0 ? std::int16_t{0} : source.min,
                     penalties.small,
                     penalties.large[static_cast<std::size_t>(grey_step)],
                     count,
                     after.costs.data() + out,
                     row.sums + at);
  }
}

}  // namespace

StepPenalties step_penalties(int smoothness_small, int smoothness_large) {
  StepPenalties penalties{.small = static_cast<std::int16_t>(smoothness_small), .large = {}};
  for (int step = 0; step < 256; ++step) {
    penalties.large.push_back(static_cast<std::int16_t>(
        std::max(smoothness_small + 1, smoothness_large * 16 / (16 + step))));
  }
  return penalties;
}

void aggregate_along(const CandidateRow& row, const StepPenalties& penalties) {
  const std::size_t slot = slot_size(row);
  const std::size_t size = 3 * slot + kDisparityLanes;
  std::vector<std::int16_t> scratch(2 * size, kUnreachable);
  along_row(row, penalties, Walk(scratch.data(), slot), Walk(scratch.data() + size, slot));
}

void aggregate_from(const CandidateRow& row,
                    const CandidateRow& from,
                    int dx,
                    const StepPenalties& penalties,
                    PathRow& state,
                    PathRow& scratch) {
  const auto width = static_cast<std::size_t>(row.width);
  scratch.costs.resize(path_offset(row, row.width));
  scratch.mins.resize(width);
  std::fill_n(scratch.costs.begin(), kDisparityLanes, kUnreachable);
  std::vector<std::int16_t> copy(slot_size(row));
  from_row(row, from, dx, penalties, state, scratch, copy.data());
  std::swap(state, scratch);
}

}  // namespace hybridfusion
