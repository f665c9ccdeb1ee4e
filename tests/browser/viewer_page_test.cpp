#include "browser.hpp"
#include "sample_workspace.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/io/ply.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;

constexpr double kPatience_s = 60.0;  // software drawing on a busy machine
const char* const kIdle = "document.getElementById('view').getAttribute('aria-busy') === 'false'";

/// `hybridfusion view` on a workspace, and a browser that looks at it.
class ViewerPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Browser::program()) GTEST_SKIP() << "Chromium is not installed: the page is not looked at";
    folder_ = std::filesystem::temp_directory_path() / ("hf_browser_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "ws");
  }
  void TearDown() override {
    browser_.reset();
    viewer_.reset();
    std::filesystem::remove_all(folder_);
  }

  /// Serves the workspace and opens it.
  void start(bool webgl = true) {
    viewer_ = std::make_unique<ChildProcess>(
        std::vector<std::string>{
            HF_PROGRAM, "view", (folder_ / "ws").string(), "--no-browser", "--json"},
        std::map<int, int>{{STDOUT_FILENO, out_.write_end}});
    out_.close_write();
    std::string rest;
    const Json said =
        Json::parse(read_until(out_.read_end, '\n', rest, kPatience_s), nullptr, false);
    ASSERT_TRUE(said.is_object());
    url_ = said.value("url", "");
    ASSERT_THAT(url_, HasSubstr("http://127.0.0.1:"));
    browser_ = std::make_unique<Browser>(folder_ / "profile", webgl);
    browser_->open(url_);
    ASSERT_TRUE(browser_->wait_for(kIdle, kPatience_s)) << "the page never came to rest";
  }

  void click(const std::string& id) {
    (void)browser_->evaluate("document.getElementById('" + id + "').click()");
    (void)browser_->evaluate("new Promise(r => setTimeout(r, 100))");
    ASSERT_TRUE(browser_->wait_for(kIdle, kPatience_s));
  }

  std::filesystem::path folder_ = {};
  Pipe out_;
  std::unique_ptr<ChildProcess> viewer_ = {};
  std::unique_ptr<Browser> browser_ = {};
  std::string url_ = {};
};

// The panel and the lines at the top and the bottom are not the picture.
constexpr int kLeft_px = 270;
constexpr int kTop_px = 60;
constexpr int kBottom_px = 40;

struct PictureStatistics {
  double drawn = 0.0;    ///< Share of pixels that are not background.
  double colored = 0.0;  ///< Share whose channels differ.
};

PictureStatistics statistics_of(const Image8& image) {
  PictureStatistics result;
  std::size_t count = 0;
  for (int y = kTop_px; y < image.height - kBottom_px; ++y) {
    for (int x = kLeft_px; x < image.width; ++x) {
      const std::uint8_t* p = &image.pixels[3 * (static_cast<std::size_t>(y) * image.width + x)];
      const int high = std::max({p[0], p[1], p[2]});
      const int low = std::min({p[0], p[1], p[2]});
      ++count;
      if (high > 60) result.drawn += 1.0;
      if (high - low > 40) result.colored += 1.0;
    }
  }
  result.drawn /= static_cast<double>(std::max<std::size_t>(1, count));
  result.colored /= static_cast<double>(std::max<std::size_t>(1, count));
  return result;
}

double mean_difference(const Image8& a, const Image8& b) {
  if (a.pixels.size() != b.pixels.size() || a.pixels.empty()) return 255.0;
  double sum = 0.0;
  std::size_t count = 0;
  for (int y = kTop_px; y < a.height - kBottom_px; ++y) {
    for (int x = kLeft_px; x < a.width; ++x) {
      const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                                  static_cast<std::size_t>(x));
      for (std::size_t k = at; k < at + 3; ++k) sum += std::abs(a.pixels[k] - b.pixels[k]);
      count += 3;
    }
  }
  return sum / static_cast<double>(count);
}

TEST_F(ViewerPage, ShowsTheFusedCloudInColourAndSwitchesLayersAndColours) {
  write_sample_workspace(folder_ / "ws");
  start();
  const Image8 fused = browser_->screenshot();
  ASSERT_GT(fused.width, 0);
  EXPECT_GT(statistics_of(fused).drawn, 0.05) << "the picture is blank";
  EXPECT_GT(statistics_of(fused).colored, 0.02) << "the cloud has no colour";
  EXPECT_LT(mean_difference(fused, browser_->screenshot()), 0.2) << "the picture does not rest";

  Image8 last = fused;
  for (const char* mode : {"height", "intensity", "source", "distance", "rgb"}) {
    click(std::string("mode-") + mode);
    const Image8 shown = browser_->screenshot();
    EXPECT_GT(mean_difference(last, shown), 1.0) << mode << " looks like the colouring before it";
    last = shown;
  }
  EXPECT_LT(mean_difference(fused, last), 0.2) << "the photos' colours come back";
  click("layer-fused");
  EXPECT_LT(statistics_of(browser_->screenshot()).drawn, 0.01) << "nothing is switched on";
  click("layer-vision");
  const Image8 vision = browser_->screenshot();
  EXPECT_GT(statistics_of(vision).drawn, 0.03);
  click("layer-vision");
  click("layer-lidar");
  const Image8 lidar = browser_->screenshot();
  EXPECT_GT(statistics_of(lidar).drawn, 0.01);
  EXPECT_GT(mean_difference(vision, lidar), 1.0);
  EXPECT_THAT(browser_->errors(), IsEmpty());
  EXPECT_EQ(viewer_->end(SIGINT, 10.0), 0) << "Ctrl-C ends the viewer cleanly";
}

