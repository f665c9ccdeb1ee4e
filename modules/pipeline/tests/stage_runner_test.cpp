#include "stage_runner.hpp"

#include "run_record.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/pipeline/options_file.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>

#include <filesystem>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A stage that copies its input and counts its runs, in a folder of its own.
class StageRunner : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = std::filesystem::temp_directory_path() /
            ("hf_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
    set_input("first");
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void set_input(const std::string& text) const {
    ASSERT_TRUE(write_file_atomically(root_ / "input.txt", text));
  }

  Expected<StageOutcome> run(const std::vector<std::string>& forced = {}, std::uint64_t seed = 0) {
    auto workspace = Workspace::open(root_ / "ws");
    if (!workspace) return std::unexpected(workspace.error());
    Project project{*std::move(workspace), options_, forced};
    const StagePlan plan{.stage = "evaluate",
                         .option_groups = {"evaluation"},
                         .inputs = {root_ / "input.txt"},
                         .outputs = {workspace_file::kMetrics}};
    return run_stage(project, plan, {.seed = seed}, [&]() -> Expected<StageResult> {
      ++runs_;
      if (fail_) return fail(ErrorCode::kIo, "disk full");
      if (auto made = project.workspace.make_folder("evaluation"); !made) {
        return std::unexpected(made.error());
      }
      const auto path = project.workspace.path(workspace_file::kMetrics);
      if (auto written = write_file_atomically(path, "{}"); !written) {
        return std::unexpected(written.error());
      }
      return StageResult{.json = R"({"runs": )" + std::to_string(runs_) + "}",
                         .summary = {"it ran"}};
    });
  }

  std::filesystem::path root_;
  PipelineOptions options_;
  int runs_ = 0;
  bool fail_ = false;
};

TEST_F(StageRunner, DoesNotRunAgainWhenNothingChanged) {
  ASSERT_TRUE(run());
  const auto again = run();
  ASSERT_TRUE(again);
  EXPECT_EQ(runs_, 1);
  EXPECT_TRUE(again->up_to_date);
  EXPECT_EQ(again->summary, std::vector<std::string>{"it ran"});
  EXPECT_EQ(again->result_json, R"({"runs":1})");
}

TEST_F(StageRunner, RunsAgainWhenInputOptionSeedOrOutputChanged) {
  ASSERT_TRUE(run());
  set_input("second");
  ASSERT_TRUE(run());
  EXPECT_EQ(runs_, 2);
  options_.evaluation.leaf_m = 0.25;
  ASSERT_TRUE(run());
  EXPECT_EQ(runs_, 3);
  ASSERT_TRUE(run({}, 7));
  EXPECT_EQ(runs_, 4);
  std::filesystem::remove(root_ / "ws" / workspace_file::kMetrics);
  ASSERT_TRUE(run({}, 7));
  EXPECT_EQ(runs_, 5);
  ASSERT_TRUE(run({}, 7));
  EXPECT_EQ(runs_, 5);
}

TEST_F(StageRunner, RunsWhenForced) {
  ASSERT_TRUE(run());
  ASSERT_TRUE(run({"evaluate"}));
  EXPECT_EQ(runs_, 2);
}

TEST_F(StageRunner, LeavesNoResultOfAnOldRunWhenTheNewOneFails) {
  ASSERT_TRUE(run());
  set_input("second");
  fail_ = true;
  ASSERT_FALSE(run());
  EXPECT_FALSE(std::filesystem::exists(root_ / "ws" / workspace_file::kMetrics));
  fail_ = false;
  ASSERT_TRUE(run());
  EXPECT_EQ(runs_, 3);
}

TEST_F(StageRunner, RecordsProvenanceAndEffectiveOptions) {
  ASSERT_TRUE(run({}, 5));
  const RunRecord record = RunRecord::load(root_ / "ws" / workspace_file::kRun);
  ASSERT_TRUE(record.stages.contains("evaluate"));
  const StageRecord& stage = record.stages.at("evaluate");
  EXPECT_EQ(stage.seed, 5U);
  ASSERT_EQ(stage.inputs.size(), 1U);
  // sha256 of "first", from sha256sum
  EXPECT_EQ(stage.inputs[0].sha256,
            "a7937b64b8caa58f03721bb6bacf5c78cb235febe0e70b1b84cd99541461a08e");
  EXPECT_EQ(stage.inputs[0].size, 5U);
  EXPECT_GT(stage.cost.peak_memory_mib, 1.0);
  PipelineOptions loaded;
  ASSERT_TRUE(load_options(root_ / "ws" / workspace_file::kConfig, loaded));
}

TEST_F(StageRunner, AWorkspaceIsHeldByOneProcessAtATime) {
  const auto first = Workspace::open(root_ / "ws");
  ASSERT_TRUE(first);
  const auto second = Workspace::open(root_ / "ws");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kIo);
}

TEST(RunRecord, ADamagedFileCountsAsNoRecord) {
  const auto path = std::filesystem::temp_directory_path() / "hf_damaged_run.json";
  ASSERT_TRUE(write_file_atomically(path, R"({"stages": {"map": {"key": 3}}})"));
  EXPECT_TRUE(RunRecord::load(path).stages.empty());
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace hybridfusion
