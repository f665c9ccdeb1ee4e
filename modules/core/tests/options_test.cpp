#include "nested_options.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Options, DefaultsAreValid) {
  EXPECT_TRUE(validate(OuterOptions{}));
}

TEST(Options, OutOfRangeAndUnknownChoiceNameTheFullKey) {
  OuterOptions options;
  options.inner.ring_ratio = 1.5;
  EXPECT_THAT(validate(options, "registration").error().message,
              HasSubstr("registration.inner.ring_ratio"));
  options.inner.ring_ratio = 0.5;
  options.method = "magic";
  EXPECT_THAT(validate(options).error().message, AllOf(HasSubstr("method"), HasSubstr("sgm|fast")));
}

TEST(Options, NanIsOutOfRange) {
  OuterOptions options;
  options.inner.ring_ratio = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(validate(options));
}

TEST(SetOption, WalksDottedKeys) {
  OuterOptions options;
  ASSERT_TRUE(set_option(options, "inner.ring_ratio", "0.3"));
  ASSERT_TRUE(set_option(options, "refine", "false"));
  ASSERT_TRUE(set_option(options, "method", "fast"));
  EXPECT_EQ(options.inner.ring_ratio, 0.3);
  EXPECT_FALSE(options.refine);
  EXPECT_EQ(options.method, "fast");
}

TEST(SetOption, RefusesUnknownKeysGroupsAndWrongTypes) {
  OuterOptions options;
  EXPECT_THAT(set_option(options, "inner.rung", "1").error().message, HasSubstr("inner.rung"));
  EXPECT_FALSE(set_option(options, "inner", "1"));
  EXPECT_FALSE(set_option(options, "refine.deeper", "true"));
  EXPECT_FALSE(set_option(options, "inner.min_points", "3.5"));
  EXPECT_FALSE(set_option(options, "inner.ring_ratio", "nan"));
}

TEST(Options, ReferenceHasOneRowPerLeaf) {
  std::string markdown;
  append_reference(markdown, OuterOptions{}, "group");
  EXPECT_EQ(std::ranges::count(markdown, '\n'), 4);
  EXPECT_THAT(markdown, HasSubstr("`group.inner.ring_ratio` | 0.2 | 1 | 0 .. 1 |"));
}

}  // namespace
}  // namespace hybridfusion
