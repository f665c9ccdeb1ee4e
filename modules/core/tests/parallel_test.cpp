#include <hybridfusion/core/parallel.hpp>

#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(ParallelFor, VisitsEachIndexOnceAtAnyThreadCount) {
  for (const int num_threads : {1, 2, 4}) {
    std::vector<int> visits(1003, 0);
    parallel_for(
        {.num_threads = num_threads}, visits.size(), 10, [&](std::size_t b, std::size_t e) {
          for (std::size_t i = b; i < e; ++i) ++visits[i];
        });
    EXPECT_EQ(std::ranges::count(visits, 1), 1003);
  }
}

TEST(ParallelFor, AnExceptionReachesTheCaller) {
  EXPECT_THROW(parallel_for({.num_threads = 2},
                            100,
                            1,
                            [](std::size_t b, std::size_t) {
                              if (b == 50) throw std::runtime_error("chunk 50");
                            }),
               std::runtime_error);
}

TEST(OrderedReduce, GivesTheSameBitsAtAnyThreadCount) {
  const auto sum_with = [](int num_threads) {
    return ordered_reduce(
        {.num_threads = num_threads},
        100'000,
        64,
        0.0,
        [](std::size_t b, std::size_t e) {
          double sum = 0.0;
          for (std::size_t i = b; i < e; ++i) sum += std::sin(static_cast<double>(i)) * 1e-3;
          return sum;
        },
        std::plus<>{});
  };
  const double serial = sum_with(1);
  EXPECT_EQ(serial, sum_with(2));
  EXPECT_EQ(serial, sum_with(4));
}

}  // namespace
}  // namespace hybridfusion
