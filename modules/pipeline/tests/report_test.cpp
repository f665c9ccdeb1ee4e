#include "report/chart.hpp"
#include "report/lights.hpp"
#include "report/plan_map.hpp"
#include "report/report_data.hpp"
#include "report/splat.hpp"
#include "sample_workspace.hpp"

#include <hybridfusion/io/jpeg.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The page without its encoded pictures, in which any three letters occur.
std::string without_pictures(std::string html) {
  const std::string begin = "base64,";
  for (std::size_t at = 0; (at = html.find(begin, at)) != std::string::npos; at += begin.size()) {
    const std::size_t from = at + begin.size();
    html.erase(from, html.find_first_of("'\"", from) - from);
  }
  return html;
}

class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() / ("hf_report_" + std::to_string(::getpid()));
    std::filesystem::remove_all(root_);
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  /// Replaces the only place where a file of the workspace has this text.
  void edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::ifstream in(root_ / name);
    std::ostringstream text;
    text << in.rdbuf();
    std::string content = std::move(text).str();
    ASSERT_NE(content.find(from), std::string::npos) << name;
    content.replace(content.find(from), from.size(), to);
    std::ofstream(root_ / name) << content;
  }

  [[nodiscard]] std::string report() const {
    const PipelineOptions options;
    const Project project{.workspace = Workspace::open(root_).value(), .options = options};
    const auto written = write_report(project, {});
    EXPECT_TRUE(written) << written.error().message;
    std::ifstream file(root_ / "report/index.html");
    std::ostringstream text;
    text << file.rdbuf();
    return std::move(text).str();
  }

  std::filesystem::path root_ = {};
};

std::string anchor(std::string_view id) {
  return "<figure id='" + std::string(id) + "'>";
}

TEST_F(Report, ShowsEveryFigureOfACompleteWorkspaceAndNamesItsFile) {
  testing::write_sample_workspace(root_);
  const std::string html = report();
  for (const char* id :
       {"picture",       "sources",          "supplement-degree", "boundary-distances",
        "baselines",     "overlap-map",      "change-map",        "survey-map",
        "overlap",       "camera-positions", "gnss-residuals",    "reprojection",
        "track-lengths", "photo-matches",    "camera-model",      "trajectory",
        "lidar-health",  "drive-gnss",       "transform",         "yaw-search",
        "candidates",    "evidence",         "ground-profile",    "cross-sections",
        "patches"}) {
    EXPECT_THAT(html, HasSubstr(anchor(id)));
  }
  EXPECT_THAT(html, HasSubstr("<code>vision/positions.csv</code>"));
  EXPECT_THAT(html, HasSubstr("peak memory [MiB]"));
  EXPECT_THAT(html, HasSubstr("Ran: reconstruct, map, register"));
  EXPECT_THAT(without_pictures(html), AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf "))));
}

TEST_F(Report, EveryNumberLeadsToAFileThatSaysIt) {
  if (std::system("python3 -c '' 2>/dev/null") != 0) GTEST_SKIP() << "python3 is not installed";
  testing::write_sample_workspace(root_);
  std::ignore = report();
  const std::string check = "python3 " HF_REPORT_CHECK " '" + root_.string() + "'";
  EXPECT_EQ(std::system(check.c_str()), 0);
  edit("run.json", "\"num_scans\":200", "\"num_scans\":201");
  EXPECT_NE(std::system((check + " >/dev/null").c_str()), 0) << "a wrong number must not pass";
}

TEST_F(Report, ShowsThePatchesOfTheMethodThatMadeThem) {
  testing::write_sample_workspace(root_);
  EXPECT_THAT(report(), AllOf(HasSubstr("Vote of the patches"), Not(HasSubstr("in the ring"))));
  edit("registration/registration.json", "\"method\":\"hybrid\"", "\"method\":\"paper\"");
  EXPECT_THAT(report(),
              AllOf(HasSubstr("Patches of the published chain"), HasSubstr("in the ring")));
}

TEST_F(Report, IsOneFileWithoutScriptsAndEscapesNames) {
  testing::write_sample_workspace(root_);
  const std::string html = report();
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert("));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http://")), Not(HasSubstr("https://"))));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("src='/")), Not(HasSubstr("<link"))));
}

