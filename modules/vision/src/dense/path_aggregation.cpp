#include "path_aggregation.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

// Vectors are passed between functions that are always inlined: no call depends on their ABI.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace hybridfusion {
namespace {

// GCC's vector extension: the compiler maps it to whatever the target of each clone has.
using Lanes [[gnu::vector_size(2 * kDisparityLanes)]] = std::int16_t;
using Bytes [[gnu::vector_size(kDisparityLanes)]] = std::uint8_t;

[[gnu::always_inline]] inline Lanes load(const std::int16_t* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

[[gnu::always_inline]] inline Lanes load_bytes(const std::uint8_t* from) {
  Bytes bytes;
  std::memcpy(&bytes, from, sizeof bytes);
  return __builtin_convertvector(bytes, Lanes);
}

[[gnu::always_inline]] inline void store(std::int16_t* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline Lanes smaller(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}

[[gnu::always_inline]] inline Lanes splat(std::int16_t value) {
  return Lanes{} + value;
}

[[gnu::always_inline]] inline std::int16_t smallest(const Lanes& lanes) {
  Lanes v = lanes;
  v = smaller(v,
              __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
  v = smaller(v,
              __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11));
  v = smaller(v,
              __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
  v = smaller(v,
              __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
  return v[0];
}

/// kUnreachable in the lanes from `count` on, 0 before.
[[gnu::always_inline]] inline Lanes beyond(int count) {
  constexpr Lanes kIndex = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  return (kIndex >= splat(static_cast<std::int16_t>(count))) & splat(kUnreachable);
}

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
    if (k + kDisparityLanes > count) value |= beyond(count - k);
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

__attribute__((target_clones("avx2", "default"))) void along_row(const CandidateRow& row,
                                                                 int step,
                                                                 const StepPenalties& penalties,
                                                                 std::int16_t* scratch,
                                                                 std::size_t slot) {
  std::int16_t* current = scratch + kDisparityLanes;
  std::int16_t* next = current + slot;
  std::int16_t* copy = next + slot;
  Source from{.costs = current};
  for (int i = 0; i < row.width; ++i) {
    const int x = step > 0 ? i : row.width - 1 - i;
    const int count = row.count[x];
    if (count == 0) {
      from.count = 0;
      continue;
    }
    const int before_x = i == 0 ? x : x - step;
    const std::size_t at = static_cast<std::size_t>(row.block[x]) * kDisparityLanes;
    const std::int16_t min = advance_path(
        row.costs + at,
        shifted_costs(from, row.low[x], count, copy),
        from.count == 0 ? std::int16_t{0} : from.min,
        penalties.small,
        penalties.large[static_cast<std::size_t>(std::abs(row.grey[x] - row.grey[before_x]))],
        count,
        next,
        row.sums + at);
    const std::size_t slots =
        static_cast<std::size_t>(row.block[x + 1] - row.block[x]) * kDisparityLanes;
    store(next + slots, splat(kUnreachable));
    from = {.costs = next, .low = row.low[x], .count = count, .min = min};
    std::swap(current, next);
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

void aggregate_along(const CandidateRow& row, int step, const StepPenalties& penalties) {
  const std::size_t slot = slot_size(row);
  std::vector<std::int16_t> scratch(3 * slot + kDisparityLanes, kUnreachable);
  along_row(row, step, penalties, scratch.data(), slot);
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
