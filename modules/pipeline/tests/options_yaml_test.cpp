#include "options_yaml.hpp"

#include "nested_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(OptionsYaml, OverridesOnlyWhatItNames) {
  OuterOptions options;
  ASSERT_TRUE(read_yaml(YAML::Load("inner: {ring_ratio: 0.4}\nrefine: false"), options));
  EXPECT_EQ(options.inner.ring_ratio, 0.4);
  EXPECT_EQ(options.inner.min_points, 500);
  EXPECT_FALSE(options.refine);
}

TEST(OptionsYaml, MisspeltKeyIsAnErrorWithItsLine) {
  OuterOptions options;
  const auto result = read_yaml(YAML::Load("method: fast\ninner:\n  ring_ration: 0.4\n"), options);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, AllOf(HasSubstr("line 3"), HasSubstr("inner.ring_ration")));
}

TEST(OptionsYaml, WhatIsWrittenReadsBackEqual) {
  OuterOptions options;
  options.inner.ring_ratio = 0.1 + 0.2;
  options.method = "fast";
  YAML::Emitter out;
  write_yaml(out, options);
  OuterOptions back;
  ASSERT_TRUE(read_yaml(YAML::Load(out.c_str()), back));
  EXPECT_EQ(back.inner.ring_ratio, options.inner.ring_ratio);
  EXPECT_EQ(back.method, "fast");
}

}  // namespace
}  // namespace hybridfusion