TEST_F(Report, WorksWithPhotosAlone) {
  testing::write_sample_workspace(root_);
  for (const char* gone : {"lidar", "fused", "registration", "evaluation"}) {
    std::filesystem::remove_all(root_ / gone);
  }
  const std::string html = report();
  EXPECT_THAT(html, HasSubstr(anchor("survey-map")));
  EXPECT_THAT(html,
              AllOf(Not(HasSubstr(anchor("trajectory"))), Not(HasSubstr(anchor("transform")))));
}

TEST_F(Report, WorksWithTheDriveAlone) {
  testing::write_sample_workspace(root_);
  for (const char* gone : {"vision", "fused", "registration", "evaluation"}) {
    std::filesystem::remove_all(root_ / gone);
  }
  const std::string html = report();
  EXPECT_THAT(html, AllOf(HasSubstr(anchor("trajectory")), HasSubstr(anchor("ground-profile"))));
  EXPECT_THAT(html, Not(HasSubstr(anchor("survey-map"))));
}

TEST_F(Report, ARefusalIsTheVerdictAndDrawsNoFusion) {
  testing::write_sample_workspace(root_);
  std::ofstream(root_ / "registration/registration.json")
      << R"({"status": "refused", "reason": "no <b>overlap</b>", "vision_from_lidar": null})";
  const std::string html = report();
  EXPECT_THAT(html, HasSubstr("<b>REFUSED</b><span>no &lt;b&gt;overlap&lt;/b&gt;</span>"));
  EXPECT_THAT(html,
              AllOf(Not(HasSubstr(anchor("cross-sections"))), Not(HasSubstr(anchor("sources")))));
}

TEST_F(Report, DamagedFilesCostTheirFiguresNotTheReport) {
  testing::write_sample_workspace(root_);
  std::ofstream(root_ / "lidar/quality.csv") << "time,points\nx,y\n";
  std::ofstream(root_ / "registration/registration.json") << "{";
  std::ofstream(root_ / "vision/dense.ply") << "ply\nformat";
  std::ofstream(root_ / "evaluation/metrics.json") << R"({"supplement": [{"leaf_m": null}]})";
  const std::string html = report();
  EXPECT_THAT(html, AllOf(HasSubstr(anchor("survey-map")), HasSubstr(anchor("trajectory"))));
  EXPECT_THAT(html, Not(HasSubstr(anchor("lidar-health"))));
  EXPECT_THAT(html, Not(HasSubstr(anchor("supplement-degree"))));
}

TEST_F(Report, OfAnEmptyWorkspaceSaysThatNothingRan) {
  const std::string html = report();
  EXPECT_THAT(html, HasSubstr("no stage has run yet"));
  EXPECT_THAT(html, HasSubstr("Ran: nothing. Not run: reconstruct, map, register, evaluate."));
}

TEST(TrafficLights, APoorScaleByGnssAloneIsRedOnlyWithoutALidarCloud) {
  ReportData data;
  data.reconstruct = {{"georeference", {{"verdict", "unusable"}}}, {"scale_sigma", 2.0}};
  const auto color = [&] {
    for (const Light& light : traffic_lights(data)) {
      if (light.what == "scale and tilt by GNSS alone") return light.color;
    }
    return decltype(Light::color){};
  };
  EXPECT_EQ(color(), "red");
  data.pose.emplace();
  data.pose->ok = true;
  EXPECT_EQ(color(), "amber");
}

TEST(TrafficLights, GivenPosesHaveNoUncertaintyOfTheirOwn) {
  ReportData data;
  data.reconstruct = {
      {"num_photos", 3}, {"num_registered", 3}, {"georeference", {{"verdict", "given"}}}};
  const std::vector<Light> lights = traffic_lights(data);
  const auto light = std::ranges::find(lights, "scale and tilt", &Light::what);
  ASSERT_NE(light, lights.end());
  EXPECT_EQ(light->color, "amber");
  EXPECT_THAT(light->value, AllOf(HasSubstr("not adjusted"), Not(HasSubstr("±"))));
  EXPECT_EQ(std::ranges::count(lights, "focal length against metadata", &Light::what), 0);
}

