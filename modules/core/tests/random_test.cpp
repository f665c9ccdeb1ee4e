#include <hybridfusion/core/random.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(Random, TheSameSeedAndStreamRepeatAndOthersDiffer) {
  Random a(7, "stage");
  Random b(7, "stage");
  Random other_stream(7, "other");
  Random other_index(7, "stage", 1);
  const std::uint32_t first = a.next_u32();
  EXPECT_EQ(first, b.next_u32());
  EXPECT_NE(first, other_stream.next_u32());
  EXPECT_NE(first, other_index.next_u32());
}

TEST(Random, NormalHasZeroMeanAndUnitVariance) {
  Random random(1, "normal");
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  // Five standard errors: 1 / sqrt(n) for the mean, sqrt(2 / n) for the variance.
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, 1.0, 5.0 * std::sqrt(2.0 / kCount));
}

TEST(Random, IndexStaysBelowItsCountAndReachesEveryValue) {
  Random random(3, "index");
  unsigned seen = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::uint32_t k = random.index(5);
    ASSERT_LT(k, 5U);
    seen |= 1U << k;
  }
  EXPECT_EQ(seen, 31U);
}

}  // namespace
}  // namespace hybridfusion