TEST_F(ViewerPage, TheSliderMovesTheLidarCloudAndEveryKeyIsHarmless) {
  write_sample_workspace(folder_ / "ws");
  start();
  EXPECT_EQ(browser_->evaluate("document.getElementById('registration').hidden"), Json(false));
  const auto slide = [&](const char* to) {
    (void)browser_->evaluate(
        std::string("(() => { const s = document.getElementById('slider'); s.value = ") + to +
        "; s.dispatchEvent(new Event('input')); })()");
    EXPECT_TRUE(browser_->wait_for(kIdle, kPatience_s));
    return browser_->screenshot();
  };
  const Image8 after = slide("1");
  const Image8 before = slide("0");
  EXPECT_GT(mean_difference(before, after), 0.5);
  for (const char* key : {"1",
                          "2",
                          "3",
                          "c",
                          "c",
                          "c",
                          "m",
                          "Escape",
                          "f",
                          "t",
                          "p",
                          "l",
                          "e",
                          "+",
                          "-",
                          "h",
                          "h",
                          "b",
                          "?"}) {
    (void)browser_->evaluate(
        std::string("window.dispatchEvent(new KeyboardEvent('keydown', {key: '") + key + "'}))");
  }
  EXPECT_EQ(browser_->evaluate("document.getElementById('keyboard').open"), Json(true));
  EXPECT_THAT(browser_->errors(), IsEmpty());
}

/// A roof of many points, where the sample workspace has its fused cloud.
void write_large_cloud(const std::filesystem::path& file) {
  Random random(4, "test/large-cloud");
  PointCloud cloud;
  for (int i = 0; i < 700'000; ++i) {
    cloud.points.emplace_back(static_cast<float>(random.uniform(-30.0, 30.0)),
                              static_cast<float>(random.uniform(-30.0, 30.0)),
                              0.0F);
    cloud.colors.push_back({190, 70, 50});
  }
  ASSERT_TRUE(write_ply(file, cloud));
}

TEST_F(ViewerPage, ASlowMachineShowsFewerPointsWhileTheViewMovesAndMoreOnceItRests) {
  write_sample_workspace(folder_ / "ws");
  write_large_cloud(folder_ / "ws/fused/fused.ply");
  start();
  // Four frames a second from here on; the view is set again with each of them.
  (void)browser_->evaluate(
      "(() => { window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), "
      "250);"
      "window.moves = setInterval(() => document.getElementById('frame').click(), 100); })()");
  (void)browser_->evaluate("new Promise(r => setTimeout(r, 5000))");
  const auto shown = [&] {
    return browser_->evaluate("parseInt(document.getElementById('status').textContent)").get<int>();
  };
  const int moving = shown();
  (void)browser_->evaluate("clearInterval(window.moves)");
  ASSERT_TRUE(browser_->wait_for(kIdle, kPatience_s));
  EXPECT_GT(moving, 0);
  EXPECT_LE(moving, 400);
  EXPECT_GT(shown(), 1.2 * moving);
  EXPECT_THAT(browser_->errors(), IsEmpty());
}

TEST_F(ViewerPage, MeasuringDrawsTheLineOverTheCloud) {
  write_sample_workspace(folder_ / "ws");
  start();
  click("measure");
  const Image8 without = browser_->screenshot();
  const auto press = [&](int x, int y) {
    std::string script = "(() => { const c = document.getElementById('view');";
    for (const char* event : {"pointerdown", "pointerup", "click"}) {
      script.append("c.dispatchEvent(new PointerEvent('").append(event);
      script.append("', {clientX: ").append(std::to_string(x)).append(", clientY: ");
      script.append(std::to_string(y)).append(", bubbles: true, button: 0, pointerId: 1}));");
    }
    (void)browser_->evaluate(script + "})()");
    ASSERT_TRUE(browser_->wait_for(kIdle, kPatience_s));
  };
  const auto said = [&] {
    return browser_->evaluate("document.getElementById('message').textContent").get<std::string>();
  };
  // Not every place has a point under it.
  for (int x = 420; x < 820 && said().find("horizontal") == std::string::npos; x += 50) {
    press(x, 330);
  }
  EXPECT_THAT(said(), HasSubstr("horizontal"));
  EXPECT_GT(mean_difference(without, browser_->screenshot()), 0.02) << "no line is seen";
}

TEST_F(ViewerPage, WorksWithPhotosOrLidarAlone) {
  write_sample_workspace(folder_ / "ws");
  for (const char* gone : {"lidar", "fused", "registration", "evaluation"}) {
    std::filesystem::remove_all(folder_ / "ws" / gone);
  }
  start();
  EXPECT_GT(statistics_of(browser_->screenshot()).drawn, 0.03);
  EXPECT_EQ(browser_->evaluate("document.querySelectorAll('#layers input').length"), Json(1));
  EXPECT_EQ(browser_->evaluate("document.getElementById('registration').hidden"), Json(true));
  EXPECT_EQ(browser_->evaluate("document.getElementById('mode-distance').disabled"), Json(true));
  EXPECT_THAT(browser_->errors(), IsEmpty());
}

TEST_F(ViewerPage, SaysSoWhenThereIsNoWebGl) {
  write_sample_workspace(folder_ / "ws");
  start(/*webgl=*/false);
  EXPECT_EQ(browser_->evaluate("document.getElementById('failure').hidden"), Json(false));
  EXPECT_THAT(
      browser_->evaluate("document.getElementById('failure').textContent").get<std::string>(),
      HasSubstr("WebGL"));
}

}  // namespace
}  // namespace hybridfusion::testing