TEST(Ticks, AreRoundAndWithinTheEnds) {
  EXPECT_THAT(ticks(0.0, 1.0, 5),
              ElementsAre(0.0,
                          0.2,
                          ::testing::DoubleNear(0.4, 1e-12),
                          ::testing::DoubleNear(0.6, 1e-12),
                          0.8,
                          1.0));
  EXPECT_TRUE(ticks(1.0, 1.0, 5).empty());
  EXPECT_TRUE(ticks(0.0, INFINITY, 5).empty());
  EXPECT_EQ(tick_text(0.2 + 0.4, 0.2), "0.6");
  EXPECT_EQ(tick_text(-50.0, 10.0), "-50");
  EXPECT_EQ(tick_text(-1e-17, 0.1), "0");
}

TEST(HistogramOfValues, CountsWhatLiesBeyondInTheOutermostBins) {
  const std::vector<double> values = {-5.0, 0.1, 0.6, 0.6, 99.0, NAN};
  EXPECT_THAT(histogram(values, 0.0, 1.0, 2).counts, ElementsAre(2.0, 3.0));
}

TEST(Chart, SurvivesValuesThatAreNotNumbers) {
  Chart chart({"x", 0.0, 0.0}, {"y", NAN, 1.0});
  chart.dots(std::vector<Eigen::Vector2d>{{NAN, 0.0}, {0.5, 0.5}}, ink::kVision);
  EXPECT_THAT(chart.svg(), Not(HasSubstr("nan")));
}

TEST(Splatter, TheNearerPointHidesTheFartherOneInAnyOrder) {
  const ParallelView view =
      view_from_above({Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(10.0, 10.0)}, 11);
  const Eigen::Vector3f low(5.0F, 5.0F, 0.0F);
  const Eigen::Vector3f high(5.0F, 5.0F, 3.0F);
  for (const bool low_first : {true, false}) {
    Splatter splatter(view);
    if (low_first) splatter.add(low, {255, 0, 0}, 0);
    splatter.add(high, {0, 255, 0}, 0);
    if (!low_first) splatter.add(low, {255, 0, 0}, 0);
    const Image8 image = splatter.image({0, 0, 0});
    EXPECT_EQ(image.pixels[3 * (5 * image.width + 5) + 1], 255);
    EXPECT_EQ(image.pixels[3 * (5 * image.width + 5)], 0);
  }
}

TEST(Splatter, BlankRowsAreCutButForAMarginAndStrayPointsDoNotCount) {
  constexpr Rgb8 kPaper = {250, 250, 250};
  constexpr int kWidth = 200;
  Image8 image{.width = kWidth, .height = 100, .channels = 3};
  image.pixels.assign(3 * kWidth * 100, 250);
  for (std::size_t i = 3 * kWidth * 40; i < 3 * kWidth * 60; ++i) image.pixels[i] = 10;
  image.pixels[3 * kWidth * 5] = 0;  // a stray point
  const Image8 cut = without_blank_rows(image, kPaper);
  EXPECT_EQ(cut.height, 20 + 2 * 14);
  EXPECT_EQ(cut.pixels.size(), 3U * kWidth * 48);
  EXPECT_EQ(cut.pixels[3 * kWidth * 14], 10);
  image.pixels.assign(image.pixels.size(), 250);
  EXPECT_EQ(without_blank_rows(image, kPaper).height, 100) << "nothing is drawn";
}

TEST(Splatter, NorthIsUpAndEastIsRightFromAbove) {
  const ParallelView view =
      view_from_above({Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(10.0, 10.0)}, 100);
  const Eigen::Vector3d north_east = view.picture_from_world * Eigen::Vector3d(9.0, 9.0, 0.0);
  EXPECT_GT(north_east.x(), 50.0);
  EXPECT_LT(north_east.y(), 50.0);
}

TEST(Splatter, AnObliqueViewFromTheSouthHasEastToTheRightAndUpUpwards) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-5.0, -5.0, 0.0), Eigen::Vector3d(5.0, 5.0, 5.0));
  const ParallelView view = oblique_view(box, std::numbers::pi, 0.5, 200);
  const auto at = [&](double x, double y, double z) {
    return Eigen::Vector3d(view.picture_from_world * Eigen::Vector3d(x, y, z));
  };
  EXPECT_GT(at(1.0, 0.0, 0.0).x(), at(-1.0, 0.0, 0.0).x());
  EXPECT_LT(at(0.0, 0.0, 2.0).y(), at(0.0, 0.0, 0.0).y());
  EXPECT_LT(at(0.0, -1.0, 0.0).z(), at(0.0, 1.0, 0.0).z()) << "south is nearer";
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

}  // namespace
}  // namespace hybridfusion
