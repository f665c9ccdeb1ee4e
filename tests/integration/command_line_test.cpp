#include "program.hpp"

#include <map>
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

TEST_F(CommandLine, TheConfigurationReadsBackFromJsonToo) {
  const ProgramResult json = run_program({"config", "--set", "evaluation.leaf_m=0.25", "--json"});
  ASSERT_EQ(json.exit_code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out).at("evaluation").at("leaf_m"), 0.25);
  const ProgramResult yaml = run_program({"config", "--set", "evaluation.leaf_m=0.25"});
  EXPECT_EQ(run_program({"--config", write("all.json", json.out), "config"}).out, yaml.out);
}

TEST_F(CommandLine, JsonOfEveryCommandIsOneObjectWhateverHappens) {
  const std::string xyz = write("in.xyz", "0 0 0\n1.5 2 -3\n4 5 6\n");
  const std::string nowhere = path("nowhere");
  const std::map<std::string, std::vector<std::vector<std::string>>> arguments = {
      {"run", {{"--images", nowhere, "--bag", nowhere, "--output", path("a")}}},
      {"reconstruct", {{"--images", nowhere, "--output", path("b")}}},
      {"map", {{"--bag", nowhere, "--output", path("c")}}},
      {"register",
       {{"--vision", xyz, "--lidar", xyz, "--output", path("d")},
        {"--vision", nowhere, "--lidar", xyz, "--output", path("e")}}},
      {"evaluate", {{"--workspace", nowhere}, {"--vision", xyz, "--lidar", nowhere}}},
      {"convert", {{xyz, path("out.ply")}, {nowhere, path("out.las")}}},
      {"config", {{}}},
      {"simulate", {{"--output", xyz}}},
      {"view", {{nowhere, "--no-browser"}}},
      {"doctor", {{}, {"--images", nowhere}}},
      {"completion", {{"bash"}, {"zsh"}, {"commands"}}}};
  for (const std::string& command : commands()) {
    ASSERT_TRUE(arguments.contains(command)) << command << ": add it here";
    for (std::vector<std::string> line : arguments.at(command)) {
      line.insert(line.begin(), command);
      line.emplace_back("--json");
      const ProgramResult result = run_program(line);
      const nlohmann::json json = nlohmann::json::parse(result.out, nullptr, false);
      ASSERT_TRUE(json.is_object()) << ::testing::PrintToString(line) << result.out;
      EXPECT_EQ(json.value("exit_code", result.exit_code), result.exit_code);
      EXPECT_EQ(json.value("status", "ok") == "ok", result.exit_code == 0)
          << ::testing::PrintToString(line);
    }
  }
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

TEST_F(CommandLine, ConvertPlacesACloudAndDrawsItFromAbove) {
  const std::string origin = write("vision/origin.json",
                                   R"({"latitude_deg": 48.0, "longitude_deg": 9.0,
                                       "altitude_m": 500.0, "datum": "WGS84"})");
  std::string points;
  for (int i = 0; i < 400; ++i) {
    points += std::to_string(i % 20) + " " + std::to_string(i / 20) + " 2 10 200 30\n";
  }
  const std::string cloud = write("vision/dense.xyz", points);
  const ProgramResult drawn = run_program({"convert",
                                           cloud,
                                           "--dsm",
                                           path("dsm.tif"),
                                           "--ortho",
                                           path("ortho.tif"),
                                           "--cell-m",
                                           "0.5",
                                           "--json"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(nlohmann::json::parse(drawn.out).at("crs"), "WGS 84 / UTM zone 32N");
  EXPECT_EQ(read_file(path("dsm.tif")).substr(0, 2), "II");
  EXPECT_EQ(read_file(path("ortho.tif")).substr(0, 2), "II");
  const ProgramResult utm =
      run_program({"convert", cloud, path("utm.las"), "--origin", origin, "--json"});
  ASSERT_EQ(utm.exit_code, 0) << utm.err;
  const ProgramResult local =
      run_program({"convert", path("utm.las"), path("local.ply"), "--json"});
  ASSERT_EQ(local.exit_code, 0) << local.err;
  EXPECT_EQ(nlohmann::json::parse(local.out).at("subtracted_m").at(0), 500000.0);
  EXPECT_EQ(run_program({"convert", cloud}).exit_code, 2);
  EXPECT_EQ(run_program({"convert", cloud, path("x.las"), "--crs", "EPSG:4326"}).exit_code, 2);
  EXPECT_EQ(
      run_program({"convert", path("utm.las"), path("x.las"), "--crs", "EPSG:32633"}).exit_code, 2);
}

TEST_F(CommandLine, ConvertCarriesTrajectoriesBothWays) {
  const std::string tum = write("a.tum", "1.5 1 2 3 0 0 0 1\n2.25 4 5 6 0 0 0.6 0.8\n");
  const ProgramResult there =
      run_program({"convert", tum, path("a.kitti"), "--times", path("times.txt")});
  ASSERT_EQ(there.exit_code, 0) << there.err;
  EXPECT_EQ(read_file(path("times.txt")), "1.500000000\n2.250000000\n");
  const ProgramResult back =
      run_program({"convert", path("a.kitti"), path("b.tum"), "--times", path("times.txt")});
  ASSERT_EQ(back.exit_code, 0) << back.err;
  EXPECT_THAT(read_file(path("b.tum")), HasSubstr("2.250000000 4.000000 5.000000 6.000000"));
  EXPECT_EQ(run_program({"convert", path("a.kitti"), path("c.tum")}).exit_code, 2);
  EXPECT_EQ(run_program({"convert", tum, path("c.ply")}).exit_code, 2);
}

}  // namespace
}  // namespace hybridfusion::testing
