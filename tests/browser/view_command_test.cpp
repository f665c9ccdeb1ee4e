#include "child_process.hpp"
#include "sample_workspace.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

class ViewCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() / ("hf_view_" + std::to_string(::getpid()));
    std::filesystem::remove_all(root_);
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  /// Starts the viewer, waits for its address, stops it. @returns its exit code.
  int start_and_stop(int signal) const {
    Pipe out;
    ChildProcess viewer({HF_PROGRAM, "view", root_.string(), "--no-browser", "--json"},
                        {{STDOUT_FILENO, out.write_end}});
    out.close_write();
    std::string rest;
    const Json said = Json::parse(read_until(out.read_end, '\n', rest, 60.0), nullptr, false);
    EXPECT_EQ(said.value("status", ""), "ok");
    EXPECT_EQ(said.value("url", ""),
              "http://127.0.0.1:" + std::to_string(said.value("port", 0)) + "/");
    return viewer.end(signal, 10.0);
  }

  std::filesystem::path root_ = {};
};

TEST_F(ViewCommand, PrintsItsAddressEndsCleanlyAndKeepsTheOctrees) {
  write_sample_workspace(root_);
  EXPECT_EQ(start_and_stop(SIGINT), 0);
  const auto octree = root_ / "cache/view/fused/octree.bin";
  const auto written = std::filesystem::last_write_time(octree);
  EXPECT_EQ(start_and_stop(SIGTERM), 0);
  EXPECT_EQ(std::filesystem::last_write_time(octree), written) << "nothing had changed";
  std::filesystem::last_write_time(root_ / "vision/dense.ply",
                                   std::filesystem::file_time_type::clock::now());
  EXPECT_EQ(start_and_stop(SIGTERM), 0);
  EXPECT_NE(std::filesystem::last_write_time(octree), written) << "a cloud had changed";
}

TEST_F(ViewCommand, ShowsAWorkspaceInWhichAnotherProcessWorksWithoutWritingThere) {
  write_sample_workspace(root_);
  const int lock = ::open((root_ / ".lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  const auto temporary = root_ / "temporary";
  std::filesystem::create_directory(temporary);
  ::setenv("TMPDIR", temporary.c_str(), 1);
  EXPECT_EQ(start_and_stop(SIGINT), 0);
  ::unsetenv("TMPDIR");
  ::close(lock);
  EXPECT_FALSE(std::filesystem::exists(root_ / "cache"));
  EXPECT_TRUE(std::filesystem::is_empty(temporary)) << "what was prepared is gone";
}

TEST_F(ViewCommand, AFolderWithoutCloudsIsUnusableInput) {
  Pipe err;
  ChildProcess viewer({HF_PROGRAM, "view", root_.string(), "--no-browser"},
                      {{STDERR_FILENO, err.write_end}});
  err.close_write();
  std::string rest;
  EXPECT_THAT(read_until(err.read_end, '\n', rest, 30.0), HasSubstr("holds no cloud to show"));
  constexpr int kNoSignal = 0;
  EXPECT_EQ(viewer.end(kNoSignal, 10.0), 3);
  EXPECT_FALSE(std::filesystem::exists(root_)) << "looking at nothing creates nothing";
}

}  // namespace
}  // namespace hybridfusion::testing
