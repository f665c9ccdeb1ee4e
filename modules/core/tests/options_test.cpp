#include <hybridfusion/core/options_yaml.hpp>

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {

struct InnerOptions {
  double ring_ratio = 0.2;
  int min_points = 500;
};
template <>
struct OptionFields<InnerOptions> {
  using T = InnerOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::ring_ratio, {.key = "ring_ratio", .unit = "1", .min = 0.0, .max = 1.0, .doc = "d"}},
      Field{&T::min_points, {.key = "min_points", .unit = "points", .min = 1.0, .doc = "d"}},
  };
};

struct OuterOptions {
  InnerOptions inner = {};
  std::string method = "sgm";
  bool refine = true;
};
template <>
struct OptionFields<OuterOptions> {
  using T = OuterOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::inner, {.key = "inner"}},
      Field{&T::method, {.key = "method", .choices = "sgm|fast", .doc = "d"}},
      Field{&T::refine, {.key = "refine", .doc = "d"}},
  };
};

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Options, DefaultsAreValid) {
  EXPECT_TRUE(validate(OuterOptions{}));
}

TEST(Options, YamlOverridesOnlyWhatItNames) {
  OuterOptions options;
  ASSERT_TRUE(read_yaml(YAML::Load("inner: {ring_ratio: 0.4}\nrefine: false"), options));
  EXPECT_EQ(options.inner.ring_ratio, 0.4);
  EXPECT_EQ(options.inner.min_points, 500);
  EXPECT_FALSE(options.refine);
}

TEST(Options, MisspeltYamlKeyIsAnErrorWithItsLine) {
  OuterOptions options;
  const auto result = read_yaml(YAML::Load("method: fast\ninner:\n  ring_ration: 0.4\n"), options);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, AllOf(HasSubstr("line 3"), HasSubstr("inner.ring_ration")));
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

TEST(Options, WrittenYamlReadsBackEqual) {
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

TEST(Options, ReferenceHasOneRowPerLeaf) {
  std::string markdown;
  append_reference(markdown, OuterOptions{}, "group");
  EXPECT_EQ(std::ranges::count(markdown, '\n'), 4);
  EXPECT_THAT(markdown, HasSubstr("`group.inner.ring_ratio` | 0.2 | 1 | 0 .. 1 |"));
}

}  // namespace
}  // namespace hybridfusion
