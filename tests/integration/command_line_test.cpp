#include "program.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;

class CommandLine : public ProgramTest {};

/// As the program itself lists them, so that none is forgotten.
std::vector<std::string> commands() {
  std::istringstream lines(run_program({"completion", "commands"}).out);
  std::vector<std::string> names;
  for (std::string name; std::getline(lines, name);) names.push_back(name);
  return names;
}

TEST_F(CommandLine, HelpOfEveryCommandSaysWhatItReadsAndWritesWithAnExampleAndTheExitCodes) {
  EXPECT_EQ(run_program({"--help"}).exit_code, 0);
  EXPECT_GE(commands().size(), 10U);
  for (const std::string& command : commands()) {
    const ProgramResult result = run_program({command, "--help"});
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_THAT(result.out, HasSubstr("\nReads:\n")) << command;
    EXPECT_THAT(result.out, HasSubstr("\nWrites:\n")) << command;
    EXPECT_THAT(result.out, HasSubstr("\nExample:\n")) << command;
    EXPECT_THAT(result.out, HasSubstr("hybridfusion " + command)) << command;
    EXPECT_THAT(result.out, HasSubstr("Exit codes")) << command;
  }
}

TEST_F(CommandLine, PrintsItsVersion) {
  const ProgramResult result = run_program({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("hybridfusion 0."));
}

TEST_F(CommandLine, WrongUsageIsExitCode2WithNothingOnStdout) {
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"fly"},
      {"run"},
      {"register", "--vision", "G.ply", "--lidar", "L.ply"},
      {"register", "--vision", "G", "--lidar", "L", "--output", path("ws"), "--method", "magic"},
      {"register", "--vision", "G", "--lidar", "L", "--output", path("ws"), "--max-yaw-deg", "200"},
      {"run", "--images", "a", "--bag", "b", "--output", path("ws"), "--from", "nowhere"},
      {"config", "--unknown-option"},
      {"config", "--quiet", "--verbose"},
      {"config", "--set", "evaluation.leaf_m"},
      {"config", "--set", "evaluation.leave_m=1"},
      {"config", "--set", "evaluation.leaf_m=-1"},
      {"config", "--set", "evaluation.leaf_m=wide"},
      {"evaluate"},
      {"evaluate", "--vision", "G.ply"},
  };
  for (const auto& arguments : wrong) {
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << ::testing::PrintToString(arguments) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
    EXPECT_FALSE(result.err.empty()) << ::testing::PrintToString(arguments);
  }
}

TEST_F(CommandLine, AMisspeltOptionIsNamedWithTheKnownOnes) {
  const ProgramResult result = run_program({"config", "--set", "evaluation.leave_m=1"});
  EXPECT_THAT(result.err, HasSubstr("evaluation.leave_m"));
  EXPECT_THAT(result.err, HasSubstr("leaf_m"));
  const std::string file = write("bad.yaml", "evaluation:\n  leave_m: 1\n");
  const ProgramResult from_file = run_program({"config", "--config", file});
  EXPECT_EQ(from_file.exit_code, 2);
  EXPECT_THAT(from_file.err, HasSubstr("line 2"));
}

TEST_F(CommandLine, TheConfigurationReadsBackToItself) {
  const ProgramResult first = run_program(
      {"config", "--set", "evaluation.leaf_m=0.25", "--set", "registration.voxel_m=0.3"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("leaf_m: 0.25"));
  const ProgramResult second = run_program({"--config", write("all.yaml", first.out), "config"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(first.out, second.out);
}

TEST_F(CommandLine, TheOptionReferenceHasARowForEveryOption) {
  const ProgramResult result = run_program({"config", "--markdown"});
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("| `evaluation.leaf_m` | 0.5 | m |"));
  EXPECT_THAT(result.out, HasSubstr("| `registration.max_offset_m` | 20 | m |"));
}

TEST_F(CommandLine, ConvertKeepsThePoints) {
  const std::string xyz = write("in.xyz", "0 0 0\n1.5 2 -3\n4 5 6\n");
  for (const char* name : {"a.ply", "b.pcd", "c.las", "d.xyz"}) {
    const ProgramResult result = run_program({"convert", xyz, path(name), "--json"});
    ASSERT_EQ(result.exit_code, 0) << name << result.err;
    EXPECT_EQ(nlohmann::json::parse(result.out).at("num_points"), 3) << name;
    EXPECT_TRUE(std::filesystem::exists(path(name)));
  }
  const ProgramResult back = run_program({"convert", path("b.pcd"), path("e.xyz")});
  ASSERT_EQ(back.exit_code, 0) << back.err;
  EXPECT_THAT(read_file(path("e.xyz")), HasSubstr("1.5"));
  EXPECT_EQ(run_program({"convert", xyz, path("f.docx")}).exit_code, 2);
}

}  // namespace
}  // namespace hybridfusion::testing
