#include "program.hpp"

#include <hybridfusion/io/ply.hpp>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace hybridfusion::testing {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

/// reconstruct --watch on a small simulated flight.
class Watch : public ProgramTest {
 protected:
  static void SetUpTestSuite() {
    flight_ = std::filesystem::temp_directory_path() /
              ("hf_flight_" + std::to_string(static_cast<long>(::getpid())));
    std::filesystem::remove_all(flight_);
    std::vector<std::string> arguments = {
        "simulate", "--output", flight_.string(), "--seed", "3", "--quiet"};
    for (const char* setting : {"drive.enabled=false",
                                "flight.oblique_photos=0",
                                "flight.altitude_m=90",
                                "camera.width_px=480",
                                "camera.height_px=360",
                                "camera.samples_per_pixel=1",
                                "samples_per_m2=0.1",
                                "world.ambient_rays=4"}) {
      arguments.insert(arguments.end(), {"--set", std::string("simulation.") + setting});
    }
    const ProgramResult result = run_program(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(flight_); }

  [[nodiscard]] static std::vector<std::string> photo_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(flight_ / "images")) {
      if (entry.path().extension() == ".JPG") names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
  }
  /// Lets a photo arrive as a card reader would: under its name, in two pieces.
  void arrive(const std::string& name) const {
    const std::string bytes = read_file(flight_ / "images" / name);
    write("in/" + name, bytes.substr(0, bytes.size() / 3));
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    write("in/" + name, bytes);
  }
  [[nodiscard]] std::vector<std::string> watch_arguments(const std::string& workspace) const {
    std::vector<std::string> arguments = common("--watch", workspace);
    arguments.insert(arguments.end(), {"--idle-s", "2"});
    return arguments;
  }
  [[nodiscard]] std::vector<std::string> common(const std::string& option,
                                                const std::string& workspace) const {
    return {"reconstruct",
            option,
            path("in"),
            "--output",
            path(workspace),
            "--set",
            "vision.densify.max_size_px=300",
            "--set",
            "watch.preview_size_px=300"};
  }

  static std::filesystem::path flight_;
};

std::filesystem::path Watch::flight_ = {};

TEST_F(Watch, EndsInTheSameBytesAsAPlainReconstruction) {
  std::filesystem::create_directories(path("in"));
  std::thread camera([&] {
    for (const std::string& name : photo_names()) arrive(name);
  });
  std::vector<std::string> arguments = watch_arguments("watched");
  arguments.back() = "5";  // a busy machine may let a photo wait
  const ProgramResult watched = run_program(arguments);
  camera.join();
  ASSERT_EQ(watched.exit_code, 0) << watched.err;
  const ProgramResult plain = run_program(common("--images", "plain"));
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  for (const char* name : {"cameras.txt",
                           "images.txt",
                           "points3D.txt",
                           "positions.csv",
                           "pose_covariance.csv",
                           "origin.json",
                           "dense.ply"}) {
    const std::string file = std::string("/vision/") + name;
    EXPECT_TRUE(read_file(path("watched" + file)) == read_file(path("plain" + file))) << name;
  }
  for (const std::string& name : photo_names()) EXPECT_THAT(watched.out, HasSubstr(name));
  EXPECT_THAT(read_file(path("watched/vision/cameras.csv")), HasSubstr(photo_names().back()));
  const auto preview = read_ply(path("watched/vision/preview.ply"));
  ASSERT_TRUE(preview) << preview.error().message;
  EXPECT_GT(preview->size(), 500U);
  EXPECT_TRUE(std::filesystem::exists(path("watched/vision/preview_origin.json")));
  EXPECT_FALSE(std::filesystem::exists(path("watched/vision/cache")));
  EXPECT_FALSE(std::filesystem::exists(path("plain/vision/cache")));
  // The photos did not change: a plain call has nothing to do.
  const ProgramResult again = run_program(common("--images", "watched"));
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.out, HasSubstr("up to date"));
}

TEST_F(Watch, AKilledWatchIsTakenUpAndDamagedAndRepeatedPhotosAreListed) {
  const std::vector<std::string> names = photo_names();
  for (const std::string& name : names) write("in/" + name, read_file(flight_ / "images" / name));
  write("in/COPY.JPG", read_file(flight_ / "images" / names.front()));
  write("in/BROKEN.JPG", read_file(flight_ / "images" / names.back()).substr(0, 4000));
  std::vector<std::string> arguments = watch_arguments("ws");
  arguments.emplace_back("--preview-only");
  const ProgramResult killed = run_program(arguments, {.signal_after_s = 3.0, .signal = SIGKILL});
  EXPECT_EQ(killed.exit_code, 128 + SIGKILL) << killed.err;
  arguments.emplace_back("--json");
  const ProgramResult watched = run_program(arguments);
  ASSERT_EQ(watched.exit_code, 0) << watched.err;
  std::istringstream lines(watched.out);
  std::size_t events = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with("{\"event\"");) {
    const Json event = Json::parse(line);
    const bool usable = event.at("name") != "COPY.JPG" && event.at("name") != "BROKEN.JPG";
    if (!usable) {
      EXPECT_FALSE(event.at("registered").get<bool>());
      EXPECT_FALSE(event.at("reason").get<std::string>().empty());
    }
    ++events;
  }
  EXPECT_EQ(events, names.size() + 2);
  const std::string result_text = watched.out.substr(watched.out.find("\n{\n"));
  const Json result = Json::parse(result_text).at("stages").at("watch").at("result");
  EXPECT_EQ(result.at("num_photos"), names.size() + 2);
  EXPECT_EQ(result.at("num_registered"), names.size());
  EXPECT_EQ(result.at("not_registered").size(), 2U);
  EXPECT_FALSE(std::filesystem::exists(path("ws/vision/dense.ply")));
  EXPECT_TRUE(std::filesystem::exists(path("ws/vision/cache")));  // for what comes next
}

TEST_F(Watch, AnInterruptEndsItResumably) {
  std::filesystem::create_directories(path("in"));
  const ProgramResult result =
      run_program(watch_arguments("ws"), {.signal_after_s = 1.0, .signal = SIGINT});
  EXPECT_EQ(result.exit_code, 130) << result.err;
}

TEST_F(Watch, AFolderWithoutPhotosAndWrongUsageAreTold) {
  std::filesystem::create_directories(path("in"));
  const ProgramResult idle = run_program(watch_arguments("ws"));
  EXPECT_EQ(idle.exit_code, 3);
  EXPECT_THAT(idle.err, HasSubstr("no photo arrived"));
  std::filesystem::remove_all(path("in"));
  EXPECT_EQ(run_program(watch_arguments("ws")).exit_code, 3);
  std::vector<std::string> both = watch_arguments("ws");
  both.insert(both.end(), {"--images", path("in")});
  EXPECT_EQ(run_program(both).exit_code, 2);
  EXPECT_EQ(run_program({"reconstruct", "--output", path("ws")}).exit_code, 2);
}

}  // namespace
}  // namespace hybridfusion::testing
