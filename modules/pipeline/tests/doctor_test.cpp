#include "doctor_checks.hpp"
#include "doctor_inputs.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Doctor : public DoctorTest {
 protected:
  [[nodiscard]] std::filesystem::path workspace() const { return folder_.path() / "ws"; }
};

TEST_F(Doctor, AHealthyDataSetHasNoFindings) {
  write_flight(healthy_flight());
  write_drive();
  const DoctorReport report =
      report_of({.images = images(), .bag = bag(), .workspace = workspace()});
  EXPECT_THAT(ids_of(report), IsEmpty());
  EXPECT_FALSE(report.has_errors());
  EXPECT_FALSE(std::filesystem::exists(workspace()));
}

TEST_F(Doctor, TheRecordedBlockHasNoFindings) {
  const auto block = test_data("block-11");
  if (!block) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder with the recordings";
  EXPECT_THAT(ids_of(report_of({.images = *block / "images", .bag = *block / "street.bag"})),
              IsEmpty());
}

TEST_F(Doctor, SitesFarApartAreAnError) {
  write_flight(healthy_flight());
  write_drive({.latitude_deg = kSiteLatitude_deg + 0.05});
  EXPECT_THAT(ids_of(report_of({.images = images(), .bag = bag()})), ElementsAre("site.apart"));
}

TEST_F(Doctor, SwappedCoordinatesAreRecognised) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) {
    const double latitude_deg = *photo.latitude_deg;
    photo.latitude_deg = photo.longitude_deg;
    photo.longitude_deg = latitude_deg;
  }
  write_flight(photos);
  write_drive();
  const DoctorReport report = report_of({.images = images(), .bag = bag()});
  EXPECT_THAT(finding(report, "site.apart").cause, HasSubstr("swapped"));
}

TEST_F(Doctor, PhotosBelowTheStreetAreAnError) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) photo.altitude_m = 80.0;  // above take-off, street at 520 m
  write_flight(photos);
  write_drive();
  EXPECT_THAT(ids_of(report_of({.images = images(), .bag = bag()})),
              ElementsAre("site.photos_below_street"));
}

TEST_F(Doctor, AnAltitudeOfZeroIsNoAltitudeAndJudgesNothingElse) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) {
    photo.relative_altitude_m.reset();
    photo.altitude_m = 0.0;
  }
  write_flight(photos);
  write_drive();
  EXPECT_THAT(ids_of(report_of({.images = images(), .bag = bag()})),
              ElementsAre("photos.no_altitude"));
}

TEST_F(Doctor, TheStreetGivesTheHeightForTheOverlap) {
  auto photos = healthy_flight();
  for (PhotoSpec& photo : photos) {
    photo.relative_altitude_m.reset();
    photo.altitude_m = 550.0;  // 30 m above the street
  }
  write_flight(photos);
  write_drive();
  EXPECT_THAT(ids_of(report_of({.images = images(), .bag = bag()})),
              ElementsAre("photos.low_overlap"));
}

TEST_F(Doctor, TooLittleMemoryOrDiskIsAResourceError) {
  const PhotoEvidence photos{.num_photos = 200, .width_px = 5472, .height_px = 3648};
  const RecordingEvidence recording{.size_bytes = 1U << 30U};
  Diagnosis diagnosis;
  check_machine({.memory_bytes = 1U << 30U, .disk_bytes = 1U << 30U}, photos, recording, diagnosis);
  DoctorReport report{.findings = diagnosis.findings.take()};
  EXPECT_THAT(ids_of(report), ElementsAre("machine.memory", "machine.disk"));
  EXPECT_TRUE(report.only_resource_errors());
  check_machine(
      {.memory_bytes = 64ULL << 30U, .disk_bytes = 64ULL << 30U}, photos, recording, diagnosis);
  EXPECT_THAT(diagnosis.findings.take(), IsEmpty());
  report.findings.push_back({.id = "photos.too_few", .severity = Severity::kError});
  EXPECT_FALSE(report.only_resource_errors());
}

