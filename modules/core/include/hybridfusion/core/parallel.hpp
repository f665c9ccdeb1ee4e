#pragma once

#include <hybridfusion/core/run_context.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace hybridfusion {

/// Calls `body(begin, end)` over [0, count) in chunks of exactly `grain` (the last may be shorter),
/// on `ctx.num_threads` threads. Chunk borders do not depend on the number of threads. The first
/// exception is rethrown. Progress, logging and stop remain the body's business.
void parallel_for(const RunContext& ctx,
                  std::size_t count,
                  std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Threads that `ctx` asks for: its num_threads, or every core for 0.
[[nodiscard]] int effective_threads(const RunContext& ctx);

/// Folds `map_chunk(begin, end)` left to right in chunk order: the same bits at any thread count.
template <class Sum, class MapChunk, class Combine>
[[nodiscard]] Sum ordered_reduce(const RunContext& ctx,
                                 std::size_t count,
                                 std::size_t grain,
                                 Sum sum,
                                 MapChunk&& map_chunk,
                                 Combine&& combine) {
  std::vector<Sum> parts((count + grain - 1) / grain, sum);
  parallel_for(ctx, parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part) {
      parts[part] = map_chunk(part * grain, std::min(count, (part + 1) * grain));
    }
  });
  for (Sum& part : parts) sum = combine(std::move(sum), part);
  return sum;
}

}  // namespace hybridfusion
