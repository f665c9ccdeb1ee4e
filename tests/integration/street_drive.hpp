#pragma once

#include "program.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace hybridfusion::testing {

/// Simulates a recording without photos that is small enough to be mapped within a second or two:
/// 16 rings of 180 points, ten scans a second.
/// @param settings  "drive.duration_s=30": options of the simulation besides these.
void simulate_street(const std::filesystem::path& folder,
                     const std::vector<std::string>& settings = {});

/// Root mean square position error [m] of a mapped drive, after the best rigid alignment; infinite
/// when there is no trajectory.
[[nodiscard]] double drive_error_m(const std::filesystem::path& workspace,
                                   const std::filesystem::path& data_set);

/// All flags that a scan of a mapped drive has.
[[nodiscard]] std::set<std::string> quality_flags(const std::filesystem::path& workspace);

/// A test with a simulated drive of 18 s, shared by the tests of a suite.
class StreetTest : public ProgramTest {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();

  [[nodiscard]] static const std::filesystem::path& street() { return street_; }
  /// Maps a recording of this drive into the workspace `name`.
  [[nodiscard]] ProgramResult map(const std::string& recording,
                                  const std::string& name,
                                  const std::vector<std::string>& more = {}) const;
  [[nodiscard]] double error_m(const std::string& workspace) const {
    return drive_error_m(path(workspace), street_);
  }

 private:
  static std::filesystem::path street_;
};

}  // namespace hybridfusion::testing
