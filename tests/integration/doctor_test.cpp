#include "program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::testing {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

class DoctorCommand : public ProgramTest {};

TEST_F(DoctorCommand, LooksAtTheMachineAloneWithoutInputs) {
  const ProgramResult result = run_program({"doctor"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("memory:"));
  EXPECT_THAT(result.out, HasSubstr("0 errors, 0 warnings"));
}

TEST_F(DoctorCommand, AnErrorOfAnInputIsExitCode3AndNamesTheRemedy) {
  std::filesystem::create_directories(path("photos"));
  const ProgramResult result =
      run_program({"doctor", "--images", path("photos"), "--bag", path("no.bag")});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.out, HasSubstr("error photos.folder"));
  EXPECT_THAT(result.out, HasSubstr("error recording.unreadable"));
  EXPECT_THAT(result.out, HasSubstr("  -> "));
}

TEST_F(DoctorCommand, AnErrorOfTheOutputAloneIsExitCode5) {
  const std::string file = write("file", "in the way");
  const ProgramResult result = run_program({"doctor", file, "--json"});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json.at("status"), "problems");
  EXPECT_EQ(json.at("exit_code"), 5);
  EXPECT_EQ(json.at("findings").at(0).at("id"), "output.not_writable");
}

TEST_F(DoctorCommand, ARecordedDataSetIsHealthyWithinSeconds) {
  HF_NEEDS_TEST_DATA();
  const std::string block = (*test_data() / "block-11").string();
  const ProgramResult result = run_program({"doctor",
                                            "--images",
                                            block + "/images",
                                            "--bag",
                                            block + "/street.bag",
                                            path("ws"),
                                            "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_TRUE(Json::parse(result.out).at("findings").empty()) << result.out;
  EXPECT_FALSE(std::filesystem::exists(path("ws")));
}

}  // namespace
}  // namespace hybridfusion::testing
