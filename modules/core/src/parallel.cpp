#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/parallel.hpp>

#include <thread>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace hybridfusion {

int effective_threads(const RunContext& ctx) {
  if (ctx.num_threads > 0) return ctx.num_threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(const RunContext& ctx,
                  std::size_t count,
                  std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  HF_CHECK(grain > 0);
  if (count == 0) return;
  const std::size_t num_chunks = (count + grain - 1) / grain;
  const auto run_chunk = [&](std::size_t chunk) {
    body(chunk * grain, std::min(count, (chunk + 1) * grain));
  };
  const int num_threads = effective_threads(ctx);
  if (num_threads == 1 || num_chunks == 1) {
    for (std::size_t chunk = 0; chunk < num_chunks; ++chunk) run_chunk(chunk);
    return;
  }
  // More slots than cores oversubscribes, which is what a caller asking for it wants to test.
  tbb::task_arena arena(num_threads);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, num_chunks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) run_chunk(chunk);
        },
        tbb::simple_partitioner{});
  });
}

}  // namespace hybridfusion
