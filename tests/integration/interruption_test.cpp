#include "program.hpp"

#include <chrono>
#include <csignal>

#include <gmock/gmock.h>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;

/// Grid of unit spacing, as `x y z` lines.
std::string field_of(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += std::to_string(i % 100) + " " + std::to_string(i / 100) + " 0\n";
  }
  return text;
}

class Interruption : public ProgramTest {
 protected:
  [[nodiscard]] static std::string data(const std::string& name) {
    return (*test_data() / name).string();
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
      if (entry.is_regular_file()) names.push_back(entry.path().string());
    }
    return names;
  }

  /// Runs a stage undisturbed, then in another workspace with kill -9 at shares of that time
  /// and once more to its end: the files must be the same and nothing half written may be left.
  void expect_resume_to_the_same_bytes(std::vector<std::string> arguments,
                                       const std::vector<std::string>& results) const {
    arguments.insert(arguments.end(), {"--output", path("whole")});
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run_program(arguments).exit_code, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
    arguments.back() = path("killed");
    for (const double share : {0.3, 0.7}) {
      const ProgramResult killed =
          run_program(arguments, {.signal_after_s = share * whole.count(), .signal = SIGKILL});
      if (killed.exit_code == 0) break;  // the machine was quicker this time
      EXPECT_EQ(killed.exit_code, 128 + SIGKILL) << killed.err;
    }
    const ProgramResult resumed = run_program(arguments);
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    for (const std::string& name : results) {
      EXPECT_TRUE(read_file(path("killed/" + name)) == read_file(path("whole/" + name))) << name;
    }
    for (const std::string& name : files()) EXPECT_FALSE(name.ends_with(".part")) << name;
  }
};

TEST_F(Interruption, AKilledMappingResumesToTheSameBytes) {
  HF_NEEDS_TEST_DATA();
  expect_resume_to_the_same_bytes({"map", "--bag", data("block-12-avia/street.bag")},
                                  {"lidar/map.ply", "lidar/trajectory.tum", "lidar/gnss.json"});
}

TEST_F(Interruption, AKilledRegistrationResumesToTheSameBytes) {
  HF_NEEDS_TEST_DATA();
  expect_resume_to_the_same_bytes(
      {"register", "--vision", data("pairs/pair-21/G.ply"), "--lidar", data("pairs/pair-21/L.ply")},
      {"fused/fused.ply", "fused/fused.las"});
}

TEST_F(Interruption, AKilledReconstructionResumesToTheSameBytes) {
  HF_NEEDS_TEST_DATA();
  std::filesystem::create_directories(path("images"));
  for (int i = 1; i <= 6; ++i) {
    const std::string name = "IMG_000" + std::to_string(i) + ".JPG";
    std::filesystem::copy(data("block-11/images/" + name), path("images/" + name));
  }
  expect_resume_to_the_same_bytes({"reconstruct",
                                   "--images",
                                   path("images"),
                                   "--set",
                                   "vision.reconstruction.features.min_keypoints=1000",
                                   "--set",
                                   "vision.reconstruction.features.max_keypoints=2000",
                                   "--set",
                                   "vision.densify.max_size_px=400"},
                                  {"vision/dense.ply", "vision/images.txt", "vision/points3D.txt"});
}

TEST_F(Interruption, AFullDiskIsToldWithPathAndBytesAndLeavesNoHalfFile) {
  const std::string cloud = write("in.xyz", field_of(20000));
  for (const char* name : {"out.ply", "out.pcd", "out.las", "out.xyz"}) {
    const ProgramResult result =
        run_program({"convert", cloud, path(name)}, {.max_file_bytes = 2000});
    EXPECT_EQ(result.exit_code, 5) << name << result.err;
    EXPECT_THAT(result.err, HasSubstr(path(name)));
    EXPECT_THAT(result.err, HasSubstr("bytes"));
    EXPECT_FALSE(std::filesystem::exists(path(name))) << name;
  }
  EXPECT_EQ(files().size(), 1U);  // the input alone: no *.part
}

TEST_F(Interruption, AFullDiskLeavesTheFormerResultAlone) {
  const std::string cloud = write("in.xyz", field_of(20000));
  write("out.ply", "the former result");
  EXPECT_EQ(run_program({"convert", cloud, path("out.ply")}, {.max_file_bytes = 2000}).exit_code,
            5);
  EXPECT_EQ(read_file(path("out.ply")), "the former result");
}

TEST_F(Interruption, OddPathsWorkAndAreShownOnOneLine) {
  const std::string odd = "a folder\nwith \xc3\xa4\xe6\x97\xa5 & <b>\"quotes\"'";
  const std::string cloud = write(odd + "/in.xyz", field_of(3000));
  ASSERT_EQ(run_program({"convert", cloud, path(odd + "/out.ply")}).exit_code, 0);
  const ProgramResult result = run_program({"register",
                                            "--vision",
                                            path(odd + "/out.ply"),
                                            "--lidar",
                                            path(odd + "/out.ply"),
                                            "--output",
                                            path(odd + "/ws")});
  EXPECT_EQ(result.exit_code, 4) << result.err;  // a flat field fits anywhere
  const std::string report = read_file(path(odd + "/ws/report/index.html"));
  EXPECT_FALSE(report.empty());
  EXPECT_EQ(report.find("<b>\"quotes\""), std::string::npos);
}

TEST_F(Interruption, ALoopOfLinksIsAnErrorAndNoHang) {
  std::filesystem::create_directories(path("images"));
  std::filesystem::create_directory_symlink(path("images"), path("images/loop"));
  std::filesystem::create_symlink(path("images/b.jpg"), path("images/a.jpg"));
  std::filesystem::create_symlink(path("images/a.jpg"), path("images/b.jpg"));
  const ProgramResult result =
      run_program({"reconstruct", "--images", path("images"), "--output", path("ws")});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("a.jpg"));
}

}  // namespace
}  // namespace hybridfusion::testing