TEST_F(Doctor, TheMachineIsMeasured) {
  const MachineState state = machine_state(folder_.path() / "not" / "made" / "yet");
  ASSERT_TRUE(state.memory_bytes && state.disk_bytes);
  EXPECT_GT(*state.memory_bytes, 1U << 20U);
  EXPECT_GT(*state.disk_bytes, 1U << 20U);
}

TEST_F(Doctor, AWorkspaceInUseIsToldAndOneThatIsFreeIsNot) {
  {
    const auto held = Workspace::open(workspace());
    ASSERT_TRUE(held);
    EXPECT_THAT(ids_of(report_of({.workspace = workspace()})), ElementsAre("output.locked"));
  }
  const DoctorReport report = report_of({.workspace = workspace()});
  EXPECT_THAT(ids_of(report), IsEmpty());
  EXPECT_TRUE(Workspace::open(workspace()));  // looking left no lock behind
}

TEST_F(Doctor, AFileInTheWayOfTheWorkspaceIsTold) {
  const auto file = folder_.file("file", "in the way");
  EXPECT_THAT(ids_of(report_of({.workspace = file})), ElementsAre("output.not_writable"));
  EXPECT_THAT(ids_of(report_of({.workspace = file / "ws"})), ElementsAre("output.not_writable"));
}

TEST_F(Doctor, AWorkspaceOfAnotherVersionIsTold) {
  std::filesystem::create_directories(workspace());
  (void)folder_.file("ws/run.json", R"({"version": "0.0.1"})");
  EXPECT_THAT(ids_of(report_of({.workspace = workspace()})), ElementsAre("output.other_version"));
  (void)folder_.file("ws/run.json", "[1, 2");
  EXPECT_THAT(ids_of(report_of({.workspace = workspace()})), ElementsAre("output.other_version"));
  (void)folder_.file("ws/run.json", fmt::format(R"({{"version": "{}"}})", program_version()));
  EXPECT_THAT(ids_of(report_of({.workspace = workspace()})), IsEmpty());
}

TEST_F(Doctor, AStopIsObeyed) {
  write_drive();
  std::stop_source stop;
  stop.request_stop();
  const auto report = examine({.bag = bag()}, options_, {.stop = stop.get_token()});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::kCancelled);
}

TEST_F(Doctor, JsonHoldsEveryFindingWithItsSubjects) {
  DoctorReport report;
  report.facts = {"a fact"};
  FindingList findings;
  findings.add("photos.blurred", "soft", {"a\xff.jpg"});
  findings.add("photos.no_positions", "none");
  report.findings = findings.take();
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json.at("facts").at(0), "a fact");
  EXPECT_EQ(json.at("findings").at(0).at("id"), "photos.no_positions");  // errors first
  EXPECT_EQ(json.at("findings").at(0).at("severity"), "error");
  EXPECT_EQ(json.at("findings").at(1).at("subjects").size(), 1U);
}

TEST(FindingKinds, HaveDistinctIdsAndAMeaningAndARemedyEach) {
  std::set<std::string_view> ids;
  for (const FindingKind& kind : finding_kinds()) {
    EXPECT_TRUE(ids.insert(kind.id).second) << kind.id;
    EXPECT_FALSE(kind.meaning.empty()) << kind.id;
    EXPECT_FALSE(kind.remedy.empty()) << kind.id;
    EXPECT_THAT(findings_reference(), HasSubstr("| `" + std::string(kind.id) + "` |"));
  }
}

TEST(FindingKinds, AnUnknownIdIsAMistakeOfTheCaller) {
  FindingList findings;
  EXPECT_THROW(findings.add("photos.nonsense", ""), std::logic_error);
}

TEST(Listed, NamesAFewAndCountsTheRest) {
  const std::vector<std::string> names = {"a", "b", "c\n", "d", "e", "f"};
  EXPECT_EQ(listed(names), "a, b, c?, d and 2 more");
}

}  // namespace
}  // namespace hybridfusion::testing
