#pragma once

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion::testing {

struct ProgramResult {
  int exit_code = -1;
  std::string out = {};
  std::string err = {};
};

/// What happens to the program while it runs.
struct Adversity {
  double signal_after_s = 0.0;  ///< Sends `signal` after this time when it still runs; 0: never.
  int signal = SIGTERM;
  std::uint64_t max_file_bytes = 0;  ///< RLIMIT_FSIZE; 0: no limit.
};

/// Runs hybridfusion with these arguments and waits for it. An end by a signal is exit code 128 +
/// n.
[[nodiscard]] ProgramResult run_program(const std::vector<std::string>& arguments,
                                        const Adversity& adversity = {});

/// A test with a folder of its own that is deleted at the end.
class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// A path inside the folder.
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  /// Creates a file with this content, and its folder.
  std::string write(const std::string& name, const std::string& content) const;

  std::filesystem::path folder_ = {};
};

/// Root of the recordings for tests, or nothing when HYBRIDFUSION_TEST_DATA is not set.
[[nodiscard]] std::optional<std::filesystem::path> test_data();

[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace hybridfusion::testing

#define HF_NEEDS_TEST_DATA()                                                                  \
  if (!::hybridfusion::testing::test_data()) {                                                \
    GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder with the recordings for tests"; \
  }
